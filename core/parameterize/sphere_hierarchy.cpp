// Rings are the whole connectivity: a collapse and its inverse change a few entries of them.
#include "core/parameterize/sphere_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/error.h"
#include "core/math/hash.h"
#include "core/mesh/rings.h"

namespace mw {
namespace {

constexpr size_t evenRounds = 3;   // between two levels
constexpr size_t mostValence = 8;  // of what is taken out, as long as there is anything

/// The middle of the largest circle that lies on the inner side of all great circles through two successive points. `room` is its angle, below 0
/// when there is none.
glm::dvec3 middleOfKernel(const std::vector<glm::dvec3>& ring, double& room)
{
    const size_t n = ring.size();
    std::vector<glm::dvec3> inward(n);
    for (size_t i = 0; i < n; ++i) inward[i] = glm::normalize(glm::cross(ring[i], ring[(i + 1) % n]));
    glm::dvec3 best(0);
    double least = -1;
    const auto consider = [&](const glm::dvec3& direction) {
        const double length = glm::length(direction);
        if (!(length > 1e-12)) return;
        const glm::dvec3 p = direction / length;
        double nearest = 1;
        for (size_t m = 0; m < n && nearest > least; ++m) nearest = std::min(nearest, glm::dot(p, inward[m]));
        if (nearest <= least) return;
        least = nearest;
        best = p;
    };
    // As far from three of them, or from two where the others are the same circles.
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            consider(inward[i] + inward[j]);
            for (size_t k = j + 1; k < n; ++k) {
                const glm::dvec3 p = glm::cross(inward[j] - inward[i], inward[k] - inward[i]);
                consider(glm::dot(p, inward[i]) < 0 ? -p : p);
            }
        }
    room = std::asin(std::clamp(least, -1.0, 1.0));
    return best;
}

size_t placeIn(const std::vector<uint32_t>& ring, uint32_t v)
{
    return size_t(std::find(ring.begin(), ring.end(), v) - ring.begin());
}

}  // namespace

std::vector<std::vector<uint32_t>> orderedRings(const Mesh& mesh)
{
    const Rings& rings = mesh.rings();
    std::vector<std::vector<uint32_t>> out(mesh.vertexCount());
    std::vector<std::pair<uint32_t, uint32_t>> sides;  // of the ring, one a face
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        sides.clear();
        for (const uint32_t c : rings.cornersOf(v)) {
            const uint32_t f = c - c % 3;
            sides.emplace_back(mesh.cornerVertex()[f + (c + 1) % 3], mesh.cornerVertex()[f + (c + 2) % 3]);
        }
        if (sides.empty()) continue;
        std::sort(sides.begin(), sides.end());
        uint32_t at = sides[0].first;
        for (size_t i = 0; i < sides.size(); ++i) {
            out[v].push_back(at);
            const auto next = std::lower_bound(sides.begin(), sides.end(), std::pair(at, 0u));
            if (next == sides.end() || next->first != at) throw Error("vertex " + std::to_string(v) + " has no closed ring; add Repair before it");
            at = next->second;
        }
    }
    return out;
}

double moveOnSphere(std::vector<glm::dvec3>& places, uint32_t v, std::span<const uint32_t> ring, const glm::dvec3& target, double least)
{
    const glm::dvec3 from = places[v];
    const size_t n = ring.size();
    for (double share = 1; share > 0.1; share /= 2) {
        const glm::dvec3 to = from + share * (target - from);
        const double length = glm::length(to);
        if (!(length > 1e-9)) continue;
        const glm::dvec3 place = to / length;
        bool fits = true;
        for (size_t i = 0; i < n && fits; ++i) {
            const glm::dvec3 side = glm::cross(places[ring[i]], places[ring[(i + 1) % n]]);
            const double now = glm::dot(place, side);
            fits = now >= least || (now > 0 && now >= glm::dot(from, side));
        }
        if (!fits) continue;
        places[v] = place;
        return glm::length(place - from);
    }
    return 0;
}

SphereHierarchy::SphereHierarchy(const Mesh& triangles) : rings_(orderedRings(triangles)), blocked_(rings_.size(), 0)
{
    for (const auto& ring : rings_) left_ += !ring.empty();
    places_.assign(rings_.size(), glm::dvec3(0));
    beginLevel();
}

/// Low valences first, else in an order of no meaning, so that a level is spread over the mesh.
void SphereHierarchy::beginLevel()
{
    queue_.clear();
    next_ = 0;
    ++level_;
    std::fill(blocked_.begin(), blocked_.end(), uint8_t(0));
    std::vector<std::pair<uint64_t, uint32_t>> order;
    size_t fewest = mostValence;
    for (const auto& ring : rings_)
        if (!ring.empty()) fewest = std::max(mostValence, std::min(fewest, ring.size()));
    for (uint32_t v = 0; v < rings_.size(); ++v)
        if (!rings_[v].empty() && rings_[v].size() <= fewest)
            order.emplace_back(uint64_t(rings_[v].size()) << 56 | Hasher::mix(v + 1, 0x9e3779b97f4a7c15u) >> 8, v);
    std::sort(order.begin(), order.end());
    for (const auto& [key, v] : order) queue_.push_back(v);
}

