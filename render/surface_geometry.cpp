// Splitting vertices where corners differ, sorting triangles by material, and sending the result.
#include "render/surface_geometry.h"

#include <algorithm>
#include <cstring>

namespace mw {
namespace {

constexpr int splitWalk = 64;  // a vertex with more different corners than this gets copies that could have been shared

enum Use : uint64_t { usePlain, useGathered = 1, useFloats, useGatheredFloats, useEdgeFlags };

/// An attribute as floats, whatever it is stored as.
class Floats {
public:
    explicit Floats(const Attribute* a) : components_(a ? size_t(a->components) : 0)
    {
        if (!a) return;
        values_ = a->floats();
        if (!values_.empty() || a->size() == 0) return;
        own_.resize(a->size() * components_);
        for (size_t i = 0; i < own_.size(); ++i) own_[i] = float(a->at(i / components_, int(i % components_)));
        values_ = own_;
    }
    size_t components() const { return components_; }
    const float* at(size_t element) const { return values_.data() + element * components_; }
    bool same(size_t a, size_t b) const { return components_ == 0 || std::memcmp(at(a), at(b), components_ * sizeof(float)) == 0; }

private:
    size_t components_;
    std::span<const float> values_;
    std::vector<float> own_;
};

const Attribute* cornerOnly(const Attribute* a)
{
    return a && a->domain == Domain::Corner ? a : nullptr;
}

const Attribute* cornerOrVertex(const Mesh& mesh, std::string_view name)
{
    const Attribute* a = mesh.find(name, Domain::Corner);
    return a ? a : mesh.find(name, Domain::Vertex);
}

/// Gives each triangle corner a drawn vertex: one that its payload vertex already has and whose corner looks the same, or a new one.
class Splitter {
public:
    Splitter(const Mesh& mesh, const SurfaceLayout& l)
        : normal_(cornerOnly(l.normal)),
          color_(cornerOnly(l.color)),
          tangent_(cornerOnly(l.tangent)),
          texcoord_(cornerOnly(l.texcoord[0])),
          texcoord1_(cornerOnly(l.texcoord[1])),
          first_(mesh.vertexCount(), none)
    {}

    uint32_t drawn(uint32_t vertex, uint32_t corner)
    {
        int walked = 0;
        for (uint32_t d = first_[vertex]; d != none && walked < splitWalk; d = next_[d], ++walked)
            if (same(cornerOf[d], corner)) return d;
        const uint32_t d = uint32_t(vertexOf.size());
        vertexOf.push_back(vertex);
        cornerOf.push_back(corner);
        next_.push_back(first_[vertex]);
        first_[vertex] = d;
        return d;
    }

