// The table of the test data against the report: every OBJ, OFF, PLY and STL mesh as stored, and merged by position where that changes it; strips and
// half-edge views of all of them besides. Figures were measured by others, on the faces as indexed.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

#include "core/io/io.h"
#include "core/mesh/halfedge.h"
#include "core/mesh/stripify.h"
#include "core/mesh/topology.h"
#include "core/repair/weld.h"

#include "data.h"

using namespace mw;

namespace {

struct Row {
    std::string file, vertices, edges, faces, kinds, components, loops, genus, manifold, notes;
};

std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> out;
    std::stringstream in(line);
    for (std::string cell; std::getline(in, cell, '|');) {
        const size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        out.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
    }
    return out;
}

std::vector<Row> rowsOf(const std::filesystem::path& data)
{
    std::vector<Row> rows;
    std::ifstream in(data / "README.md");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("| meshes/")) continue;
        const auto c = cells(line);
        if (c.size() > 12 && !c[4].empty()) rows.push_back({c[1], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11], c[12]});
    }
    return rows;
}

Mesh meshOf(const std::filesystem::path& file)
{
    const Imported read = readFile(file);
    const auto all = read.scene.meshes();
    return all.empty() ? Mesh() : read.scene.find(all[0])->base;
}

/// "5 (223 edges)", as the table writes it.
std::string loopsText(const TopologyReport& r)
{
    const std::string n = std::to_string(r.boundaryLoops.size());
    return r.boundaryLoops.empty() ? n : n + " (" + std::to_string(r.boundaryEdges) + " edges)";
}

/// "tri", "quad", "66-gon", "3: 8, 4: 18", "none".
std::string kindsText(const TopologyReport& r)
{
    if (r.faceSizes.empty()) return "none";
    if (r.faceSizes.size() == 1) {
        const size_t n = r.faceSizes.begin()->first;
        return n == 3 ? "tri" : n == 4 ? "quad" : std::to_string(n) + "-gon";
    }
    std::string text;
    for (const auto& [n, count] : r.faceSizes) text += (text.empty() ? "" : ", ") + std::to_string(n) + ": " + std::to_string(count);
    return text;
}

std::string genusText(const TopologyReport& r)
{
    return r.genus ? std::to_string(*r.genus) : "-";
}

/// The number before a phrase of the notes, 0 when the phrase is not there.
size_t noted(const std::string& notes, const std::string& phrase)
{
    std::smatch m;
    return std::regex_search(notes, m, std::regex("([0-9]+) " + phrase)) ? std::stoul(m[1]) : 0;
}

void expectNotes(const TopologyReport& r, const std::string& notes)
{
    EXPECT_EQ(r.isolatedVertices.size(), noted(notes, "unreferenced vertices"));
    EXPECT_EQ(r.nonmanifoldEdges.size(), noted(notes, "edges with >2 faces"));
    EXPECT_EQ(r.nonmanifoldVertices.size(), noted(notes, "vertices with >1 fan"));
    EXPECT_EQ(r.inconsistentEdges.size(),
              noted(notes, "half-edges used twice") + (notes.find("NOT orientable") != notes.npos ? r.inconsistentEdges.size() : 0));
    EXPECT_EQ(r.orientable, notes.find("NOT orientable") == notes.npos);
}

/// "merged by position: V 505, E 1005, C 1, loops 4 (42 edges), genus -, manifold no, ..."
void expectMerged(const Mesh& mesh, const std::string& notes)
{
    RunOf<Mesh> run(false, [&](Stage<Mesh>& s) { return weld(mesh, {}, s); });
    while (run.advance()) continue;
    const Mesh merged = std::any_cast<Mesh>(run.snapshot().value);
    const TopologyReport& r = merged.topology();
    const size_t at = notes.find("merged by position:");
    if (at == notes.npos) {
        EXPECT_EQ(r.edges, mesh.topology().edges);
        return;
    }
    std::ostringstream own;
    own << "merged by position: V " << r.vertices << ", E " << r.edges << ", C " << r.components << ", loops " << loopsText(r) << ", genus "
        << genusText(r) << ", manifold " << (r.manifold() ? "yes" : "no");
    EXPECT_EQ(own.str(), notes.substr(at, own.str().size()));
    const std::string rest = notes.substr(at);
    EXPECT_EQ(r.degenerateFaces.size(), noted(rest, "degenerate faces"));
    EXPECT_EQ(r.nonmanifoldVertices.size(), noted(rest, "vertices with >1 fan"));
}

