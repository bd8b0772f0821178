// The three rules.
#include "core/subdivide/butterfly_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mw {

namespace {

constexpr uint32_t next(uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

constexpr uint32_t previous(uint32_t corner)
{
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// Of neighbour j of k round an extraordinary vertex; the vertex itself has 3/4.
double ringWeight(size_t j, size_t k)
{
    if (k == 3) return j == 0 ? 5.0 / 12 : -1.0 / 12;
    if (k == 4) return j == 0 ? 3.0 / 8 : j == 2 ? -1.0 / 8 : 0;
    const double angle = 2 * std::numbers::pi * double(j) / double(k);
    return (0.25 + std::cos(angle) + 0.5 * std::cos(2 * angle)) / double(k);
}

}  // namespace

ButterflyRows::ButterflyRows(const LoopLevel& level, double w, bool modified)
    : level_(level),
      w_(w),
      modified_(modified),
      cornerOf_(2 * level.edges.size(), none),
      valence_(level.vertices, 6),
      sharp_(level.edges.size(), 0),
      onSharp_(level.vertices, 0),
      along_(level.vertices, 0)
{
    for (uint32_t c = 0; c < level.half.size(); ++c) cornerOf_[level.half[c]] = c;
    for (const auto& [v, n] : level.irregular) valence_[v] = n;
    for (const SharpEdge& s : level.sharp) {
        if (s.sharpness != alwaysSharp) continue;
        sharp_[s.edge] = 1;
        const LoopLevel::Edge& k = level.edges[s.edge];
        along_[k.a] += k.b, along_[k.b] += k.a;
        for (const uint32_t v : {k.a, k.b}) onSharp_[v] = uint8_t(std::min(onSharp_[v] + 1, 3));
    }
}

bool ButterflyRows::extraordinary(uint32_t v) const
{
    return modified_ && onSharp_[v] == 0 && valence_[v] != 6 && valence_[v] >= 3;
}

ButterflyRule ButterflyRows::row(uint32_t e, std::vector<Term>& terms) const
{
    const LoopLevel::Edge& k = level_.edges[e];
    terms.clear();
    if (sharp_[e]) {
        border(e, terms);
        return ButterflyRule::Border;
    }
    const bool a = extraordinary(k.a), b = extraordinary(k.b);
    if (!a && !b) {
        wings(e, terms);
        return ButterflyRule::Regular;
    }
    terms = {{k.a, 0}, {k.b, 0}};
    if (a) ring(2 * e, b ? 0.5 : 1, terms);
    if (b) ring(2 * e + 1, a ? 0.5 : 1, terms);
    return ButterflyRule::Extraordinary;
}

void ButterflyRows::border(uint32_t e, std::vector<Term>& terms) const
{
    const LoopLevel::Edge& k = level_.edges[e];
    terms = {{k.a, 9.0 / 16}, {k.b, 9.0 / 16}};
    const auto beyond = [&](uint32_t v, uint32_t other, size_t own) {
        if (onSharp_[v] == 2) {
            terms.push_back({along_[v] - other, -1.0 / 16});
        } else {  // the line goes on as its reflection
            terms[own].weight -= 2.0 / 16;
            terms[1 - own].weight += 1.0 / 16;
        }
    };
    beyond(k.a, k.b, 0);
    beyond(k.b, k.a, 1);
}

void ButterflyRows::wings(uint32_t e, std::vector<Term>& terms) const
{
    const LoopLevel::Edge& k = level_.edges[e];
    terms = {{k.a, 0.5}, {k.b, 0.5}, {k.c, 2 * w_}, {k.d, 2 * w_}};
    for (const uint32_t half : {2 * e, 2 * e + 1}) {
        const uint32_t corner = cornerOf_[half];
        addWing(next(corner), level_.vertex[corner], terms);
        addWing(previous(corner), level_.vertex[next(corner)], terms);
    }
}

void ButterflyRows::addWing(uint32_t corner, uint32_t away, std::vector<Term>& terms) const
{
    if (!sharp_[level_.half[corner] >> 1]) {
        terms.push_back({level_.vertex[previous(across(corner))], -w_});
        return;
    }
    terms.push_back({level_.vertex[corner], -w_});
    terms.push_back({level_.vertex[next(corner)], -w_});
    terms.push_back({away, w_});
}

void ButterflyRows::ring(uint32_t h, double share, std::vector<Term>& terms) const
{
    const uint32_t first = cornerOf_[h], centre = level_.vertex[first];
    uint32_t n = 0;  // of this fan: a vertex may have several
    for (uint32_t c = first; n == 0 || (c != first && n < valence_[centre]); c = across(previous(c))) ++n;
    const auto add = [&](uint32_t v, double weight) {
        if (v == terms[0].vertex)
            terms[0].weight += weight;
        else if (v == terms[1].vertex)
            terms[1].weight += weight;
        else
            terms.push_back({v, weight});
    };
    if (n < 3) {
        add(centre, 0.5 * share);
        add(level_.vertex[next(first)], 0.5 * share);
        return;
    }
    add(centre, 0.75 * share);
    uint32_t corner = first;
    for (uint32_t j = 0; j < n; ++j, corner = across(previous(corner))) add(level_.vertex[next(corner)], share * ringWeight(j, n));
}

}  // namespace mw
