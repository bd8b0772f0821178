#include "core/scene/document.h"

#include <algorithm>

namespace mw {

bool Selection::has(NodeId n) const
{
    return std::find(nodes.begin(), nodes.end(), n) != nodes.end();
}

namespace {

bool sameBase(const Mesh& a, const Mesh& b)
{
    return a.positions().id() == b.positions().id() && a.cornerVertex().id() == b.cornerVertex().id() && a.faceStart().id() == b.faceStart().id();
}

// What differs between two scenes, and in which nodes.
Change changeBetween(const Scene& before, const Scene& after)
{
    unsigned aspects = 0;
    Change change{Aspect(0), {}};
    const auto mark = [&](Aspect a, NodeId n) {
        aspects |= unsigned(a);
        if (n) change.nodes.insert(n);
    };
    if (before.roots() != after.roots()) mark(Aspect::Tree, {});
    for (NodeId id : after.nodes()) {
        const Node *a = before.find(id), &b = after.node(id);
        if (!a || a->name != b.name || a->children != b.children || a->parent != b.parent || a->visible != b.visible) mark(Aspect::Tree, id);
        if (!a || !(a->local == b.local)) mark(Aspect::Transform, id);
        if (!a || a->mesh != b.mesh) mark(Aspect::Mesh, id);
        if (!a || a->joint != b.joint || a->morphWeights != b.morphWeights || a->skin != b.skin || before.find(a->skin) != after.find(b.skin))
            mark(Aspect::Skin, id);
        if ((a ? before.find(a->terrain) : nullptr) != after.find(b.terrain)) mark(Aspect::Terrain, id);
        const auto from = a ? before.shared(a->mesh) : nullptr, to = after.shared(b.mesh);
        if (!from || !to || from == to) continue;
        if (!sameBase(from->base, to->base)) mark(Aspect::Mesh, id);
        if (from->stack != to->stack) mark(Aspect::Stack, id);
        if (from->materials != to->materials || from->name != to->name) mark(Aspect::Material, id);
        if (from->base.attributes().size() != to->base.attributes().size()) mark(Aspect::Mesh, id);
    }
    for (MaterialId id : after.materials())
        if (before.find(id) != after.find(id)) mark(Aspect::Material, {});
    if (before.clips() != after.clips()) mark(Aspect::Clip, {});
    for (ClipId id : after.clips())
        if (before.find(id) != after.find(id)) mark(Aspect::Clip, {});
    change.aspects = Aspect(aspects);
    return change;
}

// A selection without what is no longer there; elements are dropped when their mesh has changed.
Selection valid(const Selection& s, const Scene& before, const Scene& after)
{
    Selection out;
    for (NodeId n : s.nodes)
        if (after.find(n)) out.nodes.push_back(n);
    const Node *a = before.find(s.elementsOf), *b = after.find(s.elementsOf);
    if (!a || !b) return out;
    const auto from = before.shared(a->mesh), to = after.shared(b->mesh);
    if (from == to || (from && to && sameBase(from->base, to->base) && from->stack == to->stack)) {
        out.elementsOf = s.elementsOf;
        out.elements = s.elements;
    }
    return out;
}

}  // namespace

Document::Document() : scene_(std::make_shared<const Scene>())
{
    history_.push_back({"New scene", scene_, {}, std::chrono::system_clock::now()});
}

void Document::commit(std::string name, Scene next, std::vector<EditCall> calls)
{
    const Selection kept = valid(selection_, *scene_, next);
    commit(std::move(name), std::move(next), kept, std::move(calls));
}

void Document::commit(std::string name, Scene next, Selection selection, std::vector<EditCall> calls)
{
    if (savedPosition_ != never && savedPosition_ > position_) savedPosition_ = never;  // the saved state is being cut off
    history_.resize(position_ + 1);
    auto scene = std::make_shared<const Scene>(std::move(next));
    history_.push_back({std::move(name), scene, selection, std::chrono::system_clock::now(), std::move(calls)});
    ++position_;
    boundHistory();
    previewing_ = false;
    show(std::move(scene), selection, Aspect::History);
}

// Forgets the oldest entries while those before the present hold too much; what the present shares with them costs nothing.
void Document::boundHistory()
{
    while (position_ > 1 && historyOnlyBytes() > historyBytes_) {
        history_.erase(history_.begin());
        --position_;
        savedPosition_ = savedPosition_ == never || savedPosition_ == 0 ? never : savedPosition_ - 1;
    }
}

size_t Document::historyOnlyBytes() const
{
    std::set<const void*> seen;
    const auto size = [&](const Scene& s) {
        size_t bytes = 0;
        const auto count = [&](const void* key, size_t n) { bytes += key && seen.insert(key).second ? n : 0; };
        for (MeshId id : s.meshes()) {
            const Mesh& m = s.find(id)->base;
            count(m.positions().id(), m.positions().bytes());
            count(m.cornerVertex().id(), m.cornerVertex().bytes());
            count(m.faceStart().id(), m.faceStart().bytes());
            for (const Attribute& a : m.attributes()) count(a.id(), a.bytes());
        }
        for (ClipId id : s.clips())
            for (const auto& channel : s.find(id)->channels) count(channel->values.id(), channel->values.bytes());
        for (TerrainId id : s.terrains()) {
            const HeightMap& map = s.find(id)->terrain.map;
            for (uint32_t y = 0; y < map.tilesY(); ++y)
                for (uint32_t x = 0; x < map.tilesX(); ++x) count(map.tile(x, y).id(), map.tile(x, y).bytes());
        }
        return bytes;
    };
    size(*history_[position_].scene);
    size_t total = 0;
    for (const Entry& e : history_) total += size(*e.scene);
    return total;
}

void Document::preview(Scene next)
{
    previewing_ = true;
    const Selection kept = valid(selection_, *scene_, next);
    show(std::make_shared<const Scene>(std::move(next)), kept, Aspect(0));
}

void Document::cancelPreview()
{
    if (!previewing_) return;
    previewing_ = false;
    show(history_[position_].scene, selection_, Aspect(0));
}

void Document::select(Selection selection)
{
    selection_ = std::move(selection);
    history_[position_].selection = selection_;
    notify({Aspect::Selection, {}});
}

void Document::goTo(size_t position)
{
    if (position >= history_.size() || position == position_) return;
    position_ = position;
    previewing_ = false;
    show(history_[position].scene, history_[position].selection, Aspect::History);
}

void Document::undo()
{
    if (canUndo()) goTo(position_ - 1);
}

void Document::redo()
{
    if (canRedo()) goTo(position_ + 1);
}

std::string Document::undoName() const
{
    return canUndo() ? history_[position_].name : std::string();
}
std::string Document::redoName() const
{
    return canRedo() ? history_[position_ + 1].name : std::string();
}

void Document::open(Scene scene, std::filesystem::path file, std::string historyName)
{
    history_.clear();
    evaluations_.clear();
    position_ = savedPosition_ = 0;
    previewing_ = false;
    file_ = std::move(file);
    auto next = std::make_shared<const Scene>(std::move(scene));
    Selection first;
    for (NodeId n : next->nodes())
        if (next->node(n).mesh || next->node(n).terrain) {
            first.nodes = {n};
            break;
        }
    history_.push_back({std::move(historyName), next, first, std::chrono::system_clock::now()});
    scene_ = std::move(next);
    selection_ = first;
    notify({Aspect::All, {}});
}

bool Document::modified() const
{
    return savedPosition_ != position_;
}

void Document::saved(std::filesystem::path file)
{
    file_ = std::move(file);
    savedPosition_ = position_;
    notify({Aspect::File | Aspect::History, {}});
}

std::shared_ptr<const Evaluation> Document::evaluation(MeshId id) const
{
    const auto i = evaluations_.find(id);
    return i == evaluations_.end() ? nullptr : i->second;
}

void Document::setEvaluation(MeshId id, std::shared_ptr<const Evaluation> e)
{
    if (!scene_->find(id)) return;  // deleted meanwhile
    evaluations_[id] = std::move(e);
    Change change{Aspect::Evaluation, {}};
    for (NodeId n : scene_->nodes())
        if (scene_->node(n).mesh == id) change.nodes.insert(n);
    notify(change);
}

Mesh Document::shownMesh(MeshId id) const
{
    const MeshObject* object = scene_->find(id);
    if (!object) return {};
    const auto e = evaluation(id);
    return e && !object->stack.empty() ? e->result() : object->base;
}

std::shared_ptr<void> Document::subscribe(Listener listener)
{
    auto token = std::make_shared<Listener>(std::move(listener));
    listeners_.push_back(token);
    return token;
}

void Document::notify(const Change& change)
{
    // Over a copy: a listener may subscribe or let go.
    std::erase_if(listeners_, [](const auto& l) { return l.expired(); });
    const auto listeners = listeners_;
    for (const auto& weak : listeners)
        if (const auto l = weak.lock()) (*l)(change);
}

void Document::show(std::shared_ptr<const Scene> next, const Selection& selection, Aspect also)
{
    Change change = changeBetween(*scene_, *next);
    scene_ = std::move(next);
    selection_ = selection;
    std::erase_if(evaluations_, [&](const auto& e) { return !scene_->find(e.first); });
    change.aspects = change.aspects | also | Aspect::Selection;
    notify(change);
}

}  // namespace mw