/// Into the neighbour that has the fewest edges, where the two have no common neighbours but the two beside the edge.
bool SphereHierarchy::remove(uint32_t u)
{
    std::vector<uint32_t>& ring = rings_[u];
    const size_t k = ring.size();
    size_t into = k;
    for (size_t i = 0; i < k; ++i) {
        if (into < k && rings_[ring[i]].size() >= rings_[ring[into]].size()) continue;
        const std::vector<uint32_t>& other = rings_[ring[i]];
        size_t common = 0;
        for (const uint32_t w : ring) common += std::find(other.begin(), other.end(), w) != other.end();
        if (common == 2) into = i;
    }
    if (into == k) return false;
    std::rotate(ring.begin(), ring.begin() + ptrdiff_t(into), ring.end());
    const uint32_t v = ring[0];
    // v's ring: ... w1, u, wm ... becomes ... w1, w2, ..., wm ...
    std::vector<uint32_t>& of = rings_[v];
    const auto at = of.erase(of.begin() + ptrdiff_t(placeIn(of, u)));
    of.insert(at, ring.begin() + 2, ring.end() - 1);
    for (size_t i = 2; i + 1 < k; ++i) rings_[ring[i]][placeIn(rings_[ring[i]], u)] = v;
    for (const uint32_t w : {ring[1], ring[k - 1]}) rings_[w].erase(rings_[w].begin() + ptrdiff_t(placeIn(rings_[w], u)));
    for (const uint32_t w : ring) blocked_[w] = 1;
    lastRing_ = ring;
    last_ = u;
    removed_.push_back({u, level_, std::move(ring)});
    ring = {};
    --left_;
    return true;
}

bool SphereHierarchy::removeNext()
{
    if (left_ <= 4) return false;
    for (bool fresh = false;;) {
        while (next_ < queue_.size()) {
            const uint32_t u = queue_[next_++];
            if (!blocked_[u] && remove(u)) return true;
        }
        if (fresh) throw Error("the mesh cannot be reduced to a tetrahedron; it is no sphere. Add Repair before it.");
        fresh = true;
        beginLevel();
    }
}

void SphereHierarchy::putTetrahedron()
{
    for (uint32_t v = 0; v < rings_.size(); ++v)
        if (!rings_[v].empty()) present_.push_back(v);
    const uint32_t top = present_[0];
    const double z = std::sqrt(8.0) / 3;
    places_[top] = {0, 1, 0};
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2.0943951023931953;
        places_[rings_[top][size_t(i)]] = {z * std::sin(angle), -1.0 / 3, z * std::cos(angle)};
    }
    based_ = true;
}

/// Every vertex towards the middle of its ring, faces weighted by their area: so none gets small.
bool SphereHierarchy::evenOut()
{
    constexpr size_t atOnce = 4096;
    const size_t n = present_.size();
    const double least = 1e-3 * 8 * 3.14159265358979 / (2 * double(n));
    for (size_t i = 0; i < atOnce && toEven_ > 0; ++i, --toEven_) {
        const uint32_t v = present_[(n - toEven_ % n) % n];
        const std::vector<uint32_t>& ring = rings_[v];
        glm::dvec3 sum(0);
        double weight = 0;
        for (size_t k = 0; k < ring.size(); ++k) {
            const glm::dvec3 &a = places_[ring[k]], &b = places_[ring[(k + 1) % ring.size()]];
            const double area = glm::length(glm::cross(a - places_[v], b - places_[v]));
            sum += area * (a + b + places_[v]);
            weight += 3 * area;
        }
        if (weight > 0) moveOnSphere(places_, v, ring, sum / weight, least);
    }
    return toEven_ > 0;
}

bool SphereHierarchy::insertNext()
{
    if (!based_) putTetrahedron();
    while (evenOut()) {
    }
    if (removed_.empty()) return false;
    Removal r = std::move(removed_.back());
    removed_.pop_back();
    const std::vector<uint32_t>& ring = r.ring;
    const uint32_t u = r.vertex, v = ring[0];
    const size_t k = ring.size();
    std::vector<uint32_t>& of = rings_[v];
    std::rotate(of.begin(), of.begin() + ptrdiff_t(placeIn(of, ring[1])), of.end());
    of.erase(of.begin() + 1, of.begin() + ptrdiff_t(k - 2));
    of.insert(of.begin() + 1, u);
    for (size_t i = 2; i + 1 < k; ++i) rings_[ring[i]][placeIn(rings_[ring[i]], v)] = u;
    std::vector<uint32_t>&first = rings_[ring[1]], &last = rings_[ring[k - 1]];
    first.insert(first.begin() + ptrdiff_t(placeIn(first, v)), u);
    last.insert(last.begin() + ptrdiff_t(placeIn(last, v) + 1), u);
    std::vector<glm::dvec3> places;
    for (const uint32_t w : ring) places.push_back(places_[w]);
    places_[u] = middleOfKernel(places, room_);
    if (!(room_ > 0)) throw Error("the mesh is too uneven for the sphere: no room for vertex " + std::to_string(u) + "; simplify it a little");
    rings_[u] = ring;
    lastRing_ = ring;
    last_ = u;
    present_.push_back(u);
    ++left_;
    if (removed_.empty() || removed_.back().level != r.level) toEven_ = evenRounds * present_.size();
    return true;
}

std::vector<glm::dvec3> SphereHierarchy::places() const
{
    std::vector<glm::dvec3> out = places_;
    for (size_t i = removed_.size(); i-- > 0;) out[removed_[i].vertex] = out[removed_[i].ring[0]];
    return out;
}

}  // namespace mw
