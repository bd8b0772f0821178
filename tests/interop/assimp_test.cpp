// OFF, STL, OBJ and PLY as we write them, read by Assimp: as many triangles at the same places, with the same colours and texture coordinates.
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cmath>
#include <gtest/gtest.h>

#include "core/io/helpers.h"
#include "core/io/io.h"

#include "data.h"

namespace mw::test {
namespace {

using Row = std::array<float, 9>;  // a corner: place, colour (or 0), texture coordinate (or 0)
using Triangle = std::array<Row, 3>;

/// From the corner that sorts first, so that it does not matter where a triangle begins.
Triangle turned(const Triangle& t)
{
    return std::min({t, Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[0], t[1]}});
}

std::vector<Triangle> sorted(std::vector<Triangle> all)
{
    for (Triangle& t : all) t = turned(t);
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<Triangle> trianglesOf(const Mesh& mesh, bool colors, bool texcoords)
{
    const auto value = [&](std::string_view name, size_t t, size_t k, int component) {
        const Attribute* a = mesh.find(name);
        if (!a || component >= a->components) return component == 3 ? 1.f : 0.f;
        const Mesh::Triangulation& cut = mesh.triangulation();
        const size_t e = a->domain == Domain::Corner ? cut.corners[3 * t + k] : cut.vertices[3 * t + k];
        return float(a->at(e, component));
    };
    std::vector<Triangle> all(mesh.triangulation().faces.size());
    for (size_t t = 0; t < all.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh.positions()[mesh.triangulation().vertices[3 * t + k]];
            Row& r = all[t][k] = {p.x, p.y, p.z};
            for (int c = 0; colors && c < 4; ++c) r[3 + size_t(c)] = value(names::color, t, k, c);
            for (int c = 0; texcoords && c < 2; ++c) r[7 + size_t(c)] = value(names::texcoord, t, k, c);
        }
    return sorted(std::move(all));
}

std::vector<Triangle> trianglesOf(const std::string& file, bool colors, bool texcoords)
{
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const aiScene* scene = importer.ReadFile(file, aiProcess_PreTransformVertices);
    if (!scene) {
        ADD_FAILURE() << importer.GetErrorString();
        return {};
    }
    std::vector<Triangle> all;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        EXPECT_TRUE(!colors || mesh.HasVertexColors(0));
        EXPECT_TRUE(!texcoords || mesh.HasTextureCoords(0));
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;
            Triangle t{};
            for (unsigned k = 0; k < 3; ++k) {
                const unsigned v = mesh.mFaces[f].mIndices[k];
                t[k] = {mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z};
                if (colors && mesh.HasVertexColors(0)) {
                    const aiColor4D c = mesh.mColors[0][v];
                    for (size_t i = 0; i < 4; ++i) t[k][3 + i] = c[unsigned(i)];
                }
                if (texcoords && mesh.HasTextureCoords(0)) {
                    t[k][7] = mesh.mTextureCoords[0][v].x;
                    t[k][8] = mesh.mTextureCoords[0][v].y;
                }
            }
            all.push_back(t);
        }
    }
    return sorted(std::move(all));
}

/// Largest difference of one number, or infinity when there are not equally many.
float worst(const std::vector<Triangle>& a, const std::vector<Triangle>& b)
{
    if (a.size() != b.size()) return INFINITY;
    float most = 0;
    for (size_t t = 0; t < a.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < 9; ++i) most = std::max(most, std::abs(a[t][k][i] - b[t][k][i]));
    return most;
}

/// A tetrahedron with a value of its own at each corner of the space of values.
Mesh coloured(int components)
{
    Mesh m = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0.25f}, {0, 1, 0.5f}, {0.125f, 0, 1}},
                             Array<uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    Array<float> c, t;
    for (int v = 0; v < 4; ++v) {
        for (int k = 0; k < components; ++k) c.push_back(float((v * 3 + k * 2) % 5) / 5);
        t.push_back(float(v) / 4);
        t.push_back(float(v * v) / 16);
    }
    Attribute texcoord = gathered(floatAttribute("texcoord", Domain::Vertex, 2, t), m.cornerVertex());
    texcoord.domain = Domain::Corner;
    return m.with(floatAttribute("color", Domain::Vertex, components, c)).with(texcoord);
}

TEST(Assimp, ReadsColoursAndTextureCoordinatesAsWritten)
{
    const Folder folder;
    for (const auto& [name, binary] : {std::pair("a.ply", true), std::pair("a.ply", false), std::pair("a.obj", false)}) {
        SCOPED_TRACE(std::string(name) + (binary ? " binary" : ""));
        const Mesh m = coloured(name == std::string("a.ply") ? 4 : 3);
        const std::string file = (folder.path / name).string();
        writeFile(sceneOf(m, "m"), file, {.binary = binary});
        EXPECT_LE(worst(trianglesOf(file, true, true), trianglesOf(m, true, true)), 1e-6f);
    }
    // Assimp's OFF reader takes colours only when nothing else stands beside the position.
    const Mesh m = coloured(4).without("texcoord");
    const std::string file = (folder.path / "a.off").string();
    writeFile(sceneOf(m, "m"), file, {.binary = false});
    EXPECT_LE(worst(trianglesOf(file, true, false), trianglesOf(m, true, false)), 1e-6f);
}

TEST(Assimp, ReadsColoursOfFacets)
{
    const Folder folder;
    Mesh m = coloured(3).without("texcoord").without("color");
    Array<float> c;
    for (size_t i = 0; i < 3 * m.cornerCount(); ++i) c.push_back(float(double((i / 9 * 7 + i % 3) % 32) / 31));
    m = m.with(floatAttribute("color", Domain::Corner, 3, c));
    const std::string file = (folder.path / "a.stl").string();
    writeFile(sceneOf(m, "m"), file);
    EXPECT_LE(worst(trianglesOf(file, true, false), trianglesOf(m, true, false)), 1e-6f);
}

TEST(Assimp, ReadsEveryMeshOfTheDataAsWeWriteIt)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Folder folder;
    size_t checked = 0;
    for (const char* name : {"closed_genus0/spot.obj", "closed_genus0/bumpy.off", "closed_genus0/bunny_3k.off", "closed_higher_genus/3holes.off",
                             "format_variants/Wuson.stl", "format_variants/Spider_binary.stl", "disk/cat_head.obj", "nonmanifold/hourglass_ico.obj",
                             "format_variants/beetle_binary.off", "nonmanifold/cow.obj"}) {
        const Imported in = readFile(data / "meshes" / name);
        const Mesh& mesh = in.scene.find(in.scene.meshes().at(0))->base;
        for (const auto& [target, binary] : {std::pair("a.off", false), std::pair("a.stl", true), std::pair("a.stl", false), std::pair("a.ply", true),
                                             std::pair("a.ply", false), std::pair("a.obj", false)}) {
            SCOPED_TRACE(std::string(name) + " as " + target + (binary ? " binary" : ""));
            const std::string file = (folder.path / target).string();
            writeFile(in.scene, file, {.binary = binary});
            // Text: Assimp's numbers are not rounded to the nearest.
            const float tolerance = binary ? 0.f : float(1e-6 * (1 + mesh.bounds().diagonal()));
            EXPECT_LE(worst(trianglesOf(file, false, false), trianglesOf(mesh, false, false)), tolerance);
            ++checked;
        }
    }
    EXPECT_EQ(checked, 60u);
}

}  // namespace
}  // namespace mw::test
