// What is written reads back equal, for each format and encoding, with every attribute it can hold.
#include <array>

#include "data.h"
#include "helpers.h"

namespace mw::test {
namespace {

namespace fs = std::filesystem;

/// Two triangles and a pentagon over seven vertices, one of them loose.
Mesh patch()
{
    Array<glm::vec3> p{{0, 0, 0}, {1, 0, 0.1f}, {1, 1, -1e-20f}, {0, 1, 1e20f}, {2, 0.333333343f, 0}, {2, 1, 16777217}, {-0.f, 5, 5}};
    return Mesh(std::move(p), Array<uint32_t>{0, 3, 6, 11}, Array<uint32_t>{0, 1, 2, 0, 2, 3, 1, 4, 5, 2, 0}).withLines(Array<uint32_t>{6, 0, 3, 6});
}

Attribute floats(const char* name, Domain domain, int components, const Mesh& mesh, float scale)
{
    Array<float> v(mesh.count(domain) * size_t(components));
    for (size_t i = 0; i < v.size(); ++i) v[i] = float((i * 7919) % 101) * scale;
    return floatAttribute(name, domain, components, std::move(v));
}

Attribute bytes255(const char* name, Domain domain, int components, const Mesh& mesh)
{
    Array<float> v(mesh.count(domain) * size_t(components));
    for (size_t i = 0; i < v.size(); ++i) v[i] = float(double((i * 53) % 256) / 255);
    Attribute a = floatAttribute(name, domain, components, std::move(v));
    a.stored = Scalar::UInt8;
    return a;
}

Attribute integers(const char* name, Domain domain, int components, const Mesh& mesh, int32_t scale, Scalar stored)
{
    Array<int32_t> v(mesh.count(domain) * size_t(components));
    for (size_t i = 0; i < v.size(); ++i) v[i] = int32_t(i % 5) * scale;
    Attribute a = integerAttribute(name, domain, components, std::move(v));
    a.stored = stored;
    return a;
}

Mesh written(const Mesh& mesh, const std::string& name, const WriteOptions& options = {})
{
    const Folder folder;
    writeFile(sceneOf(mesh, "patch"), folder.path / name, options);
    const Imported in = readFile(folder.path / name);
    EXPECT_TRUE(checkMesh(meshOf(in)));
    EXPECT_TRUE(in.warnings.empty()) << in.warnings[0].text;
    return meshOf(in);
}

/// Same arrays, whatever the order of the attributes.
void expectEqual(const Mesh& a, const Mesh& b)
{
    ASSERT_EQ(a.attributes().size(), b.attributes().size());
    const auto bare = [](Mesh m) {
        while (!m.attributes().empty()) m = m.without(m.attributes().front().name);
        return contentHash(m);
    };
    EXPECT_EQ(bare(a), bare(b));
    for (const Attribute& x : a.attributes()) {
        SCOPED_TRACE(x.name);
        const Attribute* y = b.find(x.name, x.domain);
        ASSERT_TRUE(y);
        EXPECT_EQ(x.components, y->components);
        EXPECT_EQ(x.stored, y->stored);
        EXPECT_EQ(x.values.index(), y->values.index());
        ASSERT_EQ(x.size(), y->size());
        for (size_t e = 0; e < x.size(); ++e)
            for (int k = 0; k < x.components; ++k) EXPECT_EQ(x.at(e, k), y->at(e, k)) << e << "," << k;
    }
}

const std::array<WriteOptions, 3> encodings{WriteOptions{false, false, false}, WriteOptions{false, true, false}, WriteOptions{false, true, true}};

TEST(RoundTrip, PlyKeepsEveryAttributeInEveryEncoding)
{
    Mesh m = patch();
    m = m.with(floats("normal", Domain::Vertex, 3, m, 0.01f)).with(floats("texcoord", Domain::Corner, 2, m, 0.013f));
    m = m.with(bytes255("color", Domain::Vertex, 4, m))
            .with(bytes255("color", Domain::Corner, 3, m))
            .with(floats("tangent", Domain::Corner, 4, m, 0.1f));
    m = m.with(floats("quality", Domain::Vertex, 1, m, 1e-7f))
            .with(floats("flow", Domain::Vertex, 2, m, 3.3f))
            .with(floats("crease", Domain::Corner, 1, m, 0.5f));
    m = m.with(integers("flags", Domain::Face, 1, m, 60, Scalar::UInt8)).with(integers("label", Domain::Face, 3, m, -300, Scalar::Int16));
    m = m.with(integers("id", Domain::Vertex, 1, m, 1 << 28, Scalar::Int32)).with(integers("joints", Domain::Vertex, 4, m, 3, Scalar::UInt16));
    m = m.with(floats("weights", Domain::Vertex, 4, m, 0.01f));
    Attribute exact{"exact", Domain::Vertex, 1, Shared(Array<double>{0.1, 1.0 / 3, 1e300, -2e-300, 5, 6, 7}), Scalar::Float64};
    Attribute wide{"wide", Domain::Face, 1, Shared(Array<double>{4294967295.0, 0, 77}), Scalar::UInt32};
    m = m.with(exact).with(wide).with(integers("group", Domain::Face, 1, m, 1, Scalar::Int32)).withGroupNames({"left", "right side", "top"});
    ASSERT_TRUE(checkMesh(m));
    for (const WriteOptions& o : encodings) {
        SCOPED_TRACE(int(o.binary) + 2 * int(o.bigEndian));
        expectEqual(m, written(m, "a.ply", o));
    }
}

// Then its list of corners is no memory at all.
TEST(RoundTrip, PlyKeepsFacesWithoutCorners)
{
    const Mesh m(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}}, Array<uint32_t>{0, 0, 0}, Array<uint32_t>{});
    const Folder folder;
    for (const WriteOptions& o : encodings) {
        writeFile(sceneOf(m, "hollow"), folder.path / "a.ply", o);
        const Mesh back = meshOf(readFile(folder.path / "a.ply"));
        EXPECT_EQ(back.vertexCount(), 2u);
        EXPECT_EQ(back.faceCount(), 2u);
        EXPECT_EQ(back.cornerCount(), 0u);
    }
}

