#include "core/morph/domain_mesh.h"

#include <algorithm>
#include <numbers>

#include "core/error.h"

namespace mw {

DomainMesh::DomainMesh(std::vector<Direction> places, std::vector<uint32_t> triangles)
    : places_(std::move(places)), corners_(std::move(triangles)), opposite_(corners_.size(), none), edge_(corners_.size(), none)
{
    outStart_.assign(places_.size() + 1, 0);
    for (const uint32_t v : corners_) ++outStart_[v + 1];
    for (size_t v = 0; v < places_.size(); ++v) outStart_[v + 1] += outStart_[v];
    out_.resize(corners_.size());
    std::vector<uint32_t> fill(outStart_.begin(), outStart_.end() - 1);
    for (uint32_t h = 0; h < corners_.size(); ++h) out_[fill[corners_[h]]++] = h;
    for (uint32_t h = 0; h < corners_.size(); ++h) {
        if (edge_[h] != none) continue;
        uint32_t back = none, same = 0;
        for (const uint32_t g : outgoing(to(h)))
            if (to(g) == from(h)) back = back == none ? g : none - 1;
        for (const uint32_t g : outgoing(from(h))) same += to(g) == to(h);
        if (same > 1 || back == none - 1)
            throw Error("the edge between vertices " + std::to_string(from(h)) + " and " + std::to_string(to(h)) +
                        " belongs to more than two faces; repair the mesh first");
        edge_[h] = uint32_t(edgeHalf_.size());
        edgeHalf_.push_back(h);
        if (back == none) continue;
        edge_[back] = edge_[h];
        opposite_[h] = back;
        opposite_[back] = h;
    }
}

std::vector<uint32_t> DomainMesh::folds() const
{
    std::vector<uint32_t> out;
    for (uint32_t f = 0; f < triangles(); ++f)
        if (side(at(corners_[3 * f]), at(corners_[3 * f + 1]), at(corners_[3 * f + 2])) <= 0) out.push_back(f);
    return out;
}

double DomainMesh::coverings() const
{
    double sum = 0;
    for (uint32_t f = 0; f < triangles(); ++f) {
        const glm::dvec3 a = at(corners_[3 * f]).point(), b = at(corners_[3 * f + 1]).point(), c = at(corners_[3 * f + 2]).point();
        const double triple = glm::dot(a, glm::cross(b, c));
        sum += 2 * std::atan2(triple, 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));  // van Oosterom and Strackee
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace mw
