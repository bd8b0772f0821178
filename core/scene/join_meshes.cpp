// Attributes are matched by name; what a mesh lacks is filled in, what moves with the mesh is turned.
#include "core/scene/join_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <map>
#include <set>

namespace mw {
namespace {

/// How an attribute of this name moves with the mesh.
enum class Turned { Not, Normal, Direction };
Turned turnedBy(const Attribute& a)
{
    if (a.components < 3) return Turned::Not;
    if ((a.name == names::normal && a.components == 3) || (a.name.starts_with("morph-normal:") && a.components == 3)) return Turned::Normal;
    if ((a.name == names::tangent && a.components == 4) || (a.name.starts_with(names::morph) && a.components == 3)) return Turned::Direction;
    return Turned::Not;
}

Attribute turned(const Attribute& a, const glm::dmat3& linear, bool mirrored)
{
    const Turned how = turnedBy(a);
    if (how == Turned::Not || a.floats().empty()) return a;
    const glm::dmat3 m = how == Turned::Normal ? glm::inverseTranspose(linear) : linear;
    const bool unit = a.name == names::normal || a.name == names::tangent;
    const std::span<const float> old = a.floats();
    Array<float> values(old.begin(), old.end());
    for (size_t i = 0; i < a.size(); ++i) {
        float* v = values.data() + i * size_t(a.components);
        const glm::dvec3 before(v[0], v[1], v[2]);
        glm::dvec3 after = m * before;
        if (const double l = glm::length(after); unit && l > 0) after *= glm::length(before) / l;
        for (int k = 0; k < 3; ++k) v[k] = float(after[k]);
        if (a.components == 4 && mirrored) v[3] = -v[3];
    }
    Attribute out = a;
    out.values = Shared(std::move(values));
    return out;
}

/// Every face the other way round, from the same first corner.
Mesh reversed(const Mesh& mesh)
{
    Array<uint32_t> from(mesh.cornerCount()), edgeFrom(mesh.cornerCount());
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t s = mesh.faceStart()[f], n = mesh.faceStart()[f + 1] - s;
        for (uint32_t j = 0; j < n; ++j) {
            from[s + j] = s + (n - j) % n;
            edgeFrom[s + j] = s + n - 1 - j;  // the edge to the next corner was the one from it
        }
    }
    Array<uint32_t> corners(mesh.cornerCount());
    for (size_t c = 0; c < corners.size(); ++c) corners[c] = mesh.cornerVertex()[from[c]];
    Mesh out(mesh.positions(), mesh.faceStart(), std::move(corners));
    if (!mesh.lines().empty()) out = out.withLines(mesh.lines());
    for (const Attribute& a : mesh.attributes())
        out = out.with(a.domain != Domain::Corner ? a : gathered(a, a.name == names::crease ? edgeFrom : from));
    return out.withGroupNames(mesh.groupNames());
}

Mesh moved(const Mesh& mesh, const glm::dmat4& m)
{
    if (m == glm::dmat4(1)) return mesh;
    const glm::dmat3 linear(m);
    const bool mirrored = glm::determinant(linear) < 0;
    Array<glm::vec3> positions(mesh.vertexCount());
    for (size_t i = 0; i < positions.size(); ++i) positions[i] = glm::vec3(m * glm::dvec4(mesh.positions()[i], 1));
    Mesh out = mesh.withPositions(std::move(positions));
    for (const Attribute& a : mesh.attributes())
        if (turnedBy(a) != Turned::Not) out = out.with(turned(a, linear, mirrored));
    return mirrored ? reversed(out) : out;
}

template <class T>
void append(Array<T>& to, std::span<const T> from)
{
    to.insert(to.end(), from.begin(), from.end());
}

/// What an attribute of the joined mesh is like.
struct Column {
    std::string name;
    Domain domain;
    int components;
    Scalar stored;
    bool integral, wide;  // wide: a file had doubles
};

/// Puts the meshes one after the other.
class Joiner {
public:
    explicit Joiner(std::vector<MeshPart>& parts) : parts_(parts) {}
    JoinedMeshes run(bool groupByPart);

private:
    Mesh geometry() const;
    std::vector<Column> columns() const;
    Attribute joined(const Column& c) const;
    double missing(const Column& c, const Mesh& mesh, size_t element, int component) const;
    Attribute groups(std::vector<std::string>& groupNames) const;
    Attribute materials(std::vector<MaterialId>& slots) const;

