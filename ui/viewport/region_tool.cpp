#include "ui/viewport/region_tool.h"

#include "render/colors.h"

namespace mw {

Region boxRegion(const ToolView& view, glm::dvec2 a, glm::dvec2 b)
{
    Region r;
    r.low = glm::ivec2(glm::floor(view.pixelRatio() * glm::min(a, b)));
    r.high = glm::ivec2(glm::ceil(view.pixelRatio() * glm::max(a, b)));
    return r;
}

bool RegionTool::beginDrag(const PointerEvent& e)
{
    if (e.alt()) return false;
    quick_ = false;
    line_ = {e.at};
    return true;
}

void RegionTool::beginQuick(const PointerEvent& e)
{
    quick_ = true;
    line_ = {e.at};
}

void RegionTool::move(const PointerEvent& e)
{
    if (!lasso_) line_.resize(1);
    if (!lasso_ || glm::distance(line_.back(), e.at) >= 2) line_.push_back(e.at);
    view_.redraw();
}

Region RegionTool::region() const
{
    if (!lasso_) return boxRegion(view_, line_.front(), line_.back());
    std::vector<glm::dvec2> corners;
    for (const glm::dvec2& p : line_) corners.push_back(view_.pixelRatio() * p);
    return polygonRegion(corners, glm::ivec2(glm::round(view_.pixelRatio() * view_.logicalSize())));
}

void RegionTool::release(const PointerEvent& e)
{
    if (line_.empty()) return;
    move(e);
    const bool big = lasso_ ? line_.size() > 2 : glm::all(glm::greaterThan(glm::abs(line_.back() - line_.front()), glm::dvec2(1)));
    const Region chosen = region();
    const SelectMode plain = quick_ ? SelectMode::Add : SelectMode::Replace;
    const SelectMode mode = e.shift() ? SelectMode::Add : e.control() ? SelectMode::Remove : plain;
    line_.clear();
    if (big) selectRegion(view_, chosen, mode);
    view_.redraw();
}

bool RegionTool::abort()
{
    if (line_.empty()) return false;
    line_.clear();
    view_.redraw();
    return true;
}

void RegionTool::decorate(Frame& frame)
{
    if (line_.size() < 2) return;
    Flat f;
    f.color = glm::vec4(1);
    f.width = 1.5f;
    if (lasso_) {
        for (const glm::dvec2& p : line_) f.at.emplace_back(p);
    } else {
        const glm::vec2 a(line_.front()), b(line_.back());
        f.at = {a, {b.x, a.y}, b, {a.x, b.y}};
        Flat fill = f;
        fill.kind = Flat::Kind::Quad;
        fill.halo = false;
        fill.color.a = 0.08f;
        frame.flats.push_back(std::move(fill));
    }
    f.at.push_back(f.at.front());
    frame.flats.push_back(std::move(f));
}

QString RegionTool::hint(Qt::KeyboardModifiers m) const
{
    const QString shape = lasso_ ? "Drag round what is to be" : "Drag a box over what is to be";
    if (m & Qt::ShiftModifier) return shape + " added to the selection";
    if (m & Qt::ControlModifier) return shape + " removed from the selection";
    return shape + " selected \u00b7 Shift adds \u00b7 Ctrl removes \u00b7 Middle-drag orbits \u00b7 Esc back to Select";
}

}  // namespace mw
