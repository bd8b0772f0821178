// What the lines of an OBJ file and the elements of a PLY file mean.
#include "helpers.h"

namespace mw::test {
namespace {

Imported obj(const std::string& text)
{
    static const Folder folder;
    Imported in = readFile(folder.write("a.obj", text));
    EXPECT_TRUE(checkMesh(meshOf(in)));
    return in;
}
Imported ply(const std::string& text)
{
    static const Folder folder;
    Imported in = readFile(folder.write("a.ply", text));
    EXPECT_TRUE(checkMesh(meshOf(in)));
    return in;
}
std::vector<uint32_t> corners(const Imported& in)
{
    const auto c = meshOf(in).cornerVertex().span();
    return {c.begin(), c.end()};
}
using Indices = std::vector<uint32_t>;
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, IndicesForwardsBackwardsAndAhead)
{
    EXPECT_EQ(corners(obj(square + "f 1 2 3\nf -4 -3 -2\n")), (Indices{0, 1, 2, 0, 1, 2}));
    EXPECT_EQ(corners(obj("f 1 2 3\n" + square)), (Indices{0, 1, 2}));  // vertices may come after their faces
    const Imported in = obj("v 5 5 5\nf -1 2 9\nf 1 2 3\n" + square);
    EXPECT_EQ(corners(in), (Indices{0, 1, 2}));
    EXPECT_NE(warning(in.warnings, "face-index")->text.find("line 2"), std::string::npos);
}

TEST(ReadObj, LineEndsAndEncodings)
{
    const std::string text = square + "f 1 2 \\\n3 4\n";
    const uint64_t hash = contentHash(meshOf(obj(text)));
    EXPECT_EQ(contentHash(meshOf(obj(replaced(text, '\n', "\r\n")))), hash);
    EXPECT_EQ(contentHash(meshOf(obj(replaced(text, '\n', "\r")))), hash);
    EXPECT_EQ(contentHash(meshOf(obj("\xef\xbb\xbf" + text))), hash);
    EXPECT_EQ(contentHash(meshOf(obj(text.substr(0, text.size() - 1)))), hash);
    std::string little = "\xff\xfe", big = "\xfe\xff";
    for (char c : text) {
        little += {c, '\0'};
        big += {'\0', c};
    }
    EXPECT_EQ(contentHash(meshOf(obj(little))), hash);
    EXPECT_EQ(contentHash(meshOf(obj(big))), hash);
}

/// Plain lines are read in another way than others.
TEST(ReadObj, HowItIsSpacedChangesNothing)
{
    const std::string text =
        "v 0.5 -1.25 3\nv 1e0 0.0625 -7.5\nv 1 1 0\nv 0.123456789 1 12345678.5\nvn 0 0.5 1\nf 1 2 3\nf 1 2 3 4\nf 2 3 9\nf 2 3 4\n";
    const Imported plain = obj(text);
    EXPECT_EQ(corners(plain), (Indices{0, 1, 2, 0, 1, 2, 3, 1, 2, 3}));
    EXPECT_EQ(meshOf(plain).positions()[1], glm::vec3(1, 0.0625f, -7.5f));
    for (const auto& [from, to] :
         std::vector<std::pair<char, std::string>>{{' ', "  "}, {' ', "\t"}, {'\n', " \n"}, {'\n', "\r\n"}, {' ', " \\\n "}}) {
        const Imported in = obj(replaced(text, from, to));
        EXPECT_EQ(contentHash(meshOf(in)), contentHash(meshOf(plain)));
        ASSERT_TRUE(warning(in.warnings, "face-index"));
        EXPECT_EQ(in.warnings.size(), plain.warnings.size());
    }
    EXPECT_NE(warning(plain.warnings, "face-index")->text.find("line 8"), std::string::npos);
}

TEST(ReadObj, NumbersInEveryForm)
{
    const Imported in = obj("v +1 -.5 2.e1\nv 1E2 1e-2 0.1\nv 123456789012345678901234567890 1e-50 16777217\nv 0x10 1 2\nv 1 2\nf 1 2 3\n");
    const auto& p = meshOf(in).positions();
    EXPECT_EQ(p[0], glm::vec3(1, -0.5f, 20));
    EXPECT_EQ(p[1], glm::vec3(100, 0.01f, 0.1f));
    EXPECT_EQ(p[2], glm::vec3(1.2345678901234567e29f, 0, 16777216));  // half-way between two floats: to the even one
    EXPECT_TRUE(warning(in.warnings, "odd-number"));
    EXPECT_TRUE(warning(in.warnings, "broken-vertex"));
    EXPECT_EQ(warning(in.warnings, "nan-position")->elements, (std::vector<uint32_t>{4}));
}

TEST(ReadObj, TextcoordsAndNormalsAreCornerAttributes)
{
    const Imported in = obj(square + "vt 0 0.25\nvt 1 0\nvn 0 0 1\nvn 0 1 0\nf 1/1/1 2/2/2 3/-1/-1\nf 1 3 4\nf 1//2 3 4/9\n");
    const Mesh& m = meshOf(in);
    const Attribute &t = *m.find("texcoord", Domain::Corner), &n = *m.find("normal", Domain::Corner);
    EXPECT_EQ(t.at(0, 1), 0.25);
    EXPECT_EQ(t.at(2, 0), 1);
    EXPECT_EQ(n.at(1, 1), 1);
    EXPECT_EQ(n.at(3, 2), 1);  // no normal in the file: the face's own
    EXPECT_NE(warning(in.warnings, "texcoord-missing")->text.find("5 corners"), std::string::npos);
    EXPECT_TRUE(warning(in.warnings, "texcoord-index"));
}

TEST(ReadObj, GroupsObjectsAndMaterials)
{
    const Imported in = obj(square + "f 1 2 3\no body\nusemtl a\nf 1 2 3\ng arm\nf 1 2 4\nf 2 3 4\no head\nusemtl a\nf 1 3 4\n");
    const Mesh& m = meshOf(in);
    EXPECT_EQ(in.scene.meshes().size(), 1u);
    const auto name = [&](size_t f) { return m.groupNames()[size_t(m.find("group")->integers()[f])]; };
    EXPECT_EQ(name(0), "default");
    EXPECT_EQ(name(1), "body");
    EXPECT_EQ(name(2), "body/arm");
    EXPECT_EQ(name(4), "head");
    const auto material = [&](size_t f) { return in.scene.find(objectOf(in.scene).materials[size_t(m.find("material")->integers()[f])])->name; };
    EXPECT_EQ(material(0), "default");
    EXPECT_EQ(material(4), "a");
}

TEST(ReadObj, ColoursLinesAndOddFaces)
{
    const Imported in = obj("v 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0 0 1 0 0.5\nl 1 2 3 1\nl 1 77\nf 1 2\nf 1 2 x\nf\nf 1 1 2\nwhat is this\n");
    const Mesh& m = meshOf(in);
    const Attribute& c = *m.find("color", Domain::Vertex);
    EXPECT_EQ(c.components, 4);
    EXPECT_EQ(c.at(0, 1), 1);  // white where the file has none
    EXPECT_EQ(c.at(2, 3), 0.5);
    EXPECT_EQ(m.lines().size(), 6u);
    EXPECT_EQ(m.faceCount(), 2u);  // the two degenerate ones are kept
    for (const char* code : {"line-index", "small-face", "broken-face", "unknown-line"}) EXPECT_TRUE(warning(in.warnings, code)) << code;
}

TEST(ReadPly, AnyOrderOfElementsAndProperties)
{
    const Imported in =
        ply("ply\r\nformat ascii 1.0\r\ncomment x\r\nelement camera 1\r\nproperty list uchar float m\r\nelement face 2\r\nproperty uchar "
            "red\r\nproperty list uchar ushort vertex_index\r\n"
            "property uchar green\r\nproperty uchar blue\r\nproperty list uchar float texcoord\r\nelement edge 1\r\nproperty int vertex1\r\nproperty "
            "int vertex2\r\n"
            "element vertex 4\r\nproperty double z\r\nproperty short y\r\nproperty int quality\r\nproperty uchar x\r\nend_header\r\n"
            "2 1.5 2.5\r\n255 3 0 1 2 0 51 6 0 0 1 0 1 1\r\n0 3 0 2 3 0 0 6 0 0 1 1 0 1\r\n1 3\r\n0.5 0 7 0\r\n0.5 0 8 1\r\n\r\n0.5 1 9 1\r\n0.5 1 "
            "-3 0 99\r\n");
    const Mesh& m = meshOf(in);
    EXPECT_EQ(m.positions()[2], glm::vec3(1, 1, 0.5f));
    EXPECT_EQ(corners(in), (Indices{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(m.find("color", Domain::Corner)->at(0, 2), double(float(51.0 / 255)));
    EXPECT_EQ(m.find("texcoord", Domain::Corner)->at(4, 1), 1);
    EXPECT_EQ(m.find("quality")->integers()[3], -3);
    EXPECT_EQ(m.lines().size(), 2u);
    EXPECT_TRUE(warning(in.warnings, "unknown-element"));
    EXPECT_NE(warning(in.warnings, "extra-values")->text.find("line 29"), std::string::npos) << warning(in.warnings, "extra-values")->text;
}

TEST(ReadPly, StripsBecomeTriangles)
{
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list int int "
        "vertex_indices\nend_header\n";
    const Imported in = ply(head + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 3 4\n");
    EXPECT_EQ(corners(in), (Indices{0, 1, 2, 2, 1, 3}));
    EXPECT_EQ(corners(ply(head + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n4 0 1 2 3\n")), (Indices{0, 1, 2, 2, 1, 3}));
}

TEST(ReadPly, BrokenVerticesAndIndices)
{
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\n"
        "element face 4\nproperty list uchar int vertex_indices\nproperty int id\nend_header\n";
    const Imported in = ply(head + "nan 0 0 1 1\n2 0 0 0.5 1\n0 1 0 nan 0\n2 2 0 0 0\n3 0 1 2 10\n3 1 2 3 11\n3 1 2 -1 12\n3 3 2 1 13\n");
    const Mesh& m = meshOf(in);
    EXPECT_EQ(corners(in), (Indices{1, 2, 3, 3, 2, 1}));
    EXPECT_EQ(m.positions()[0], glm::vec3(1, 1, 0));  // the centre of the others
    EXPECT_EQ(m.find("id")->integers()[1], 13);
    EXPECT_EQ(m.find("texcoord", Domain::Corner)->at(0, 0), 0.5);
    EXPECT_EQ(warning(in.warnings, "nan-position")->elements, (std::vector<uint32_t>{0}));
    EXPECT_TRUE(warning(in.warnings, "nan-value"));
    const std::string e = errorOf([&] { ply(head + "0 0 0 0 0\n0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n3 0 1 2 0\n3 0 1 2 0\n3 0 1 2 0\n3 0 1 2 0\n"); });
    EXPECT_NE(e.find("line 14"), e.npos) << e;
    EXPECT_NE(e.find("'t'"), e.npos) << e;
}

TEST(ReadPly, WellKnownNamesInOtherFormsAreRenamed)
{
    const Imported in = ply(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float normal\nproperty int color\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty float material\nproperty list uchar int texcoord\nend_header\n"
        "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n3 0 1 2 0.5 3 7 8 9\n");
    for (const char* name : {"normal_", "color_", "material_", "texcoord_"}) EXPECT_TRUE(meshOf(in).find(name)) << name;
}

TEST(ReadPly, DoublesFarFromTheOriginAreReported)
{
    const Imported in =
        ply("ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\nend_header\n4000000.1 0 0\n4000000.7 "
            "1 0\n");
    EXPECT_TRUE(warning(in.warnings, "double-position"));
}

}  // namespace
}  // namespace mw::test
