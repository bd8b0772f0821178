// The ways in which programs write OFF and STL: what is written on the page of each format, and what is found in the wild.
#include <bit>
#include <cmath>

#include "data.h"
#include "helpers.h"

namespace mw::test {
namespace {

Imported read(const Folder& folder, const std::string& bytes, const char* name = "a.off")
{
    Imported in = readFile(folder.write(name, bytes));
    EXPECT_TRUE(checkMesh(meshOf(in)));
    return in;
}

std::string big(std::initializer_list<uint32_t> values)
{
    std::string out;
    for (uint32_t v : values)
        for (int i = 3; i >= 0; --i) out += char(v >> 8 * i);
    return out;
}
uint32_t bits(float v)
{
    return std::bit_cast<uint32_t>(v);
}

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, HeadersInAllTheirForms)
{
    const Folder folder;
    for (const char* header : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "OFF4 1 0\n", "# by hand\n\nOFF # of a square\n4 1\n", "OFF\r\n4 1 4\r\n",
                               "\xef\xbb\xbfOFF\n4\n1\n4\n", "4 1 4\n", "nOFF 3\n4 1 4\n"}) {
        const Imported in = read(folder, header + square + "4 0 1 2 3\n");
        EXPECT_EQ(meshOf(in).vertexCount(), 4u) << header;
        EXPECT_EQ(meshOf(in).face(0).size(), 4u) << header;
        EXPECT_TRUE(in.warnings.empty()) << header;
        EXPECT_EQ(in.units, "unknown");
    }
    // Its content tells, whatever the name.
    EXPECT_EQ(read(folder, "OFF\n4 1 0\n" + square + "4 0 1 2 3\n", "a.txt").format, "OFF (text)");
    EXPECT_EQ(read(folder, "OFF\n4 1 0\n" + square + "4 0 1 2 3\n", "a.obj").format, "OFF (text)");
    EXPECT_NE(errorOf([&] { readFile(folder.write("a.off", "nOFF 4\n1 0 0\n0 0 0 0\n")); }).find("three dimensions"), std::string::npos);
    EXPECT_NE(errorOf([&] { readFile(folder.write("a.off", "CCOFF\n1 0 0\n0 0 0 0\n")); }).find("begins with"), std::string::npos);
}

TEST(Off, LettersInAnyOrderSayWhatAVertexHas)
{
    const Folder folder;
    for (const char* word : {"STCNOFF", "NCSTOFF", "CSTNOFF"}) {
        const Mesh m = meshOf(read(folder, std::string(word) + "\n3 1 0\n0 0 0 0 0 1 0.5 0.25 1 1 0.1 0.2\n1 0 0 0 0 1 0 0 0 0.5 0.3 0.4\n"
                                                               "0 1 0 0 1 0 1 1 1 1 0.5 0.6\n3 0 1 2\n"));
        const Attribute *n = m.find("normal", Domain::Vertex), *c = m.find("color", Domain::Vertex), *t = m.find("texcoord", Domain::Corner);
        ASSERT_TRUE(n && c && t) << word;
        EXPECT_EQ(n->at(2, 1), 1);
        EXPECT_EQ(c->components, 4);
        EXPECT_EQ(c->at(1, 3), 0.5);
        EXPECT_EQ(t->at(1, 0), double(0.3f));
    }
    const Mesh projective = meshOf(read(folder, "4OFF\n3 1 0\n2 4 6 2\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"));
    EXPECT_EQ(projective.positions()[0], glm::vec3(1, 2, 3));
    const Imported infinite = read(folder, "4OFF\n4 2 0\n2 4 6 0\n1 0 0 1\n0 1 0 1\n0 0 1 1\n3 0 1 2\n3 1 2 3\n");
    EXPECT_TRUE(warning(infinite.warnings, "nan-position"));
    EXPECT_EQ(meshOf(infinite).faceCount(), 1u);
}

