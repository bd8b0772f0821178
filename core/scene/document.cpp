#include "core/scene/document.h"

#include <algorithm>

namespace mw {

bool Selection::has(NodeId n) const
{
    return std::find(nodes.begin(), nodes.end(), n) != nodes.end();
}

namespace {

bool sameFaces(const Mesh& a, const Mesh& b)
{
    return a.vertexCount() == b.vertexCount() && a.cornerVertex().id() == b.cornerVertex().id() && a.faceStart().id() == b.faceStart().id();
}

bool sameBase(const Mesh& a, const Mesh& b)
{
    return a.positions().id() == b.positions().id() && sameFaces(a, b);
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

// Calls f(address, bytes) for every array that a scene holds; several times for one that is shared.
void forArrays(const Scene& s, const std::function<void(const void*, size_t)>& f)
{
    const auto tell = [&](const auto& array) {
        if (array.id()) f(array.id(), array.bytes());
    };
    for (MeshId id : s.meshes()) {
        const Mesh& m = s.find(id)->base;
        tell(m.positions());
        tell(m.cornerVertex());
        tell(m.faceStart());
        tell(m.lines());
        for (const Attribute& a : m.attributes()) tell(a);
    }
    for (ClipId id : s.clips())
        for (const auto& channel : s.find(id)->channels) tell(channel->values);
    for (ImageId id : s.images())
        if (const auto& bytes = s.find(id)->bytes) f(bytes.get(), bytes->size());
    for (TerrainId id : s.terrains()) {
        const HeightMap& map = s.find(id)->terrain.map;
        for (uint32_t y = 0; y < map.tilesY(); ++y)
            for (uint32_t x = 0; x < map.tilesX(); ++x) tell(map.tile(x, y));
    }
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
    // Places may move under a selection of a base mesh; what a stack makes of them may have other elements.
    const bool moved = from && to && sameFaces(from->base, to->base) && from->stack.empty() && to->stack.empty();
    if (from == to || moved || (from && to && sameBase(from->base, to->base) && from->stack == to->stack)) {
        out.elementsOf = s.elementsOf;
        out.elements = s.elements;
    }
    return out;
}

}  // namespace

Document::Document() : scene_(std::make_shared<const Scene>())
{
    history_.push_back({"New scene", scene_, {}, std::chrono::system_clock::now()});
    source_ = Source{std::string(1, '-'), {}};
}

void Document::commit(std::string name, Scene next, std::vector<EditCall> calls)
{
    const Selection kept = valid(selection_, *scene_, next);
    commit(std::move(name), std::move(next), kept, std::move(calls));
}

void Document::commit(std::string name, Scene next, Selection selection, std::vector<EditCall> calls)
{
    if (savedPosition_ != never && savedPosition_ > position_) savedPosition_ = never;  // the saved state is being cut off
    for (size_t i = position_ + 1; i < history_.size(); ++i) count(*history_[i].scene, -1);
    history_.resize(position_ + 1);
    auto scene = std::make_shared<const Scene>(std::move(next));
    count(*scene, 1);
    history_.push_back({std::move(name), scene, selection, std::chrono::system_clock::now(), std::move(calls)});
    ++position_;
    dropOldest();
    previewing_ = false;
    show(std::move(scene), selection, Aspect::History);
}

void Document::boundHistory(size_t bytes)
{
    historyBytes_ = bytes;
    dropOldest();
}

// Forgets the oldest entries while those before the present hold too much; what the present shares with them costs nothing.
void Document::dropOldest()
{
    while (position_ > 1 && historyOnlyBytes() > historyBytes_) {
        count(*history_.front().scene, -1);
        forgotten_.push_back(std::move(history_.front()));
        forgotten_.back().scene.reset();
        history_.erase(history_.begin());
        --position_;
        savedPosition_ = savedPosition_ == never || savedPosition_ == 0 ? never : savedPosition_ - 1;
    }
}

void Document::count(const Scene& scene, int by)
{
    forArrays(scene, [&](const void* key, size_t bytes) {
        const auto i = held_.try_emplace(key, 0, bytes).first;
        if (i->second.first == 0) heldBytes_ += bytes;
        i->second.first += size_t(by);
        if (i->second.first > 0) return;
        heldBytes_ -= bytes;
        held_.erase(i);
    });
}

size_t Document::historyOnlyBytes() const
{
    std::set<const void*> seen;
    size_t present = 0;
    forArrays(*history_[position_].scene, [&](const void* key, size_t bytes) { present += seen.insert(key).second ? bytes : 0; });
    return heldBytes_ - present;
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

void Document::open(Scene scene, std::filesystem::path file, std::string historyName, Source source)
{
    history_.clear();
    forgotten_.clear();
    held_.clear();
    heldBytes_ = sourceEntry_ = 0;
    source_ = std::move(source);
    if (source_.input.empty()) source_.input = file.string();
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
    count(*next, 1);
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
    if (file_.string() == source_.input) {  // what was read is there no more
        source_ = {file_.string(), {}};
        sourceEntry_ = forgotten_.size() + position_;
    }
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
