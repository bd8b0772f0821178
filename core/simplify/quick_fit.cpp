// Fitting by least squares. Everything is gathered, by face and then by vertex, so that pieces on several threads give the same sums.
#include "core/simplify/quick_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/simplify/ranges.h"

namespace mw::quick {

namespace {

/// Squared distance of p to a triangle, and the weights of the nearest point (Ericson 2005, 5.1.5).
MW_INLINE float nearestOn(Float4 p, Float4 a, Float4 b, Float4 c, float* w)
{
    const Float4 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const float d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    float wb = 0, wc = 0;
    if (d1 <= 0 && d2 <= 0) {
        wb = 0;
    } else if (d3 >= 0 && d4 <= d3) {
        wb = 1;
    } else if (d6 >= 0 && d5 <= d6) {
        wc = 1;
    } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        wb = d1 > d3 ? d1 / (d1 - d3) : 0;
    } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        wc = d2 > d6 ? d2 / (d2 - d6) : 0;
    } else if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const float span = (d4 - d3) + (d5 - d6);
        wc = span > 0 ? (d4 - d3) / span : 0;
        wb = 1 - wc;
    } else {
        const float whole = 1 / (va + vb + vc);
        wb = vb * whole, wc = vc * whole;
    }
    w[0] = 1 - wb - wc, w[1] = wb, w[2] = wc;
    const Float4 gap = ab * wb + ac * wc - ap;
    return dot(gap, gap);
}

}  // namespace

Fit::Fit(Tables& tables) : t_(tables)
{
    listFaces();
    listAround();
    takeSamples();
    normals(firstNormals_);
    first_ = places_;
    pulls_.resize(corners_.size());
    errors_.resize(faces_.size());
}

void Fit::listFaces()
{
    std::vector<uint32_t> number(t_.vertices.size(), none);
    for (size_t f = 0; f < t_.faces.size(); ++f) {
        if (t_.faces[f].v[0] < 0) continue;
        faces_.push_back(int(f));
        for (const int v : t_.faces[f].v) {
            uint32_t& n = number[size_t(v)];
            if (n == none) {
                n = uint32_t(vertices_.size());
                vertices_.push_back(v);
                places_.push_back(t_.vertices[size_t(v)].place);
            }
            corners_.push_back(n);
        }
    }
    root_.resize(t_.vertices.size());
    std::vector<int> into(t_.vertices.size());
    for (size_t v = 0; v < into.size(); ++v) into[v] = t_.vertices[v].parent;
    for (size_t v = 0; v < into.size(); ++v) {
        int x = int(v);
        while (into[size_t(x)] != x) x = into[size_t(x)] = into[size_t(into[size_t(x)])];
        root_[v] = number[size_t(x)];
    }
}

