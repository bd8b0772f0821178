// Corner values of cut faces without tables; vertices by rows, faces gathered.
#include "core/subdivide/carried.h"

#include <algorithm>

#include "core/error.h"
#include "core/mesh/submesh.h"
#include "core/subdivide/lanes.h"

namespace mw {

namespace {

constexpr double mostFaces = 100e6;

/// Calls put(weights of old corners) for each new corner in order: own(c), middle(c, d), centre(first, end).
template <class Own, class Middle, class Centre>
void forNewCorners(const FaceCut& cut, const Own& own, const Middle& middle, const Centre& centre)
{
    for (size_t f = 0; f < cut.faces; ++f) {
        const uint32_t first = cut.first(f), end = cut.first(f + 1), n = end - first;
        const bool triangles = cut.intoTriangles(n);
        for (uint32_t c = first; c < end; ++c) {
            own(c);
            middle(c, c + 1 == end ? first : c + 1);
            if (!triangles) centre(first, end);
            middle(c == first ? end - 1 : c - 1, c);
        }
        if (!triangles) continue;
        for (uint32_t k = 0; k < 3; ++k) middle(first + k, first + (k + 1) % 3);
    }
}

/// K numbers a corner; 0: as many as `components` says.
template <size_t K, class T>
Shared<T> mixedOf(const Shared<T>& old, size_t components, const FaceCut& cut)
{
    const size_t k = K ? K : components;
    Array<T> a = largeArray<T>(cut.newCorners() * k);
    T* out = a.data();
    const T* in = old.data();
    forNewCorners(
        cut,
        [&](uint32_t c) {
            for (size_t i = 0; i < k; ++i) *out++ = in[c * k + i];
        },
        [&](uint32_t c, uint32_t d) {
            for (size_t i = 0; i < k; ++i) *out++ = T(0.5 * (double(in[c * k + i]) + double(in[d * k + i])));
        },
        [&](uint32_t first, uint32_t end) {
            for (size_t i = 0; i < k; ++i) {
                double sum = 0;
                for (uint32_t c = first; c < end; ++c) sum += double(in[c * k + i]);
                *out++ = T(sum / double(end - first));
            }
        });
    return a;
}

template <class T>
Shared<T> mixed(const Shared<T>& old, size_t k, const FaceCut& cut)
{
    return k == 2 ? mixedOf<2>(old, k, cut) : k == 3 ? mixedOf<3>(old, k, cut) : mixedOf<0>(old, k, cut);
}

/// As rows: for what is not simply mixed (directions, integers).
Stencils rowsOf(const FaceCut& cut)
{
    Stencils rows;
    forNewCorners(
        cut,
        [&](uint32_t c) {
            rows.add(c, 1);
            rows.endRow();
        },
        [&](uint32_t c, uint32_t d) {
            rows.add(c, 0.5);
            rows.add(d, 0.5);
            rows.endRow();
        },
        [&](uint32_t first, uint32_t end) {
            for (uint32_t c = first; c < end; ++c) rows.add(c, 1.0 / double(end - first));
            rows.endRow();
        });
    return rows;
}

}  // namespace

size_t FaceCut::newFaces() const
{
    if (faceStart.empty()) return faces * (intoTriangles(size) ? 4 : size);
    size_t n = 0;
    for (size_t f = 0; f < faces; ++f) {
        const uint32_t corners = first(f + 1) - first(f);
        n += intoTriangles(corners) ? 4 : corners;
    }
    return n;
}

size_t FaceCut::newCorners() const
{
    if (faceStart.empty()) return faces * (intoTriangles(size) ? 12 : 4 * size);
    size_t n = 0;
    for (size_t f = 0; f < faces; ++f) {
        const uint32_t corners = first(f + 1) - first(f);
        n += intoTriangles(corners) ? 12 : 4 * size_t(corners);
    }
    return n;
}

Attribute cutCorners(const Attribute& a, const FaceCut& cut)
{
    if (a.integral() || a.name == names::normal || a.name == names::tangent) return blended(a, rowsOf(cut));
    Attribute out = a;
    if (const auto* f = std::get_if<Shared<float>>(&a.values)) out.values = mixed(*f, size_t(a.components), cut);
    if (const auto* d = std::get_if<Shared<double>>(&a.values)) out.values = mixed(*d, size_t(a.components), cut);
    return out;
}

Attribute cutCrease(const Attribute& crease, const FaceCut& cut, Creases creases)
{
    Array<float> sharpness(crease.size());
    for (size_t c = 0; c < sharpness.size(); ++c) sharpness[c] = crease.floats().empty() ? float(crease.at(c, 0)) : crease.floats()[c];
    for (float& s : sharpness) s = creases == Creases::Fading ? std::max(0.f, s - 1) : creases == Creases::Kept || s >= 1 ? s : 0.f;
    Array<float> out = largeArray<float>(cut.newCorners());
    float* to = out.data();
    for (size_t f = 0; f < cut.faces; ++f) {
        const uint32_t first = cut.first(f), end = cut.first(f + 1);
        const bool triangles = cut.intoTriangles(end - first);
        float before = end > first ? sharpness[end - 1] : 0;
        for (uint32_t c = first; c < end; ++c) {
            const float own = sharpness[c];
            *to++ = own;
            *to++ = 0;
            if (!triangles) *to++ = 0;
            *to++ = before;
            before = own;
        }
        for (int k = 0; triangles && k < 3; ++k) *to++ = 0;
    }
    return floatAttribute(crease.name, Domain::Corner, 1, std::move(out));
}

Array<uint32_t> cutFaces(const FaceCut& cut)
{
    Array<uint32_t> from;
    from.reserve(cut.newFaces());
    for (uint32_t f = 0; f < cut.faces; ++f) {
        const uint32_t n = cut.first(f + 1) - cut.first(f);
        from.insert(from.end(), cut.intoTriangles(n) ? 4 : n, f);
    }
    return from;
}

Array<float> creaseOf(const Mesh& mesh)
{
    const Attribute* a = mesh.find(names::crease, Domain::Corner);
    Array<float> out(a && a->components == 1 ? a->size() : 0);
    for (size_t c = 0; c < out.size(); ++c) out[c] = float(a->at(c, 0));
    return out;
}

std::vector<Attribute> carried(const std::vector<Attribute>& old, const Origins& origins)
{
    const auto has = [&](Domain d) { return std::any_of(old.begin(), old.end(), [d](const Attribute& a) { return a.domain == d; }); };
    const auto find = [&](std::string_view name) {
        const auto i = std::find_if(old.begin(), old.end(), [&](const Attribute& a) { return a.name == name && a.domain == Domain::Vertex; });
        return i == old.end() ? nullptr : &*i;
    };
    const Stencils rows = has(Domain::Vertex) ? origins.vertexRows() : Stencils();
    const Array<uint32_t> faces = has(Domain::Face) ? origins.faces() : Array<uint32_t>();
    const Attribute *joints = find(names::joints), *skin = find(names::weights);
    std::vector<Attribute> out;
    for (const Attribute& a : old) {
        if (a.domain == Domain::Face)
            out.push_back(gathered(a, faces));
        else if (a.domain == Domain::Corner)
            out.push_back(a.name == names::crease && a.components == 1 ? origins.crease(a) : origins.corner(a));
        else if (!(joints && skin && (&a == joints || &a == skin)))
            out.push_back(blended(a, rows));
    }
    if (joints && skin) {
        SkinWeights mixed = blendedSkin(*joints, *skin, rows);
        out.push_back(std::move(mixed.joints));
        out.push_back(std::move(mixed.weights));
    }
    return out;
}

Mesh withAttributes(Mesh mesh, const std::vector<Attribute>& attributes)
{
    for (const Attribute& a : attributes) mesh = mesh.with(a);
    return mesh;
}

void checkResultSize(double faces, const std::string& parameter)
{
    if (faces <= mostFaces) return;
    throw Error(parameter + " would make " + std::to_string(int64_t(std::min(faces / 1e6, 1e15))) + " million faces, at most " +
                std::to_string(int64_t(mostFaces / 1e6)) + " million are made; take fewer levels or simplify first");
}

Mesh polygonsCut(const Mesh& input, size_t most)
{
    bool whole = true;
    for (size_t f = 0; whole && f < input.faceCount(); ++f) whole = input.face(f).size() >= 3 && input.face(f).size() <= most;
    if (whole) return input;
    const Mesh::Triangulation& t = input.triangulation();
    Array<uint32_t> corners, faces, start{0u}, vertices;
    for (size_t f = 0, i = 0; f < input.faceCount(); ++f) {
        const uint32_t first = input.faceStart()[f], end = input.faceStart()[f + 1];
        const bool kept = end - first >= 3 && end - first <= most;
        for (uint32_t c = first; kept && c < end; ++c) corners.push_back(c);
        if (kept) start.push_back(uint32_t(corners.size())), faces.push_back(uint32_t(f));
        for (; i < t.faces.size() && t.faces[i] == f; ++i) {
            if (kept) continue;
            corners.insert(corners.end(), t.corners.data() + 3 * i, t.corners.data() + 3 * i + 3);
            start.push_back(uint32_t(corners.size())), faces.push_back(uint32_t(f));
        }
    }
    for (const uint32_t c : corners) vertices.push_back(input.cornerVertex()[c]);
    const auto isSide = [&](uint32_t face, uint32_t c, uint32_t after) {
        return after == (c + 1 == input.faceStart()[face + 1] ? input.faceStart()[face] : c + 1);
    };
    Mesh out = Mesh(input.positions(), start, vertices).withGroupNames(input.groupNames());
    if (!input.lines().empty()) out = out.withLines(input.lines());
    for (const Attribute& a : input.attributes()) {
        Attribute onPieces = a.domain == Domain::Corner ? gathered(a, corners) : a.domain == Domain::Face ? gathered(a, faces) : a;
        if (a.domain == Domain::Corner && a.name == names::crease) {
            Array<float> crease(corners.size(), 0.f);
            for (size_t f = 0; f < faces.size(); ++f)
                for (uint32_t c = start[f]; c < start[f + 1]; ++c)
                    if (isSide(faces[f], corners[c], corners[c + 1 == start[f + 1] ? start[f] : c + 1])) crease[c] = float(a.at(corners[c], 0));
            onPieces = floatAttribute(a.name, Domain::Corner, 1, std::move(crease));
        }
        out = out.with(std::move(onPieces));
    }
    return out;
}

Mesh asTriangles(const Mesh& input)
{
    return input.isTriangles() ? input : polygonsCut(input, 3);
}

Mesh withoutTinyFaces(const Mesh& input)
{
    KeptElements kept(input);
    bool all = true;
    for (size_t f = 0; f < input.faceCount(); ++f)
        if (input.face(f).size() < 3) kept.faces[f] = all = false;
    return all ? input : submesh(input, kept);
}

}  // namespace mw