TEST(RoundTrip, PlyWritesValuesOfCornersAtVerticesOrFacesWhereTheyAgree)
{
    Mesh m = patch();
    Array<float> byVertex, byFace;
    for (size_t c = 0; c < m.cornerCount(); ++c) {
        byVertex.push_back(float(m.cornerVertex()[c]));
        byVertex.push_back(0.5f);
        for (int k = 0; k < 3; ++k) byFace.push_back(c < 3 ? 0.f : c < 6 ? 0.2f : 1.f);
    }
    m = m.with(floatAttribute("texcoord", Domain::Corner, 2, byVertex)).with(floatAttribute("color", Domain::Corner, 3, byFace));
    const Folder folder;
    writeFile(sceneOf(m, "m"), folder.path / "m.ply", encodings[0]);
    const std::string text = bytesOf(folder.path / "m.ply");
    EXPECT_NE(text.find("property float s\n"), text.npos);
    EXPECT_LT(text.find("element face"), text.find("property float red"));
    EXPECT_EQ(text.find("list", text.find("vertex_indices")), text.npos);
    expectEqual(m, meshOf(readFile(folder.path / "m.ply")));
}

TEST(RoundTrip, ObjKeepsWhatItHolds)
{
    Mesh m = patch();
    m = m.with(floats("normal", Domain::Corner, 3, m, 0.01f))
            .with(floats("texcoord", Domain::Corner, 2, m, 0.013f))
            .with(floats("color", Domain::Vertex, 4, m, 0.0099f));
    m = m.with(integers("group", Domain::Face, 1, m, 1, Scalar::Int32)).withGroupNames({"left", "right side", "top"});
    expectEqual(m, written(m, "a.obj"));
    expectEqual(patch(), written(patch(), "b.obj"));
}

/// Faces only, and every vertex used: what STL and OFF hold.
Mesh tiles()
{
    Array<glm::vec3> p{{0, 0, 0}, {1, 0, 0.1f}, {1, 1, -1e-20f}, {0, 1, 1e20f}, {2, 0.333333343f, 0}, {2, 1, 16777217}};
    return Mesh(std::move(p), Array<uint32_t>{0, 3, 6, 10}, Array<uint32_t>{0, 1, 2, 0, 2, 3, 1, 4, 5, 2});
}