TEST(Off, ColoursOfVerticesAsBytesOrFractions)
{
    const Folder folder;
    const Mesh bytes = meshOf(read(folder, "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 0 0 0\n0 1 0 1 2 3 4\n3 0 1 2\n"));
    EXPECT_FLOAT_EQ(float(bytes.find("color")->at(0, 2)), 0.2f);
    EXPECT_EQ(bytes.find("color")->stored, Scalar::UInt8);
    const Mesh three = meshOf(read(folder, "COFF\n3 1 0\n0 0 0 0.5 0 1\n1 0 0 0 0 0\n0 1 0 1 1 1\n3 0 1 2\n"));
    EXPECT_EQ(three.find("color")->components, 3);
    EXPECT_EQ(three.find("color")->at(0, 0), 0.5);
    const Imported silent = read(folder, "OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    EXPECT_TRUE(warning(silent.warnings, "unannounced-color"));
    EXPECT_EQ(meshOf(silent).find("color")->at(1, 1), 1);
    const Imported more = read(folder, "OFF\n3 1 0\n0 0 0 0.5\n1 0 0 0.5\n0 1 0 0.5\n3 0 1 2\n");
    EXPECT_TRUE(warning(more.warnings, "extra-values"));
    EXPECT_EQ(meshOf(more).positions()[2], glm::vec3(0, 1, 0));
}

TEST(Off, ColoursOfFacesInAllTheirForms)
{
    const Folder folder;
    const std::string start = "OFF\n4 3 0\n" + square;
    const Mesh bytes = meshOf(read(folder, start + "3 0 1 2 255 0 51\n3 0 2 3 # none\n3 1 2 3 0 0 0 255\n"));
    const Attribute* c = bytes.find("color", Domain::Corner);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->components, 4);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(c->at(k, 0), 1);
    EXPECT_FLOAT_EQ(float(c->at(0, 2)), 0.2f);
    EXPECT_EQ(c->at(3, 0), 1);  // white where the file says nothing
    EXPECT_EQ(c->at(6, 0), 0);
    const Mesh fractions = meshOf(read(folder, start + "3 0 1 2 0.5 0 1.0\n3 0 2 3 255 0 0\n3 1 2 3 1e0 1. 0.25\n"));
    c = fractions.find("color", Domain::Corner);
    EXPECT_EQ(c->at(0, 0), 0.5);
    EXPECT_EQ(c->at(3, 0), 1);
    EXPECT_EQ(c->at(6, 2), 0.25);
    const Imported map = read(folder, start + "3 0 1 2 7\n3 0 2 3\n3 1 2 3 12\n");
    EXPECT_TRUE(warning(map.warnings, "color-map"));
    EXPECT_EQ(meshOf(map).find("color_index")->at(0, 0), 7);
    EXPECT_EQ(meshOf(map).find("color_index")->at(1, 0), -1);
    EXPECT_FALSE(meshOf(map).find("color"));
    const Imported odd = read(folder, start + "3 0 1 2 red\n3 0 2 3 1 2\n3 1 2 3\n");
    EXPECT_TRUE(warning(odd.warnings, "broken-color"));
    EXPECT_EQ(meshOf(odd).faceCount(), 3u);
}

/// Plain lines are read in another way than others.
TEST(Off, HowItIsSpacedChangesNothing)
{
    const Folder folder;
    const std::string text =
        "NOFF\n4 3 0\n0.5 -1.25 3 0 0 1\n1e0 0.0625 -7.5 0 1 0\n1 1 0 0.6 0.8 0\n0.123456789 1 12345678.5 1 0 0\n3 0 1 2\n4 0 1 2 3\n";
    const std::string end = "3 1 2 3\n";
    const Mesh plain = meshOf(read(folder, text + end));
    EXPECT_EQ(plain.positions()[1], glm::vec3(1, 0.0625f, -7.5f));
    EXPECT_EQ(plain.face(1)[3], 3u);
    for (const auto& [from, to] : std::vector<std::pair<char, std::string>>{{' ', "  "}, {' ', "\t"}, {'\n', " \n"}, {'\n', "\r\n"}, {'\n', " # \n"}})
        EXPECT_EQ(contentHash(meshOf(read(folder, replaced(text + end, from, to)))), contentHash(plain));
    for (const char* broken : {"3 1 2 x\n", "3 1 2", "4 0 1 2", "3 1 2."}) {
        const std::string error = errorOf([&] { readFile(folder.write("a.off", text + broken)); });
        EXPECT_NE(error.find("face 2"), std::string::npos) << error;
        EXPECT_NE(error.find("line 9"), std::string::npos) << error;
    }
    EXPECT_NE(errorOf([&] { readFile(folder.write("a.off", "OFF\n2 0 0\n0 0 0\n1 2 1.5y\n")); }).find("line 4"), std::string::npos);
}

