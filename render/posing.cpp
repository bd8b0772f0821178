#include "render/posing.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/error.h"

namespace mw {
namespace {

constexpr uint64_t unusedFrames = 8;
constexpr size_t keptPlaces = 16, keptReaches = 64;
constexpr GLenum makingUnit = GL_TEXTURE0 + 15;  // as in the cache: no texture a pass has bound is pushed out
enum Use : uint64_t { useSlots = 300, useWeights };

/// As ids and stroke of resources/shaders/object.glsl; the rest of the block is not read.
struct PoseBlock {
    glm::mat4 unusedMatrices[3];
    glm::vec4 unused[5], stroke{0};
    glm::ivec4 ids{0};
};

struct SkinArrays {
    const Attribute *joints = nullptr, *weights = nullptr;
    explicit operator bool() const { return joints != nullptr; }
};

SkinArrays skinOf(const DrawObject& o)
{
    const Attribute *j = o.mesh.find(names::joints, Domain::Vertex), *w = o.mesh.find(names::weights, Domain::Vertex);
    if (!o.pose || o.pose->joints.empty() || !j || !w || j->components != w->components || j->integers().empty() || w->floats().empty()) return {};
    return {j, w};
}

std::vector<const Attribute*> targetsOf(const Mesh& mesh)
{
    std::vector<const Attribute*> all;
    for (const Attribute& a : mesh.attributes())
        if (a.domain == Domain::Vertex && a.name.starts_with(names::morph)) all.push_back(&a);
    return all;
}

bool usable(const Attribute* a, size_t elements)
{
    return a && a->components == 3 && a->floats().size() == 3 * elements;
}

/// Targets whose weight is not 0, as the shader wants them.
std::vector<glm::vec4> targetsInUse(const DrawObject& o)
{
    std::vector<glm::vec4> used;
    const std::vector<const Attribute*> targets = targetsOf(o.mesh);
    const size_t n = std::min(targets.size(), o.pose->morphWeights.size());
    for (size_t i = 0; i < n; ++i)
        if (o.pose->morphWeights[i] != 0) used.emplace_back(o.pose->morphWeights[i], float(i), 0, 0);
    return used;
}

/// Four numbers a texel: lists that are not multiples of four are filled up with zeros.
template <class T>
GLuint slotTexture(GpuCache& cache, const Attribute& a, Use use, GLenum format)
{
    const auto& values = std::get<Shared<T>>(a.values);
    const size_t n = a.size(), have = size_t(a.components), want = (have + 3) / 4 * 4;
    if (have == want) {
        cache.buffer(values);
        return cache.bufferTexture({{values.id()}, 0}, format);
    }
    const GpuKey key{{values.id()}, use};
    cache.made(key, {values.owner()}, [&] {
        Array<T> filled(n * want, T(0));
        for (size_t i = 0; i < n; ++i) std::copy_n(values.data() + i * have, have, filled.data() + i * want);
        return filled;
    });
    return cache.bufferTexture(key, format);
}

void bindBufferTexture(TextureUnit unit, GLuint texture)
{
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture);
}

void makeBufferTexture(gl::Texture& texture, gl::Buffer& buffer, GLenum format)
{
    if (texture) return;
    glActiveTexture(makingUnit);
    glBindTexture(GL_TEXTURE_BUFFER, texture.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
}

void integerAttribute(GLuint location, GLuint buffer)
{
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(location);
    glVertexAttribIPointer(location, 1, GL_UNSIGNED_INT, 0, nullptr);
}

/// The program and vertex array of whoever draws, put back at the end.
class Kept {
public:
    Kept()
    {
        glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, objectBlock, &block_);
    }
    ~Kept()
    {
        glUseProgram(GLuint(program_));
        glBindVertexArray(GLuint(vertexArray_));
        glBindBufferBase(GL_UNIFORM_BUFFER, objectBlock, GLuint(block_));
    }
    Kept(const Kept&) = delete;

private:
    GLint program_ = 0, vertexArray_ = 0, block_ = 0;
};

}  // namespace

bool operator==(const MeshPose& a, const MeshPose& b)
{
    return a.joints == b.joints && a.morphWeights == b.morphWeights;
}

void Posing::beginFrame()
{
    ++frame_;
    std::erase_if(captured_, [&](const auto& e) { return e.second.lastUse + unusedFrames < frame_; });
    std::erase_if(deltas_, [&](const Deltas& d) { return d.lastUse + unusedFrames < frame_; });
    std::erase_if(placed_, [](const Placed& p) { return p.rest.expired(); });
}

