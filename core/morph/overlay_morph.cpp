#include "core/morph/overlay_morph.h"

#include <algorithm>

#include "core/error.h"
#include "core/mesh/topology.h"
#include "core/morph/morph_maps.h"
#include "core/morph/target.h"

namespace mw {

namespace {

/// The triangles made so far, in the places of the first.
Mesh partly(const Overlay& overlay)
{
    Array<glm::vec3> places(overlay.vertices());
    for (uint32_t v = 0; v < overlay.vertices(); ++v) places[v] = glm::vec3(overlay.position(0, v));
    return Mesh::triangles(std::move(places), Array<uint32_t>(overlay.corners().begin(), overlay.corners().end()));
}

/// A vertex of mesh `of` in the other: the place and the weights there.
struct Insertion {
    glm::vec3 at;
    glm::dvec3 weights;
    uint32_t face = none;

    void read(const Overlay& overlay, int of, uint32_t v)
    {
        const OverlayPlace p = overlay.placeInOther(of, v);
        const DomainMesh& map = overlay.input(1 - of).map;
        at = glm::vec3(overlay.mixed(1 - of, p));
        face = p.at.kind == Location::Kind::Triangle ? p.at.index
               : p.at.kind == Location::Kind::Edge   ? p.at.index / 3
                                                     : map.outgoing(p.at.index)[0] / 3;
        weights = overlay.weightsOf(1 - of, face, p);
    }
};

/// The way of an edge of mesh `of` over the other: its bends, the first and the last one its ends.
std::vector<glm::vec3> wayOf(const Overlay& overlay, int of, uint32_t edge)
{
    const DomainMesh &map = overlay.input(of).map, &other = overlay.input(1 - of).map;
    const uint32_t h = map.half(edge);
    std::vector<glm::vec3> way;
    const auto end = [&](uint32_t v) { way.push_back(glm::vec3(overlay.mixed(1 - of, overlay.placeInOther(of, v)))); };
    end(map.from(h));
    for (const Hop& hop : overlay.hops(of, edge)) {
        if (hop.kind == Hop::Met::Edge) way.push_back(glm::vec3(overlay.mixed(1 - of, overlay.crossed(1 - of, other.edge(hop.met), edge))));
        if (hop.kind == Hop::Met::Vertex) way.push_back(glm::vec3(overlay.input(1 - of).positions[hop.met]));
    }
    end(map.to(h));
    return way;
}

Generator mapsOf(Mesh input, Morph p, MorphMaps& out)
{
    const bool align = p.align == Morph::Align::Automatic;
    if (p.method == Morph::Method::Spherical) return sphericalMaps(std::move(input), p.other.mesh, align, out);
    if (p.method == Morph::Method::Barycentric) return diskMaps(std::move(input), p.other.mesh, align, out);
    return projectiveMaps(std::move(input), p.other.mesh, out);
}

}  // namespace

Generator overlayMorph(Mesh input, Morph parameters, Stage<Mesh>& stage)
{
    constexpr size_t chunk = 4096;
    const std::string name = targetName(parameters.other.name);
    Mesh shown = input;
    stage.show([&shown] { return shown; });
    co_yield Step("map").number("vertices", double(input.vertexCount())).number("others", double(parameters.other.mesh.vertexCount())).progress(0);
    MorphMaps maps;
    Generator mapping = mapsOf(input, parameters, maps);
    while (mapping.next())
        if (!stage.watched()) co_yield Step("map").progress(0.3 * double(mapping.step().progress()));
    const Mesh meshes[2] = {maps.meshes[0].mesh(), maps.meshes[1].mesh()};
    co_yield Step("aligned").number("turn", maps.turn).progress(0.3);

    Overlay overlay(std::move(maps.maps[0]), std::move(maps.maps[1]));
    if (!stage.watched()) co_yield Step("insert").progress(0.35);
    overlay.locate();
    co_yield Step("insert").number("inserted", 0).progress(0.4);
    // Vertices of the second in the first, then the other way round.
    for (const int of : {1, 0}) {
        while (overlay.locateMore(of, chunk)) co_yield Step("insert").number("inserted", double(overlay.reached(of))).progress(0.45);
        if (!stage.watched()) continue;
        shown = meshes[1 - of];
        const char* const mine = of ? "Q" : "P";
        Insertion in;
        for (uint32_t v = 0; v < overlay.input(of).map.vertices(); ++v) {
            in.read(overlay, of, v);
            const uint32_t* corner = overlay.input(1 - of).map.corners().data() + 3 * in.face;
            co_yield Step("insert")
                .face(in.face, Role::Neighbour)
                .point(in.at, Role::New, mine)
                .vertex(corner[0], Role::Neighbour, "A")
                .vertex(corner[1], Role::Neighbour, "B")
                .vertex(corner[2], Role::Neighbour, "C")
                .number("l1", in.weights.x)
                .number("l2", in.weights.y)
                .number("l3", in.weights.z)
                .number("inserted", double(v + 1))
                .progress(0.45);
        }
    }
    for (const int of : {1, 0}) {
        const uint32_t edges = uint32_t(overlay.input(of).map.edges());
        shown = meshes[1 - of];
        for (uint32_t e = 0; e < edges;) {
            const uint32_t last = stage.watched() ? e + 1 : std::min(edges, e + uint32_t(chunk));
            overlay.trace(of, e, last);
            const double progress = 0.5 + (of ? 0 : 0.15) + 0.15 * last / double(edges);
            if (stage.watched()) {
                const std::vector<glm::vec3> way = wayOf(overlay, of, e);
                Step step("trace");
                for (size_t i = 0; i + 1 < way.size(); ++i) step = std::move(step).segment(way[i], way[i + 1], Role::Current);
                for (size_t i = 1; i + 1 < way.size(); ++i) step = std::move(step).point(way[i], Role::New, "X");
                step =
                    std::move(step).number("met", double(way.size() - 2)).number("crossings", double(overlay.crossingsSoFar(of))).progress(progress);
                co_yield step;
            } else {
                co_yield Step("trace").number("crossings", double(overlay.crossingsSoFar(of))).progress(progress);
            }
            e = last;
        }
    }
    while (overlay.connect())
        if (!stage.watched()) co_yield Step("join").progress(0.8);
    shown = partly(overlay);
    co_yield Step("join")
        .number("vertices", double(overlay.vertices()))
        .number("crossings", double(overlay.crossings()))
        .number("coincident", double(overlay.coincident()))
        .progress(0.85);
    if (stage.watched()) stage.show([&overlay] { return partly(overlay); });
    for (bool more = true; more;) {
        const size_t before = overlay.corners().size() / 3;
        more = overlay.fill(stage.watched() ? 1 : chunk);
        const size_t after = overlay.corners().size() / 3;
        std::vector<uint32_t> fresh;
        for (size_t f = before; f < after && stage.watched(); ++f) fresh.push_back(uint32_t(f));
        if (stage.watched() && fresh.empty()) continue;
        co_yield Step("triangles")
            .ring(ElementKind::Face, Role::New, fresh)
            .number("cut", double(after - before))
            .number("faces", double(after))
            .progress(0.9);
    }
    Mesh result = overlaid(overlay, maps.meshes[0]);
    if (!stage.watched()) co_yield Step("triangles").progress(0.95);
    result = withTarget(result, name, displacement(overlay));
    if (const std::optional<Attribute> color = colorOn(overlay, 1, maps.meshes[1])) {
        if (!stage.watched()) co_yield Step("triangles").progress(0.97);
        result = withTargetColor(result, *color);
    }
    if (stage.watched()) {
        stage.show([&shown] { return shown; });
        for (int i = 0; i <= 8; ++i) {
            const double t = i / 8.0;
            shown = towardsTarget(result, t);
            co_yield Step("between").number("t", t).number("volume", enclosedVolume(shown)).number("area", surfaceArea(shown)).progress(0.95);
        }
    }
    stage.finish(std::move(result));
}

Generator correspondingMorph(Mesh input, Morph parameters, Stage<Mesh>& stage)
{
    const Mesh& other = parameters.other.mesh;
    if (!std::ranges::equal(input.faceStart(), other.faceStart()) || !std::ranges::equal(input.cornerVertex(), other.cornerVertex()))
        throw Error("corresponding wants two meshes with the same faces: this one has " + std::to_string(input.faceCount()) + " of " +
                    std::to_string(input.vertexCount()) + " vertices, the other " + std::to_string(other.faceCount()) + " of " +
                    std::to_string(other.vertexCount()));
    Array<float> displacement(3 * input.vertexCount(), 0.f);
    for (size_t v = 0; v < std::min(input.vertexCount(), other.vertexCount()); ++v)
        for (int k = 0; k < 3; ++k) displacement[3 * v + size_t(k)] = float(double(other.positions()[v][k]) - double(input.positions()[v][k]));
    Mesh result = withTarget(input, targetName(parameters.other.name), std::move(displacement));
    if (const Attribute* color = colorOf(other); color && color->size() == input.count(color->domain)) result = withTargetColor(result, *color);
    if (stage.watched()) {
        Mesh shown;
        stage.show([&shown] { return shown; });
        for (int i = 0; i <= 8; ++i) {
            const double t = i / 8.0;
            shown = towardsTarget(result, t);
            co_yield Step("between").number("t", t).number("volume", enclosedVolume(shown)).number("area", surfaceArea(shown)).progress(t);
        }
    }
    stage.finish(std::move(result));
}

}  // namespace mw
