// Attributes: access by any type, and the one way in which operations mix and gather them.
#include "core/mesh/attribute.h"

#include <algorithm>
#include <cmath>

namespace mw {

namespace {

template <class T>
Shared<T> gatheredValues(const Shared<T>& old, int components, std::span<const uint32_t> from)
{
    const size_t k = size_t(components);
    Array<T> a(from.size() * k);
    T* out = a.data();
    for (const uint32_t f : from)
        for (size_t c = 0; c < k; ++c) *out++ = old[f * k + c];
    return a;
}

template <class T>
Shared<T> mixedValues(const Shared<T>& old, int components, const Stencils& rows)
{
    const size_t k = size_t(components);
    Array<T> a(rows.size() * k);
    for (size_t i = 0; i < rows.size(); ++i)
        for (size_t c = 0; c < k; ++c) {
            double sum = 0;
            for (uint32_t j = rows.start[i]; j < rows.start[i + 1]; ++j) sum += double(rows.weight[j]) * double(old[rows.source[j] * k + c]);
            a[i * k + c] = T(sum);
        }
    return a;
}

/// Where in the lists of row i (not empty) its greatest weight stands; the first of equal ones.
uint32_t strongest(const Stencils& rows, size_t i)
{
    uint32_t best = rows.start[i];
    for (uint32_t j = best; j < rows.start[i + 1]; ++j)
        if (rows.weight[j] > rows.weight[best]) best = j;
    return best;
}

Shared<int32_t> strongestValues(const Shared<int32_t>& old, int components, const Stencils& rows)
{
    const size_t k = size_t(components);
    Array<int32_t> a(rows.size() * k, 0);
    for (size_t i = 0; i < rows.size(); ++i) {
        if (rows.start[i] == rows.start[i + 1]) continue;
        const size_t s = rows.source[strongest(rows, i)];
        for (size_t c = 0; c < k; ++c) a[i * k + c] = old[s * k + c];
    }
    return a;
}

/// Directions lose length when mixed. The fourth number of a tangent is a sign and is taken from the strongest source.
template <class T>
Shared<T> madeUnit(const Shared<T>& mixed, const Shared<T>& old, int components, const Stencils& rows)
{
    const size_t k = size_t(components);
    Array<T> a(mixed.begin(), mixed.end());
    for (size_t i = 0; i < rows.size(); ++i) {
        T* v = a.data() + i * k;
        const double length = std::sqrt(double(v[0]) * double(v[0]) + double(v[1]) * double(v[1]) + double(v[2]) * double(v[2]));
        if (length > 0)
            for (int c = 0; c < 3; ++c) v[c] = T(double(v[c]) / length);
        if (k == 4 && rows.start[i] < rows.start[i + 1]) v[3] = old[rows.source[strongest(rows, i)] * k + 3];
    }
    return a;
}

bool isDirection(const Attribute& a)
{
    return (a.name == names::normal && a.components == 3) || (a.name == names::tangent && (a.components == 3 || a.components == 4));
}

}  // namespace

size_t Attribute::size() const
{
    const size_t n = std::visit([](const auto& v) { return v.size(); }, values);
    return components > 0 ? n / size_t(components) : 0;
}

double Attribute::at(size_t element, int component) const
{
    const size_t i = element * size_t(components) + size_t(component);
    return std::visit([i](const auto& v) { return double(v[i]); }, values);
}

std::span<const float> Attribute::floats() const
{
    const auto* v = std::get_if<Shared<float>>(&values);
    return v ? v->span() : std::span<const float>();
}

std::span<const int32_t> Attribute::integers() const
{
    const auto* v = std::get_if<Shared<int32_t>>(&values);
    return v ? v->span() : std::span<const int32_t>();
}

const void* Attribute::id() const
{
    return std::visit([](const auto& v) { return v.id(); }, values);
}

size_t Attribute::bytes() const
{
    return std::visit([](const auto& v) { return v.bytes(); }, values);
}

Attribute floatAttribute(std::string name, Domain domain, int components, Array<float> values)
{
    return {std::move(name), domain, components, Shared<float>(std::move(values)), Scalar::Float32};
}

Attribute integerAttribute(std::string name, Domain domain, int components, Array<int32_t> values)
{
    return {std::move(name), domain, components, Shared<int32_t>(std::move(values)), Scalar::Int32};
}

Attribute blended(const Attribute& a, const Stencils& rows)
{
    Attribute out = a;
    if (const auto* f = std::get_if<Shared<float>>(&a.values)) {
        Shared<float> mixed = mixedValues(*f, a.components, rows);
        out.values = isDirection(a) ? madeUnit(mixed, *f, a.components, rows) : mixed;
    } else if (const auto* d = std::get_if<Shared<double>>(&a.values)) {
        Shared<double> mixed = mixedValues(*d, a.components, rows);
        out.values = isDirection(a) ? madeUnit(mixed, *d, a.components, rows) : mixed;
    } else {
        out.values = strongestValues(std::get<Shared<int32_t>>(a.values), a.components, rows);
    }
    return out;
}

Attribute gathered(const Attribute& a, std::span<const uint32_t> from)
{
    Attribute out = a;
    std::visit([&](const auto& v) { out.values = gatheredValues(v, a.components, from); }, a.values);
    return out;
}

SkinWeights blendedSkin(const Attribute& joints, const Attribute& weights, const Stencils& rows)
{
    const int slots = std::min(joints.components, weights.components);
    const size_t width = size_t(slots);
    Array<int32_t> newJoints(rows.size() * width, 0);
    Array<float> newWeights(rows.size() * width, 0.f);
    std::vector<std::pair<int32_t, double>> merged;
    for (size_t i = 0; i < rows.size(); ++i) {
        merged.clear();
        for (uint32_t j = rows.start[i]; j < rows.start[i + 1]; ++j)
            for (int s = 0; s < slots; ++s) {
                const double w = double(rows.weight[j]) * weights.at(rows.source[j], s);
                if (w == 0) continue;
                const int32_t joint = int32_t(joints.at(rows.source[j], s));
                auto known = std::find_if(merged.begin(), merged.end(), [&](const auto& m) { return m.first == joint; });
                if (known == merged.end()) known = merged.insert(merged.end(), {joint, 0.0});
                known->second += w;
            }
        // Stencils may have negative weights; a joint must not.
        std::erase_if(merged, [](const auto& m) { return !(m.second > 0); });
        std::sort(merged.begin(), merged.end(),
                  [](const auto& a, const auto& b) { return a.second != b.second ? a.second > b.second : a.first < b.first; });
        merged.resize(std::min(merged.size(), width));
        double sum = 0;
        for (const auto& m : merged) sum += m.second;
        for (size_t s = 0; s < merged.size(); ++s) {
            newJoints[i * width + s] = merged[s].first;
            newWeights[i * width + s] = float(merged[s].second / sum);
        }
    }
    SkinWeights out{joints, weights};
    out.joints.components = out.weights.components = slots;
    out.joints.values = Shared<int32_t>(std::move(newJoints));
    out.weights.values = Shared<float>(std::move(newWeights));
    return out;
}

}  // namespace mw
