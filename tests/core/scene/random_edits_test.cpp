// Edits by seed, as a restless user makes them: every edit of the list, undo, redo, saving, loading. A state that was left and is come back to has
// the same hash, and the history's command line gives the last one again.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

#include "core/io/height_picture.h"
#include "core/io/io.h"
#include "core/mesh/select.h"
#include "core/scene/command_line.h"

namespace mw {
namespace {

class Folder {
public:
    explicit Folder(unsigned seed)
        : path_(std::filesystem::temp_directory_path() / ("mw-random-" + std::to_string(getpid()) + "-" + std::to_string(seed)))
    {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

/// Makes calls that may well go: of nodes there are, elements there are.
class Dice {
public:
    Dice(unsigned seed, const Folder& folder) : random_(seed), folder_(folder) {}

    size_t below(size_t n) { return n == 0 ? 0 : std::uniform_int_distribution<size_t>(0, n - 1)(random_); }
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    bool coin(double share = 0.5) { return real(0, 1) < share; }
    template <class T>
    const T& one(const std::vector<T>& of)
    {
        return of[below(of.size())];
    }

    EditCall call(const Scene& scene, const Edit& edit)
    {
        EditCall c{edit.id, {}};
        for (const Parameter& p : edit.parameters)
            if (auto v = value(scene, edit.id, p)) c.values[p.name] = *v;
        special(scene, c);
        return c;
    }

private:
    using Wanted = std::function<bool(const Node&)>;
    std::string node(const Scene& s, const Wanted& wanted)
    {
        std::vector<NodeId> fit;
        for (const NodeId n : s.nodes())
            if (wanted(s.node(n))) fit.push_back(n);
        return fit.empty() ? "#0" : nodeText(s, one(fit));
    }
    static bool any(const Node&) { return true; }
    static bool shape(const Node& n) { return n.mesh && !n.skin; }
    static bool ground(const Node& n) { return bool(n.terrain); }

    std::string name()
    {
        static const std::vector<std::string> all{"ball",      "a, b", "say \"hi\"",  "plus+minus", "#7",        "l\u00e9g\u00e8re",
                                                  "two words", " x",   "back\\slash", "it's",       "new\nline", "box"};
        return one(all) + (coin() ? "" : " " + std::to_string(below(50)));
    }
    std::string values(const Operation& op)
    {
        ParameterValues v;
        for (const Parameter& p : op.parameters)
            if (coin(0.4))
                if (auto x = plain(p)) v[p.name] = *x;
        return printed(op.parameters, v);
    }
    std::optional<ParameterValue> plain(const Parameter& p)
    {
        const auto low = [&](double ifNone) {
            return std::isfinite(p.about.softMin) ? p.about.softMin : std::isfinite(p.about.min) ? p.about.min : ifNone;
        };
        const auto high = [&](double ifNone) {
            return std::isfinite(p.about.softMax) ? p.about.softMax : std::isfinite(p.about.max) ? p.about.max : ifNone;
        };
        switch (p.type) {
            case ParameterType::Flag:
                return coin();
            case ParameterType::Choice:
                return one(p.choices);
            case ParameterType::Integer:
                return int64_t(std::floor(real(low(-5), std::min(high(5), low(-5) + 3))));
            case ParameterType::Number:
                return real(std::max(-1e3, low(-10)), std::min(1e3, high(10)));
            case ParameterType::Point: {
                const double a = std::max(low(-3), -3.0), b = std::min(high(3), 3.0);
                return glm::dvec3(real(a, b), real(a, b), real(a, b));
            }
            case ParameterType::Text:
                return name();
            default:
                return std::nullopt;
        }
    }
    std::optional<ParameterValue> value(const Scene& s, const std::string& edit, const Parameter& p)
    {
        const bool terrain = edit.find("terrain") != std::string::npos || edit == "stroke";
        const bool mesh =
            edit.find("modif") != std::string::npos || edit == "separate" || edit == "delete-elements" || edit.find("material") != std::string::npos;
        const Wanted wanted = terrain ? ground : mesh ? shape : any;
        if (p.name == "nodes") {
            std::string all = node(s, edit == "join" ? shape : any);
            for (size_t i = below(3) + (edit == "join"); i > 0; --i) all += "+" + node(s, edit == "join" ? shape : any);
            return all;
        }
        if (p.type == ParameterType::Object && p.name == "node" && (edit.ends_with("-modifier") || edit == "apply-modifiers"))
            if (const std::string n = node(s, [&](const Node& x) { return x.mesh && s.find(x.mesh)->stack.size() > 1; }); n != "#0") return n;
        if (p.type == ParameterType::Object && p.name == "node") return node(s, wanted);
        if (p.name == "to" && p.type == ParameterType::Object) return coin() ? std::string() : node(s, any);
        if (p.name == "material") return s.materials().empty() ? "none" : "#" + std::to_string(one(s.materials()).value);
        if (p.name == "clip") return s.clips().empty() ? "none" : "#" + std::to_string(one(s.clips()).value);
        if (p.name == "faces" || p.name == "elements") return std::string();
        if (p.name == "modifier" || (p.name == "to" && edit == "move-modifier")) return int64_t(1 + below(2));
        return plain(p);
    }

    const Mesh* meshIn(const Scene& s, const EditCall& c)
    {
        const auto i = c.values.find("node");
        if (i == c.values.end() || std::get<std::string>(i->second) == "#0") return nullptr;
        const MeshObject* o = s.find(s.node(nodeOf(s, std::get<std::string>(i->second))).mesh);
        return o ? &o->base : nullptr;
    }
    std::string someElements(const Mesh& m, const std::string& kind)
    {
        ElementSet set{kind == "edges" ? ElementKind::Edge : kind == "vertices" ? ElementKind::Vertex : ElementKind::Face, {}};
        const size_t count = set.kind == ElementKind::Edge ? m.edges().size() / 2 : set.kind == ElementKind::Vertex ? m.vertexCount() : m.faceCount();
        const size_t from = below(count), to = std::min(count, from + 1 + below(12));
        for (uint32_t i = uint32_t(from); i < to; ++i) {
            if (set.kind == ElementKind::Edge)
                set.indices.insert(set.indices.end(), {m.edges()[2 * i], m.edges()[2 * i + 1]});
            else
                set.indices.push_back(i);
        }
        return elementText(set);
    }

    // What plain dice would hardly ever get right.
    void special(const Scene& s, EditCall& c)
    {
        const std::string& id = c.id;
        if (id == "add") c.values = {{"op", std::string("icosphere")}, {"with", "subdivisions=" + std::to_string(below(3))}, {"name", name()}};
        if (id == "new-terrain" || id == "generate-terrain") {
            c.values["op"] = std::string("diamond-square");
            c.values["with"] = "size=" + std::string(coin() ? "33" : "65") + ",seed=" + std::to_string(below(99));
        }
        if (id == "import") {
            static const std::vector<std::string> files{"mesh.obj", "map.png"};
            c.values = {{"file", coin(0.05) ? std::string("sample:mannequin") : folder_.file(one(files))}};
            if (coin()) c.values["unit"] = 0.01;
            if (coin()) c.values["up"] = std::string("z");
        }
        if (id == "terrain-picture") {
            c.values["file"] = folder_.file("map.png");
            if (coin()) c.values.erase("node");
        }
        if (id == "modify") {
            static const std::vector<std::string> ops{"smooth", "weld", "subdivide-loop", "decimate-quadric"};
            const Operation& op = operation(one(ops));
            c.values["op"] = op.id;
            c.values["with"] = op.id == "subdivide-loop" ? std::string() : values(op);
        }
        if (id == "set-modifier") {
            const MeshObject* o = s.find(
                std::get<std::string>(c.values.at("node")) == "#0" ? MeshId{} : s.node(nodeOf(s, std::get<std::string>(c.values.at("node")))).mesh);
            const Operation* op = o && !o->stack.empty() ? findOperation(o->stack[0].operation) : nullptr;
            c.values["modifier"] = int64_t(1);
            c.values["with"] = op && op->id != "subdivide-loop" ? values(*op) : std::string();
        }
        if (id == "apply-modifiers") c.values.erase("levels");
        if (id == "set-terrain") c.values["with"] = "waterLevel=" + std::to_string(below(50)) + (coin() ? ",patches=8" : "");
        if (id == "terrain-mesh") c.values["triangles"] = int64_t(200 + below(500));
        if (id == "stroke") {
            std::string way;
            for (size_t i = 1 + below(6); i > 0; --i)
                way += (way.empty() ? "" : ";") + std::to_string(real(-500, 500)) + "/" + std::to_string(real(-500, 500));
            c.values["points"] = way;
            c.values["radius"] = real(20, 200);
        }
        if (id == "assign-material") {
            const auto painted = [&](const Node& n) { return n.mesh && !s.find(n.mesh)->materials.empty(); };
            if (const std::string n = node(s, painted); n != "#0") {
                c.values["node"] = n;
                c.values["slot"] = int64_t(below(s.find(s.node(nodeOf(s, n)).mesh)->materials.size()));
            }
        }
        if (id == "separate" || id == "delete-elements" || id == "new-material" || id == "assign-material")
            if (const Mesh* m = meshIn(s, c); m && m->faceCount() > 0) {
                const std::string kind = id == "delete-elements" ? std::get<std::string>(c.values.at("kind")) : "faces";
                c.values[id == "delete-elements" ? "elements" : "faces"] = someElements(*m, kind);
            }
    }

    std::mt19937 random_;
    const Folder& folder_;
};

void writeFiles(const Folder& folder)
{
    std::ofstream(folder.file("mesh.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                              "g base\nf 1/1 2/2 3/3 4/4\ng side\nf 1/1 5/2 2/3\nl 3 5\n";
    Array<float> heights(17 * 17);
    for (size_t i = 0; i < heights.size(); ++i) heights[i] = float(i % 17) / 32;
    writeHeightMap(HeightMap(17, 17, heights), folder.file("map.png"));
}

class RandomEdits : public testing::TestWithParam<unsigned> {};

/// The document and what its entries hashed to when they were made.
struct Watched {
    explicit Watched(const Folder& f) : folder(f) {}
    Document document;
    std::vector<uint64_t> hashes{contentHash(document.scene())};
    const Folder& folder;
    int files = 0;

    void check(const char* what)
    {
        ASSERT_EQ(hashes.size(), document.history().size() + document.forgotten().size());
        EXPECT_EQ(contentHash(document.scene()), hashes[document.forgotten().size() + document.historyPosition()]) << what;
    }
    // Through the text of the command line. False when it was refused: then nothing has changed.
    bool edit(const EditCall& call)
    {
        const uint64_t before = contentHash(document.scene());
        const size_t entries = document.history().size(), position = document.historyPosition();
        try {
            const EditCall again = parsedEdit(commandText(call));
            EXPECT_EQ(again.values, unlikeDefaults(editOf(call.id).parameters, call.values)) << commandText(call);
            commitEdit(document, again);
        } catch (const Error&) {
            EXPECT_EQ(contentHash(document.scene()), before) << commandText(call);
            EXPECT_EQ(document.history().size(), entries);
            return false;
        }
        if (document.historyPosition() == position && document.history().size() == entries) {
            EXPECT_EQ(contentHash(document.scene()), before) << "changed without an entry: " << commandText(call);
            return true;
        }
        EXPECT_FALSE(document.undoName().empty());
        hashes.resize(document.forgotten().size() + document.historyPosition());
        hashes.push_back(contentHash(document.scene()));
        return true;
    }
    // The file holds the same; now and then one goes on with it.
    void saveAndLoad(bool goOn)
    {
        const std::string file = folder.file(std::to_string(files++) + ".glb");
        writeFile(document.scene(), file, {.project = true});
        Imported read = readFile(file);
        EXPECT_TRUE(read.project);
        EXPECT_EQ(contentHash(read.scene), contentHash(document.scene())) << file;
        if (!goOn) return document.saved(file);
        document.open(std::move(read.scene), file, "Open");
        hashes = {contentHash(document.scene())};
    }
};

// So that there is something for an edit to work on.
void prepare(Watched& w, const std::string& id)
{
    const auto scene = [&]() -> const Scene& { return w.document.scene(); };
    if (id.ends_with("-clip") && scene().clips().empty()) w.edit(parsedEdit("import:file=sample:mannequin"));
    if ((id.find("terrain") != std::string::npos || id == "stroke") && scene().terrains().empty()) w.edit(parsedEdit("new-terrain:with=size=33"));
    if (id.ends_with("-modifier") || id == "apply-modifiers") {
        for (const NodeId n : scene().nodes())
            if (const MeshObject* o = scene().find(scene().node(n).mesh); o && o->stack.size() > 1) return;
        w.edit(parsedEdit("add:name=stacked"));
        for (const char* op : {"weld", "smooth"})
            w.edit(parsedEdit("modify:node=" + nodeText(scene(), w.document.selection().active()) + ",op=" + op));
    }
    if (scene().nodes().size() < 3) {
        w.edit(parsedEdit("add:name=ball 98"));
        w.edit(parsedEdit("add:name=ball 99"));
    }
}

TEST_P(RandomEdits, EveryStateComesBack)
{
    const Folder folder(GetParam());
    writeFiles(folder);
    Dice dice(GetParam(), folder);
    Watched w(folder);
    for (const char* first : {"add:name=ball", "add:with=subdivisions=2,name=box", "import:file=sample:mannequin", "new-terrain:with=size=65"})
        w.edit(parsedEdit(first));
    std::vector<const Edit*> order;
    std::map<std::string, int> done;
    for (int step = 0; step < 1000; ++step) {
        if (order.empty())
            for (const Edit& e : editList()) order.insert(order.begin() + ptrdiff_t(dice.below(order.size() + 1)), &e);
        const Edit& edit = *order.back();
        order.pop_back();
        const size_t nodes = w.document.scene().nodes().size();
        if (nodes > 150 && (edit.id == "duplicate" || edit.id == "import")) continue;
        prepare(w, edit.id);
        const EditCall call = dice.call(w.document.scene(), edit);
        done[edit.id] += w.edit(call);
        if (testing::Test::HasFailure()) FAIL() << "step " << step << ": " << commandText(call);
        if (dice.coin(0.15)) w.document.undo();
        if (dice.coin(0.10)) w.document.redo();
        if (dice.coin(0.05)) w.document.goTo(dice.below(w.document.history().size()));
        w.check("after undo and redo");
        if (dice.coin(0.02)) w.saveAndLoad(dice.coin(0.2));
        if (testing::Test::HasFailure()) FAIL() << "step " << step << ": " << commandText(call);
    }
    for (const Edit& e : editList()) {
        EXPECT_TRUE(done.contains(e.id)) << e.id << " did not occur";
    }
    for (const char* id : {"add",
                           "apply-modifiers",
                           "assign-material",
                           "delete",
                           "delete-clip",
                           "delete-elements",
                           "duplicate",
                           "duplicate-clip",
                           "duplicate-modifier",
                           "enable-modifier",
                           "generate-terrain",
                           "group",
                           "import",
                           "join",
                           "modify",
                           "move-modifier",
                           "new-material",
                           "new-terrain",
                           "own-copy",
                           "remove-modifier",
                           "rename",
                           "rename-clip",
                           "reparent",
                           "separate",
                           "set-modifier",
                           "set-terrain",
                           "show",
                           "stroke",
                           "terrain-mesh",
                           "terrain-picture",
                           "transform"}) {
        EXPECT_GT(done[id], 0) << id << " was refused each time";  // further ones may want more than dice can guess
    }
    // The command line, from what the document was opened from; the dice may have left it as it was opened.
    w.edit(parsedEdit("add:name=last"));
    const std::vector<EditCall> calls = callsUpTo(w.document, w.document.historyPosition());
    EXPECT_FALSE(calls.empty());
    std::vector<EditCall> again;
    for (const EditCall& c : calls) again.push_back(parsedEdit(commandText(c)));
    EditRun run;
    const std::string& source = w.document.source().input;
    const Scene scene = replayed(source == "-" ? Scene() : readFile(source).scene, again, run);
    EXPECT_EQ(contentHash(scene), contentHash(w.document.scene()));
    EXPECT_NE(commandLine(w.document, w.document.historyPosition()).find(" -o result.glb"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdits, testing::Values(1u, 2u, 3u));

}  // namespace
}  // namespace mw
