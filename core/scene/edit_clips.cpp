// Edits of motions: names, copies.
#include "core/scene/animate_morph.h"
#include "core/scene/edit_entries.h"

namespace mw {
namespace {

ClipId clipOf(const Scene& scene, const std::string& text)
{
    ClipId found;
    for (const ClipId id : scene.clips()) {
        if (scene.find(id)->name != text && "#" + std::to_string(id.value) != text) continue;
        if (found) throw Error("several clips are called \"" + text + "\"; name one by its number, #" + std::to_string(found.value));
        found = id;
    }
    if (!found) throw Error("there is no clip \"" + text + "\"");
    return found;
}

struct Which {
    std::string clip;
    template <class V>
    void describe(V& v)
    {
        v.object("clip", clip, {.title = "Clip", .help = "Its name, or # and its number."});
    }
};

struct Rename {
    Which which;
    std::string name;
    template <class V>
    void describe(V& v)
    {
        which.describe(v);
        v.text("name", name, {.title = "Name", .help = "Its new name."});
    }
};

void rename(Scene& scene, const Rename& p, EditRun&)
{
    if (p.name.find_first_not_of(" \t\n") == std::string::npos) throw Error("a clip wants a name");
    const ClipId id = clipOf(scene, p.which.clip);
    Clip clip = *scene.find(id);
    clip.name = p.name;
    scene.set(id, std::move(clip));
}

std::string renameName(const Scene& scene, const Rename& p)
{
    return scene.find(clipOf(scene, p.which.clip))->name + ": rename to " + p.name;
}

void duplicate(Scene& scene, const Which& p, EditRun& run)
{
    Clip clip = *scene.find(clipOf(scene, p.clip));
    clip.name += " copy";
    run.clips = {scene.add(std::move(clip))};
}

std::string duplicateName(const Scene& scene, const Which& p)
{
    return scene.find(clipOf(scene, p.clip))->name + ": duplicate";
}

void remove(Scene& scene, const Which& p, EditRun&)
{
    scene.remove(clipOf(scene, p.clip));
}

std::string removeName(const Scene& scene, const Which& p)
{
    return scene.find(clipOf(scene, p.clip))->name + ": delete";
}

struct AnimateMorph {
    std::string node;
    int64_t target = 0;
    double seconds = 4;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which one, by its name."});
        v.integer("target", target, {.title = "Target", .help = "Which of its morph targets, counted from 1; 0: the last.", .min = 0, .max = 10000});
        v.number("seconds", seconds,
                 {.title = "Duration", .help = "There and back.", .unit = "s", .min = 0.01, .max = 3600, .softMin = 0.5, .softMax = 20});
    }
};

void animateMorph(Scene& scene, const AnimateMorph& p, EditRun& run)
{
    run.clips = {scene.add(morphClip(scene, nodeOf(scene, p.node), size_t(p.target), p.seconds))};
}

std::string animateName(const Scene& scene, const AnimateMorph& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": animate morph";
}

}  // namespace

std::vector<Edit> clipEdits()
{
    return {editEntry<Rename>("rename-clip", "Rename clip", "Gives a motion another name.", rename, renameName),
            editEntry<Which>("duplicate-clip", "Duplicate clip", "Copies a motion.", duplicate, duplicateName),
            editEntry<Which>("delete-clip", "Delete clip", "Removes a motion.", remove, removeName),
            editEntry<AnimateMorph>("animate-morph", "Animate morph", "Adds a motion that plays a morph target there and back.", animateMorph,
                                    animateName)};
}

}  // namespace mw
