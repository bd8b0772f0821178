#include "ui/viewport/cut_tool.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/cut_edits.h"
#include "ui/variants.h"
#include "ui/viewport/heat_probe.h"
#include "ui/words.h"

namespace mw {
namespace {

constexpr glm::vec4 white{1, 1, 1, 1}, yellow{1, 0.88f, 0.30f, 1};

const DrawObject* objectOf(const Frame& frame, NodeId node)
{
    for (const DrawObject& o : frame.objects)
        if (o.node == node) return &o;
    return nullptr;
}

/// Vertices of the way to `to`, both ends included; empty when there is none.
std::vector<uint32_t> wayTo(const EdgeDistances& d, uint32_t to)
{
    if (!std::isfinite(d.distance[to])) return {};
    std::vector<uint32_t> way;
    for (uint32_t v = to; v != none; v = d.before[v]) way.push_back(v);
    std::reverse(way.begin(), way.end());
    return way;
}

Mark edgesOf(NodeId node, std::span<const uint32_t> way, glm::vec4 color)
{
    Mark m{node, ElementKind::Edge, {}, color, 3};
    m.through = true;
    for (size_t i = 0; i + 1 < way.size(); ++i) m.indices.insert(m.indices.end(), {way[i], way[i + 1]});
    return m;
}

Mark discs(NodeId node, std::vector<uint32_t> vertices, glm::vec4 color)
{
    Mark m{node, ElementKind::Vertex, std::move(vertices), color, 9};
    m.through = true;
    return m;
}

}  // namespace

CutTool::CutTool(ToolView& view)
    : Tool(view),
      ways_(
          "Ways along edges",
          [](const Mesh& mesh, uint32_t vertex, Progress& progress) {
              return std::make_shared<EdgeDistances>(edgeDistances(mesh, std::span(&vertex, 1), none, &progress));
          },
          [this] { prepared(); })
{}

// The nearest corner of the face there: on a fine mesh it is under the pointer, on a coarse one nobody has to aim.
std::optional<CutTool::Target> CutTool::under(const PointerEvent& e)
{
    const auto pick = view_.pick(e.at);
    const DrawObject* o = pick ? objectOf(view_.seen(), pick->node) : nullptr;
    if (!o) return std::nullopt;
    if (pick->vertex != none) return Target{pick->node, pick->vertex};
    const auto t = pick->face == none ? std::nullopt : triangleAt(*o, pick->face, pick->atWorld);
    if (!t) return std::nullopt;
    const WorldPlaces places(*o);
    uint32_t nearest = t->vertices[0];
    for (const int k : {1, 2})
        if (glm::distance(places[t->vertices[k]], pick->atWorld) < glm::distance(places[nearest], pick->atWorld)) nearest = t->vertices[k];
    return Target{pick->node, nearest};
}

QString CutTool::obstacle(const Target& t) const
{
    const Scene& scene = session().document.scene();
    if (showsVariant(view_.look(), scene, t.node)) return "This view shows a variant; show the result to cut it.";
    if (!stops_.empty() && t.node != node_)
        return QString("The cut runs over %1: Enter cuts it, Esc clears it.").arg(QString::fromStdString(scene.node(node_).name));
    return {};
}

bool CutTool::stillThere()
{
    if (stops_.empty()) return false;
    const DrawObject* o = objectOf(view_.seen(), node_);
    if (o && sameMesh(o->mesh, mesh_)) return true;
    clear();
    return false;
}

bool CutTool::click(const PointerEvent& e)
{
    const auto t = under(e);
    if (!t) return true;  // beside everything: the selection stays
    stillThere();
    if (const QString why = obstacle(*t); !why.isEmpty()) {
        if (session().trouble) session().trouble(why);
        return true;
    }
    if (stops_.empty()) {
        node_ = t->node;
        mesh_ = objectOf(view_.seen(), node_)->mesh;
        stops_.push_back({t->vertex, {}});
        ways_.of(session().jobs, mesh_, t->vertex);
    } else if (t->vertex == awaited_.value_or(stops_.back().vertex)) {
        commit();  // a double click
    } else {
        take(t->vertex);
    }
    view_.redraw();
    return true;
}

void CutTool::take(uint32_t vertex)
{
    awaited_.reset();
    const auto ways = ways_.of(session().jobs, mesh_, stops_.back().vertex);
    if (!ways) {
        awaited_ = vertex;
        return;
    }
    std::vector<uint32_t> way = wayTo(*ways, vertex);
    if (way.empty()) {
        if (session().trouble) session().trouble("No edges lead there: it is another piece of the mesh.");
        return;
    }
    stops_.push_back({vertex, std::move(way)});
    hoverWay_.clear();
    ways_.of(session().jobs, mesh_, vertex);
}

void CutTool::prepared()
{
    if (!stillThere()) return;
    if (awaited_ && ways_.failure().isEmpty()) take(*awaited_);
    showWay();
}

void CutTool::showWay()
{
    hoverWay_.clear();
    if (hover_ && stillThere() && hover_->node == node_ && !awaited_ && hover_->vertex != stops_.back().vertex)
        if (const auto ways = ways_.of(session().jobs, mesh_, stops_.back().vertex)) hoverWay_ = wayTo(*ways, hover_->vertex);
    view_.redraw();
}

void CutTool::rest(const PointerEvent& e)
{
    auto at = under(e);
    if (at && !obstacle(*at).isEmpty()) at.reset();
    if (std::exchange(hover_, at) != at) showWay();
}

void CutTool::leave()
{
    hover_.reset();
    showWay();
}

bool CutTool::key(const QKeyEvent& e)
{
    if (!stillThere()) return false;
    if (e.key() == Qt::Key_Return || e.key() == Qt::Key_Enter) {
        commit();
        return true;
    }
    if (e.key() != Qt::Key_Backspace) return false;
    if (awaited_)
        awaited_.reset();
    else
        stops_.pop_back();
    if (stops_.empty())
        clear();
    else
        showWay();
    return true;
}

void CutTool::commit()
{
    if (awaited_) stops_.push_back({*awaited_, {}});
    if (stops_.size() < 2) {
        if (session().trouble) session().trouble("Click a second vertex first: the cut runs from one to the next.");
        return;
    }
    std::string vertices;
    for (const Stop& s : stops_) vertices += (vertices.empty() ? "" : ";") + std::to_string(s.vertex);
    const NodeId node = node_;
    clear();
    session().document.select({{node}, {}, {}});
    edits::addCut(session(), node, {{"method", std::string("shortest")}, {"vertices", vertices}});
}

void CutTool::clear()
{
    stops_.clear();
    awaited_.reset();
    hoverWay_.clear();
    ways_.drop(session().jobs);
    mesh_ = {};
    view_.redraw();
}

bool CutTool::abort()
{
    if (stops_.empty()) return false;
    clear();
    return true;
}

void CutTool::decorate(Frame& frame)
{
    if (stillThere()) {
        std::vector<uint32_t> passed;
        for (const Stop& s : stops_) {
            frame.marks.push_back(edgesOf(node_, s.way, yellow));
            passed.push_back(s.vertex);
        }
        if (awaited_) passed.push_back(*awaited_);
        frame.marks.push_back(discs(node_, std::move(passed), yellow));
        frame.marks.push_back(edgesOf(node_, hoverWay_, white));
    }
    if (hover_ && session().document.scene().find(hover_->node)) frame.marks.push_back(discs(hover_->node, {hover_->vertex}, white));
}

QString CutTool::hint(Qt::KeyboardModifiers) const
{
    if (stops_.empty()) return "Click the first vertex of the cut \u00b7 Drag orbits";
    const QString back = " \u00b7 Backspace takes the last back \u00b7 Esc clears";
    if (!ways_.failure().isEmpty()) return ways_.failure() + back;
    if (awaited_) return "Preparing: looking for the shortest ways along edges" + back;
    if (stops_.size() == 1) return "Click the next vertex: the cut takes the shortest way along edges" + back;
    size_t edges = 0;
    for (const Stop& s : stops_) edges += s.way.empty() ? 0 : s.way.size() - 1;
    if (edges == 1) return "One edge: inside a surface it opens nothing alone \u00b7 Click the next vertex" + back;
    return QString("%1 edges \u00b7 Enter or a double click cuts \u00b7 Click the next vertex").arg(grouped(edges)) + back;
}

}  // namespace mw