/// Every edge is counted at both its ends, every corner in its face; the Euler characteristic is that of the counts and, of closed surfaces, of the
/// genus: V - E + F = 2 (c - g) - b.
void expectSums(const Mesh& mesh, const TopologyReport& r)
{
    size_t valences = 0, corners = 0, joined = 0;
    for (const auto& [valence, n] : r.vertexValences) {
        valences += valence * n;
        joined += valence > 0 ? n : 0;
    }
    for (const auto& [size, n] : r.faceSizes) corners += size * n;
    EXPECT_EQ(valences, 2 * r.edges);
    EXPECT_EQ(corners, mesh.cornerCount());
    EXPECT_EQ(r.euler, long(joined) - long(r.edges) + long(r.faces - r.degenerateFaces.size()));
    if (r.genus) {
        EXPECT_EQ(r.euler, 2 * (long(r.components) - *r.genus) - long(r.boundaryLoops.size()));
    }
    if (r.closed && r.manifold() && mesh.isTriangles() && r.degenerateFaces.empty()) {
        EXPECT_EQ(2 * r.edges, 3 * r.faces);
    }
}

void expectStrips(const Mesh& mesh)
{
    RunOf<Table> run(false, [&](Stage<Table>& s) { return stripify(mesh, {}, s); });
    while (run.advance()) continue;
    const Table t = std::any_cast<Table>(run.snapshot().value);
    const auto canonical = [](std::span<const uint32_t> list) {
        std::vector<std::array<uint32_t, 3>> out;
        for (size_t i = 0; i + 2 < list.size(); i += 3) {
            std::array<uint32_t, 3> a{list[i], list[i + 1], list[i + 2]}, b{a[1], a[2], a[0]}, c{a[2], a[0], a[1]};
            out.push_back(std::min({a, b, c}));
        }
        std::sort(out.begin(), out.end());
        return out;
    };
    EXPECT_TRUE(canonical(decodeStrips(t.lists[0].second)) == canonical(mesh.triangulation().vertices));
}

}  // namespace

TEST(DataTable, EveryMeshHasItsFigures)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t checked = 0;
    for (const Row& row : rowsOf(data)) {
        // Text in UTF-16: the table's reader saw nothing in it.
        if (row.file.find("UTF16") != std::string::npos) continue;
        SCOPED_TRACE(row.file);
        const Mesh mesh = meshOf(data / row.file);
        const TopologyReport& r = mesh.topology();
        const std::string stored = row.notes.substr(0, row.notes.find("merged by position:"));
        EXPECT_EQ(std::to_string(r.vertices), row.vertices);
        EXPECT_EQ(std::to_string(r.edges), row.edges);
        EXPECT_EQ(std::to_string(r.faces), row.faces);
        EXPECT_EQ(kindsText(r), row.kinds);
        EXPECT_EQ(std::to_string(r.components), row.components);
        EXPECT_EQ(loopsText(r), row.loops);
        EXPECT_EQ(genusText(r), row.genus.substr(0, row.genus.find(" (sum)")));
        EXPECT_EQ(r.manifold() ? "yes" : "no", row.manifold);
        expectNotes(r, stored);
        expectSums(mesh, r);
        expectMerged(mesh, row.notes);
        expectStrips(mesh);
        EXPECT_EQ(mesh.halfedges().degenerateFaces, r.degenerateFaces.size());
        ++checked;
    }
    EXPECT_GT(checked, 65u);
}

TEST(DataTable, ConcavePolygonIsCutRight)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh mesh = meshOf(data / "meshes/nonmanifold/concave_polygon.obj");
    ASSERT_EQ(mesh.triangulation().faces.size(), 64u);
    // Plane: the triangles must not overlap, so their areas add up to that of the outline.
    glm::dvec3 whole(0);
    const auto face = mesh.face(0);
    for (size_t i = 1; i + 1 < face.size(); ++i) {
        const glm::dvec3 a(mesh.positions()[face[0]]), u = glm::dvec3(mesh.positions()[face[i]]) - a,
                                                       v = glm::dvec3(mesh.positions()[face[i + 1]]) - a;
        whole += 0.5 * glm::dvec3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    }
    EXPECT_NEAR(surfaceArea(mesh), std::sqrt(whole.x * whole.x + whole.y * whole.y + whole.z * whole.z), 1e-6 * surfaceArea(mesh));
}
