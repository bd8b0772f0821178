#include "ui/viewport/collapse_tool.h"

#include "render/colors.h"
#include "ui/stack_edits.h"

namespace mw {
namespace {

const glm::vec4 good(roleColor(Role::New), 1), bad(roleColor(Role::Removed), 1), white(1);

const DrawObject* objectOf(const Frame& frame, NodeId node)
{
    for (const DrawObject& o : frame.objects)
        if (o.node == node) return &o;
    return nullptr;
}

}  // namespace

CollapseTool::CollapseTool(ToolView& view)
    : Tool(view),
      collapser_(
          "Edge tables", [](const Mesh& mesh, uint32_t, Progress&) { return std::make_shared<EdgeCollapser>(mesh); },
          [this] {
              if (hover_) rest(last_);
          })
{}

// A modifier goes to the end of the stack: what is in view must be what the stack gives, as it is at rest.
QString CollapseTool::obstacle(NodeId node) const
{
    const MeshId id = session().document.scene().node(node).mesh;
    const auto& levels = view_.look().shownLevel;
    const auto level = levels.find(id);
    const MeshObject* object = session().document.scene().find(id);
    if (!object) return "this is no mesh";
    if (level != levels.end() && (level->second < object->stack.size() || level->second == variantLevel))
        return "this is an earlier level; show the result first";
    return {};
}

std::optional<CollapseTool::Hover> CollapseTool::at(const PointerEvent& e)
{
    const auto pick = view_.pick(e.at);
    if (!pick || pick->edge.x == none) return std::nullopt;
    const DrawObject* o = objectOf(view_.seen(), pick->node);
    if (!o) return std::nullopt;
    Hover h;
    h.node = pick->node;
    h.a = pick->edge.x;
    h.b = pick->edge.y;
    h.pointer = e.at;
    const auto world = [&](const glm::vec3& p) { return glm::dvec3(o->worldFromLocal * glm::dvec4(glm::dvec3(p), 1)); };
    h.first = world(o->mesh.positions()[h.a]);
    h.second = world(o->mesh.positions()[h.b]);
    h.reason = o->pose ? QString("it is posed; let it stand at rest first") : obstacle(h.node);
    if (!h.reason.isEmpty()) return h;
    const auto collapser = collapser_.of(session().jobs, o->mesh);
    h.reason = collapser_.failure();
    h.preparing = !collapser && h.reason.isEmpty();
    if (!collapser) return h;
    const EdgeCollapser::Judgement j = collapser->judge(h.a, h.b, CollapsePlace::Optimal);
    h.legal = j.legal();
    h.reason = QString::fromStdString(reasonAgainst(j));
    h.to = world(collapser->mesh().position(j.place));
    return h;
}

void CollapseTool::rest(const PointerEvent& e)
{
    last_ = e;
    hover_ = at(e);
    view_.redraw();
}

void CollapseTool::leave()
{
    hover_.reset();
    view_.redraw();
}

bool CollapseTool::click(const PointerEvent& e)
{
    const auto h = at(e);
    if (!h) return false;  // beside every edge: it picks
    if (h->preparing) return true;
    if (!h->legal) {
        if (session().trouble) session().trouble("This edge stays: " + h->reason);
        return true;
    }
    const MeshId mesh = session().document.scene().node(h->node).mesh;
    const std::string edge = std::to_string(h->a) + "~" + std::to_string(h->b);
    edits::addModifier(session().document, mesh, operation("collapse-edge"), {{"edge", edge}});
    hover_.reset();
    view_.redraw();
    return true;
}

void CollapseTool::decorate(Frame& frame)
{
    if (!hover_) return;
    const Hover& h = *hover_;
    const glm::vec4 color = h.preparing ? white : h.legal ? good : bad;
    frame.points.push_back({glm::vec3(h.first), color, 3.f, glm::vec3(h.second), !h.legal && !h.preparing, true});
    if (h.preparing) return;
    if (h.legal) {
        for (const glm::dvec3& end : {h.first, h.second}) frame.points.push_back({glm::vec3(end), good, 1.6f, glm::vec3(h.to), true, true});
        frame.points.push_back({glm::vec3(h.to), good, 10, {}, false, true});
        return;
    }
    Flat text;
    text.kind = Flat::Kind::Text;
    text.at = {glm::vec2(h.pointer) + glm::vec2(18, 20)};
    text.color = bad;
    text.text = h.reason.toStdString();
    frame.flats.push_back(std::move(text));
}

QString CollapseTool::hint(Qt::KeyboardModifiers) const
{
    if (!hover_) return "Point at an edge: green where it would go, or why it stays \u00b7 Click collapses it \u00b7 Drag orbits";
    if (hover_->preparing) return "Preparing the tables of this mesh: a moment";
    if (!hover_->legal) return "It stays: " + hover_->reason;
    return QString("Click collapses the edge %1~%2 \u00b7 Ctrl+Z takes it back").arg(hover_->a).arg(hover_->b);
}

Qt::CursorShape CollapseTool::cursor() const
{
    return hover_ && !hover_->legal && !hover_->preparing ? Qt::ForbiddenCursor : Qt::ArrowCursor;
}

}  // namespace mw
