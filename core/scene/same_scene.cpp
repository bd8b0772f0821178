#include "core/scene/same_scene.h"

namespace mw {
namespace {

bool same(const Node& a, const Node& b)
{
    return a.name == b.name && a.local == b.local && a.parent == b.parent && a.children == b.children && a.visible == b.visible && a.mesh == b.mesh &&
           a.skin == b.skin && a.terrain == b.terrain && a.joint == b.joint && a.morphWeights == b.morphWeights && a.extras == b.extras;
}

bool same(const Mesh& a, const Mesh& b)
{
    if (a.positions().id() != b.positions().id() || a.faceStart().id() != b.faceStart().id() || a.cornerVertex().id() != b.cornerVertex().id() ||
        a.lines().id() != b.lines().id() || a.attributes().size() != b.attributes().size() || a.groupNames() != b.groupNames())
        return false;
    for (size_t i = 0; i < a.attributes().size(); ++i) {
        const Attribute &x = a.attributes()[i], &y = b.attributes()[i];
        if (x.name != y.name || x.id() != y.id() || x.domain != y.domain || x.components != y.components) return false;
    }
    return true;
}

bool same(const MeshObject& a, const MeshObject& b)
{
    return a.name == b.name && a.materials == b.materials && a.stack == b.stack && same(a.base, b.base);
}

// The same payloads under the same ids. Those that have no quick comparison count as changed when they were set anew.
template <class Id>
bool sameAll(const Scene& a, const Scene& b, const std::vector<Id>& ids)
{
    for (const Id id : ids) {
        const auto *x = a.find(id), *y = b.find(id);
        if (x == y) continue;
        if constexpr (std::is_same_v<Id, NodeId> || std::is_same_v<Id, MeshId>) {
            if (x && y && same(*x, *y)) continue;
        }
        return false;
    }
    return true;
}

}  // namespace

bool sameScene(const Scene& a, const Scene& b)
{
    return a.roots() == b.roots() && a.nodes() == b.nodes() && a.meshes() == b.meshes() && a.materials() == b.materials() &&
           a.images() == b.images() && a.skins() == b.skins() && a.clips() == b.clips() && a.terrains() == b.terrains() && sameAll(a, b, a.nodes()) &&
           sameAll(a, b, a.meshes()) && sameAll(a, b, a.materials()) && sameAll(a, b, a.images()) && sameAll(a, b, a.skins()) &&
           sameAll(a, b, a.clips()) && sameAll(a, b, a.terrains());
}

}  // namespace mw
