// Weights by bone heat (Baran and Popovic 2007, "Automatic rigging and animation of 3D characters", section 4): (L + M H) w = M H p, where L
// is the cotangent Laplacian, M the area of each vertex, H the heat it takes from its nearest bone and p which bone that is.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/character/mannequin.h"

namespace mw {

namespace {

using glm::dvec3;

struct Bone {
    uint32_t joint;
    dvec3 a, b;
};

std::vector<Bone> bonesOf(const Skeleton& s)
{
    std::vector<dvec3> at;
    std::vector<Bone> bones;
    for (const Joint& j : s.joints) {
        at.push_back((j.parent == none ? dvec3(0) : at[j.parent]) + j.rest.translation);
        if (j.parent != none) bones.push_back({j.parent, at[j.parent], at.back()});
    }
    return bones;
}

dvec3 nearest(const Bone& bone, const dvec3& p)
{
    const dvec3 along = bone.b - bone.a;
    return bone.a + along * std::clamp(glm::dot(p - bone.a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
}

struct System {
    Eigen::SparseMatrix<double> laplacian;
    Eigen::VectorXd area;
};

/// Polygons are cut from each of their corners in turn and the cuts averaged: no diagonal is preferred, so a mirrored body has mirrored weights.
System systemOf(const Mesh& m)
{
    const auto n = Eigen::Index(m.vertexCount());
    std::vector<Eigen::Triplet<double>> entries;
    System s{{n, n}, Eigen::VectorXd::Zero(n)};
    const auto addTriangle = [&](const std::array<uint32_t, 3>& t, double share) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t i = t[k], j = t[(k + 1) % 3];
            const dvec3 o(m.positions()[t[(k + 2) % 3]]), a = dvec3(m.positions()[i]) - o, b = dvec3(m.positions()[j]) - o;
            const double twice = glm::length(glm::cross(a, b));
            const double w = share * 0.5 * std::max(glm::dot(a, b) / std::max(twice, 1e-12), 1e-3);
            entries.insert(entries.end(), {{int(i), int(i), w}, {int(j), int(j), w}, {int(i), int(j), -w}, {int(j), int(i), -w}});
            s.area[Eigen::Index(t[k])] += share * twice / 6;
        }
    };
    for (size_t f = 0; f < m.faceCount(); ++f) {
        const auto face = m.face(f);
        const size_t count = face.size();
        for (size_t k = 0; k < count; ++k)
            for (size_t i = 1; i + 1 < count; ++i) addTriangle({face[k], face[(k + i) % count], face[(k + i + 1) % count]}, 1.0 / double(count));
    }
    s.laplacian.setFromTriplets(entries.begin(), entries.end());
    return s;
}

/// The strongest four of each vertex; what is hardly felt is left out.
Mesh withWeights(const Mesh& body, const Eigen::MatrixXd& weights)
{
    Array<int32_t> joints(body.vertexCount() * 4, 0);
    Array<float> values(body.vertexCount() * 4, 0.f);
    for (size_t v = 0; v < body.vertexCount(); ++v) {
        std::vector<std::pair<double, int32_t>> strongest;
        for (Eigen::Index j = 0; j < weights.cols(); ++j)
            if (const double w = weights(Eigen::Index(v), j); w > 0.01) strongest.emplace_back(w, int32_t(j));
        std::sort(strongest.begin(), strongest.end(),
                  [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
        strongest.resize(std::min<size_t>(strongest.size(), 4));
        double sum = 0;
        for (const auto& s : strongest) sum += s.first;
        for (size_t k = 0; k < strongest.size(); ++k) {
            joints[4 * v + k] = strongest[k].second;
            values[4 * v + k] = float(strongest[k].first / sum);
        }
    }
    Attribute slots = integerAttribute(std::string(names::joints), Domain::Vertex, 4, std::move(joints));
    slots.stored = Scalar::UInt8;
    return body.with(std::move(slots)).with(floatAttribute(std::string(names::weights), Domain::Vertex, 4, std::move(values)));
}

}  // namespace

Mesh withBoneHeat(const Mesh& body, const Skeleton& skeleton)
{
    const std::vector<Bone> bones = bonesOf(skeleton);
    size_t joints = 0;
    for (const Bone& b : bones) joints = std::max<size_t>(joints, b.joint + 1);
    System system = systemOf(body);
    const auto n = Eigen::Index(body.vertexCount());
    Eigen::MatrixXd heat = Eigen::MatrixXd::Zero(n, Eigen::Index(joints));
    for (Eigen::Index v = 0; v < n; ++v) {
        const dvec3 p(body.positions()[size_t(v)]), outwards(body.vertexNormals()[size_t(v)]);
        // A bone is seen through the flesh, not through the air.
        double best = 1e9, least = 1e9;
        std::vector<std::pair<double, uint32_t>> seen;
        for (const Bone& bone : bones) {
            const dvec3 to = nearest(bone, p) - p;
            const double d = std::max(glm::length(to), 1e-3);
            least = std::min(least, d);
            if (glm::dot(to, outwards) > 0.1 * d) continue;
            seen.emplace_back(d, bone.joint);
            best = std::min(best, d);
        }
        if (seen.empty()) {
            for (const Bone& bone : bones) seen.emplace_back(std::max(glm::length(nearest(bone, p) - p), 1e-3), bone.joint);
            best = least;
        }
        double count = 0;
        for (const auto& [d, joint] : seen) count += d < best * (1 + 1e-6);
        const double taken = system.area[v] / (best * best);
        for (const auto& [d, joint] : seen)
            if (d < best * (1 + 1e-6)) heat(v, joint) += taken / count;  // equally near: shared
        system.laplacian.coeffRef(v, v) += taken;
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system.laplacian);
    return withWeights(body, solver.solve(heat));
}

}  // namespace mw