Posing::Deltas& Posing::deltas(GpuCache& cache, const Mesh& mesh, bool normals, Domain domain)
{
    const std::vector<const Attribute*> targets = targetsOf(mesh);
    std::vector<const Attribute*> moved;
    for (const Attribute* t : targets) moved.push_back(normals ? mesh.find("morph-normal:" + t->name.substr(names::morph.size()), domain) : t);
    std::vector<const void*> arrays;
    for (const Attribute* a : moved) arrays.push_back(a ? a->id() : nullptr);
    for (Deltas& d : deltas_) {
        const bool alive = std::none_of(d.owners.begin(), d.owners.end(), [](const auto& o) { return o.expired(); });
        if (d.arrays != arrays || !alive) continue;
        d.lastUse = frame_;
        return d;
    }
    Deltas& d = deltas_.emplace_back();
    d.arrays = std::move(arrays);
    d.elements = mesh.count(domain);
    d.lastUse = frame_;
    std::vector<float> all(3 * d.elements * targets.size(), 0.f);
    for (size_t i = 0; i < moved.size(); ++i) {
        if (moved[i]) d.owners.emplace_back(ownerOf(*moved[i]));
        if (usable(moved[i], d.elements)) std::copy_n(moved[i]->floats().data(), 3 * d.elements, all.data() + 3 * d.elements * i);
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, d.buffer.id());
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(all.size() * sizeof(float)), all.data(), GL_STATIC_DRAW);
    makeBufferTexture(d.texture, d.buffer, GL_RGB32F);
    cache.countUpload(all.size() * sizeof(float));
    return d;
}

Posing::Buffers Posing::captured(GpuCache& cache, Programs& programs, const DrawObject& o, const SurfaceLayout& layout, const SurfaceBuffers& rest)
{
    if (!o.pose || rest.vertices == 0) return {rest.positions, rest.normals};
    const Key key{reinterpret_cast<const void*>(uintptr_t(o.node.value)), o.mesh.positions().id(), layout.vertexOf.id(),
                  reinterpret_cast<const void*>(uintptr_t(rest.normals))};
    Captured& c = captured_[key];
    c.lastUse = frame_;
    // The same arrays: their owners are the same, too, however often an address was used.
    const bool same = c.positions && c.rest.lock() == o.mesh.positions().owner() && c.layout.lock() == layout.vertexOf.owner() && c.pose == *o.pose;
    if (!same) {
        capture(cache, programs, o, layout, rest, c);
        c.rest = o.mesh.positions().owner();
        c.layout = layout.vertexOf.owner();
        c.pose = *o.pose;
    }
    return {c.positions.get(), rest.normals ? c.normals.get() : 0};
}

void Posing::capture(GpuCache& cache, Programs& programs, const DrawObject& o, const SurfaceLayout& layout, const SurfaceBuffers& rest, Captured& to)
{
    const SkinArrays skin = skinOf(o);
    std::vector<glm::vec4> data = targetsInUse(o);
    PoseBlock block;
    block.ids.y = int(data.size());
    block.ids.z = int(o.mesh.vertexCount());
    unsigned variant = layout.vertexOf.empty() ? 0 : variant::poseSplit;
    const Kept kept;
    if (block.ids.y > 0) {
        variant |= variant::poseMorphed;
        bindBufferTexture(morphUnit, deltas(cache, o.mesh, false, Domain::Vertex).texture.get());
        if (layout.normal) {
            const Deltas& d = deltas(cache, o.mesh, true, layout.normal->domain);
            const bool any = std::any_of(d.arrays.begin(), d.arrays.end(), [](const void* a) { return a != nullptr; });
            block.ids.w = any ? int(d.elements) : 0;
            block.stroke.x = layout.normal->domain == Domain::Corner ? 1.f : 0.f;
            bindBufferTexture(morphNormalUnit, d.texture.get());
        }
    }
    if (skin) {
        variant |= variant::poseSkinned;
        block.ids.x = (skin.joints->components + 3) / 4;
        bindBufferTexture(jointSlotUnit, slotTexture<int32_t>(cache, *skin.joints, useSlots, GL_RGBA32I));
        bindBufferTexture(jointWeightUnit, slotTexture<float>(cache, *skin.weights, useWeights, GL_RGBA32F));
        for (const glm::mat4& m : o.pose->joints)
            for (int row = 0; row < 3; ++row) data.emplace_back(m[0][row], m[1][row], m[2][row], m[3][row]);
    }
    if (data.empty()) data.emplace_back(0);
    gl::stream(to.data, std::span<const glm::vec4>(data), GL_COPY_WRITE_BUFFER);
    makeBufferTexture(to.dataTexture, to.data, GL_RGBA32F);
    cache.countUpload(data.size() * sizeof(glm::vec4));
    bindBufferTexture(poseDataUnit, to.dataTexture.get());

    glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, objectBlock, block_.get());
    glBindVertexArray(vertexArray_.id());
    for (GLuint i = 0; i < 4; ++i) glDisableVertexAttribArray(i);
    gl::attribute({0, rest.positions});
    if (rest.normals) gl::attribute({1, rest.normals});
    if (variant & variant::poseSplit) {
        integerAttribute(2, cache.buffer(layout.vertexOf));
        integerAttribute(3, cache.buffer(layout.cornerOf));
    }
    const GLsizeiptr bytes = GLsizeiptr(rest.vertices * sizeof(glm::vec3));
    const auto room = [&](gl::Buffer& buffer, GLuint index) {
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id());
        glBufferData(GL_COPY_WRITE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, index, buffer.get());
    };
    room(to.positions, 0);
    if (rest.normals) room(to.normals, 1);
    glUseProgram(programs.get(rest.normals ? ProgramId::PoseNormals : ProgramId::Pose, variant));
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, GLsizei(rest.vertices));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    for (const GLuint index : {0u, 1u}) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, index, 0);
}