/// Corner values that are the same all round a vertex.
Attribute byVertex(const char* name, int components, const Mesh& mesh, float scale)
{
    Attribute a = gathered(floats(name, Domain::Vertex, components, mesh, scale), mesh.cornerVertex());
    a.domain = Domain::Corner;
    return a;
}

Attribute byFace(const char* name, const Mesh& mesh, float step)
{
    Array<float> values;
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (size_t i = 0; i < 3 * mesh.face(f).size(); ++i) values.push_back(float((7 * f + i % 3) % 32) * step);
    return floatAttribute(name, Domain::Corner, 3, std::move(values));
}

TEST(RoundTrip, OffKeepsWhatItHolds)
{
    const Mesh bare = tiles();
    Mesh full = bare;
    full = full.with(floats("normal", Domain::Vertex, 3, full, 0.013f)).with(byVertex("texcoord", 2, full, 0.017f));
    const Mesh both = full.with(floats("color", Domain::Vertex, 4, full, 0.0091f)).with(byFace("color", full, 1 / 31.f));
    const Mesh indices = bare.with(integerAttribute("color_index", Domain::Face, 1, Array<int32_t>{3, -1, 164}));
    for (const bool binary : {false, true}) {
        SCOPED_TRACE(binary);
        const WriteOptions options{.binary = binary};
        for (const Mesh& m : {bare, full, both, bare.with(floats("color", Domain::Vertex, 3, bare, 0.0033f)), bare.with(byFace("color", bare, 0.01f)),
                              bare.with(bytes255("color", Domain::Vertex, 3, bare))}) {
            const Folder folder;
            const auto lost = writeFile(sceneOf(m, "m"), folder.path / "a.off", options);
            EXPECT_TRUE(lost.empty()) << lost[0].text;
            expectEqual(m, meshOf(readFile(folder.path / "a.off")));
        }
        const Folder folder;
        writeFile(sceneOf(indices, "m"), folder.path / "a.off", options);
        expectEqual(indices, meshOf(readFile(folder.path / "a.off")));
    }
}

TEST(RoundTrip, OffSaysWhatItCannotHold)
{
    const Folder folder;
    Mesh m = patch();
    m = m.with(floats("texcoord", Domain::Corner, 2, m, 0.013f)).with(floats("quality", Domain::Vertex, 1, m, 1));
    const auto lost = writeFile(sceneOf(m, "m"), folder.path / "a.off", {.binary = false});
    EXPECT_TRUE(warning(lost, "seam-lost"));
    EXPECT_TRUE(warning(lost, "line-lost"));
    ASSERT_TRUE(warning(lost, "attribute-lost"));
    EXPECT_NE(warning(lost, "attribute-lost")->text.find("quality"), std::string::npos);
    const Mesh back = meshOf(readFile(folder.path / "a.off"));
    EXPECT_EQ(back.vertexCount(), 7u);  // the loose one, too
    EXPECT_TRUE(back.attributes().empty());
}

