// Edits that read files: scenes, motions, pictures of heights.
#include "core/catalog/lesson_scene.h"
#include "core/io/height_picture.h"
#include "core/io/io.h"
#include "core/scene/adopt_clips.h"
#include "core/scene/edit_entries.h"

namespace mw {
namespace {

struct Import {
    std::string file;
    double unit = 0;
    enum class Up { AsFile, Y, Z, X } up = Up::AsFile;
    bool hidden = false;
    template <class V>
    void describe(V& v)
    {
        v.file("file", file, {.title = "File", .help = "Which one, or sample:NAME."});
        v.number("unit", unit, {.title = "Unit", .help = "Length of a unit of the file; 0: as the file says.", .unit = "m", .min = 0, .max = 1e9});
        v.choice("up", up, {"file", "y", "z", "x"}, {.title = "Up", .help = "Axis that points up; file: as the file says."});
        v.flag("hidden", hidden, {.title = "Hidden", .help = "Comes in hidden, and the selection stays: a mesh that an operation works with."});
    }
};

std::string plainName(const std::string& file)
{
    const std::string name = std::filesystem::path(file).filename().string();
    return name.empty() ? file : name;
}

// Motion alone goes to the character it is for, when there is one; everything else is added.
void import(Scene& scene, const Import& p, EditRun& run)
{
    if (p.file.empty()) throw Error("no file is named");
    ImportOptions options;
    if (p.unit > 0) options.metresPerUnit = p.unit;
    if (p.up != Import::Up::AsFile) options.up = p.up == Import::Up::Y ? UpAxis::Y : p.up == Import::Up::Z ? UpAxis::Z : UpAxis::X;
    Imported read = readFile(p.file, run.progress, options);
    run.warnings = std::move(read.warnings);
    // `run` may know clips of an edit before this one.
    std::vector<ClipId> clips;
    if (read.scene.meshes().empty() && read.scene.terrains().empty()) clips = adoptClips(scene, read.scene);
    if (!clips.empty()) {
        run.clips = std::move(clips);
        return;
    }
    const std::vector<NodeId> made = scene.merge(read.scene);
    if (!p.hidden) {
        run.made = made;
        return;
    }
    for (const NodeId id : made) {
        Node n = scene.node(id);
        n.visible = false;
        scene.set(id, std::move(n));
    }
}

std::string importName(const Scene&, const Import& p)
{
    return plainName(p.file) + ": import";
}

struct Picture {
    std::string file, node;
    template <class V>
    void describe(V& v)
    {
        v.file("file", file, {.title = "File", .help = "A grey picture: PNG, TGA or PGM."});
        v.object("node", node, {.title = "Node", .help = "The terrain whose map it becomes; empty: a new terrain."});
    }
};

void picture(Scene& scene, const Picture& p, EditRun& run)
{
    if (p.file.empty()) throw Error("no file is named");
    HeightMap map = readHeightMap(p.file, &run.warnings, run.progress);
    if (p.node.empty()) {
        TerrainObject object;
        Node n;
        n.name = object.terrain.name = freeName(scene, std::filesystem::path(p.file).stem().string());
        object.terrain.map = std::move(map);
        n.terrain = scene.add(std::move(object));
        run.made = {scene.add(std::move(n))};
        return;
    }
    const Node& n = scene.node(nodeOf(scene, p.node));
    const TerrainObject* old = scene.find(n.terrain);
    if (!old) throw Error("\"" + n.name + "\" shows no terrain; name a node that does");
    TerrainObject object = *old;
    object.terrain.map = std::move(map);
    object.terrain.name = plainName(p.file);
    object.sourceOperation.clear();
    object.sourceValues.clear();
    scene.set(n.terrain, std::move(object));
}

std::string pictureName(const Scene& scene, const Picture& p)
{
    if (p.node.empty()) return plainName(p.file) + ": add terrain";
    return scene.node(nodeOf(scene, p.node)).name + ": height map " + plainName(p.file);
}

struct OpenLesson {
    std::string lesson;
    template <class V>
    void describe(V& v)
    {
        v.text("lesson", lesson, {.title = "Lesson", .help = "Its id, as the verb lessons lists it."});
    }
};

void openLesson(Scene& scene, const OpenLesson& p, EditRun& run)
{
    const Lesson* lesson = findLesson(p.lesson);
    if (!lesson) throw Error("there is no lesson \"" + p.lesson + "\"; the verb lessons lists them");
    const Value subject = lessonSubject(*lesson, run.progress);
    const Mesh* mesh = std::get_if<Mesh>(&subject);
    if (!mesh) throw Error("the lesson \"" + p.lesson + "\" is not about a mesh and has no scene");
    scene = sceneOf(*mesh, lesson->title);
    run.made = scene.roots();
}

std::string lessonName(const Scene&, const OpenLesson& p)
{
    const Lesson* lesson = findLesson(p.lesson);
    return "Lesson: " + (lesson ? lesson->title : p.lesson);
}

}  // namespace

std::vector<Edit> fileEdits()
{
    return {editEntry<Import>("import", "Import", "Adds what a file holds; motion alone goes to the character it is for.", import, importName, true),
            editEntry<Picture>("terrain-picture", "Terrain from picture", "Makes a terrain of a grey picture, or gives one another map.", picture,
                               pictureName, true),
            editEntry<OpenLesson>("lesson", "Open lesson", "Puts the scene of a lesson in place of what is there.", openLesson, lessonName)};
}

}  // namespace mw
