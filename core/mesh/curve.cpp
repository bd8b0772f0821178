#include "core/mesh/curve.h"

#include "core/math/hash.h"

namespace mw {

size_t byteSize(const Curve& c)
{
    return sizeof c + (c.points.size() + c.control.size()) * sizeof(glm::dvec3);
}

uint64_t contentHash(const Curve& c)
{
    Hasher h;
    h.array(std::span<const glm::dvec3>(c.points));
    h.array(std::span<const glm::dvec3>(c.control));
    h.number(c.closed);
    return h.value();
}

}  // namespace mw
