// render FILE -o PNG: a picture of what a file shows, or of it turning, without a display.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "app/cli/clip_options.h"
#include "app/cli/operation_call.h"
#include "app/cli/other_mesh.h"
#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "app/cli/placement_options.h"
#include "app/cli/render_compare.h"
#include "app/cli/verb.h"
#include "core/catalog/others.h"
#include "core/io/io.h"
#include "render/animated_png.h"
#include "render/offscreen.h"
#include "render/turntable.h"

namespace mw::cli {

namespace {

/// The metric of every mesh, all over one range, so that colours can be compared.
void colourBy(Frame& frame, const OperationCall& metric, const Scene& scene, Progress* progress)
{
    std::map<const void*, std::shared_ptr<HeatMap>> byMesh;
    const Others others = othersOf(*metric.operation, metric.values, meshesOf(scene, progress), progress);
    double low = 0, high = 0;
    bool first = true;
    for (DrawObject& o : frame.objects) {
        if (o.mesh.faceCount() == 0) continue;
        std::shared_ptr<HeatMap>& heat = byMesh[o.mesh.positions().id()];
        if (!heat) {
            Table table = std::get<Table>(apply(*metric.operation, o.mesh, metric.values, progress, others));
            if (table.columns.empty() || table.rows == ElementKind::Object)
                throw Error("the operation " + metric.operation->id + " gives no number for each vertex, edge or face; choose another metric");
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

bool isAnimation(const std::string& file)
{
    return file.ends_with(".apng");
}

/// "turn.png" and 7: "turn-007.png".
std::string numbered(const std::string& file, int i)
{
    const std::filesystem::path path(file);
    char digits[16];
    std::snprintf(digits, sizeof digits, "-%03d", i);
    return (path.parent_path() / (path.stem().string() + digits + path.extension().string())).string();
}

void drawTurntable(Frame& frame, const PictureSize& size, int count, const std::string& out, Working& working)
{
    Offscreen offscreen;
    std::optional<AnimatedPng> animation;
    if (isAnimation(out)) animation.emplace(out, count, std::clamp(4.0 / count, 0.02, 0.2));  // a turn takes some four seconds
    const Camera first = frame.camera;
    const double firstTurn = frame.options.environmentTurn;
    for (int i = 0; i < count; ++i) {
        working.now("drawing " + std::to_string(i + 1) + " of " + std::to_string(count));
        turn(frame, first, firstTurn, i, count);
        const Picture picture = offscreen.draw(frame, size.width, size.height);
        if (animation)
            animation->add(picture);
        else
            writePng(picture, numbered(out, i));
    }
    if (animation) animation->finish();
}

struct Wanted {
    std::string file, out;
    PictureSize size;
    PictureLook look;
    Camera camera;
    bool cameraGiven = false;
    int turntable = 0;
    std::vector<Variant> variants;
    std::string show;
    ClipOptions when;
    std::optional<std::string> motion;
    ImportOptions reading;
};

Wanted take(Arguments& arguments)
{
    Wanted w;
    const std::optional<std::string> out = arguments.value("--output", "-o");
    w.size = takeSize(arguments, {1280, 800});
    w.look = takeLook(arguments);
    const std::optional<std::string> view = arguments.value("--view");
    const std::optional<Camera> camera = takeCamera(arguments);
    const std::optional<long> turntable = arguments.number("--turntable", 2, 3600);
    w.variants = takeVariants(arguments);
    w.show = arguments.value("--show").value_or("");
    w.when = takeClipOptions(arguments);
    w.motion = arguments.value("--motion");
    w.reading = takeImportOptions(arguments);
    w.file = arguments.finish({"FILE"})[0];
    if (!out) throw UsageError("say where the picture goes: -o PNG");
    w.out = *out;
    if (!w.show.empty() && w.show != "mesh" && w.show != "bones" && w.show != "both")
        throw UsageError("--show wants mesh, bones or both, not \"" + w.show + "\"");
    if (camera && view) throw UsageError("--camera and --view both say from where; give one");
    if (camera && turntable) throw UsageError("--camera stands still; a turntable takes --view");
    if (turntable && !w.variants.empty()) throw UsageError("--compare makes one picture; leave --turntable out");
    if (isAnimation(w.out) && !turntable) throw UsageError("an .apng file is a turntable: say --turntable N, or write a .png");
    if (camera) w.camera = *camera;
    w.cameraGiven = camera.has_value();
    w.turntable = int(turntable.value_or(0));
    if (!camera && !setView(w.camera, view.value_or("32,17")))
        throw UsageError("--view wants front, back, left, right, top, bottom or AZIMUTH,ELEVATION in degrees, not \"" + *view + "\"");
    return w;
}

void drawVariants(const Frame& base, const Wanted& w, const Scene& scene, Working& working)
{
    working.now("comparing");
    std::vector<Frame> frames = variantFrames(base, w.variants, working.progress());
    if (w.look.metric)
        for (Frame& f : frames) colourBy(f, *w.look.metric, scene, working.progress());
    shareRange(frames);
    const PictureSize each = viewSize(w.size, frames.size());
    if (!w.cameraGiven) shareCamera(frames, double(each.width) / each.height);
    working.now("drawing");
    Offscreen offscreen;
    writePng(sideBySide(offscreen, frames, w.variants, w.size), w.out);
}

int run(Arguments& arguments)
{
    const Wanted w = take(arguments);
    Working working("reading " + w.file);
    Imported in = readFile(w.file, working.progress(), w.reading);
    if (w.motion) addMotion(in.scene, w.file, *w.motion, working.progress());
    warn(w.file, in.warnings);
    std::map<MeshId, Mesh> shownMeshes;
    for (const MeshId id : in.scene.meshes()) shownMeshes[id] = evaluated(*in.scene.find(id), working.progress(), nullptr, &in.scene);
    ScenePose pose;
    if (w.when) pose = poseAt(in.scene, clipOf(w.file, in.scene, w.when), w.when.time.value_or(0));
    Frame frame = frameOf(
        in.scene, [&](MeshId id) { return shownMeshes[id]; }, pose);
    choose(frame, w.show);
    frame.camera = w.camera;
    frame.options = w.look.options;
    if (!w.variants.empty()) {
        drawVariants(frame, w, in.scene, working);
        return 0;
    }
    if (w.look.metric) colourBy(frame, *w.look.metric, in.scene, working.progress());
    const double aspect = double(w.size.width) / w.size.height;
    if (w.turntable) {
        frameTurntable(frame, aspect);
        drawTurntable(frame, w.size, w.turntable, w.out, working);
        return 0;
    }
    if (!w.cameraGiven) frameTightly(frame, aspect);
    working.now("drawing");
    Offscreen offscreen;
    writePng(offscreen.draw(frame, w.size.width, w.size.height), w.out);
    return 0;
}

}  // namespace

const Verb renderVerb{
    "render", "a picture of a file, without a display",
    "render FILE -o PNG [--time S] [--clip NAME|#INDEX] [--motion FILE] [--show mesh|bones|both] [--size WxH] [--view VIEW]\n"
    "       [--camera EYE/TARGET/FOV] [--turntable N] [--compare OP --compare OP ...] [--style STYLE] [--light LIGHT] [--light-turn DEGREES] "
    "[--shadows]\n"
    "       [--no-grid] [--theme dark|light] [--transparent] [--unit UNIT] [--up y|z|x]\n\n"
    "  --time S        seconds into the clip; without --time and --clip the file rests\n"
    "  --clip CLIP     by name, or #0 for the first one, which is taken unless said\n"
    "  --motion FILE   also the clips of this file, made for the same skeleton (same names of joints)\n"
    "  --show WHAT     mesh, bones or both; the mesh unless said, bones where there is no mesh\n"
    "  --size WxH      pixels, 1280x800 unless said\n"
    "  --view VIEW     front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees; 32,17 unless said\n"
    "  --camera CAM    where the eye is, what it looks at, and the vertical angle in degrees: 4,3,2/0,0,0/40\n"
    "  --turntable N   N pictures of a whole turn, -o turn.png gives turn-000.png ...; -o turn.apng one that plays\n"
    "  --compare OP    a view with this operation done (subdivide-loop:levels=2; as-is: nothing), beside those of the other --compare: one\n"
    "                  camera, and with --style heat one range of values\n" MESHWRIGHT_LOOK_HELP
    "  --unit UNIT, --up y|z|x   how the file's numbers are meant; see meshwright convert --help\n",
    run};

}  // namespace mw::cli