    Array<uint32_t> vertexOf, cornerOf;

private:
    bool same(uint32_t a, uint32_t b) const
    {
        return normal_.same(a, b) && color_.same(a, b) && texcoord_.same(a, b) && texcoord1_.same(a, b) && tangent_.same(a, b);
    }
    Floats normal_, color_, tangent_, texcoord_, texcoord1_;
    Array<uint32_t> first_, next_;
};

/// Triangles in runs of one material; order within a run is kept. Null attribute: one run.
std::vector<uint32_t> sortByMaterial(const Mesh& mesh, const Attribute* material, size_t slots, std::vector<SurfaceLayout::Run>& runs)
{
    const Mesh::Triangulation& t = mesh.triangulation();
    const size_t n = t.vertices.size() / 3;
    if (!material || slots < 2) {
        runs = {{0, 0, n}};
        return {};
    }
    const auto slotOf = [&](size_t triangle) {
        const double slot = material->at(t.faces[triangle], 0);
        return slot > 0 ? std::min(size_t(slot), slots - 1) : 0;
    };
    std::vector<size_t> start(slots + 1, 0);
    for (size_t i = 0; i < n; ++i) ++start[slotOf(i) + 1];
    for (size_t s = 0; s < slots; ++s) {
        if (start[s + 1]) runs.push_back({uint32_t(s), start[s], start[s + 1]});
        start[s + 1] += start[s];
    }
    std::vector<uint32_t> order(n);
    for (size_t i = 0; i < n; ++i) order[start[slotOf(i)]++] = uint32_t(i);
    return runs.size() > 1 ? order : std::vector<uint32_t>{};
}

/// What is wanted and there.
void findAttributes(const Mesh& mesh, const SurfaceWants& wants, SurfaceLayout& l)
{
    l.normal = wants.normals ? cornerOrVertex(mesh, names::normal) : nullptr;
    l.color = wants.colors ? cornerOrVertex(mesh, names::color) : nullptr;
    l.tangent = wants.tangents ? cornerOrVertex(mesh, names::tangent) : nullptr;
    if (l.tangent && l.tangent->components != 4) l.tangent = nullptr;
    for (size_t i = 0; i < 2; ++i) {
        const int set = wants.texcoordSets[i];
        l.texcoord[i] = set >= 0 ? cornerOrVertex(mesh, std::string(names::texcoord) + (set > 0 ? std::to_string(set) : "")) : nullptr;
    }
}

SurfaceLayout makeLayout(const Mesh& mesh, const SurfaceWants& wants, const Attribute* material)
{
    SurfaceLayout l;
    findAttributes(mesh, wants, l);

    const Mesh::Triangulation& t = mesh.triangulation();
    const std::vector<uint32_t> order = sortByMaterial(mesh, material, wants.slots, l.runs);
    const bool splits =
        cornerOnly(l.normal) || cornerOnly(l.color) || cornerOnly(l.tangent) || cornerOnly(l.texcoord[0]) || cornerOnly(l.texcoord[1]);
    l.indices = t.vertices;
    if (!mesh.isTriangles()) l.triangleFace = t.faces;
    if (order.empty() && !splits) return l;

    const size_t n = t.vertices.size() / 3;
    Array<uint32_t> indices(3 * n), faces(n);
    Splitter splitter(mesh, l);
    for (size_t i = 0; i < n; ++i) {
        const size_t from = order.empty() ? i : order[i];
        faces[i] = t.faces[from];
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = t.vertices[3 * from + k];
            indices[3 * i + k] = splits ? splitter.drawn(v, t.corners[3 * from + k]) : v;
        }
    }
    l.indices = std::move(indices);
    if (!order.empty()) l.triangleFace = std::move(faces);
    if (splits) {
        l.vertexOf = std::move(splitter.vertexOf);
        l.cornerOf = std::move(splitter.cornerOf);
    }
    return l;
}

GpuKey gathered(const void* values, const SurfaceLayout& l, Use use)
{
    return {{values, l.vertexOf.id()}, use};
}

/// An attribute for each drawn vertex.
GLuint attributeBuffer(GpuCache& cache, const SurfaceLayout& l, const Attribute& a)
{
    if (l.vertexOf.empty()) {
        if (const auto* shared = std::get_if<Shared<float>>(&a.values)) return cache.buffer(*shared);
    }
    return cache.made(gathered(a.id(), l, useGatheredFloats), {ownerOf(a), l.vertexOf.owner()}, [&] {
        const Floats from(&a);
        const size_t n = l.vertexOf.empty() ? a.size() : l.vertexOf.size(), k = from.components();
        Array<float> out(n * k);
        for (size_t i = 0; i < n; ++i) {
            const size_t element = l.vertexOf.empty() ? i : a.domain == Domain::Corner ? l.cornerOf[i] : l.vertexOf[i];
            std::copy_n(from.at(element), k, out.data() + i * k);
        }
        return out;
    });
}

GLuint vectors(GpuCache& cache, const SurfaceLayout& l, const Shared<glm::vec3>& values)
{
    if (l.vertexOf.empty()) return cache.buffer(values);
    return cache.made(gathered(values.id(), l, useGathered), {values.owner(), l.vertexOf.owner()}, [&] {
        Array<glm::vec3> out(l.vertexOf.size());
        for (size_t i = 0; i < out.size(); ++i) out[i] = values[l.vertexOf[i]];
        return out;
    });
}

}  // namespace

std::shared_ptr<const void> ownerOf(const Attribute& a)
{
    return std::visit([](const auto& v) { return v.owner(); }, a.values);
}

