#include "core/io/corner_values.h"

#include <algorithm>
#include <bit>

namespace mw {

Attribute atCorners(const Attribute& a, const Mesh& mesh)
{
    Array<uint32_t> faces;
    if (a.domain == Domain::Face) {
        faces.resize(mesh.cornerCount());
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) std::fill(faces.begin() + mesh.faceStart()[f], faces.begin() + mesh.faceStart()[f + 1], f);
    }
    Attribute c = gathered(a, a.domain == Domain::Face ? std::span<const uint32_t>(faces) : mesh.cornerVertex().span());
    c.domain = Domain::Corner;
    return c;
}

std::optional<Attribute> gatheredIfEqual(const Attribute& a, const Mesh& mesh, Domain domain)
{
    Array<uint32_t> corner(mesh.count(domain), none);
    const auto equal = [&](size_t c, size_t d) {
        for (int k = 0; k < a.components; ++k)
            if (std::bit_cast<uint64_t>(a.at(c, k)) != std::bit_cast<uint64_t>(a.at(d, k))) return false;
        return true;
    };
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
            uint32_t& at = corner[domain == Domain::Vertex ? mesh.cornerVertex()[c] : f];
            if (at == none)
                at = c;
            else if (!equal(at, c))
                return {};
        }
    std::replace(corner.begin(), corner.end(), none, 0u);
    Attribute out = gathered(a, corner);
    out.domain = domain;
    return out;
}

}  // namespace mw