TEST(Off, RecordsMayLieAnywhere)
{
    const Folder folder;
    const Mesh m = meshOf(read(folder, "OFF\n4 2 0\n0 0\n0 1 0 0\n\n1 1 0 # third\n0 1 0\n3 0\n1\n2\n4\n0 1 2 3\n"));
    EXPECT_EQ(m.positions()[3], glm::vec3(0, 1, 0));
    EXPECT_EQ(m.face(1).size(), 4u);
    const Imported kept = read(folder, "OFF\n4 4 0\n" + square + "3 0 1 2\n2 0 1\n3 0 1 9\n3 0 -1 2\n");
    EXPECT_EQ(meshOf(kept).faceCount(), 2u);
    EXPECT_TRUE(warning(kept.warnings, "small-face"));
    ASSERT_TRUE(warning(kept.warnings, "face-index"));
    EXPECT_EQ(warning(kept.warnings, "face-index")->text.substr(0, 1), "2");
    EXPECT_TRUE(warning(read(folder, "OFF\n4 1 0\n" + square + "3 0 1 2\n3 0 2 3\n").warnings, "trailing-text"));
    EXPECT_EQ(meshOf(read(folder, "OFF\n4 0 0\n" + square)).vertexCount(), 4u);  // a point cloud
}

/// By the page of Geomview: big-endian, and each face tells how many values its colour has.
TEST(Off, BinaryAsGeomviewWritesIt)
{
    const Folder folder;
    const std::string corners = big({0, 0, 0, bits(1), 0, 0, 0, bits(1), 0});
    const Imported plain = read(folder, "OFF BINARY\n" + big({3, 1, 3}) + corners + big({3, 0, 1, 2, 0}));
    EXPECT_EQ(plain.format, "OFF (binary, big-endian)");
    EXPECT_EQ(meshOf(plain).positions()[2], glm::vec3(0, 1, 0));
    EXPECT_TRUE(plain.warnings.empty());
    const Mesh colored = meshOf(read(folder, "OFF BINARY\n" + big({3, 1, 3}) + corners + big({3, 0, 1, 2, 4, bits(0.5f), 0, bits(1), bits(0.25f)})));
    EXPECT_EQ(colored.find("color", Domain::Corner)->at(1, 0), 0.5);
    EXPECT_EQ(colored.find("color", Domain::Corner)->at(1, 3), 0.25);
    const Mesh index = meshOf(read(folder, "OFF BINARY\n" + big({3, 1, 3}) + corners + big({3, 0, 1, 2, 1, 5})));
    EXPECT_EQ(index.find("color_index")->at(0, 0), 5);
    const Mesh vertex = meshOf(read(folder, "COFF BINARY\n" + big({1, 0, 0, bits(1), bits(2), bits(3), bits(0.5f), 0, 0, bits(1)})));
    EXPECT_EQ(vertex.find("color", Domain::Vertex)->at(0, 0), 0.5);
    EXPECT_TRUE(warning(read(folder, "OFF BINARY\n" + big({3, 1, 3}) + corners + big({3, 0, 1, 2, 0}) + "more").warnings, "trailing-bytes"));
}

std::string facet(const char* corners)
{
    return std::string("facet normal 0 0 0\nouter loop\n") + corners + "endloop\nendfacet\n";
}
const char* const lower = "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n";
const char* const upper = "vertex 0 0 -0\nvertex 1 1 0\nvertex 0 1 0\n";

TEST(Stl, SolidsWithNamesOfSeveralWords)
{
    const Folder folder;
    const Imported in = read(folder,
                             "solid left part (v2)\n" + facet(lower) + "endsolid left part (v2)\nsolid\n" + facet(upper) +
                                 "endsolid\nsolid left part (v2)\n" + facet("vertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\n") + "endsolid\n",
                             "a.stl");
    const Mesh& m = meshOf(in);
    EXPECT_EQ(in.format, "STL (text)");
    EXPECT_TRUE(in.warnings.empty());
    EXPECT_EQ(m.vertexCount(), 7u);  // 0 and -0 are one place
    ASSERT_EQ(m.groupNames(), (std::vector<std::string>{"left part (v2)", ""}));
    EXPECT_EQ(m.find("group")->at(0, 0), 0);
    EXPECT_EQ(m.find("group")->at(1, 0), 1);
    EXPECT_EQ(m.find("group")->at(2, 0), 0);
    EXPECT_TRUE(meshOf(read(folder, "solid\n" + facet(lower) + "endsolid\n", "a.stl")).groupNames().empty());
}

