// The open document: present scene, named history, selection, and the one change notice after each edit. One thread (the window's).
#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/scene/evaluation.h"
#include "core/scene/scene.h"

namespace mw {

/// Selected nodes, and at most one set of elements of one of them.
struct Selection {
    std::vector<NodeId> nodes;  ///< in order of selection; the last is the active one
    NodeId elementsOf;
    ElementSet elements;
    NodeId active() const { return nodes.empty() ? NodeId{} : nodes.back(); }
    bool has(NodeId n) const;
};

enum class Aspect : unsigned {
    Tree = 1,
    Transform = 2,
    Mesh = 4,
    Stack = 8,
    Material = 16,
    Selection = 32,
    History = 64,
    Evaluation = 128,
    File = 256,
    Skin = 512,  ///< skins, joints, morph weights
    Clip = 1024,
    Terrain = 2048,
    All = ~0u
};
constexpr Aspect operator|(Aspect a, Aspect b)
{
    return Aspect(unsigned(a) | unsigned(b));
}
constexpr bool operator&(Aspect a, Aspect b)
{
    return (unsigned(a) & unsigned(b)) != 0;
}

/// One edit of the list in core/scene/edit.h, as it was called.
struct EditCall {
    std::string id;
    ParameterValues values;
    bool operator==(const EditCall&) const = default;
};

struct Change {
    Aspect aspects;
    std::set<NodeId> nodes;  ///< those concerned; empty: ask the scene
};

/// What a document was opened from, as the words of a command line.
struct Source {
    std::string input;                      ///< a file, "sample:NAME", "-": an empty scene; empty: a shell cannot make it
    std::vector<std::string> options = {};  ///< how it was read: {"--up", "z"}
};

class Document {
public:
    Document();

    const Scene& scene() const { return *scene_; }
    std::shared_ptr<const Scene> snapshot() const { return scene_; }
    const Selection& selection() const { return selection_; }

    /// One history entry. What changed is found by comparing. Ends a preview. `calls` are the edits that do the same again; none: no command
    /// line can repeat it.
    void commit(std::string name, Scene next, std::vector<EditCall> calls = {});
    void commit(std::string name, Scene next, Selection selection, std::vector<EditCall> calls = {});
    /// Shown, but in no history: a drag that goes on. The next commit or cancelPreview() ends it.
    void preview(Scene next);
    void cancelPreview();
    void select(Selection selection);

    struct Entry {
        std::string name;
        std::shared_ptr<const Scene> scene;
        Selection selection;
        std::chrono::system_clock::time_point at;
        std::vector<EditCall> calls = {};
    };
    const std::vector<Entry>& history() const { return history_; }
    size_t historyPosition() const { return position_; }  ///< of the present entry
    void goTo(size_t position);
    bool canUndo() const { return position_ > 0; }
    bool canRedo() const { return position_ + 1 < history_.size(); }
    void undo();
    void redo();
    std::string undoName() const;  ///< of the edit that undo takes back
    std::string redoName() const;

    /// What history may hold beyond the present, bytes; the oldest entries go first. Their calls stay.
    void boundHistory(size_t bytes);
    const std::vector<Entry>& forgotten() const { return forgotten_; }  ///< without scenes, oldest first

    /// A new document: history begins anew with this scene. `source` is the file when nothing else is said.
    void open(Scene scene, std::filesystem::path file, std::string historyName, Source source = {});
    const Source& source() const { return source_; }
    size_t sourceEntry() const { return sourceEntry_; }  ///< number of the entry that source() gives, forgotten ones counted
    const std::filesystem::path& file() const { return file_; }
    bool modified() const;
    void saved(std::filesystem::path file);  ///< marks the present state as the one on disk

    /// The last good result of a mesh object, set by whoever runs the jobs. Null until the first; may lag behind the stack.
    std::shared_ptr<const Evaluation> evaluation(MeshId id) const;
    void setEvaluation(MeshId id, std::shared_ptr<const Evaluation> e);
    /// What is to be shown of it: the result, or the base while there is none.
    Mesh shownMesh(MeshId id) const;

    /// Told after each change. Keep the returned token; letting it go ends the subscription.
    using Listener = std::function<void(const Change&)>;
    [[nodiscard]] std::shared_ptr<void> subscribe(Listener listener);

private:
    void notify(const Change& change);
    void show(std::shared_ptr<const Scene> next, const Selection& selection, Aspect also);
    void dropOldest();
    void count(const Scene& scene, int by);
    size_t historyOnlyBytes() const;

    static constexpr size_t never = ~size_t(0);  // of savedPosition_: the state on disk is in no entry

    std::shared_ptr<const Scene> scene_;
    Selection selection_;
    std::vector<Entry> history_, forgotten_;
    std::map<const void*, std::pair<size_t, size_t>> held_;  // arrays of all entries: how many entries have it, its bytes
    size_t heldBytes_ = 0;
    Source source_;
    size_t sourceEntry_ = 0;
    size_t position_ = 0, savedPosition_ = 0;
    bool previewing_ = false;
    size_t historyBytes_ = size_t(2) << 30;  // bound on what only history holds
    std::filesystem::path file_;
    std::map<MeshId, std::shared_ptr<const Evaluation>> evaluations_;
    std::vector<std::weak_ptr<Listener>> listeners_;
};

}  // namespace mw