TEST(RoundTrip, StlKeepsTrianglesColoursAndSolids)
{
    // The order of vertices is that of first use, so that reading numbers them as before.
    Array<glm::vec3> p{{0, 0, 0}, {1, 0, 0.1f}, {1, 1, -1e-20f}, {0, 1, 12.5f}, {2, 0.333333343f, 0}};
    Mesh m(std::move(p), Array<uint32_t>{0, 3, 6, 9}, Array<uint32_t>{0, 1, 2, 0, 2, 3, 1, 4, 2});
    for (const bool binary : {false, true}) {
        const Mesh back = written(m, "a.stl", {.binary = binary});
        EXPECT_EQ(back.faceCount(), 3u);
    }
    const Folder folder;
    EXPECT_TRUE(writeFile(sceneOf(m, "m"), folder.path / "a.stl", {.binary = true}).empty());
    expectEqual(m, meshOf(readFile(folder.path / "a.stl")));
    EXPECT_TRUE(writeFile(sceneOf(m, "m"), folder.path / "b.stl", {.binary = false}).empty());
    expectEqual(m, meshOf(readFile(folder.path / "b.stl")));
    const Mesh groups = m.with(integerAttribute("group", Domain::Face, 1, Array<int32_t>{0, 1, 0})).withGroupNames({"left one", "right"});
    EXPECT_TRUE(writeFile(sceneOf(groups, "m"), folder.path / "c.stl", {.binary = false}).empty());
    expectEqual(groups, meshOf(readFile(folder.path / "c.stl")));
    EXPECT_TRUE(warning(writeFile(sceneOf(groups, "m"), folder.path / "d.stl"), "attribute-lost"));
    Mesh colored = m.with(byFace("color", m, 0));
    Array<float> values;
    for (size_t f = 0; f < 3; ++f)
        for (size_t i = 0; i < 9; ++i) values.push_back(float(double((11 * f + i % 3) % 32) / 31));
    colored = m.with(floatAttribute("color", Domain::Corner, 3, std::move(values)));
    EXPECT_TRUE(warning(writeFile(sceneOf(colored, "m"), folder.path / "e.stl"), "color-coarse"));
    expectEqual(colored, meshOf(readFile(folder.path / "e.stl")));
    EXPECT_TRUE(warning(writeFile(sceneOf(patch(), "m"), folder.path / "f.stl"), "triangulated"));
    EXPECT_TRUE(warning(writeFile(sceneOf(patch(), "m"), folder.path / "f.stl"), "point-lost"));
}

TEST(RoundTrip, UnitsAndAxesComeBackToTheSameBits)
{
    const Mesh m = tiles();
    for (const char* name : {"a.obj", "a.ply", "a.off"})
        for (const bool binary : {false, true})
            for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::X}) {
                SCOPED_TRACE(std::string(name) + " " + std::to_string(int(up)));
                const Folder folder;
                const WriteOptions options{.binary = binary, .placement = {1, up}};
                writeFile(sceneOf(m, "m"), folder.path / name, options);
                const bool says = !(binary && name == std::string("a.off"));
                const Imported in = readFile(folder.path / name, nullptr, says ? ImportOptions{} : ImportOptions{1, up});
                EXPECT_EQ(in.placement, options.placement);
                EXPECT_EQ(in.placementFromFile, says);
                EXPECT_EQ(contentHash(flattened(in.scene).mesh), contentHash(m));
                const glm::vec3 p = m.positions()[4], q = meshOf(in).positions()[4];
                EXPECT_EQ(q, up == UpAxis::Y ? p : up == UpAxis::Z ? glm::vec3(p.x, -p.z, p.y) : glm::vec3(p.y, -p.x, p.z));
                // And the file's own numbers come out again.
                writeFile(in.scene, folder.path / (std::string("again-") + name), options);
                EXPECT_EQ(bytesOf(folder.path / (std::string("again-") + name)), bytesOf(folder.path / name));
            }
}

TEST(RoundTrip, ObjKeepsMaterialsAndPictures)
{
    const Folder folder;
    const std::string png = std::string("\x89PNG\r\n\x1a\n", 8) + "not really a picture";
    folder.write("skin of it.png", png);
    folder.write("a.mtl",
                 "newmtl red one\nKd 1 0 0.25\nKs 0.5 0.5 0.5\nNs 30\nd 0.5\nmap_Kd -s 2 2 2 skin of it.png\nillum 2\n"
                 "newmtl b\nKd 0 1 0\nPr 0.3\nPm 1\nKe 1 2 3\n");
    folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red one\nf 1 2 3\nusemtl b\nf 2 4 3\n");
    const Imported first = readFile(folder.path / "a.obj");
    EXPECT_TRUE(first.warnings.empty()) << first.warnings[0].text;
    const Folder other;
    writeFile(first.scene, other.path / "b.obj");
    const Imported second = readFile(other.path / "b.obj");
    EXPECT_TRUE(second.warnings.empty()) << second.warnings[0].text;
    for (const Imported* in : {&first, &second}) {
        const MeshObject& o = objectOf(in->scene);
        ASSERT_EQ(o.materials.size(), 2u);
        const Material &red = *in->scene.find(o.materials[0]), &b = *in->scene.find(o.materials[1]);
        EXPECT_EQ(red.name, "red one");
        EXPECT_EQ(red.baseColor, glm::dvec4(1, 0, 0.25, 0.5));
        EXPECT_EQ(red.alpha, Material::Alpha::Blend);
        EXPECT_DOUBLE_EQ(red.roughness, std::sqrt(2.0 / 32));
        EXPECT_NE(red.extras.find("Ks 0.5 0.5 0.5"), std::string::npos);
        const Image* image = in->scene.find(red.baseColorTexture.image);
        ASSERT_TRUE(image);
        EXPECT_EQ(std::string(image->bytes->begin(), image->bytes->end()), png);
        EXPECT_EQ(b.roughness, 0.3);
        EXPECT_EQ(b.metallic, 1);
        EXPECT_EQ(b.emissive, glm::dvec3(1, 2, 3));
        EXPECT_EQ(o.base.find("material")->at(0, 0), 0);
        EXPECT_EQ(o.base.find("material")->at(1, 0), 1);
    }
}

