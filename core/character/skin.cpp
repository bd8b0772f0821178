#include "core/character/skin.h"

#include <cmath>
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
/// True when any does.
bool addMorphs(const Mesh& mesh, const MeshPose& pose, const std::string& prefix, Domain domain, std::span<float> to)
{
    size_t target = 0;
    bool any = false;
    for (const Attribute& a : mesh.attributes()) {
        if (a.domain != Domain::Vertex || !a.name.starts_with(names::morph)) continue;
        const float weight = target < pose.morphWeights.size() ? pose.morphWeights[target] : 0.f;
        ++target;
        if (weight == 0) continue;
        const Attribute* moved = mesh.find(prefix + a.name.substr(names::morph.size()), domain);
        if (!moved || moved->floats().size() != to.size()) continue;
        const float* d = moved->floats().data();
        inParallel(to.size(), [&](size_t i) { to[i] += weight * d[i]; });
        any = true;
    }
    return any;
}

/// Four floats that the processor treats as one: a column of a matrix.
typedef float Column __attribute__((vector_size(16)));

Column scaled(const Column& c, float k)
{
    return c * Column{k, k, k, k};
}

/// v' = x v.x + y v.y + z v.z + at.
struct Move {
    Column x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0}, at{0, 0, 0, 1};
    Column direction(const float* v) const { return scaled(x, v[0]) + scaled(y, v[1]) + scaled(z, v[2]); }
};

Move moveOf(const glm::mat4& m)
{
    const auto column = [&](int i) { return Column{m[i][0], m[i][1], m[i][2], m[i][3]}; };
    return Move{column(0), column(1), column(2), column(3)};
}

Column cross(const Column& a, const Column& b)
{
    return Column{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0};
}

/// The inverse transpose but for a positive factor; there is one also where the inverse is not (a joint scaled flat).
Move forNormals(const Move& m)
{
    Move n{cross(m.y, m.z), cross(m.z, m.x), cross(m.x, m.y), Column{}};
    if (m.x[0] * n.x[0] + m.x[1] * n.x[1] + m.x[2] * n.x[2] < 0) n = Move{-n.x, -n.y, -n.z, n.at};
    return n;
}

/// Blended matrices, a vertex at a time.
class Blend {
public:
    Blend(const Mesh& mesh, const MeshPose& pose)
    {
        const Attribute *joints = mesh.find(names::joints, Domain::Vertex), *weights = mesh.find(names::weights, Domain::Vertex);
        if (!joints || !weights || joints->components != weights->components) return;
        joints_ = joints->integers();
        weights_ = weights->floats();
        slots_ = size_t(joints->components);
        if (!joints_.empty() && !weights_.empty())
            for (const glm::mat4& m : pose.joints) moves_.push_back(moveOf(m));
    }
    explicit operator bool() const { return !moves_.empty(); }

    Move at(size_t vertex) const
    {
        const int32_t* j = joints_.data() + vertex * slots_;
        const float* w = weights_.data() + vertex * slots_;
        Move sum{Column{}, Column{}, Column{}, Column{}};
        bool any = false;
        for (size_t i = 0; i < slots_; ++i) {
            if (w[i] == 0) continue;
            any = true;
            const Move& m = size_t(j[i]) < moves_.size() ? moves_[size_t(j[i])] : still_;
            sum.x += scaled(m.x, w[i]);
            sum.y += scaled(m.y, w[i]);
            sum.z += scaled(m.z, w[i]);
            sum.at += scaled(m.at, w[i]);
        }
        return any ? sum : still_;
    }

private:
    std::span<const int32_t> joints_;
    std::span<const float> weights_;
    size_t slots_ = 0;
    std::vector<Move> moves_;
    const Move still_;
};

/// Directions stay unit; one that vanishes stays as it was.
inline void turn(float* v, const Move& m)
{
    const Column d = m.direction(v);
    const Column squares = d * d;
    const float square = squares[0] + squares[1] + squares[2];
    if (!(square > 0)) return;
    const Column unit = scaled(d, 1 / std::sqrt(square));
    for (int i = 0; i < 3; ++i) v[i] = unit[i];
}

/// Normals and tangents, at vertices or corners: morphed (normals), then turned by the matrix of their vertex.
Attribute turned(const Mesh& mesh, const Attribute& a, const MeshPose& pose, const Blend& blend)
{
    const bool normal = a.name == names::normal;
    Array<float> values(a.floats().begin(), a.floats().end());
    if (normal) addMorphs(mesh, pose, "morph-normal:", a.domain, values);
    const size_t k = size_t(a.components);
    const auto moveAt = [&](size_t v) {
        const Move m = blend.at(v);
        return normal ? forNormals(m) : m;
    };
    if (!blend) {
        inParallel(a.size(), [&, still = Move()](size_t i) { turn(&values[i * k], still); });
    } else if (a.domain == Domain::Vertex) {
        inParallel(a.size(), [&](size_t v) { turn(&values[v * k], moveAt(v)); });
    } else {
        Array<Move> moves(mesh.vertexCount());  // a vertex has several corners
        inParallel(moves.size(), [&](size_t v) { moves[v] = moveAt(v); });
        inParallel(a.size(), [&](size_t c) { turn(&values[c * k], moves[mesh.cornerVertex()[c]]); });
    }
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

namespace {

Shared<glm::vec3> moved(const Mesh& rest, const MeshPose& pose, const Blend& blend)
{
    Array<glm::vec3> positions(rest.positions().begin(), rest.positions().end());
    if (!positions.empty()) addMorphs(rest, pose, std::string(names::morph), Domain::Vertex, {&positions[0].x, 3 * positions.size()});
    if (blend)
        inParallel(positions.size(), [&](size_t v) {
            const Move m = blend.at(v);
            const Column p = m.direction(&positions[v].x) + m.at;
            positions[v] = {p[0], p[1], p[2]};
        });
    return positions;
}

}  // namespace

Shared<glm::vec3> posedPositions(const Mesh& rest, const MeshPose& pose)
{
    return moved(rest, pose, Blend(rest, pose));
}

std::optional<Attribute> posedColor(const Mesh& rest, const MeshPose& pose)
{
    const Attribute* color = rest.find(names::color, Domain::Corner);
    if (!color) color = rest.find(names::color, Domain::Vertex);
    if (!color || color->floats().empty() || pose.morphWeights.empty()) return {};
    Array<float> values(color->floats().begin(), color->floats().end());
    if (!addMorphs(rest, pose, "morph-color:", color->domain, values)) return {};
    for (float& v : values) v = std::clamp(v, 0.f, 1.f);
    return floatAttribute(color->name, color->domain, color->components, std::move(values));
}

Mesh posed(const Mesh& rest, const MeshPose& pose)
{
    const Blend blend(rest, pose);
    Mesh out = rest.withPositions(moved(rest, pose, blend));
    for (const Attribute& a : rest.attributes())
        if (isTurned(a)) out = out.with(turned(rest, a, pose, blend));
    if (std::optional<Attribute> color = posedColor(rest, pose)) out = out.with(std::move(*color));
    return out;
}

}  // namespace mw
