// A picture for each entry of the catalog, from shapes the program makes itself. The list below is explicit.
#include "app/cli/gallery_pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "core/steps/stepper.h"
#include "render/value_frame.h"

namespace mw::cli {

namespace {

Mesh made(std::string_view id, const ParameterValues& values, const Value& input = {})
{
    const Operation& op = operation(id);
    return std::get<Mesh>(apply(op, input, checked(op.parameters, values)));
}

Table measured(std::string_view id, const Mesh& mesh)
{
    const Operation& op = operation(id);
    return std::get<Table>(apply(op, mesh, checked(op.parameters, {})));
}

Mesh sphere(int64_t level)
{
    return made("icosphere", {{"subdivisions", level}});
}

/// A sphere with smooth bumps: something a metric or a simplification has to work on.
Mesh bumpy(int64_t level)
{
    const Mesh round = sphere(level);
    Array<glm::vec3> p(round.positions().begin(), round.positions().end());
    for (glm::vec3& v : p) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(v));
        const double bump = 0.16 * std::sin(5 * n.x + 1) * std::sin(4 * n.y) + 0.10 * std::sin(7 * n.z + 2 * n.x) + 0.2 * std::pow(std::abs(n.y), 6);
        v = glm::vec3(n * (1 + bump));
    }
    return round.withPositions(std::move(p));
}

/// A cube of eight corners: coarse enough to see what subdivision does to it.
Mesh cube()
{
    Array<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    Array<uint32_t> t{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return Mesh::triangles(std::move(p), std::move(t));
}

/// Puts a mesh to the right of what is there already, on the ground, with a line of text below.
DrawObject& put(Frame& frame, Mesh mesh, const std::string& text)
{
    const Bounds b = mesh.bounds(), all = boundsOf(frame);
    const double gap = 0.25 * b.size().x, left = all.empty ? 0 : all.max.x + gap;
    DrawObject o;
    o.node = NodeId{uint32_t(frame.objects.size() + 1)};
    o.worldFromLocal = glm::translate(glm::dmat4(1), glm::dvec3(left - b.min.x, -b.min.y, -b.centre().z));
    o.mesh = std::move(mesh);
    if (!text.empty())
        frame.labels.push_back({glm::vec3(left + 0.2 * b.size().x, -0.05 * b.size().y, 0.3 * b.size().z), text, glm::vec4(0.9, 0.91, 0.92, 1)});
    frame.objects.push_back(std::move(o));
    return frame.objects.back();
}

std::string faces(const Mesh& m)
{
    return counted(m.faceCount(), "face");
}

Frame plain()
{
    Frame f;
    f.camera.azimuth = 0.12;
    f.camera.elevation = 0.2;
    f.camera.fieldOfView = 0.4;  // little perspective: things that stand side by side are compared
    f.options.shading = Shading::Flat;
    f.options.wireOverlay = true;
    return f;
}

Frame icospheres()
{
    Frame f = plain();
    for (int64_t level = 0; level < 4; ++level) {
        Mesh m = sphere(level);
        const std::string text = "Level " + std::to_string(level) + ": " + faces(m);
        put(f, std::move(m), text);
    }
    return f;
}

/// Pulls all faces of a mesh apart and moves each inwards a little, as files that hold loose triangles do.
Mesh loosened(const Mesh& m)
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (const uint32_t v : m.cornerVertex()) {
        t.push_back(uint32_t(p.size()));
        p.push_back(m.positions()[v]);
    }
    return Mesh::triangles(std::move(p), std::move(t));
}

Frame welded()
{
    Frame f = plain();
    f.options.shading = Shading::Smooth;
    f.options.wireOverlay = false;
    const Mesh loose = loosened(bumpy(3)), whole = made("weld", {}, loose);
    put(f, loose, counted(loose.vertexCount(), "vertex", "vertices"));
    put(f, whole, counted(whole.vertexCount(), "vertex", "vertices"));
    return f;
}