TEST(RoundTrip, AForeignFileOfThePicturesNameIsNotOverwritten)
{
    Scene scene;
    const ImageId image = scene.add(Image{"skin.png", "image/png", std::make_shared<const std::vector<uint8_t>>(20, uint8_t(7))});
    Material m;
    m.name = "m";
    m.baseColorTexture.image = image;
    const MaterialId material = scene.add(m);
    Node node;
    node.mesh = scene.add(MeshObject{"o", patch(), {material}, {}});
    scene.add(node);
    const Folder folder;
    folder.write("skin.png", "somebody's own");
    for (int twice = 0; twice < 2; ++twice) writeFile(scene, folder.path / "a.obj");
    EXPECT_EQ(bytesOf(folder.path / "skin.png"), "somebody's own");
    EXPECT_EQ(bytesOf(folder.path / "skin_2.png"), std::string(20, 7));
    EXPECT_NE(bytesOf(folder.path / "a.mtl").find("map_Kd skin_2.png"), std::string::npos);
    size_t files = 0;
    for ([[maybe_unused]] const auto& e : fs::directory_iterator(folder.path)) ++files;
    EXPECT_EQ(files, 4u);  // no temporary file is left, and the second time adds none
}

TEST(RoundTrip, WritingIsAllOrNothing)
{
    const Folder folder;
    folder.write("a.ply", "before");
    Progress stop;
    stop.cancelled = true;
    EXPECT_THROW(writeFile(sceneOf(patch(), "m"), folder.path / "a.ply", {}, &stop), Cancelled);
    EXPECT_EQ(bytesOf(folder.path / "a.ply"), "before");
    EXPECT_NE(errorOf([&] { writeFile(Scene(), folder.path / "a.ply"); }).find("no visible mesh"), std::string::npos);
    EXPECT_EQ(bytesOf(folder.path / "a.ply"), "before");
    EXPECT_NE(errorOf([&] { writeFile(sceneOf(patch(), "m"), folder.path / "none" / "a.ply"); }).find("folder"), std::string::npos);
    EXPECT_NE(errorOf([&] { writeFile(sceneOf(patch(), "m"), folder.path / "a.xyz"); }).find("Stanford PLY"), std::string::npos);
    size_t files = 0;
    for ([[maybe_unused]] const auto& e : fs::directory_iterator(folder.path)) ++files;
    EXPECT_EQ(files, 1u);
}

TEST(RoundTrip, EveryMeshOfTheData)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const auto& e : fs::recursive_directory_iterator(data / "meshes")) {
        const bool ply = e.path().extension() == ".ply";
        if ((!ply && e.path().extension() != ".obj") || e.path().filename() == "issue623.ply") continue;
        SCOPED_TRACE(e.path().string());
        const Folder folder;
        const Imported in = readFile(e.path());
        for (const WriteOptions& o : encodings) {
            if (!ply && o.binary) continue;
            const fs::path copy = folder.path / e.path().filename();
            writeFile(in.scene, copy, o);
            const Imported back = readFile(copy);
            EXPECT_EQ(contentHash(meshOf(in)), contentHash(meshOf(back)));
            EXPECT_TRUE(back.warnings.empty()) << back.warnings[0].text;
        }
    }
}

}  // namespace
}  // namespace mw::test
