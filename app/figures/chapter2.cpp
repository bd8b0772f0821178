// Figures of chapter 2.
#include <algorithm>
#include <cmath>
#include <set>

#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/mesh/stripify.h"
#include "core/mesh/topology.h"

namespace mw::figures {
namespace {

const std::vector<uint32_t> cubeStrip{0, 1, 2, 3, 7, 1, 5, 4, 7, 6, 2, 4, 0, 1};

std::string joined(std::span<const uint32_t> indices, const char* between = " ")
{
    std::string s;
    for (const uint32_t i : indices) s += (s.empty() ? "" : between) + std::to_string(i);
    return s;
}

/// Where the corners of a strip lie when its triangles are laid flat one after the other: odd ones up, even ones down.
glm::dvec2 bandPlace(size_t i)
{
    return {0.5 * double(i), i % 2 ? std::sqrt(0.75) : 0};
}

void stripOfCube(Page& page)
{
    const Mesh cube = stripCube();
    const Array<uint32_t> triangles = decodeStrips(cubeStrip);
    Space& solid = page.space("the cube, vertex 4x + 2y + z", {330, 250});
    solid.look(28, 24);
    solid.put(cube);
    const auto color = [&](size_t i) { return page.tint(page.series(0), 0.25f + 0.6f * float(i) / 11); };
    for (uint32_t f = 0; f < cube.faceCount(); ++f) solid.faces({f}, glm::vec4(glm::vec3(color(f)), 0.75f));
    solid.numberVertices(page.ink(Ink::Text), page.ink(Ink::Faint));
    Drawing& band = page.drawing("the strip: each corner after the second adds a triangle", {760, 250});
    for (size_t i = 0; i + 2 < cubeStrip.size(); ++i) {
        band.polygon({bandPlace(i), bandPlace(i + 1), bandPlace(i + 2)}, color(i));
        const glm::dvec2 middle = (bandPlace(i) + bandPlace(i + 1) + bandPlace(i + 2)) / 3.0;
        band.words(middle, std::to_string(i), {page.ink(Ink::Faint), Beside::On, 12, false, false});
    }
    for (size_t i = 0; i + 2 < cubeStrip.size(); ++i) band.path({bandPlace(i), bandPlace(i + 2)}, Pen(page.ink(Ink::Line), 1.5f));
    std::vector<At> order;
    for (size_t i = 0; i < cubeStrip.size(); ++i) order.emplace_back(bandPlace(i));
    band.path(order, Pen(page.ink(Ink::Focus), 2.5f).arrow().gaps(6, 8));
    for (size_t i = 0; i < cubeStrip.size(); ++i)
        band.label(bandPlace(i), std::to_string(cubeStrip[i]), page.ink(Ink::Text), i % 2 ? Beside::Above : Beside::Below, 17, true);
    page.row();
    TablePanel& table = page.table("decoded: every second triangle is turned round", {"triangle", "strip", "decoded"});
    (void)table;
    std::set<std::pair<uint32_t, uint32_t>> halfEdges;
    std::vector<double> decoded;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) halfEdges.emplace(triangles[i + k], triangles[i + (k + 1) % 3]);
        const size_t at = i / 3;
        const std::vector<uint32_t> raw(cubeStrip.begin() + ptrdiff_t(at), cubeStrip.begin() + ptrdiff_t(at + 3));
        const std::vector<uint32_t> corners(triangles.begin() + ptrdiff_t(i), triangles.begin() + ptrdiff_t(i + 3));
        table.row({std::to_string(at), joined(raw), {joined(corners), at % 2 ? page.ink(Ink::Focus) : page.ink(Ink::Text)}});
        decoded.push_back(100 * corners[0] + 10 * corners[1] + corners[2]);
    }
    page.note("Strip " + joined(cubeStrip) + ": " + std::to_string(cubeStrip.size()) + " indices for " + countText(triangles.size() / 3, "triangle") +
              "; a list has " + std::to_string(triangles.size()) + ".");
    page.number("strip indices", cubeStrip.size());
    page.number("list indices", triangles.size());
    page.number("triangles", triangles.size() / 3);
    page.numbers("decoded", decoded);
    page.number("distinct half-edges", halfEdges.size());
}

void genusOf(Page& page, const Mesh& mesh, const std::string& name, std::vector<std::vector<double>>& all)
{
    const TopologyReport& t = mesh.topology();
    double valences = 0;
    for (const auto& [valence, count] : t.vertexValences) valences += double(valence * count);
    Space& s = page.space(name + ": V = " + std::to_string(t.vertices) + ", E = " + std::to_string(t.edges) + ", F = " + std::to_string(t.faces) +
                              "\nV \u2212 E + F = " + shortNumber(double(t.euler)) + ", genus " + std::to_string(t.genus.value_or(-1)),
                          {360, 300});
    s.look(25, 38);
    s.put(mesh);
    all[0].push_back(double(t.vertices));
    all[1].push_back(double(t.edges));
    all[2].push_back(double(t.faces));
    all[3].push_back(double(t.euler));
    all[4].push_back(double(t.genus.value_or(-1)));
    all[5].push_back(valences);
}

void genus(Page& page)
{
    std::vector<std::vector<double>> all(6);
    genusOf(page, sphereMesh(2), "sphere", all);
    genusOf(page, torusMesh(1, 0.42, 26, 12), "torus", all);
    genusOf(page, torus2(), "two holes", all);
    const char* names[] = {"V", "E", "F", "V-E+F", "genus", "sum of valences"};
    for (size_t i = 0; i < all.size(); ++i) page.numbers(names[i], all[i]);
}

}  // namespace

std::vector<Figure> chapter2Figures()
{
    return {
        {"2.02-cube-strip", "2.2", "A cube as one triangle strip", {"2.1"}, stripOfCube},
        {"2.06-genus", "2.6", "Genus and Euler characteristic", {"2.3"}, genus},
    };
}

}  // namespace mw::figures
