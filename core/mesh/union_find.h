// Disjoint sets of numbers 0 to n-1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/mesh/array.h"

namespace mw {

/// The lowest number of a set is its root, so the result does not depend on the order of joins. Paths are halved on the way.
class UnionFind {
public:
    explicit UnionFind(size_t n) : parent_(n)
    {
        for (size_t i = 0; i < n; ++i) parent_[i] = uint32_t(i);
    }
    uint32_t root(uint32_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// True when the two were in different sets.
    bool join(uint32_t a, uint32_t b)
    {
        a = root(a);
        b = root(b);
        if (a == b) return false;
        if (b < a) std::swap(a, b);
        parent_[b] = a;
        return true;
    }

private:
    Array<uint32_t> parent_;
};

/// Disjoint sets whose members are turned one way or the other relative to each other.
class ParityUnionFind {
public:
    explicit ParityUnionFind(size_t n) : link_(n)
    {
        for (size_t i = 0; i < n; ++i) link_[i] = {uint32_t(i), 0};
    }
    /// Says that a and b are turned differently (or the same way). False when that contradicts what was said before.
    bool join(uint32_t a, uint32_t b, bool different)
    {
        const Link x = find(a), y = find(b);
        const uint32_t turned = uint32_t(different) ^ x.turned ^ y.turned;
        if (x.to == y.to) return turned == 0;
        const bool low = x.to < y.to;
        link_[low ? y.to : x.to] = {low ? x.to : y.to, turned};
        return true;
    }

    struct Link {
        uint32_t to, turned;  ///< relative to `to`
    };
    /// The root of the set of i, and whether i is turned relative to it.
    Link find(uint32_t i)
    {
        uint32_t turned = 0;
        while (link_[i].to != i) {
            Link& l = link_[i];
            const Link up = link_[l.to];
            if (up.to != l.to) l = {up.to, l.turned ^ up.turned};  // halves the path
            turned ^= l.turned;
            i = l.to;
        }
        return {i, turned};
    }

private:
    Array<Link> link_;
};

}  // namespace mw