/// An operation without parameters before and after.
Frame smoothed()
{
    Frame f = plain();
    f.options.shading = Shading::Smooth;
    const Mesh clean = bumpy(4);
    Array<glm::vec3> p(clean.positions().begin(), clean.positions().end());
    uint32_t seed = 12345;
    const auto random = [&seed] { return float((seed = seed * 1664525u + 1013904223u) >> 8) / float(1 << 24) - 0.5f; };
    for (glm::vec3& v : p) v += 0.035f * glm::vec3(random(), random(), random());
    const Mesh rough = clean.withPositions(std::move(p));
    put(f, rough, "Before");
    put(f, made("smooth", {}, rough), "After");
    return f;
}

Frame valences()
{
    Frame f = plain();
    const Mesh m = findOperation("decimate-quadric") ? made("decimate-quadric", {{"ratio", 0.2}}, bumpy(4)) : bumpy(3);
    f.options.shading = Shading::Smooth;
    put(f, m, "").heat = heatMapOf(measured("vertex-valence", m));
    return f;
}

Frame strips()
{
    Frame f = plain();
    const Mesh m = bumpy(3);
    put(f, m, "").heat = heatMapOf(measured("stripify", m));
    return f;
}

/// The state of a stepped operation at the first step of a phase after some share of the run, with its focus.
void putStep(Frame& f, std::string_view id, const Mesh& input, const ParameterValues& values, std::string_view phase, double share)
{
    const Operation& op = operation(id);
    Stepper stepper(stepping(op, input, checked(op.parameters, values)));
    stepper.seekWhere([&](const StepRecord& r) { return r.phase == phase && r.progress >= share; });
    const StepRecord step = stepper.step();
    const Value value = valueOf(stepper.value());
    const Mesh mesh = std::holds_alternative<Mesh>(value) ? std::get<Mesh>(value) : input;
    const DrawObject o = put(f, mesh, "Step " + std::to_string(step.index) + ": " + faces(mesh));
    addFocus(f, step, mesh, o.node, o.worldFromLocal);
    Bounds focus;
    for (const Mark& m : f.marks)
        for (const uint32_t i : m.indices)
            if (m.kind == ElementKind::Vertex || m.kind == ElementKind::Edge) focus.add(glm::dvec3(mesh.vertexNormals()[i]));
    if (focus.empty) return;
    const glm::dvec3 n = glm::normalize(focus.centre() + glm::dvec3(0, 1e-9, 0));  // look at it from outside
    f.camera.azimuth = std::atan2(n.x, n.z) + 0.2;
    f.camera.elevation = std::clamp(0.6 * std::asin(n.y), -0.3, 0.9);
}

Frame decimation()
{
    Frame f = plain();
    const Mesh m = bumpy(4);
    put(f, m, faces(m));
    const Mesh half = made("decimate-quadric", {{"ratio", 0.25}}, m), tenth = made("decimate-quadric", {{"ratio", 0.06}}, m);
    put(f, half, faces(half));
    put(f, tenth, faces(tenth));
    return f;
}

Frame decimationStep()
{
    Frame f = plain();
    putStep(f, "decimate-quadric", bumpy(3), {{"quality", std::string("textbook")}, {"ratio", 0.2}}, "collapse", 0.6);
    return f;
}

Frame loopLevels()
{
    Frame f = plain();
    const Mesh m = cube();
    put(f, m, faces(m));
    for (int64_t level = 1; level < 4; ++level) {
        const Mesh finer = made("subdivide-loop", {{"levels", level}}, m);
        put(f, finer, faces(finer));
    }
    return f;
}

/// Seen from the front, without a wire over it: for what lies in the plane.
Frame plane()
{
    Frame f = plain();
    f.camera.azimuth = f.camera.elevation = 0;
    f.options.grid = false;
    return f;
}