void Fit::listAround()
{
    start_.assign(vertices_.size() + 1, 0);
    for (const uint32_t v : corners_) ++start_[v + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    around_.resize(corners_.size());
    std::vector<uint32_t> place(start_.begin(), start_.end() - 1);
    for (size_t c = 0; c < corners_.size(); ++c) around_[place[corners_[c]]++] = uint32_t(c);
}

// In the order of the tables: neighbours one after the other.
void Fit::takeSamples()
{
    const size_t n = t_.faces.size();
    samples_.take(n);
    nearest_.take(n);
    inPieces(n, [&](size_t begin, size_t end) {
        for (size_t s = begin; s < end; ++s) {
            const uint32_t* v = t_.old().vertices.data() + 3 * size_t(t_.faces[s].old);
            const auto& p = t_.input().positions();
            samples_[s] = t_.scaled((p[v[0]] + p[v[1]] + p[v[2]]) * (1 / 3.f));
        }
    });
}

uint32_t Fit::top(const Nearest& n) const
{
    const float* w = n.weight;
    const int k = w[0] >= w[1] ? (w[0] >= w[2] ? 0 : 2) : (w[1] >= w[2] ? 1 : 2);
    return corners_[3 * size_t(n.face) + size_t(k)];
}

// From the vertex into which a corner of the old face went, or the nearest one of the last round, over to the nearest corner of the best face found.
void Fit::findNearest(size_t begin, size_t end)
{
    for (size_t s = begin; s < end; ++s) {
        const uint32_t old = t_.old().vertices[3 * size_t(t_.faces[s].old)];
        uint32_t v = begun_ ? (nearest_[s].face == none ? none : top(nearest_[s])) : root_[t_.rank[old]];
        Nearest best{none, {0, 0, 0}};
        float least = 1e30f, w[3];
        for (int hop = 0; hop < 4 && v != none; ++hop) {
            bool better = false;
            for (uint32_t i = start_[v]; i < start_[v + 1]; ++i) {
                const uint32_t f = around_[i] / 3;
                const uint32_t* c = &corners_[3 * size_t(f)];
                const float d = nearestOn(samples_[s], places_[c[0]], places_[c[1]], places_[c[2]], w);
                if (d >= least) continue;
                least = d;
                better = true;
                best = {f, {w[0], w[1], w[2]}};
            }
            const uint32_t following = better ? top(best) : v;
            if (following == v) break;
            v = following;
        }
        nearest_[s] = best;
    }
}

void Fit::group()
{
    begun_ = true;
    sampleStart_.assign(faces_.size() + 1, 0);
    for (size_t s = 0; s < samples_.size(); ++s)
        if (nearest_[s].face != none) ++sampleStart_[nearest_[s].face + 1];
    std::partial_sum(sampleStart_.begin(), sampleStart_.end(), sampleStart_.begin());
    order_.resize(sampleStart_.back());
    std::vector<uint32_t> place(sampleStart_.begin(), sampleStart_.end() - 1);
    for (size_t s = 0; s < samples_.size(); ++s)
        if (nearest_[s].face != none) order_[place[nearest_[s].face]++] = uint32_t(s);
}

// A sample pulls along the normal of its face, or, beside the face, straight to itself. Each corner takes its weight's share, which makes every step
// a descent: a bound on the sum of squares.
void Fit::pullOf(size_t f)
{
    const uint32_t* c = &corners_[3 * f];
    const Float4 a = places_[c[0]], ab = places_[c[1]] - a, ac = places_[c[2]] - a, n = cross(ab, ac);
    const float length = std::sqrt(dot(n, n));
    const Float4 normal = length > 0 ? n * (1 / length) : n;
    Pull* const pulls = &pulls_[3 * f];
    for (int k = 0; k < 3; ++k) pulls[k] = Pull();
    double error = 0;
    for (uint32_t i = sampleStart_[f]; i < sampleStart_[f + 1]; ++i) {
        const uint32_t s = order_[i];
        const float* w = nearest_[s].weight;
        const Float4 gap = samples_[s] - (a + ab * w[1] + ac * w[2]);
        Float4 u = normal;
        if (!(w[0] > 0 && w[1] > 0 && w[2] > 0)) {
            const float l = dot(gap, gap);
            if (l > 0) u = gap * (1 / std::sqrt(l));
        }
        const float d = dot(gap, u);
        const Symmetric q = square(u);
        error += double(d) * d;
        for (int k = 0; k < 3; ++k) {
            if (!(w[k] > 0)) continue;
            pulls[k].matrix = pulls[k].matrix + q * w[k];
            pulls[k].right += u * (w[k] * d);
            pulls[k].weight += w[k];
        }
    }
    errors_[f] = error;
}

void Fit::moveVertex(size_t v)
{
    constexpr float stay = 1e-3f;
    constexpr double stride = 1.5;
    if (t_.vertices[size_t(vertices_[v])].flag) return;
    Pull all;
    for (uint32_t i = start_[v]; i < start_[v + 1]; ++i) {
        const Pull& p = pulls_[around_[i]];
        all.matrix = all.matrix + p.matrix;
        all.right += p.right;
        all.weight += p.weight;
    }
    if (!(all.weight > 0)) return;
    const Adjugate inverse(all.matrix, identity * (stay * all.weight));
    double by[3];
    inverse.times(all.right[0], all.right[1], all.right[2], by);
    if (!(inverse.determinant > 0)) return;
    const double scale = stride / inverse.determinant;
    places_[v] += Float4{float(by[0] * scale), float(by[1] * scale), float(by[2] * scale), 0};
}

double Fit::move()
{
    inPieces(
        faces_.size(),
        [&](size_t begin, size_t end) {
            for (size_t f = begin; f < end; ++f) pullOf(f);
        },
        1024);
    inPieces(
        vertices_.size(),
        [&](size_t begin, size_t end) {
            for (size_t v = begin; v < end; ++v) moveVertex(v);
        },
        1024);
    const double sum = std::accumulate(errors_.begin(), errors_.end(), 0.0);
    return order_.empty() ? 0 : std::sqrt(sum / double(order_.size()));
}

void Fit::normals(std::vector<Float4>& out) const
{
    out.resize(faces_.size());
    for (size_t f = 0; f < out.size(); ++f) {
        const uint32_t* c = &corners_[3 * f];
        out[f] = cross(places_[c[1]] - places_[c[0]], places_[c[2]] - places_[c[0]]);
    }
}

// Which vertices have to go back: those of faces that turned by over 60 degrees or lie on a neighbour that they did not lie on.
bool Fit::undo(std::vector<uint8_t>& back) const
{
    std::vector<uint32_t> number(t_.faces.size(), none);
    for (size_t f = 0; f < faces_.size(); ++f) number[size_t(faces_[f])] = uint32_t(f);
    bool any = false;
    const auto restore = [&](size_t f) {
        for (size_t k = 0; k < 3; ++k) back[corners_[3 * f + k]] = 1;
        any = true;
    };
    for (size_t f = 0; f < faces_.size(); ++f) {
        const Float4 now = normals_[f], then = firstNormals_[f];
        const bool same = now[0] == then[0] && now[1] == then[1] && now[2] == then[2];
        const float d = dot(now, then);
        if (!same && !(d > 0 && d * d > 0.25f * dot(now, now) * dot(then, then))) restore(f);
        for (int k = 0; k < 3; ++k) {
            const int twin = t_.faces[size_t(faces_[f])].twin[k];
            if (twin < 0) continue;
            const size_t g = number[size_t(twin >> 2)];
            if (g > f && dot(now, normals_[g]) <= 0 && dot(then, firstNormals_[g]) > 0) restore(f), restore(g);
        }
    }
    return any;
}

void Fit::finish()
{
    std::vector<uint8_t> back(vertices_.size(), 0);
    for (int round = 0;; ++round) {
        normals(normals_);
        if (!undo(back)) break;
        if (round == 20) std::fill(back.begin(), back.end(), uint8_t(1));
        for (size_t v = 0; v < back.size(); ++v)
            if (back[v]) places_[v] = first_[v];
        if (round == 20) break;
    }
    show();
}

void Fit::show() const
{
    for (size_t v = 0; v < vertices_.size(); ++v) t_.vertices[size_t(vertices_[v])].place = places_[v];
}

}  // namespace mw::quick
