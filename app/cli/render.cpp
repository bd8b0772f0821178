// render FILE -o PNG: a picture of what a file shows, without a display.
#include <map>

#include "app/cli/clip_options.h"
#include "app/cli/operation_call.h"
#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "app/cli/placement_options.h"
#include "app/cli/verb.h"
#include "core/io/io.h"
#include "render/offscreen.h"

namespace mw::cli {

namespace {

struct Style {
    Shading shading = Shading::Smooth;
    bool wire = false;
    std::optional<OperationCall> metric;
};

Style parseStyle(const std::string& text)
{
    constexpr std::string_view heat = "heat:";
    if (text == "shaded") return {};
    if (text == "flat") return {Shading::Flat, true, {}};
    if (text == "wire") return {Shading::Wire, false, {}};
    if (!text.starts_with(heat)) throw UsageError("--style wants shaded, flat, wire or heat:METRIC, not \"" + text + "\"");
    Style s;
    s.metric = parseCall(std::string_view(text).substr(heat.size()));
    const Operation& op = *s.metric->operation;
    if (op.accepts != Kind::Mesh || op.yields != Kind::Table)
        throw Error("the operation " + op.id + " gives no numbers on a mesh to colour by; `meshwright algorithms` lists those that yield a table");
    return s;
}

/// The metric of every mesh, all over one range, so that colours can be compared.
void colourBy(Frame& frame, const OperationCall& metric, Progress* progress)
{
    std::map<const void*, std::shared_ptr<HeatMap>> byMesh;
    double low = 0, high = 0;
    bool first = true;
    for (DrawObject& o : frame.objects) {
        if (o.mesh.faceCount() == 0) continue;
        std::shared_ptr<HeatMap>& heat = byMesh[o.mesh.positions().id()];
        if (!heat) {
            Table table = std::get<Table>(apply(*metric.operation, o.mesh, metric.values, progress));
            if (table.columns.empty() || (table.rows != ElementKind::Vertex && table.rows != ElementKind::Face))
                throw Error("the operation " + metric.operation->id + " gives no number for each vertex or face; choose another metric");
            heat = std::make_shared<HeatMap>(*heatMapOf(std::move(table)));
            low = first ? heat->low : std::min(low, heat->low);
            high = first ? heat->high : std::max(high, heat->high);
            first = false;
        }
        o.heat = heat;
    }
    for (auto& [mesh, heat] : byMesh) {
        heat->low = low;
        heat->high = high;
    }
}

/// What stands for a mesh where there is none: bones, unless both or one alone are asked for.
void choose(Frame& frame, const std::string& show)
{
    if (show == "mesh" || (show.empty() && !frame.objects.empty())) frame.bones.clear();
    if (show == "bones") frame.objects.clear();
}

int run(Arguments& arguments)
{
    const std::optional<std::string> out = arguments.value("--output", "-o");
    const PictureSize size = takeSize(arguments, {1280, 800});
    const Theme theme = takeTheme(arguments);
    const std::string styleText = arguments.value("--style").value_or("shaded");
    const std::string view = arguments.value("--view").value_or("32,17");
    const bool transparent = arguments.flag("--transparent");
    const std::string show = arguments.value("--show").value_or("");
    const ClipOptions when = takeClipOptions(arguments);
    const std::optional<std::string> motion = arguments.value("--motion");
    const ImportOptions options = takeImportOptions(arguments);
    const std::vector<std::string> files = arguments.finish({"FILE"});
    if (!out) throw UsageError("say where the picture goes: -o PNG");
    if (!show.empty() && show != "mesh" && show != "bones" && show != "both")
        throw UsageError("--show wants mesh, bones or both, not \"" + show + "\"");
    const Style style = parseStyle(styleText);
    Camera camera;
    if (!setView(camera, view))
        throw UsageError("--view wants front, back, left, right, top, bottom or AZIMUTH,ELEVATION in degrees, not \"" + view + "\"");

    Working working("reading " + files[0]);
    Imported in = readFile(files[0], working.progress(), options);
    if (motion) addMotion(in.scene, files[0], *motion, working.progress());
    warn(files[0], in.warnings);
    std::map<MeshId, Mesh> shownMeshes;
    for (const MeshId id : in.scene.meshes()) shownMeshes[id] = evaluated(*in.scene.find(id), working.progress());
    ScenePose pose;
    if (when) pose = poseAt(in.scene, clipOf(files[0], in.scene, when), when.time.value_or(0));
    Frame frame = frameOf(
        in.scene, [&](MeshId id) { return shownMeshes[id]; }, pose);
    choose(frame, show);
    frame.camera = camera;
    frame.options.theme = theme;
    frame.options.shading = style.shading;
    frame.options.wireOverlay = style.wire;
    frame.options.transparentBackground = transparent;
    if (transparent) frame.options.grid = frame.options.axes = frame.options.orientationMarker = false;
    if (style.metric) colourBy(frame, *style.metric, working.progress());
    frameTightly(frame, double(size.width) / size.height);
    working.now("drawing");
    Offscreen offscreen;
    writePng(offscreen.draw(frame, size.width, size.height), *out);
    return 0;
}

}  // namespace

const Verb renderVerb{
    "render", "a picture of a file, without a display",
    "render FILE -o PNG [--time S] [--clip NAME|#INDEX] [--motion FILE] [--show mesh|bones|both] [--size WxH] [--style STYLE] [--view VIEW]\n"
    "       [--theme dark|light] [--transparent] [--unit UNIT] [--up y|z|x]\n\n"
    "  --time S        seconds into the clip; without --time and --clip the file rests\n"
    "  --clip CLIP     by name, or #0 for the first one, which is taken unless said\n"
    "  --motion FILE   also the clips of this file, made for the same skeleton (same names of joints)\n"
    "  --show WHAT     mesh, bones or both; the mesh unless said, bones where there is no mesh\n"
    "  --size WxH      pixels, 1280x800 unless said\n"
    "  --style STYLE   shaded (as the materials say), flat (faces and edges), wire, or heat:METRIC[:k=v,...], where METRIC is a\n"
    "                  query of `meshwright algorithms` that gives a number for each vertex or face (heat:vertex-valence)\n"
    "  --view VIEW     front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees; 32,17 unless said\n"
    "  --transparent   the model alone, nothing behind it\n"
    "  --unit UNIT, --up y|z|x   how the file's numbers are meant; see meshwright convert --help\n",
    run};

}  // namespace mw::cli
