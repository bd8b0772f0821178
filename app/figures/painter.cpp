// Strokes and letters of a page.
#include "app/figures/painter.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh.h"

namespace mw::figures {
namespace {

constexpr float dash = 7, dashGap = 5;

float headLength(const Pen& pen)
{
    return 6 + 3 * pen.width;
}

/// Takes a length off the beginning of a path.
void shorten(std::vector<glm::vec2>& points, float by)
{
    while (by > 0 && points.size() > 1) {
        const float first = glm::distance(points[0], points[1]);
        if (first > by) {
            points[0] += (points[1] - points[0]) * (by / first);
            return;
        }
        if (points.size() == 2) return;
        by -= first;
        points.erase(points.begin());
    }
}

/// 1 when a line runs through the box.
float crossed(const Box& b, glm::vec2 p, glm::vec2 q)
{
    float from = 0, to = 1;
    for (int k = 0; k < 2; ++k) {
        const float d = q[k] - p[k];
        if (std::abs(d) < 1e-6f) {
            if (p[k] < b.low[k] || p[k] > b.high[k]) return 0;
            continue;
        }
        const float s = (b.low[k] - p[k]) / d, t = (b.high[k] - p[k]) / d;
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    return from <= to ? 1.f : 0.f;
}

}  // namespace

int Painter::pixels(int size) const
{
    return int(std::lround(float(size) * px_));
}

void Painter::stroke(glm::vec2 a, glm::vec2 b, const Pen& pen)
{
    strokes_.emplace_back(a, b);
    canvas_.stroke(a * px_, b * px_, pen.width * px_, pen.color);
}

void Painter::head(glm::vec2 from, glm::vec2 tip, const Pen& pen)
{
    const float length = headLength(pen), d = glm::distance(from, tip);
    if (d < 1e-3f) return;
    const glm::vec2 along = (tip - from) / d, across(-along.y, along.x), back = tip - length * along;
    const glm::vec2 left = (back + 0.42f * length * across) * px_, right = (back - 0.42f * length * across) * px_;
    canvas_.quad({tip * px_, left, right, right}, pen.color, 0.3f);
}

void Painter::path(std::vector<glm::vec2> points, const Pen& pen)
{
    if (points.size() < 2) return;
    shorten(points, pen.startGap);
    std::reverse(points.begin(), points.end());
    shorten(points, pen.endGap);
    std::reverse(points.begin(), points.end());
    const glm::vec2 first = points.front(), last = points.back(), second = points[1], before = points[points.size() - 2];
    if (pen.hasHead) {
        std::reverse(points.begin(), points.end());
        shorten(points, 0.8f * headLength(pen));  // a line that ends under its head does not blunt the tip
        std::reverse(points.begin(), points.end());
    }
    if (pen.hasTail) shorten(points, 0.8f * headLength(pen));
    float at = 0;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::vec2 a = points[i], b = points[i + 1];
        const float length = glm::distance(a, b);
        if (!pen.isDashed || length < 1e-4f) {
            stroke(a, b, pen);
            continue;
        }
        const glm::vec2 along = (b - a) / length;
        for (float s = 0; s < length;) {  // dashes go on round the corners of the path
            const float in = std::fmod(at + s, dash + dashGap), left = in < dash ? dash - in : dash + dashGap - in;
            const float to = std::min(length, s + std::max(left, 0.01f));
            if (in < dash) stroke(a + s * along, a + to * along, pen);
            s = to;
        }
        at += length;
    }
    if (pen.hasHead) head(before, last, pen);
    if (pen.hasTail) head(second, first, pen);
}

void Painter::disc(glm::vec2 centre, float diameter, glm::vec4 fill, glm::vec4 border, float borderWidth)
{
    canvas_.disc(centre * px_, 0.5f * diameter * px_, fill, borderWidth * px_, border);
}

void Painter::box(const Box& b, glm::vec4 fill, float radius, glm::vec4 border, float borderWidth)
{
    canvas_.box(glm::round(b.low * px_), glm::round(b.high * px_), fill, radius * px_, borderWidth * px_, border);
}

void Painter::polygon(const std::vector<glm::vec2>& corners, glm::vec4 fill)
{
    if (corners.size() < 3) return;
    Array<glm::vec3> p;
    Array<uint32_t> face;
    for (const glm::vec2& c : corners) {
        face.push_back(uint32_t(p.size()));
        p.emplace_back(c * px_, 0);
    }
    Array<uint32_t> start{0u, uint32_t(face.size())};
    const Mesh shape(std::move(p), std::move(start), std::move(face));
    const auto& t = shape.triangulation();
    for (size_t i = 0; i + 2 < t.vertices.size(); i += 3) {
        const auto at = [&](size_t k) { return glm::vec2(shape.positions()[t.vertices[i + k]]); };
        canvas_.quad({at(0), at(1), at(2), at(2)}, fill, 0.4f);  // grown a little, so that no seam shows between the pieces
    }
}

void Painter::colorBar(const Box& b, int heatRow, float from, float to)
{
    canvas_.colorBar(glm::round(b.low * px_), glm::round(b.high * px_), heatRow, from, to);
}

float Painter::width(std::string_view text, int size, bool bold) const
{
    return canvas_.width(text, pixels(size), bold) / px_;
}

namespace {

/// Where a line may break first: at a space, but not beside a sign of equality.
size_t breakOf(std::string_view text)
{
    size_t stop = text.find_first_of(" \n");
    while (stop < text.size() && text[stop] == ' ' && (text.substr(stop + 1, 1) == "=" || (stop > 0 && text[stop - 1] == '=')))
        stop = text.find_first_of(" \n", stop + 1);
    return std::min(stop, text.size());
}

}  // namespace

std::vector<std::string> Painter::wrapped(std::string_view text, int size, float widest) const
{
    std::vector<std::string> lines;
    std::string now;
    const auto end = [&] {
        lines.push_back(now);
        now.clear();
    };
    while (!text.empty()) {
        const size_t stop = breakOf(text);
        const std::string word(text.substr(0, stop));
        const std::string longer = now.empty() ? word : now + " " + word;
        if (!now.empty() && width(longer, size) > widest) {
            end();
            now = word;
        } else {
            now = longer;
        }
        const bool broken = stop < text.size() && text[stop] == '\n';
        text.remove_prefix(std::min(stop + 1, text.size()));
        if (broken) end();
    }
    if (!now.empty()) end();
    return lines;
}

Box Painter::boxOf(glm::vec2 at, glm::vec2 extent, Beside beside, float gap) const
{
    constexpr glm::vec2 ways[] = {{0, 0}, {0, 0}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    const glm::vec2 way = ways[size_t(beside)];
    const float reach = way.x != 0 && way.y != 0 ? 0.75f * gap : gap;  // as far off across as along
    const glm::vec2 middle = at + way * (0.5f * extent + reach);
    return {middle - 0.5f * extent, middle + 0.5f * extent};
}

/// How bad it is to put text there: over text is worst, then outside, then over lines.
float Painter::cover(const Box& b) const
{
    float bad = 0;
    for (const Box& t : taken_)
        if (t.touches(b)) bad += 100;
    if (glm::any(glm::lessThan(b.low, room_.low)) || glm::any(glm::greaterThan(b.high, room_.high))) bad += 60;
    for (const auto& [p, q] : strokes_) bad += crossed(b, p, q);
    return bad;
}

Box Painter::freePlace(glm::vec2 at, glm::vec2 extent, float gap) const
{
    Box best;
    float least = 1e9f;
    for (const float further : {1.f, 2.f, 3.2f}) {
        for (int k = int(Beside::Right); k <= int(Beside::BelowLeft); ++k) {
            const Box b = boxOf(at, extent, Beside(k), gap * further);
            const float bad = cover(b) + 2 * (further - 1) + 0.01f * float(k);
            if (bad >= least) continue;
            least = bad;
            best = b;
        }
    }
    return best;
}

Box Painter::words(glm::vec2 at, std::string_view text, const Words& look)
{
    const glm::vec2 extent(width(text, look.size, look.bold), 0.95f * float(look.size));
    const Box b = look.beside == Beside::Auto ? freePlace(at, extent, look.gap) : boxOf(at, extent, look.beside, look.gap);
    const glm::vec2 base(b.low.x, b.high.y - 0.17f * float(look.size));
    if (look.halo)  // paper round the letters: lines may run behind them
        for (int k = 0; k < 8; ++k) {
            const float a = float(M_PI) * float(k) / 4;
            const glm::vec2 off = 2.f * glm::vec2(std::cos(a), std::sin(a));
            canvas_.text((base + off) * px_, text, pixels(look.size), paper_, look.bold);
        }
    canvas_.text(base * px_, text, pixels(look.size), look.color, look.bold);
    taken_.push_back(b);
    texts_.push_back({b, std::string(text)});
    return b;
}

Box Painter::line(glm::vec2 at, std::string_view text, int size, glm::vec4 color, Canvas::Align align, bool bold)
{
    const float w = width(text, size, bold);
    const float left = at.x - (align == Canvas::Align::Right ? w : align == Canvas::Align::Centre ? 0.5f * w : 0.f);
    canvas_.text(glm::vec2(left, at.y) * px_, text, pixels(size), color, bold);
    const Box b{{left, at.y - 0.78f * float(size)}, {left + w, at.y + 0.2f * float(size)}};
    taken_.push_back(b);
    texts_.push_back({b, std::string(text)});
    return b;
}

}  // namespace mw::figures
