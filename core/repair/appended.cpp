#include "core/repair/appended.h"

#include <algorithm>

namespace mw {

namespace {

template <class T>
Shared<T> joined(const Shared<T>& a, const Shared<T>& b)
{
    Array<T> out(a.begin(), a.end());
    out.insert(out.end(), b.begin(), b.end());
    return out;
}

Attribute joined(const Attribute& old, const Attribute& more)
{
    Attribute out = old;
    if (const auto* f = std::get_if<Shared<float>>(&old.values)) out.values = joined(*f, std::get<Shared<float>>(more.values));
    if (const auto* d = std::get_if<Shared<double>>(&old.values)) out.values = joined(*d, std::get<Shared<double>>(more.values));
    if (const auto* i = std::get_if<Shared<int32_t>>(&old.values)) out.values = joined(*i, std::get<Shared<int32_t>>(more.values));
    return out;
}

}  // namespace

Mesh appended(const Mesh& mesh, const Addition& added)
{
    if (added.triangles.empty()) return mesh;
    Array<uint32_t> start(mesh.faceStart().begin(), mesh.faceStart().end()), corners(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    for (size_t i = 0; i < added.triangles.size(); i += 3) start.push_back(start.back() + 3);
    corners.insert(corners.end(), added.triangles.begin(), added.triangles.end());
    Mesh out(joined(mesh.positions(), Shared<glm::vec3>(added.positions)), std::move(start), std::move(corners));
    const Attribute *joints = mesh.find(names::joints, Domain::Vertex), *weights = mesh.find(names::weights, Domain::Vertex);
    const bool skinned = joints && weights && joints->integral() && joints->components == weights->components;
    for (const Attribute& a : mesh.attributes()) {
        if (skinned && (&a == joints || &a == weights)) continue;
        const Attribute more = a.domain == Domain::Vertex   ? blended(a, added.vertices)
                               : a.domain == Domain::Corner ? blended(a, added.corners)
                                                            : gathered(a, added.faceFrom);
        out = out.with(joined(a, more));
    }
    if (skinned) {
        const SkinWeights more = blendedSkin(*joints, *weights, added.vertices);
        out = out.with(joined(*joints, more.joints)).with(joined(*weights, more.weights));
    }
    return out.withLines(mesh.lines()).withGroupNames(mesh.groupNames());
}

}  // namespace mw
