#include "core/character/pose.h"

#include "core/math/hash.h"

namespace mw {

std::vector<glm::dmat4> worldMatrices(const Pose& p)
{
    std::vector<glm::dmat4> world(p.size());
    for (size_t i = 0; i < p.size(); ++i) {
        const uint32_t parent = p.skeleton->joints[i].parent;
        world[i] = (parent == none ? p.worldFromParent : world[parent]) * p.locals[i].matrix();
    }
    return world;
}

std::vector<glm::dvec3> jointPlaces(const Pose& p)
{
    std::vector<glm::dvec3> places;
    for (const glm::dmat4& m : worldMatrices(p)) places.emplace_back(m[3]);
    return places;
}

size_t byteSize(const Pose& p)
{
    return sizeof p + p.locals.size() * sizeof(Transform) + p.targets.size() * sizeof(PoseTarget);
}

uint64_t contentHash(const Pose& p)
{
    Hasher h;
    if (p.skeleton)
        for (const Joint& j : p.skeleton->joints) {
            h.text(j.name);
            h.number(j.parent);
            h.bytes(&j.rest, sizeof j.rest);
        }
    h.array(std::span<const Transform>(p.locals));
    h.bytes(&p.worldFromParent, sizeof p.worldFromParent);
    for (const PoseTarget& t : p.targets) {
        h.number(t.joint);
        h.bytes(&t.at, sizeof t.at);
    }
    return h.value();
}

}  // namespace mw