std::shared_ptr<const SurfaceLayout> SurfaceLayouts::get(const Mesh& mesh, const SurfaceWants& wants)
{
    const Attribute* material = wants.slots > 1 ? mesh.find(names::material, Domain::Face) : nullptr;
    const auto idOf = [](const Attribute* a) { return a ? a->id() : nullptr; };
    SurfaceLayout now;
    findAttributes(mesh, wants, now);
    const std::array<const void*, 8> key{mesh.triangulation().vertices.id(),
                                         idOf(now.normal),
                                         idOf(now.color),
                                         idOf(now.tangent),
                                         idOf(now.texcoord[0]),
                                         idOf(now.texcoord[1]),
                                         idOf(material),
                                         reinterpret_cast<const void*>(wants.slots)};
    Entry& e = entries_[key];
    const bool alive = e.layout && std::none_of(e.owners.begin(), e.owners.end(), [](const auto& o) { return o.expired(); });
    if (alive) {
        // The attributes may live in another copy of the mesh now; their arrays are the same.
        auto again = std::make_shared<SurfaceLayout>(*e.layout);
        again->normal = now.normal;
        again->color = now.color;
        again->tangent = now.tangent;
        again->texcoord = now.texcoord;
        return again;
    }
    e.layout = std::make_shared<SurfaceLayout>(makeLayout(mesh, wants, material));
    e.owners = {mesh.triangulation().vertices.owner()};
    for (const Attribute* a : {now.normal, now.color, now.tangent, now.texcoord[0], now.texcoord[1], material})
        if (a) e.owners.push_back(ownerOf(*a));
    return e.layout;
}

void SurfaceLayouts::forgetDead()
{
    std::erase_if(entries_, [](const auto& e) {
        return std::any_of(e.second.owners.begin(), e.second.owners.end(), [](const auto& o) { return o.expired(); });
    });
}

SurfaceBuffers surfaceBuffers(GpuCache& cache, const Mesh& mesh, const SurfaceLayout& layout, const SurfaceWants& wants)
{
    SurfaceBuffers b;
    b.positions = vectors(cache, layout, mesh.positions());
    if (wants.normals) b.normals = layout.normal ? attributeBuffer(cache, layout, *layout.normal) : vectors(cache, layout, mesh.vertexNormals());
    if (layout.color) {
        b.colors = attributeBuffer(cache, layout, *layout.color);
        b.colorComponents = std::min(layout.color->components, 4);
        b.colorStride = 4 * layout.color->components;
    }
    if (layout.tangent) b.tangents = attributeBuffer(cache, layout, *layout.tangent);
    for (size_t i = 0; i < 2; ++i) {
        const Attribute* a = layout.texcoord[i];
        if (!a || a->components < 2) continue;
        b.texcoords[i] = attributeBuffer(cache, layout, *a);
        b.texcoordStride[i] = 4 * a->components;
    }
    b.indices = cache.buffer(layout.indices);
    b.vertices = layout.vertexOf.empty() ? mesh.vertexCount() : layout.vertexOf.size();
    return b;
}

GLuint edgeFlagTexture(GpuCache& cache, const Mesh& mesh, const SurfaceLayout& layout)
{
    if (mesh.isTriangles()) return 0;
    const GpuKey key{{layout.indices.id()}, useEdgeFlags};
    cache.made(key, {layout.indices.owner()}, [&] {
        const Mesh::Triangulation& t = mesh.triangulation();
        const size_t n = t.vertices.size() / 3;
        std::vector<size_t> firstOf(mesh.faceCount() + 1, 0);
        for (size_t i = 0; i < n; ++i)
            if (i == 0 || t.faces[i] != t.faces[i - 1]) firstOf[t.faces[i]] = i;
        Array<uint8_t> flags(n);
        for (size_t i = 0, seen = 0; i < n; ++i) {
            const uint32_t face = layout.triangleFace[i];
            seen = i > 0 && layout.triangleFace[i - 1] == face ? seen + 1 : 0;
            const size_t from = firstOf[face] + seen;
            const uint32_t start = mesh.faceStart()[face], size = mesh.faceStart()[face + 1] - start;
            uint8_t bits = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t a = t.corners[3 * from + k] - start, b = t.corners[3 * from + (k + 1) % 3] - start;
                if ((a + 1) % size == b || (b + 1) % size == a) bits |= uint8_t(1u << k);
            }
            flags[i] = bits;
        }
        return flags;
    });
    return cache.bufferTexture(key, GL_R8UI);
}

GLuint triangleFaceTexture(GpuCache& cache, const SurfaceLayout& layout)
{
    if (layout.triangleFace.empty()) return 0;
    cache.buffer(layout.triangleFace);
    return cache.bufferTexture({{layout.triangleFace.id()}, usePlain}, GL_R32UI);
}

}  // namespace mw
