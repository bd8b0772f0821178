#include "core/character/skin.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/math/hash.h"

namespace mw {

namespace {

constexpr size_t grain = 4096;

template <class Body>
void inParallel(size_t n, const Body& body)
{
    tbb::parallel_for(tbb::blocked_range<size_t>(0, n, grain), [&](const tbb::blocked_range<size_t>& r) {
        for (size_t i = r.begin(); i != r.end(); ++i) body(i);
    });
}

/// to += sum of weight times displacement over the attributes PREFIX + NAME of the targets that count.
void addMorphs(const Mesh& mesh, const MeshPose& pose, const std::string& prefix, Domain domain, std::span<float> to)
{
    size_t target = 0;
    for (const Attribute& a : mesh.attributes()) {
        if (a.domain != Domain::Vertex || !a.name.starts_with(names::morph)) continue;
        const float weight = target < pose.morphWeights.size() ? pose.morphWeights[target] : 0.f;
        ++target;
        if (weight == 0) continue;
        const Attribute* moved = mesh.find(prefix + a.name.substr(names::morph.size()), domain);
        if (!moved || moved->components != 3 || moved->floats().size() != to.size()) continue;
        const float* d = moved->floats().data();
        inParallel(to.size(), [&](size_t i) { to[i] += weight * d[i]; });
    }
}

/// Blended matrices, a vertex at a time.
class Blend {
public:
    Blend(const Mesh& mesh, const MeshPose& pose) : pose_(pose)
    {
        joints_ = mesh.find(names::joints, Domain::Vertex);
        weights_ = mesh.find(names::weights, Domain::Vertex);
        if (!joints_ || !weights_ || joints_->components != weights_->components || joints_->integers().empty() || weights_->floats().empty())
            joints_ = weights_ = nullptr;
    }
    explicit operator bool() const { return joints_ && !pose_.joints.empty(); }

    glm::mat4 at(size_t vertex) const
    {
        const size_t k = size_t(joints_->components);
        const int32_t* j = joints_->integers().data() + vertex * k;
        const float* w = weights_->floats().data() + vertex * k;
        glm::mat4 sum(0.f);
        bool any = false;
        for (size_t i = 0; i < k; ++i) {
            if (w[i] == 0) continue;
            any = true;
            sum += w[i] * (size_t(j[i]) < pose_.joints.size() ? pose_.joints[size_t(j[i])] : glm::mat4(1.f));
        }
        return any ? sum : glm::mat4(1.f);
    }

private:
    const MeshPose& pose_;
    const Attribute *joints_ = nullptr, *weights_ = nullptr;
};

/// The inverse transpose but for a positive factor; there is one also where the inverse is not (a joint scaled flat).
glm::mat3 normalMatrix(const glm::mat4& m)
{
    const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(x, cofactors[0]) < 0 ? -cofactors : cofactors;
}

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise)
{
    const float length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

void turn(float* v, const glm::mat3& m)
{
    const glm::vec3 old(v[0], v[1], v[2]), now = unitOr(m * old, old);
    for (int i = 0; i < 3; ++i) v[i] = now[i];
}

/// Normals and tangents, at vertices or corners: morphed (normals), then turned by the matrix of their vertex.
Attribute turned(const Mesh& mesh, const Attribute& a, const MeshPose& pose, const Blend& blend)
{
    const bool normal = a.name == names::normal;
    Array<float> values(a.floats().begin(), a.floats().end());
    if (normal) addMorphs(mesh, pose, "morph-normal:", a.domain, values);
    const size_t k = size_t(a.components);
    inParallel(a.size(), [&](size_t i) {
        glm::mat3 m(1.f);
        if (blend) {
            const glm::mat4 b = blend.at(a.domain == Domain::Vertex ? i : mesh.cornerVertex()[i]);
            m = normal ? normalMatrix(b) : glm::mat3(b);
        }
        turn(&values[i * k], m);
    });
    Attribute out = a;
    out.values = Shared<float>(std::move(values));
    return out;
}

bool isTurned(const Attribute& a)
{
    const bool direction = (a.name == names::normal && a.components == 3) || (a.name == names::tangent && a.components == 4);
    return direction && a.domain != Domain::Face && !a.floats().empty();
}

}  // namespace

uint64_t contentHash(const Skin& s)
{
    Hasher h;
    h.text(s.name);
    h.array(std::span<const NodeId>(s.joints));
    h.array(std::span<const glm::dmat4>(s.inverseBind));
    h.number(s.skeleton.value);
    return h.value();
}

Mesh posed(const Mesh& rest, const MeshPose& pose)
{
    Array<glm::vec3> positions(rest.positions().begin(), rest.positions().end());
    if (!positions.empty()) addMorphs(rest, pose, std::string(names::morph), Domain::Vertex, {&positions[0].x, 3 * positions.size()});
    const Blend blend(rest, pose);
    if (blend) inParallel(positions.size(), [&](size_t v) { positions[v] = glm::vec3(blend.at(v) * glm::vec4(positions[v], 1.f)); });
    Mesh out = rest.withPositions(std::move(positions));
    for (const Attribute& a : rest.attributes())
        if (isTurned(a)) out = out.with(turned(rest, a, pose, blend));
    return out;
}

}  // namespace mw
