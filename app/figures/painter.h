// Drawing on a page in logical pixels from its top left: lines with heads and dashes, filled shapes, text. It remembers where text was put,
// so that labels find a free place and a test can ask whether any lies outside the page or over another.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "render/canvas.h"

namespace mw::figures {

/// What a line looks like. Made by chaining: `Pen(color).wide(3).dashed().arrow()`.
struct Pen {
    glm::vec4 color{0, 0, 0, 1};
    float width = 2;
    bool isDashed = false, hasHead = false, hasTail = false;
    float startGap = 0, endGap = 0;  ///< pixels left free at both ends: for the discs that stand there

    Pen() = default;
    explicit Pen(glm::vec4 c, float w = 2) : color(c), width(w) {}
    Pen wide(float w) const
    {
        return with([&](Pen& p) { p.width = w; });
    }
    Pen dashed() const
    {
        return with([](Pen& p) { p.isDashed = true; });
    }
    Pen arrow() const
    {
        return with([](Pen& p) { p.hasHead = true; });
    }
    Pen bothEnds() const
    {
        return with([](Pen& p) { p.hasHead = p.hasTail = true; });
    }
    Pen gaps(float start, float end) const
    {
        return with([&](Pen& p) { p.startGap = start, p.endGap = end; });
    }

private:
    template <class F>
    Pen with(F change) const
    {
        Pen p = *this;
        change(p);
        return p;
    }
};

/// Where text stands: its middle this many pixels from the point in a direction of the page (y down), (0, 0) on the point.
enum class Beside { Auto, On, Right, Left, Above, Below, AboveRight, AboveLeft, BelowRight, BelowLeft };

struct Words {
    glm::vec4 color{0, 0, 0, 1};
    Beside beside = Beside::Auto;
    int size = 15;
    bool bold = false, halo = true;
    float gap = 8;  ///< pixels between point and text
};

struct Box {
    glm::vec2 low{0}, high{0};
    glm::vec2 size() const { return high - low; }
    glm::vec2 middle() const { return 0.5f * (low + high); }
    Box inset(float by) const { return {low + by, high - by}; }
    bool touches(const Box& o) const { return low.x < o.high.x && o.low.x < high.x && low.y < o.high.y && o.low.y < high.y; }
};

class Painter {
public:
    /// `paper` is the colour that text is set off with.
    Painter(Canvas& canvas, float pixelRatio, glm::vec4 paper) : canvas_(canvas), px_(pixelRatio), paper_(paper) {}
    /// Where labels may find a place, unless told otherwise anywhere.
    void labelsWithin(const Box& box) { room_ = box; }
    void on(glm::vec4 paper) { paper_ = paper; }

    void path(std::vector<glm::vec2> points, const Pen& pen);
    void disc(glm::vec2 centre, float diameter, glm::vec4 fill, glm::vec4 border = {}, float borderWidth = 0);
    void box(const Box& box, glm::vec4 fill, float radius = 0, glm::vec4 border = {}, float borderWidth = 0);
    /// Any simple polygon, opaque.
    void polygon(const std::vector<glm::vec2>& corners, glm::vec4 fill);
    void colorBar(const Box& box, int heatRow, float from = 0, float to = 1);
    /// Text beside a point. Returns where it stands.
    Box words(glm::vec2 at, std::string_view text, const Words& look);
    /// A line of text from its left, centre or right; `at` is on the baseline.
    Box line(glm::vec2 at, std::string_view text, int size, glm::vec4 color, Canvas::Align align = Canvas::Align::Left, bool bold = false);

    float width(std::string_view text, int size, bool bold = false) const;
    /// Cut at spaces so that no line is wider.
    std::vector<std::string> wrapped(std::string_view text, int size, float widest) const;

    struct Put {
        Box box;
        std::string text;
    };
    const std::vector<Put>& texts() const { return texts_; }
    /// Labels placed from now on keep away from this, too.
    void keepFree(const Box& box) { taken_.push_back(box); }

private:
    Box boxOf(glm::vec2 at, glm::vec2 extent, Beside beside, float gap) const;
    Box freePlace(glm::vec2 at, glm::vec2 extent, float gap) const;
    float cover(const Box& box) const;
    void stroke(glm::vec2 a, glm::vec2 b, const Pen& pen);
    void head(glm::vec2 from, glm::vec2 tip, const Pen& pen);
    int pixels(int size) const;

    Canvas& canvas_;
    float px_;
    glm::vec4 paper_;
    std::vector<Put> texts_;
    std::vector<Box> taken_;
    std::vector<std::pair<glm::vec2, glm::vec2>> strokes_;
    Box room_{glm::vec2(-1e6f), glm::vec2(1e6f)};
};

}  // namespace mw::figures