/// Values of any kind in a row, each `width` wide, with a line of text `below` their origin.
void putValue(Frame& f, const Value& value, size_t place, double width, double below, const std::string& text, const StepRecord* step = nullptr)
{
    const glm::dmat4 at = glm::translate(glm::dmat4(1), glm::dvec3(width * double(place), 0, 0));
    const NodeId node{uint32_t(place + 1)};
    addValue(f, value, node, at);
    if (step) addFocus(f, *step, value, node, at);
    if (!text.empty()) f.labels.push_back({glm::vec3(width * double(place), -below, 0), text, glm::vec4(0.9, 0.91, 0.92, 1)});
}

Value any(std::string_view id, const char* parameters, const Value& input = {})
{
    const Operation& op = operation(id);
    return apply(op, input, parsed(op.parameters, parameters));
}

Frame sampleCurves()
{
    Frame f = plane();
    const char* shapes[] = {"zigzag", "wave", "star", "spiral", "letter"};
    for (size_t i = 0; i < std::size(shapes); ++i)
        putValue(f, any("sample-curve", ("points=14,shape=" + std::string(shapes[i])).c_str()), i, 2.6, 1.3, shapes[i]);
    return f;
}

Frame curves()
{
    Frame f = plane();
    const Value polygon = any("sample-curve", "shape=star,points=10");
    const char* schemes[] = {"four-point", "positive", "b-spline"};
    for (size_t i = 0; i < std::size(schemes); ++i)
        putValue(f, any("subdivide-curve", ("levels=5,scheme=" + std::string(schemes[i])).c_str(), polygon), i, 2.6, 1.3, schemes[i]);
    return f;
}

Frame rotations()
{
    Frame f = plain();
    f.camera.azimuth = 0.6;
    f.options.wireOverlay = f.options.grid = false;
    addValue(f, any("interpolate-rotation", "samples=49"), NodeId{1}, glm::dmat4(1));
    return f;
}

/// A chain as it begins, in the middle of a solver's work, and solved.
Frame solving(const char* solver, const char* phase)
{
    Frame f = plane();
    const Value chain = any("joint-chain", "links=5,lengths=0.8,angles=75 -35,target=2/0.9/0");
    putValue(f, chain, 0, 3.6, 0.3, "Begin");
    if (solver) {
        const Operation& op = operation(solver);
        Stepper stepper(stepping(op, chain, {}));
        stepper.seekWhere([&, n = 0](const StepRecord& r) mutable { return r.phase == phase && ++n == 3; });
        putValue(f, valueOf(stepper.value()), 1, 3.6, 0.3, "Step " + std::to_string(stepper.step().index), &stepper.step());
        putValue(f, any(solver, "", chain), 2, 3.6, 0.3, "End");
    }
    return f;
}

Frame jointChain()
{
    return solving(nullptr, "");
}

Frame ccdSteps()
{
    return solving("ccd", "turn");
}

Frame fabrikSteps()
{
    return solving("fabrik", "forward");
}

constexpr OperationPicture pictures[] = {
    {"icosphere", "icosphere", icospheres},
    {"weld", "weld", welded},
    {"smooth", "smooth", smoothed},
    {"vertex-valence", "vertex-valence", valences},
    {"stripify", "stripify", strips},
    {"decimate-quadric", "decimate-quadric", decimation},
    {"decimate-quadric-step", "decimate-quadric", decimationStep},
    {"subdivide-loop", "subdivide-loop", loopLevels},
    {"sample-curve", "sample-curve", sampleCurves},
    {"subdivide-curve", "subdivide-curve", curves},
    {"interpolate-rotation", "interpolate-rotation", rotations},
    {"joint-chain", "joint-chain", jointChain},
    {"ccd", "ccd", ccdSteps},
    {"fabrik", "fabrik", fabrikSteps},
};

}  // namespace

std::span<const OperationPicture> operationPictures()
{
    return pictures;
}

}  // namespace mw::cli