    std::vector<MeshPart>& parts_;
};

Mesh Joiner::geometry() const
{
    Array<glm::vec3> positions;
    Array<uint32_t> start{0u}, corners, lines;
    for (const MeshPart& p : parts_) {
        const uint32_t firstVertex = uint32_t(positions.size()), firstCorner = uint32_t(corners.size());
        if (positions.size() + p.mesh.vertexCount() >= none || corners.size() + p.mesh.cornerCount() >= none)
            throw Error("there are more elements than one mesh can hold");
        append(positions, p.mesh.positions().span());
        for (uint32_t v : p.mesh.cornerVertex()) corners.push_back(firstVertex + v);
        for (size_t f = 0; f < p.mesh.faceCount(); ++f) start.push_back(firstCorner + p.mesh.faceStart()[f + 1]);
        for (uint32_t v : p.mesh.lines()) lines.push_back(firstVertex + v);
    }
    Mesh mesh(std::move(positions), std::move(start), std::move(corners));
    return lines.empty() ? mesh : mesh.withLines(std::move(lines));
}

/// All attributes there are. What lives at vertices here and at corners there is put at corners; the larger number of components is taken.
std::vector<Column> Joiner::columns() const
{
    std::vector<Column> all;
    const auto atCorners = [&](const std::string& name) {
        return std::any_of(parts_.begin(), parts_.end(), [&](const MeshPart& p) { return p.mesh.find(name, Domain::Corner) != nullptr; });
    };
    for (const MeshPart& p : parts_)
        for (const Attribute& a : p.mesh.attributes()) {
            if (a.domain == Domain::Face && (a.name == names::material || a.name == names::group)) continue;
            const Domain domain = a.domain == Domain::Vertex && atCorners(a.name) ? Domain::Corner : a.domain;
            auto c = std::find_if(all.begin(), all.end(), [&](const Column& o) { return o.name == a.name && o.domain == domain; });
            const bool wide = std::holds_alternative<Shared<double>>(a.values);
            if (c == all.end()) {
                all.push_back({a.name, domain, a.components, a.stored, a.integral(), wide});
                continue;
            }
            c->components = std::max(c->components, a.components);
            if (c->integral != a.integral() || c->wide != wide) c->stored = wide || c->wide ? Scalar::Float64 : Scalar::Float32;
            c->integral = c->integral && a.integral();
            c->wide = c->wide || wide;
        }
    return all;
}

/// For meshes that lack an attribute which others have.
double Joiner::missing(const Column& c, const Mesh& mesh, size_t element, int component) const
{
    if (c.name == names::color) return 1;
    if (c.name == names::normal && component < 3) {
        const size_t v = c.domain == Domain::Corner ? mesh.cornerVertex()[element] : element;
        return c.domain == Domain::Face ? double(mesh.faceNormals()[element][component]) : double(mesh.vertexNormals()[v][component]);
    }
    return 0;
}

Attribute Joiner::joined(const Column& c) const
{
    Array<double> values;
    for (const MeshPart& p : parts_) {
        const Attribute* a = p.mesh.find(c.name, c.domain);
        const Attribute* spread = !a && c.domain == Domain::Corner ? p.mesh.find(c.name, Domain::Vertex) : nullptr;
        const size_t n = p.mesh.count(c.domain);
        values.reserve(values.size() + n * size_t(c.components));
        for (size_t i = 0; i < n; ++i)
            for (int k = 0; k < c.components; ++k) {
                const Attribute* from = a ? a : spread;
                const bool has = from && k < from->components;
                values.push_back(has ? from->at(spread ? p.mesh.cornerVertex()[i] : i, k) : missing(c, p.mesh, i, k));
            }
    }
    Attribute out{c.name, c.domain, c.components, {}, c.stored};
    if (c.integral)
        out.values = Shared(Array<int32_t>(values.begin(), values.end()));
    else if (c.wide)
        out.values = Shared(std::move(values));
    else
        out.values = Shared(Array<float>(values.begin(), values.end()));
    return out;
}

/// Each node is a group; where its mesh has groups of its own, NODE/GROUP.
Attribute Joiner::groups(std::vector<std::string>& groupNames) const
{
    Array<int32_t> values;
    for (const MeshPart& p : parts_) {
        const Attribute* own = p.mesh.find(names::group, Domain::Face);
        const std::span<const int32_t> numbers = own ? own->integers() : std::span<const int32_t>();
        std::map<int32_t, int32_t> number;
        for (size_t f = 0; f < p.mesh.faceCount(); ++f) {
            const int32_t g = f < numbers.size() ? numbers[f] : -1;
            const auto [i, fresh] = number.try_emplace(g, int32_t(groupNames.size()));
            const bool named = g >= 0 && size_t(g) < p.mesh.groupNames().size();
            if (fresh) groupNames.push_back(named ? p.name + "/" + p.mesh.groupNames()[size_t(g)] : p.name);
            values.push_back(i->second);
        }
    }
    return integerAttribute(std::string(names::group), Domain::Face, 1, std::move(values));
}

/// `slots` are the materials used, each once.
Attribute Joiner::materials(std::vector<MaterialId>& slots) const
{
    Array<int32_t> values;
    std::map<MaterialId, int32_t> slot;
    for (const MeshPart& p : parts_) {
        const Attribute* own = p.mesh.find(names::material, Domain::Face);
        const std::span<const int32_t> numbers = own ? own->integers() : std::span<const int32_t>();
        for (size_t f = 0; f < p.mesh.faceCount(); ++f) {
            const size_t s = f < numbers.size() && numbers[f] >= 0 ? size_t(numbers[f]) : 0;
            const MaterialId m = s < p.materials.size() ? p.materials[s] : MaterialId{};
            const auto [i, fresh] = slot.try_emplace(m, int32_t(slots.size()));
            if (fresh) slots.push_back(m);
            values.push_back(i->second);
        }
    }
    return integerAttribute(std::string(names::material), Domain::Face, 1, std::move(values));
}

JoinedMeshes Joiner::run(bool groupByPart)
{
    JoinedMeshes out;
    out.mesh = geometry();
    for (const Column& c : columns()) out.mesh = out.mesh.with(joined(c));
    std::vector<std::string> groupNames;
    Attribute group = groups(groupNames);
    const bool some = std::any_of(parts_.begin(), parts_.end(), [](const MeshPart& p) { return p.mesh.find(names::group, Domain::Face); });
    if (!groupNames.empty() && (groupByPart || some)) out.mesh = out.mesh.with(std::move(group)).withGroupNames(std::move(groupNames));
    Attribute material = materials(out.materials);
    if (out.materials.size() > 1) out.mesh = out.mesh.with(std::move(material));
    if (out.materials == std::vector<MaterialId>{MaterialId{}}) out.materials.clear();
    return out;
}

}  // namespace

JoinedMeshes joinedMeshes(std::vector<MeshPart> parts, bool groupByPart)
{
    if (parts.empty()) return {};
    for (MeshPart& p : parts) p.mesh = moved(p.mesh, p.place);
    if (parts.size() == 1) return {parts[0].mesh, parts[0].materials};
    return Joiner(parts).run(groupByPart);
}

}  // namespace mw
