#include "ui/viewport/brush_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/scene/edit.h"
#include "core/scene/stroke_text.h"
#include "render/terrain_levels.h"
#include "ui/terrain_edits.h"

namespace mw {
namespace {

constexpr int ringParts = 72;
constexpr glm::vec4 hiddenWhite{1, 1, 1, 0.25f};

/// Where the falloff has come down to one half, share of the radius.
double halfOf(Brush::Falloff falloff)
{
    double low = 0, high = 1;
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (low + high);
        (falloffAt(falloff, middle) > 0.5 ? low : high) = middle;
    }
    return low;
}

glm::dvec3 placeOf(const DrawTerrain& t, glm::dvec2 xz)
{
    return {xz.x, std::max(t.terrain.heightAt(xz.x, xz.y), t.terrain.waterLevel), xz.y};
}

/// What hills hide of the ring shows faintly through them.
void addHidden(Frame& frame, const DrawTerrain& t, glm::dvec2 middle, double radius, glm::dvec3 eyeInWorld)
{
    const glm::dvec3 eye(glm::inverse(t.worldFromLocal) * glm::dvec4(eyeInWorld, 1));
    const glm::dvec2 half = 0.5 * t.terrain.size();
    std::optional<glm::dvec3> from;
    for (int i = 0; i <= ringParts; ++i) {
        const double a = 2 * std::numbers::pi * i / ringParts;
        const glm::dvec2 xz = middle + radius * glm::dvec2(std::cos(a), std::sin(a));
        std::optional<glm::dvec3> to;
        if (glm::all(glm::lessThan(glm::abs(xz), half))) {
            const glm::dvec3 place = placeOf(t, xz);
            const auto met = t.terrain.meet(eye, place - eye);
            if (met && glm::distance(*met, eye) < 0.995 * glm::distance(place, eye)) to = place;
        }
        if (from && to)
            frame.points.push_back({glm::vec3(t.worldFromLocal * glm::dvec4(*from, 1)), hiddenWhite, 2.6f,
                                    glm::vec3(t.worldFromLocal * glm::dvec4(*to, 1)), false, true});
        from = to;
    }
}

}  // namespace

const char* verbOf(Brush::Kind kind)
{
    return kind == Brush::Kind::Raise ? "raise" : "lower";
}

BrushTool::BrushTool(ToolView& view) : Tool(view)
{
    told_.setSingleShot(true);
    told_.setInterval(1500);
    QObject::connect(&told_, &QTimer::timeout, &told_, [this] { view_.redraw(); });
}

void BrushTool::tell()
{
    told_.start();
}

std::optional<ViewState::GroundPlace> BrushTool::under(const Ray& ray) const
{
    const Scene& scene = session().document.scene();
    std::optional<ViewState::GroundPlace> best;
    double nearest = 0;
    for (const NodeId id : scene.nodes()) {
        const TerrainObject* object = edits::terrainOf(session().document, id);
        if (!object || object->terrain.map.empty() || !scene.node(id).visible) continue;
        const glm::dmat4 world = scene.worldFromLocal(id), local = glm::inverse(world);
        const auto met = object->terrain.meet(glm::dvec3(local * glm::dvec4(ray.origin, 1)), glm::dvec3(local * glm::dvec4(ray.direction, 0)));
        if (!met) continue;
        const double d = glm::distance(ray.origin, glm::dvec3(world * glm::dvec4(*met, 1)));
        if (best && d >= nearest) continue;
        nearest = d;
        const TerrainLevels levels = levelsOf(object->terrain, world, view_.look().camera.eye());
        const glm::dvec2 share = glm::dvec2(met->x, met->z) / object->terrain.size() + 0.5;
        const size_t p = levels.patch(std::clamp(int(share.x * levels.columns), 0, levels.columns - 1),
                                      std::clamp(int(share.y * levels.rows), 0, levels.rows - 1));
        best = ViewState::GroundPlace{id, *met, levels.distance[p], levels.inner[p], levels.triangles(p)};
    }
    return best;
}

Brush BrushTool::brush() const
{
    Brush b = session().view.brush;
    if (inverted_) b.kind = b.kind == Brush::Kind::Raise ? Brush::Kind::Lower : Brush::Kind::Raise;
    return b;
}