Shared<glm::vec3> Posing::places(const DrawObject& o)
{
    if (!o.pose) return o.mesh.positions();
    for (auto i = placed_.begin(); i != placed_.end(); ++i) {
        if (i->id != o.mesh.positions().id() || i->rest.lock() != o.mesh.positions().owner() || !(i->pose == *o.pose)) continue;
        placed_.splice(placed_.begin(), placed_, i);
        return i->places;
    }
    placed_.push_front({o.mesh.positions().owner(), o.mesh.positions().id(), *o.pose, posedPositions(o.mesh, *o.pose)});
    if (placed_.size() > keptPlaces) placed_.pop_back();
    return placed_.front().places;
}

namespace {

/// Boxes at rest of what each joint moves, and how far each morph target goes.
struct Reach {
    std::vector<Bounds> joints;
    Bounds still;  ///< what no joint moves
    std::vector<Bounds> targets;
};

Reach reachOf(const DrawObject& o)
{
    Reach r;
    const Shared<glm::vec3>& p = o.mesh.positions();
    const SkinArrays skin = skinOf(o);
    r.joints.resize(o.pose->joints.size());
    const size_t k = skin ? size_t(skin.joints->components) : 0;
    for (size_t v = 0; v < p.size(); ++v) {
        bool any = false;
        for (size_t i = 0; i < k; ++i) {
            if (skin.weights->floats()[v * k + i] == 0) continue;
            const size_t slot = size_t(skin.joints->integers()[v * k + i]);
            if (slot >= r.joints.size()) continue;
            r.joints[slot].add(glm::dvec3(p[v]));
            any = true;
        }
        if (!any) r.still.add(glm::dvec3(p[v]));
    }
    for (const Attribute* a : targetsOf(o.mesh)) {
        Bounds& b = r.targets.emplace_back();
        if (!usable(a, p.size())) continue;
        const float* d = a->floats().data();
        for (size_t v = 0; v < p.size(); ++v) b.add(glm::dvec3(d[3 * v], d[3 * v + 1], d[3 * v + 2]));
    }
    return r;
}

/// Kept by the arrays they are made of: every frame asks.
std::shared_ptr<const Reach> keptReach(const DrawObject& o)
{
    struct Entry {
        std::vector<const void*> arrays;
        std::weak_ptr<const void> owner;
        std::shared_ptr<const Reach> reach;
    };
    static std::mutex mutex;
    static std::list<Entry> kept;
    std::vector<const void*> arrays{o.mesh.positions().id(), reinterpret_cast<const void*>(o.pose->joints.size())};
    if (const SkinArrays skin = skinOf(o)) arrays.insert(arrays.end(), {skin.joints->id(), skin.weights->id()});
    for (const Attribute* a : targetsOf(o.mesh)) arrays.push_back(a->id());
    const std::lock_guard lock(mutex);
    std::erase_if(kept, [](const Entry& e) { return e.owner.expired(); });
    for (const Entry& e : kept)
        if (e.arrays == arrays) return e.reach;
    kept.push_front({std::move(arrays), o.mesh.positions().owner(), std::make_shared<Reach>(reachOf(o))});
    if (kept.size() > keptReaches) kept.pop_back();
    return kept.front().reach;
}

void addMoved(Bounds& to, const Bounds& box, const glm::dmat4& m)
{
    if (box.empty) return;
    const glm::dvec3 centre(m * glm::dvec4(box.centre(), 1)), half = 0.5 * box.size();
    glm::dvec3 reach(0);
    for (int i = 0; i < 3; ++i) reach += glm::abs(glm::dvec3(m[i])) * half[i];
    to.add(centre - reach);
    to.add(centre + reach);
}

}  // namespace

Bounds worldBounds(const DrawObject& o)
{
    Bounds world;
    if (!o.pose) {
        addMoved(world, o.mesh.bounds(), o.worldFromLocal);
        return world;
    }
    if (o.mesh.vertexCount() == 0) return world;
    const std::shared_ptr<const Reach> reach = keptReach(o);
    glm::dvec3 low(0), high(0);
    for (size_t i = 0; i < std::min(reach->targets.size(), o.pose->morphWeights.size()); ++i) {
        if (reach->targets[i].empty) continue;
        const double w = o.pose->morphWeights[i];
        low += glm::min(w * reach->targets[i].min, w * reach->targets[i].max);
        high += glm::max(w * reach->targets[i].min, w * reach->targets[i].max);
    }
    const auto morphed = [&](Bounds b) {
        b.min += low;
        b.max += high;
        return b;
    };
    for (size_t i = 0; i < reach->joints.size(); ++i) addMoved(world, morphed(reach->joints[i]), o.worldFromLocal * glm::dmat4(o.pose->joints[i]));
    addMoved(world, morphed(reach->still), o.worldFromLocal);
    return world;
}

}  // namespace mw
