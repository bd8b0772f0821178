// Height pictures: bytes made by hand, ImageMagick as the other opinion, and broken files.
#include "core/io/height_picture.h"

#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

#include "core/io/helpers.h"

#include "data.h"

namespace mw {
namespace {

using test::errorOf;
using test::Folder;
using test::warning;

std::string contents(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool hasConvert()
{
    return std::system("convert -version >/dev/null 2>&1") == 0;
}

/// What a command prints.
std::string output(const std::string& command)
{
    std::string all;
    FILE* p = popen(command.c_str(), "r");
    char buffer[65536];
    for (size_t n; (n = fread(buffer, 1, sizeof buffer, p)) > 0;) all.append(buffer, n);
    pclose(p);
    return all;
}

/// ImageMagick's opinion: red, green, blue of 16 bits each, from the top left.
void expectAsConvert(const std::filesystem::path& file)
{
    const HeightMap map = readHeightMap(file);
    const std::string raw =
        output("convert '" + file.string() + "' -auto-orient -alpha off -set colorspace sRGB -type TrueColor -depth 16 -endian MSB rgb:-");
    ASSERT_EQ(raw.size(), size_t(map.width()) * map.height() * 6) << file;
    const auto* p = reinterpret_cast<const uint8_t*>(raw.data());
    for (uint32_t y = 0; y < map.height(); ++y)
        for (uint32_t x = 0; x < map.width(); ++x, p += 6) {
            const double r = (p[0] << 8 | p[1]) / 65535.0, g = (p[2] << 8 | p[3]) / 65535.0, b = (p[4] << 8 | p[5]) / 65535.0;
            ASSERT_NEAR(map.at(x, y), 0.2126 * r + 0.7152 * g + 0.0722 * b, 1e-6) << file << ": " << x << ", " << y;
        }
}

HeightMap random(uint32_t width, uint32_t height)
{
    std::mt19937 r(3);
    Array<float> rows;
    for (size_t i = 0; i < size_t(width) * height; ++i) rows.push_back(float((r() & 0xffff) / 65535.0));
    return HeightMap(width, height, rows);
}

TEST(HeightPicture, SixteenBitsComeBackExactly)
{
    const Folder folder;
    for (const auto& [w, h] : {std::pair(2u, 2u), std::pair(300u, 131u)}) {
        const HeightMap map = random(w, h);
        EXPECT_TRUE(writeHeightMap(map, folder.path / "m.png").empty());
        EXPECT_EQ(contentHash(readHeightMap(folder.path / "m.png")), contentHash(map));
        const Imported in = readFile(folder.path / "m.png");
        EXPECT_EQ(in.format, "PNG, 16 bits");
        writeFile(in.scene, folder.path / "again.png");
        EXPECT_EQ(contents(folder.path / "again.png"), contents(folder.path / "m.png"));
    }
}

TEST(HeightPicture, HeightsBeyondAreCutAndTold)
{
    const Folder folder;
    const float rows[] = {-0.5f, 0.25f, 1.f, 1.5f};
    const std::vector<Warning> w = writeHeightMap(HeightMap(2, 2, rows), folder.path / "m.png");
    ASSERT_TRUE(warning(w, "height-cut"));
    EXPECT_NE(warning(w, "height-cut")->text.find("2 heights"), std::string::npos);
    const HeightMap m = readHeightMap(folder.path / "m.png");
    EXPECT_EQ(m.at(0, 0), 0.f);
    EXPECT_NEAR(m.at(1, 0), 0.25, 1e-5);
    EXPECT_EQ(m.at(0, 1), 1.f);
    EXPECT_EQ(m.at(1, 1), 1.f);
}

TEST(HeightPicture, ASceneWithoutTerrainIsNoPicture)
{
    const Folder folder;
    EXPECT_NE(errorOf([&] { writeFile(Scene(), folder.path / "m.png"); }).find("the scene has none"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "m.png"));
}

TEST(HeightPicture, EveryKindOfPngIsReadAsImageMagickReadsIt)
{
    if (!hasConvert()) GTEST_SKIP() << "ImageMagick is not there";
    const Folder folder;
    writeHeightMap(random(61, 43), folder.path / "grey16.png");
    const std::string from = "convert '" + (folder.path / "grey16.png").string() + "' ";
    const std::pair<const char*, const char*> kinds[] = {
        {"grey16", "-depth 16"},
        {"grey8", "-depth 8"},
        {"grey4", "-depth 4 -define png:bit-depth=4 -define png:color-type=0"},
        {"bilevel", "-monochrome -define png:bit-depth=1 -define png:color-type=0"},
        {"greyalpha", "-alpha set -channel A -evaluate set 50% +channel -define png:color-type=4"},
        {"rgb8", "-depth 8 -define png:color-type=2"},
        {"rgb16", "-depth 16 -define png:color-type=2 -define png:bit-depth=16"},
        {"rgba8", "-depth 8 -alpha set -channel A -evaluate set 30% +channel -define png:color-type=6"},
        {"palette", "-colors 17 -define png:color-type=3"},
        {"colours", "-depth 8 +level-colors navy,gold -define png:color-type=2"},
        {"interlaced", "-interlace Plane -depth 16"},
        {"gamma", "-set gamma 0.5 -depth 16"},
    };
    for (const auto& [name, options] : kinds) {
        const std::filesystem::path file = folder.path / (std::string(name) + ".png");
        ASSERT_EQ(std::system((from + options + " '" + file.string() + "'").c_str()), 0) << name;
        expectAsConvert(file);
    }
    std::vector<Warning> warnings;
    readHeightMap(folder.path / "colours.png", &warnings);
    EXPECT_TRUE(warning(warnings, "height-from-colour"));
    warnings.clear();
    readHeightMap(folder.path / "rgb8.png", &warnings);
    EXPECT_TRUE(warnings.empty()) << "grey in three channels is no colour";
}

TEST(HeightPicture, OtherKindsAreReadAsImageMagickReadsThem)
{
    if (!hasConvert()) GTEST_SKIP() << "ImageMagick is not there";
    const Folder folder;
    writeHeightMap(random(61, 43), folder.path / "grey16.png");
    const std::string from = "convert '" + (folder.path / "grey16.png").string() + "' ";
    const std::pair<const char*, const char*> kinds[] = {
        {"plain8.tga", "-depth 8 -compress none"},
        {"rle8.tga", "-depth 8 -threshold 50% -compress RLE"},
        {"rgb.tga", "-depth 8 +level-colors navy,gold -type TrueColor -compress none"},
        {"rle24.tga", "-depth 8 -posterize 3 +level-colors navy,gold -type TrueColor -compress RLE"},
        {"rgba.tga", "-depth 8 +level-colors navy,gold -alpha set -channel A -evaluate set 50% +channel -type TrueColorAlpha -compress none"},
        {"text8.pgm", "-depth 8 -compress none"},
        {"text16.pgm", "-depth 16 -compress none"},
        {"binary8.pgm", "-depth 8"},
        {"binary16.pgm", "-depth 16"},
    };
    for (const auto& [name, options] : kinds) {
        const std::filesystem::path file = folder.path / name;
        ASSERT_EQ(std::system((from + options + " '" + file.string() + "'").c_str()), 0) << name;
        expectAsConvert(file);
    }
}

std::string tga(int type, int bits, int width, int height, int descriptor, const std::string& pixels)
{
    std::string s(18, '\0');
    s[2] = char(type), s[12] = char(width), s[13] = char(width >> 8), s[14] = char(height), s[15] = char(height >> 8), s[16] = char(bits);
    s[17] = char(descriptor);
    return s + pixels;
}

Array<float> rowsOf(const std::filesystem::path& file)
{
    return readHeightMap(file).rows();
}

TEST(HeightPicture, TgaByHand)
{
    const Folder folder;
    const auto rows = [&](const std::string& bytes) { return rowsOf(folder.write("m.tga", bytes)); };
    const auto parts = [](std::initializer_list<double> values) {
        Array<float> a;
        for (double v : values) a.push_back(float(v / 255));
        return a;
    };
    EXPECT_EQ(rows(tga(3, 8, 3, 2, 0, "\1\2\3\4\5\6")), parts({4, 5, 6, 1, 2, 3})) << "from the bottom";
    EXPECT_EQ(rows(tga(3, 8, 3, 2, 32, "\1\2\3\4\5\6")), parts({1, 2, 3, 4, 5, 6})) << "from the top";
    EXPECT_EQ(rows(tga(3, 8, 3, 2, 48, "\1\2\3\4\5\6")), parts({3, 2, 1, 6, 5, 4})) << "from the top right";
    EXPECT_EQ(rows(tga(11, 8, 3, 2, 32, "\x83\7\1\x8\x9")), parts({7, 7, 7, 7, 8, 9})) << "a run over the end of a row, then pixels";
    EXPECT_EQ(rows(tga(11, 8, 2, 2, 32, "\xff\7")), parts({7, 7, 7, 7})) << "a run beyond the end";
    EXPECT_EQ(rows(tga(10, 24, 2, 2, 32, std::string("\x80\x4\x4\x4\x82\x9\x9\x9"))), parts({4, 9, 9, 9}));
    // Blue, green, red; alpha does not count.
    const Array<float> colours = rows(tga(2, 32, 2, 2, 32, std::string("\xff\0\0\1\0\xff\0\1\0\0\xff\1\5\5\5\1", 16)));
    EXPECT_NEAR(colours[0], 0.0722, 1e-6);
    EXPECT_NEAR(colours[1], 0.7152, 1e-6);
    EXPECT_NEAR(colours[2], 0.2126, 1e-6);
    EXPECT_EQ(colours[3], float(5 / 255.0));
    // A text before the pixels.
    std::string named = tga(3, 8, 2, 2, 32, "abc\1\2\3\4");
    named[0] = 3;
    EXPECT_EQ(rows(named), parts({1, 2, 3, 4}));
}

TEST(HeightPicture, PgmByHand)
{
    const Folder folder;
    const auto rows = [&](const std::string& bytes) { return rowsOf(folder.write("m.pgm", bytes)); };
    const Array<float> expected{0.f, 0.25f, 0.5f, 1.f};
    EXPECT_EQ(rows("P2\n# a remark\n2 2 # another\n8\n0 2\n4 8\n"), expected);
    EXPECT_EQ(rows("P2 2 2 8 0 2 4 8"), expected) << "no line end";
    EXPECT_EQ(rows(std::string("P5\n2 2\n8\n\0\2\4\x8", 14)), expected);
    EXPECT_EQ(rows(std::string("P5 2 2 800 \0\0\0\xc8\1\x90\3\x20", 19)), expected) << "two bytes, the larger first";
    std::vector<Warning> warnings;
    readHeightMap(folder.write("m.pgm", "P2 2 2 8 0 2 4 9"), &warnings);
    EXPECT_TRUE(warning(warnings, "height-cut"));
}

TEST(HeightPicture, BecomesASceneOfOneTerrain)
{
    const Folder folder;
    const Imported in = readFile(folder.write("My island.pgm", "P2 3 2 4 0 1 2 3 4 4"));
    ASSERT_EQ(in.scene.nodes().size(), 1u);
    const Node& node = in.scene.node(in.scene.nodes()[0]);
    EXPECT_EQ(node.name, "My island");
    ASSERT_TRUE(node.terrain);
    const Terrain& t = in.scene.find(node.terrain)->terrain;
    EXPECT_EQ(t.map.width(), 3u);
    EXPECT_EQ(t.map.at(1, 0), 0.25f);
    EXPECT_EQ(t.size(), glm::dvec2(1000, 500));
}

TEST(HeightPicture, WrongFilesAreExplained)
{
    const Folder folder;
    const auto says = [&](const char* name, const std::string& bytes) {
        const std::filesystem::path file = folder.write(name, bytes);
        const std::string text = errorOf([&] { readFile(file); });
        EXPECT_TRUE(text.starts_with(file.string() + ": ")) << text;
        return text;
    };
    const auto expect = [&](const char* name, const std::string& bytes, const char* words) {
        const std::string text = says(name, bytes);
        EXPECT_NE(text.find(words), std::string::npos) << text;
    };
    expect("m.tga", "", "18");
    expect("m.tga", tga(3, 8, 512, 512, 0, std::string(1000, 'x')), "ends too early");
    expect("m.tga", tga(11, 8, 60000, 60000, 0, std::string(1000, 'x')), "60000 x 60000");
    expect("m.tga", tga(11, 8, 16000, 16000, 0, std::string(1000, 'x')), "ends too early");
    expect("m.tga", tga(1, 8, 4, 4, 0, std::string(1000, 'x')), "type 1");
    expect("m.tga", tga(2, 16, 4, 4, 0, std::string(1000, 'x')), "16 bits");
    expect("m.tga", tga(3, 8, 0, 4, 0, std::string(1000, 'x')), "at least 2 x 2");
    expect("m.pgm", "P5 99999 99999 255 x", "99999 x 99999");
    expect("m.pgm", "P5 9999 9999 255 x", "ends too early");
    expect("m.pgm", "P2 9999 9999 255 1 2 3", "ends too early");
    expect("m.pgm", "P2 2 2 255 1 2 x 4", "byte 15");
    expect("m.pgm", "P2 2 2 0 1 2 3 4", "white is 0");
    expect("m.pgm", "P2 2", "height is missing");
    expect("m.pgm", "P2 2 #", "height is missing");
    expect("m.pgm", "P2 2 99999999999999999999 1", "no whole number");
    expect("m.pgm", "P6 2 2 255 xxxxxxxxxxxx", "does not begin as");
    expect("m.png", "", "empty");
    expect("m.png", "GIF89a", "does not begin as");
    expect("m.png", "\x89PNG\r\n\x1a\n", "damaged");
    // A header of 16000 x 16000 pixels, 16 bits, with its right check sum, and nothing behind.
    const std::string header("IHDR\0\0\x3e\x80\0\0\x3e\x80\x10\0\0\0\0", 17);
    uint32_t crc = ~0u;
    for (unsigned char c : header) {
        crc ^= c;
        for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    crc = ~crc;
    std::string png = "\x89PNG\r\n\x1a\n" + std::string("\0\0\0\x0d", 4) + header;
    for (int shift : {24, 16, 8, 0}) png += char(crc >> shift);
    expect("m.png", png + std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12), "16000 x 16000");
}

TEST(HeightPicture, DamagedFilesGiveAMapOrAMessage)
{
    const Folder folder;
    writeHeightMap(random(20, 10), folder.path / "sound.png");
    const std::pair<const char*, std::string> sound[] = {
        {"m.png", contents(folder.path / "sound.png")},
        {"m.tga", tga(10, 24, 5, 4, 32, "\x88\1\2\3\x85\4\5\6\2" + std::string(30, 'a'))},
        {"m.pgm", "P2\n# note\n4 3\n900\n0 100 200 300\n400 500 600 700 800 900 1 2\n"},
        {"n.pgm", "P5\n4 3\n900\n" + std::string(24, '\1')},
    };
    std::mt19937 random(1);
    for (const auto& [name, whole] : sound) {
        const auto attempt = [&, file = name](const std::string& bytes) {
            const std::filesystem::path path = folder.write(file, bytes);
            const std::string text = errorOf([&] { readHeightMap(path); });
            EXPECT_TRUE(text.empty() || text.starts_with(path.string() + ": ")) << text;
        };
        for (size_t n = 0; n < whole.size(); ++n) attempt(whole.substr(0, n));
        for (int i = 0; i < 2000; ++i) {
            std::string bytes = whole;
            for (int k = 0; k < 1 + i % 4; ++k) bytes[random() % (i % 2 ? bytes.size() : std::min<size_t>(bytes.size(), 40))] = char(random());
            attempt(bytes);
        }
    }
}

TEST(HeightPicture, TheDataIsReadAsImageMagickReadsIt)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    if (!hasConvert()) GTEST_SKIP() << "ImageMagick is not there";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(data / "terrain")) expectAsConvert(entry.path()), ++files;
    EXPECT_GE(files, 4);
}

TEST(HeightPicture, TheDataSurvivesAsSixteenBits)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Folder folder;
    for (const auto& entry : std::filesystem::directory_iterator(data / "terrain")) {
        const HeightMap map = readHeightMap(entry.path());
        writeHeightMap(map, folder.path / "m.png");
        EXPECT_EQ(contentHash(readHeightMap(folder.path / "m.png")), contentHash(map)) << entry.path();
    }
    EXPECT_NE(errorOf([&] { readFile(data / "malformed/truncated_heightmap.tga"); }).find("512 x 512"), std::string::npos);
}

}  // namespace
}  // namespace mw