bool BrushTool::press(const PointerEvent& e)
{
    const auto place = e.alt() || e.shift() ? std::nullopt : under(view_.ray(e.at));
    if (!place) return false;
    inverted_ = e.control();
    node_ = place->node;
    object_ = *edits::terrainOf(session().document, node_);
    object_.sourceOperation.clear();  // painted: no source gives this map
    object_.sourceValues.clear();
    carry_ = -1;
    last_ = {place->local.x, place->local.z};
    way_.clear();
    painted_ = brush();
    dab(last_);
    return true;
}

void BrushTool::dab(glm::dvec2 to)
{
    if (!edits::terrainOf(session().document, node_)) {  // undone or deleted under the hand
        node_ = {};
        return;
    }
    const std::array<glm::dvec2, 2> way{last_, to};
    object_.terrain.map = stroked(object_.terrain, painted_, way, carry_);
    last_ = to;
    way_.push_back(to);
    Scene next = session().document.scene();
    next.set(next.node(node_).terrain, object_);
    session().document.preview(std::move(next));
}

void BrushTool::move(const PointerEvent& e)
{
    const auto place = painting() ? under(view_.ray(e.at)) : std::nullopt;
    if (place && place->node == node_) dab({place->local.x, place->local.z});
}

void BrushTool::release(const PointerEvent&)
{
    if (!painting()) return;
    const NodeId node = std::exchange(node_, NodeId{});
    Document& d = session().document;
    static constexpr const char* falloffs[] = {"smooth", "linear", "sphere", "constant"};
    const EditCall call{"stroke",
                        {{"node", nodeText(d.scene(), node)},
                         {"kind", std::string(verbOf(painted_.kind))},
                         {"radius", painted_.radius},
                         {"strength", painted_.strength},
                         {"spacing", painted_.spacing},
                         {"falloff", std::string(falloffs[size_t(painted_.falloff)])},
                         {"points", strokeText(way_)}}};
    // What is shown is what the edit gives: a stroke in pieces is, to the bit, the stroke in one go.
    commitEdited(d, call, *d.history()[d.historyPosition()].scene, d.scene(), {});
}

bool BrushTool::abort()
{
    if (!painting()) return false;
    node_ = {};
    session().document.cancelPreview();
    return true;
}

void BrushTool::decorate(Frame& frame)
{
    if (!session().view.ground) return;
    const ViewState::GroundPlace place = *session().view.ground;
    for (DrawTerrain& t : frame.terrains) {
        if (t.node != place.node) continue;
        const Brush b = brush();
        const glm::dvec2 at(place.local.x, place.local.z);
        t.brush = DrawTerrain::BrushMark{at, b.radius, b.radius * halfOf(b.falloff)};
        const auto world = [&](glm::dvec2 xz, double above) {
            return glm::vec3(t.worldFromLocal * glm::dvec4(placeOf(t, xz) + glm::dvec3(0, above, 0), 1));
        };
        addHidden(frame, t, at, b.radius, view_.look().camera.eye());
        const double needle = 0.6 * b.strength * b.radius;
        frame.points.push_back({world(at, 0), glm::vec4(1), 2, world(at, needle), false, true});
        frame.points.push_back({world(at, 0), glm::vec4(1), 7, {}, false, true});
        frame.points.push_back({world(at, needle), glm::vec4(1), 5, {}, false, true});
        if (!told_.isActive()) continue;
        char text[80];
        std::snprintf(text, sizeof text, "%s %.3g m, strength %.2f", b.kind == Brush::Kind::Raise ? "Raise" : "Lower", b.radius, b.strength);
        frame.labels.push_back({world(at, 0), text, glm::vec4(1)});
    }
}

QString BrushTool::hint(Qt::KeyboardModifiers m) const
{
    const bool lowers = (session().view.brush.kind != Brush::Kind::Lower) == bool(m & Qt::ControlModifier);
    return QString(
               "Drag %1 \u00b7 Ctrl+drag %2 \u00b7 [ ] radius \u00b7 Shift+[ ] strength \u00b7 Right-drag pans \u00b7 Middle-drag, or a drag "
               "beside the ground, orbits")
        .arg(lowers ? "lowers" : "raises", lowers ? "raises" : "lowers");
}

}  // namespace mw
