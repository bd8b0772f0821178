// Files made to hurt: whatever the bytes, a reader throws Error or gives a mesh that keeps its promises, in bounded time and memory.
#include <bit>
#include <chrono>
#include <random>
#include <sys/stat.h>
#include <variant>

#include "helpers.h"

namespace mw::test {
namespace {

namespace fs = std::filesystem;

const char* const smallObj =
    "mtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 .5 .5 .5\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
    "usemtl m\ng a\nf 1/1/1 2/2/1 3/3/1\nf -4//-1 \\\n -2//1 4//1\nl 1 2 3\np 1\n";

std::string smallPly(bool binary, bool big)
{
    const Folder folder;
    Mesh m(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Array<uint32_t>{0, 3, 7}, Array<uint32_t>{0, 1, 2, 0, 1, 2, 3});
    m = m.withLines(Array<uint32_t>{0, 2});
    m = m.with(floatAttribute("texcoord", Domain::Corner, 2, Array<float>{0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0, 1}));
    m = m.with(integerAttribute("id", Domain::Face, 1, Array<int32_t>{7, -7}));
    writeFile(sceneOf(m, "m"), folder.path / "m.ply", {false, binary, big});
    return bytesOf(folder.path / "m.ply");
}

const char* const smallOff =
    "# by hand\nSTCNOFF\n4 3 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n1 1 0 0 0 1 0 0 255 9 1 1\n"
    "0 1 0 0 0 1 1 2 3 4 0 1\n3 0 1 2 255 0 0\n4 0\n1 2 3 0.5 0.5 0.5 1\n3 0 2 3 17\n";

const char* const smallStl =
    "solid one two\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1e0 0\n  endloop\n endfacet\n"
    "endsolid one two\nsolid b\nfacet normal nan 0 1 outer loop vertex 0 0 0 vertex 1 1 0 vertex 0 1 0 endloop endfacet\nendsolid\n";

/// Words of four bytes, one after the other.
std::string words(std::initializer_list<std::variant<int, float>> values, bool big)
{
    std::string out;
    for (const auto& v : values) {
        uint32_t bits = std::visit([](auto x) { return std::bit_cast<uint32_t>(x); }, v);
        for (int i = 0; i < 4; ++i) out += char(bits >> 8 * (big ? 3 - i : i));
    }
    return out;
}

std::string smallBinaryOff(bool big)
{
    const std::string vertices = words({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}, big);
    if (!big) return "OFF BINARY\n" + words({4, 2, 0}, big) + vertices + words({3, 0, 1, 2, 3, 0, 2, 3}, big);
    return "OFF BINARY\n" + words({4, 2, 0}, big) + vertices + words({3, 0, 1, 2, 4, 1.f, 0.f, 0.f, 1.f, 3, 0, 2, 3, 0}, big);
}

std::string smallBinaryStl()
{
    std::string out = "solid in name only COLOR=";
    out += "\x80\x40\x20\xff";
    out.resize(80, ' ');
    out += words({2}, false);
    for (const char color : {char(0x7c), char(0x80)}) {
        out += words({0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, -0.f}, false) + '\x1f';
        out += color;
    }
    return out;
}

/// Never anything but Error or a sound mesh.
void expectSound(const fs::path& file)
{
    try {
        const Imported in = readFile(file);
        const auto sound = checkMesh(meshOf(in));
        EXPECT_TRUE(sound);
        if (!sound) std::fprintf(stderr, "%s\n", bytesOf(file).substr(0, 2000).c_str());
    } catch (const Error& e) {
        EXPECT_EQ(e.file(), file.string());
    }
}

std::vector<std::pair<std::string, std::string>> seeds()
{
    return {{"a.obj", smallObj},        {"a.ply", smallPly(false, false)}, {"b.ply", smallPly(true, false)}, {"c.ply", smallPly(true, true)},
            {"a.off", smallOff},        {"b.off", smallBinaryOff(true)},   {"c.off", smallBinaryOff(false)}, {"a.stl", smallStl},
            {"b.stl", smallBinaryStl()}};
}

TEST(Hostile, CutAnywhere)
{
    const Folder folder;
    for (const auto& [name, bytes] : seeds()) {
        SCOPED_TRACE(name);
        for (size_t n = 0; n < bytes.size(); ++n) expectSound(folder.write(name, bytes.substr(0, n)));
    }
}

TEST(Hostile, MutatedAtRandom)
{
    const Folder folder;
    std::mt19937 random(12345);
    const std::string_view pieces[] = {"-",  "9999999999", "4000000000", "nan",    "1e999", "\\\n",          "/", "//", " ",
                                       "\n", "list",       "uchar",      "double", "-1",    "element x 7\n", "\0"};
    for (const auto& [name, bytes] : seeds()) {
        SCOPED_TRACE(name);
        for (int i = 0; i < 2500; ++i) {
            std::string mutated = bytes;
            for (unsigned k = 1 + random() % 4; k > 0; --k) {
                const size_t at = random() % mutated.size();
                switch (random() % 4) {
                    case 0:
                        mutated[at] = char(random());
                        break;
                    case 1:
                        mutated.insert(at, pieces[random() % std::size(pieces)]);
                        break;
                    case 2:
                        mutated.erase(at, 1 + random() % 5);
                        break;
                    case 3:
                        mutated.insert(at, mutated.substr(random() % mutated.size(), random() % 40));
                        break;
                }
                if (mutated.empty()) mutated = "v";
            }
            expectSound(folder.write(name, mutated));
        }
    }
}

TEST(Hostile, HeadersThatPromiseTooMuch)
{
    const Folder folder;
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        for (const char* count : {"4000000000", "4294967295", "4294967296", "18446744073709551615", "99999999999999999999999", "-1", "1e9", "5"})
            for (const char* element : {"vertex", "face", "edge", "tristrips", "other"}) {
                std::string header = std::string("ply\nformat ") + format + " 1.0\n";
                if (element != std::string("vertex")) header += "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
                header += std::string("element ") + element + " " + count + "\n";
                header += element == std::string("vertex") ? "property float x\nproperty float y\nproperty float z\n"
                                                           : "property list uint uchar vertex_indices\n";
                const std::string e = errorOf([&] { readFile(folder.write("a.ply", header + "end_header\n0 0 0\n000000")); });
                EXPECT_FALSE(e.empty()) << header;
            }
}

TEST(Hostile, ListsThatPromiseTooMuch)
{
    const Folder folder;
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list int double weights\nproperty list uint int vertex_indices\nend_header\n";
    const std::string point(12, '\0');
    for (const std::string& count : {std::string("\xff\xff\xff\xff", 4), std::string("\xff\xff\xff\x7f", 4), std::string("\x05\0\0\0", 4)}) {
        const std::string e = errorOf([&] { readFile(folder.write("a.ply", header + point + count + std::string(20, '\0'))); });
        EXPECT_NE(e.find("byte "), e.npos) << e;
        EXPECT_NE(e.find("'weights'"), e.npos) << e;
    }
}

TEST(Hostile, OffAndStlThatPromiseTooMuch)
{
    const Folder folder;
    for (const char* counts : {"4000000000 1 0", "1 4000000000 0", "18446744073709551615 1 0", "99999999999999999999999 1 0", "-1 1 0", "3 1e9 0", "",
                               "0 0 0", "3 2000000000 0"}) {
        const std::string e = errorOf([&] { readFile(folder.write("a.off", std::string("OFF\n") + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")); });
        EXPECT_NE(e.find("line "), e.npos) << counts << ": " << e;
    }
    for (const char* face : {"4000000000 0 1 2", "99999999999999999999 0 1 2", "-3 0 1 2", "7 0 1 2", "3.5 0 1 2"}) {
        const std::string e = errorOf([&] { readFile(folder.write("a.off", std::string("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n") + face)); });
        EXPECT_NE(e.find("line 5"), e.npos) << face << ": " << e;
    }
    for (const bool big : {false, true})
        for (const int count : {-1, 0x7fffffff, 1000}) {
            for (const bool inFaces : {false, true}) {
                const std::string head = "OFF BINARY\n" + words({inFaces ? 1 : count, inFaces ? count : 1, 0, 0.f, 0.f, 0.f, 1, 0, 0}, big);
                EXPECT_NE(errorOf([&] { readFile(folder.write("a.off", head)); }).find("counts"), std::string::npos);
            }
            const std::string valence = "OFF BINARY\n" + words({1, 1, 0, 0.f, 0.f, 0.f, count, 0, 0}, big);
            EXPECT_NE(errorOf([&] { readFile(folder.write("a.off", valence)); }).find("counts"), std::string::npos);
            const std::string stl = std::string(80, ' ') + words({count}, big) + std::string(500, 'a');
            EXPECT_NE(errorOf([&] { readFile(folder.write("a.stl", stl)); }).find("facets"), std::string::npos);
        }
}

TEST(Hostile, EndlessContinuation)
{
    const Folder folder;
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1";
    for (int i = 0; i < 300000; ++i) text += " \\\n";
    const Imported in = readFile(folder.write("a.obj", text + "2 3\nf 3 2 9\n"));
    EXPECT_EQ(meshOf(in).cornerCount(), 3u);
    ASSERT_TRUE(warning(in.warnings, "face-index"));
    EXPECT_NE(warning(in.warnings, "face-index")->text.find("line 300005"), std::string::npos) << warning(in.warnings, "face-index")->text;
    expectSound(folder.write("b.obj", "v 0 0 0\nf 1\\"));
    expectSound(folder.write("c.obj", "v 0 0 0\nf 1 \\\n\\\r\n\\"));
    expectSound(folder.write("d.obj", "v 0 0 \\"));
}

TEST(Hostile, AFaceOfAMillionCorners)
{
    const Folder folder;
    const uint32_t n = 1000000;
    Array<glm::vec3> p;
    Array<uint32_t> corners;
    for (uint32_t i = 0; i < n; ++i) {
        p.push_back({float(i % 1000), float(i / 1000), 0});
        corners.push_back(i);
    }
    const Mesh m(std::move(p), Array<uint32_t>{0, n}, std::move(corners));
    const auto begin = std::chrono::steady_clock::now();
    for (const char* name : {"a.obj", "a.ply"}) {
        writeFile(sceneOf(m, "m"), folder.path / name);
        EXPECT_EQ(contentHash(meshOf(readFile(folder.path / name))), contentHash(m));
    }
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 20);
}

TEST(Hostile, ManyNamesAreBounded)
{
    const Folder folder;
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 70000; ++i) text += "g " + std::to_string(i) + "\nusemtl " + std::to_string(i) + "\nf 1 2 3\n";
    const Imported in = readFile(folder.write("a.obj", text));
    EXPECT_EQ(meshOf(in).faceCount(), 70000u);
    EXPECT_TRUE(warning(in.warnings, "many-groups"));
    EXPECT_TRUE(warning(in.warnings, "many-materials"));
    EXPECT_LE(objectOf(in.scene).materials.size(), 4096u);
    EXPECT_TRUE(checkMesh(meshOf(in)));
}

TEST(Hostile, OnlyOrdinaryFilesAreOpened)
{
    const Folder folder;
    EXPECT_NE(errorOf([&] { readFile(folder.path / "none.obj"); }).find("no such file"), std::string::npos);
    EXPECT_NE(errorOf([&] { readFile(folder.path); }).find("is a folder"), std::string::npos);
    ASSERT_EQ(::mkfifo((folder.path / "pipe.obj").c_str(), 0600), 0);
    EXPECT_NE(errorOf([&] { readFile(folder.path / "pipe.obj"); }).find("ordinary"), std::string::npos);
    EXPECT_NE(errorOf([&] { readFile("/dev/zero"); }).find("ordinary"), std::string::npos);
    const std::string e = errorOf([&] { readFile(folder.write("a.doc", "hello")); });
    EXPECT_NE(e.find("Wavefront OBJ (.obj)"), std::string::npos) << e;
}

TEST(Hostile, NothingOutsideTheFolderIsRead)
{
    const Folder folder;
    fs::create_directory(folder.path / "in");
    folder.write("secret.mtl", "newmtl m\nKd 1 0 0\n");
    folder.write("secret.png", "\x89PNG");
    fs::create_symlink(folder.path / "secret.mtl", folder.path / "in" / "link.mtl");
    const std::string body = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    for (const std::string& name : {std::string("../secret.mtl"), (folder.path / "secret.mtl").string(), std::string("..\\secret.mtl"),
                                    std::string("x/../../secret.mtl"), std::string("link.mtl")}) {
        const Imported in = readFile(folder.write("in/a.obj", "mtllib " + name + "\n" + body));
        EXPECT_TRUE(warning(in.warnings, "outside-folder")) << name;
        EXPECT_EQ(in.scene.find(objectOf(in.scene).materials[0])->baseColor.g, 0.8);
    }
    folder.write("in/own.mtl", "newmtl m\nmap_Kd ../secret.png\n");
    const Imported in = readFile(folder.write("in/a.obj", "mtllib own.mtl\n" + body));
    EXPECT_TRUE(warning(in.warnings, "outside-folder"));
    EXPECT_TRUE(in.scene.images().empty());
}

}  // namespace
}  // namespace mw::test