TEST(Stl, TextInTheWild)
{
    const Folder folder;
    std::string upperCase = "SOLID A\n" + facet(lower);
    for (char& c : upperCase) c = char(std::toupper(c));
    EXPECT_EQ(meshOf(read(folder, upperCase + "ENDSOLID\n", "a.stl")).faceCount(), 1u);
    std::string oneLine = "solid a\n" + facet(lower) + "endsolid a";
    for (char& c : oneLine)
        if (&c > &oneLine[8] && c == '\n') c = ' ';
    EXPECT_EQ(meshOf(read(folder, oneLine, "a.stl")).faceCount(), 1u);
    const Imported quad = read(folder, "solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n") + "endsolid\n", "a.stl");
    EXPECT_EQ(meshOf(quad).face(0).size(), 4u);
    EXPECT_TRUE(warning(quad.warnings, "polygon"));
    const Imported broken = read(folder,
                                 "solid\nfacet normal nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n" +
                                     facet("vertex 0 0 0\nvertex 1 x 0\nvertex 1 1 0\n") + facet("vertex 0 0 0\nvertex 1 0 0\n") + "endsolid\n",
                                 "a.stl");
    EXPECT_EQ(meshOf(broken).faceCount(), 1u);
    EXPECT_TRUE(warning(broken.warnings, "nan-face"));
    EXPECT_TRUE(warning(broken.warnings, "broken-face"));
    const Imported cut = read(folder, "solid a\n" + facet(lower) + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0", "a.stl");
    EXPECT_EQ(meshOf(cut).faceCount(), 1u);
    EXPECT_TRUE(warning(cut.warnings, "truncated"));
    // A degenerate facet stays, and is reported.
    EXPECT_EQ(
        meshOf(read(folder, "solid\n" + facet(lower) + facet("vertex 0 0 0\nvertex 0 0 0\nvertex 1 1 0\n") + "endsolid\n", "a.stl")).faceCount(), 2u);
}

std::string binaryStl(std::string header, std::initializer_list<uint16_t> colors)
{
    header.resize(80, ' ');
    const auto put = [&](uint32_t v, int n) {
        for (int i = 0; i < n; ++i) header += char(v >> 8 * i);
    };
    put(uint32_t(colors.size()), 4);
    uint32_t row = 0;
    for (uint16_t c : colors) {
        for (float v : {0.f, 0.f, 1.f, 0.f, 0.f, float(row), 1.f, 0.f, float(row), 1.f, 1.f, float(row)}) put(bits(v), 4);
        put(c, 2);
        ++row;
    }
    return header;
}

TEST(Stl, BinaryIsKnownByItsSize)
{
    const Folder folder;
    const Imported in = read(folder, binaryStl("solid as some programs begin", {0, 0}), "a.stl");
    EXPECT_EQ(in.format, "STL (binary)");
    EXPECT_EQ(meshOf(in).faceCount(), 2u);
    EXPECT_TRUE(meshOf(in).attributes().empty());
    EXPECT_EQ(read(folder, binaryStl("", {0, 0}), "a.dat").format, "STL (binary)");
    EXPECT_TRUE(warning(read(folder, binaryStl("x", {0, 0}) + "more", "a.stl").warnings, "trailing-bytes"));
    EXPECT_TRUE(warning(read(folder, binaryStl(std::string("solid\0", 6), {0, 0}) + "more", "a.stl").warnings, "trailing-bytes"));
}

TEST(Stl, ColoursAfterVisCamAndMagics)
{
    const Folder folder;
    // VisCAM: bit 15 says that there is one, blue lowest.
    const Mesh viscam = meshOf(read(folder, binaryStl("", {0x8000 | 31 << 10, 0x8000 | 31, 0x1234}), "a.stl"));
    const Attribute* c = viscam.find("color", Domain::Corner);
    ASSERT_TRUE(c);
    const auto expectColor = [&](size_t f, double r, double g, double b) {
        EXPECT_NEAR(c->at(3 * f, 0), r, 1e-6);
        EXPECT_NEAR(c->at(3 * f, 1), g, 1e-6);
        EXPECT_NEAR(c->at(3 * f, 2), b, 1e-6);
    };
    expectColor(0, 1, 0, 0);
    expectColor(1, 0, 0, 1);
    expectColor(2, 1, 1, 1);
    // Magics: a colour for all in the header, bit 15 says that it holds, red lowest.
    const Mesh magics = meshOf(read(folder, binaryStl("COLOR=\x33\x66\x99\xff", {0x8000, 31, 31 << 10}), "a.stl"));
    c = magics.find("color", Domain::Corner);
    ASSERT_TRUE(c);
    expectColor(0, 0.2, 0.4, 0.6);
    expectColor(1, 1, 0, 0);
    expectColor(2, 0, 0, 1);
}

}  // namespace
}  // namespace mw::test
