#include "core/character/skin.h"

#include "core/math/hash.h"

namespace mw {

uint64_t contentHash(const Skin& s)
{
    Hasher h;
    h.text(s.name);
    h.array(std::span<const NodeId>(s.joints));
    h.array(std::span<const glm::dmat4>(s.inverseBind));
    h.number(s.skeleton.value);
    return h.value();
}

}  // namespace mw
