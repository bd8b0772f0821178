// The mesh payload: changed copies that share arrays, and the caches of what is derived from it.
#include "core/mesh/mesh.h"

#include <glm/geometric.hpp>
#include <mutex>
#include <optional>

#include "core/math/hash.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/halfedge.h"
#include "core/mesh/normals.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangulate.h"

namespace mw {

namespace {

/// Made by whoever asks first; others wait. A failed attempt (no memory) leaves it for the next.
template <class T>
class Lazy {
public:
    template <class Make>
    const T& get(const Make& make)
    {
        std::call_once(once_, [&] { value_.reset(new const T(make())); });
        return *value_;
    }

private:
    std::once_flag once_;
    std::unique_ptr<const T> value_;
};

}  // namespace

/// What follows from the faces alone.
struct Mesh::TopologyCache {
    Lazy<bool> isTriangles;
    Lazy<Shared<uint32_t>> edges;
    Lazy<Rings> rings;
    Lazy<HalfedgeView> halfedges;
    Lazy<TopologyReport> report;
    Lazy<Triangulation> triangulation;  // of triangles
};

/// What follows from positions, too.
struct Mesh::GeometryCache {
    Lazy<Bounds> bounds;
    Lazy<Shared<glm::vec3>> faceNormals, vertexNormals;
    Lazy<Triangulation> triangulation;  // of polygons
};

void Bounds::add(glm::dvec3 p)
{
    min = empty ? p : glm::min(min, p);
    max = empty ? p : glm::max(max, p);
    empty = false;
}

void Bounds::add(const Bounds& b)
{
    if (b.empty) return;
    add(b.min);
    add(b.max);
}

double Bounds::diagonal() const
{
    return empty ? 0 : glm::length(max - min);
}

Mesh::Mesh() : topologyCache_(std::make_shared<TopologyCache>()), geometryCache_(std::make_shared<GeometryCache>()) {}

Mesh::Mesh(Shared<glm::vec3> positions, Shared<uint32_t> faceStart, Shared<uint32_t> cornerVertex) : Mesh()
{
    positions_ = std::move(positions);
    faceStart_ = std::move(faceStart);
    cornerVertex_ = std::move(cornerVertex);
}

Mesh Mesh::triangles(Shared<glm::vec3> positions, Shared<uint32_t> indices)
{
    Array<uint32_t> start(indices.size() / 3 + 1);
    for (size_t f = 0; f < start.size(); ++f) start[f] = uint32_t(3 * f);
    return Mesh(std::move(positions), std::move(start), std::move(indices));
}

bool Mesh::isTriangles() const
{
    return topologyCache_->isTriangles.get([this] {
        bool all = cornerCount() == 3 * faceCount();
        for (size_t f = 0; all && f < faceCount(); ++f) all = faceStart_[f + 1] - faceStart_[f] == 3;
        return all;
    });
}

const Attribute* Mesh::find(std::string_view name) const
{
    for (const Attribute& a : attributes_)
        if (a.name == name) return &a;
    return nullptr;
}

const Attribute* Mesh::find(std::string_view name, Domain domain) const
{
    for (const Attribute& a : attributes_)
        if (a.name == name && a.domain == domain) return &a;
    return nullptr;
}

Mesh Mesh::withPositions(Shared<glm::vec3> positions) const
{
    Mesh m = *this;
    if (positions.size() != positions_.size()) m.topologyCache_ = std::make_shared<TopologyCache>();
    m.geometryCache_ = std::make_shared<GeometryCache>();
    m.positions_ = std::move(positions);
    return m;
}

Mesh Mesh::withLines(Shared<uint32_t> vertexPairs) const
{
    Mesh m = *this;
    m.lines_ = std::move(vertexPairs);
    return m;
}

Mesh Mesh::with(Attribute a) const
{
    Mesh m = *this;
    for (Attribute& old : m.attributes_)
        if (old.name == a.name && old.domain == a.domain) {
            old = std::move(a);
            return m;
        }
    m.attributes_.push_back(std::move(a));
    return m;
}

Mesh Mesh::without(std::string_view name) const
{
    Mesh m = *this;
    std::erase_if(m.attributes_, [&](const Attribute& a) { return a.name == name; });
    return m;
}

Mesh Mesh::withGroupNames(std::vector<std::string> names) const
{
    Mesh m = *this;
    m.groupNames_ = std::move(names);
    return m;
}

const HalfedgeView& Mesh::halfedges() const
{
    return topologyCache_->halfedges.get([this] { return HalfedgeView(*this); });
}

const TopologyReport& Mesh::topology() const
{
    return topologyCache_->report.get([this] { return topologyOf(*this); });
}

const Rings& Mesh::rings() const
{
    return topologyCache_->rings.get([this] { return ringsOf(*this); });
}

const Shared<uint32_t>& Mesh::edges() const
{
    return topologyCache_->edges.get([this] { return Shared<uint32_t>(edgesOf(*this)); });
}

const Shared<glm::vec3>& Mesh::faceNormals() const
{
    return geometryCache_->faceNormals.get([this] { return Shared<glm::vec3>(faceNormalsOf(*this)); });
}

const Shared<glm::vec3>& Mesh::vertexNormals() const
{
    return geometryCache_->vertexNormals.get([this] { return Shared<glm::vec3>(vertexNormalsOf(*this)); });
}

const Mesh::Triangulation& Mesh::triangulation() const
{
    const auto make = [this] { return triangulationOf(*this); };
    return isTriangles() ? topologyCache_->triangulation.get(make) : geometryCache_->triangulation.get(make);
}

Bounds Mesh::bounds() const
{
    return geometryCache_->bounds.get([this] {
        Bounds b;
        if (positions_.empty()) return b;
        glm::vec3 low = positions_[0], high = low;
        for (const glm::vec3& p : positions_) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        b.add(low);
        b.add(high);
        return b;
    });
}

size_t Mesh::bytes() const
{
    size_t n = sizeof(Mesh) + positions_.bytes() + faceStart_.bytes() + cornerVertex_.bytes() + lines_.bytes();
    for (const Attribute& a : attributes_) n += sizeof(Attribute) + a.name.size() + a.bytes();
    for (const std::string& s : groupNames_) n += sizeof(std::string) + s.size();
    return n;
}

uint64_t contentHash(const Mesh& m)
{
    Hasher h;
    h.array(m.positions().span());
    h.array(m.faceStart().span());
    h.array(m.cornerVertex().span());
    h.array(m.lines().span());
    h.number(m.attributes().size());
    for (const Attribute& a : m.attributes()) {
        h.text(a.name);
        h.number(uint64_t(a.domain) | uint64_t(a.stored) << 8 | uint64_t(a.components) << 16 | uint64_t(a.values.index()) << 48);
        std::visit([&](const auto& v) { h.array(v.span()); }, a.values);
    }
    h.number(m.groupNames().size());
    for (const std::string& s : m.groupNames()) h.text(s);
    return h.value();
}

}  // namespace mw
