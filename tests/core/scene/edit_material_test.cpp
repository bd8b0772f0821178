// Edits of materials: slots, faces, values, pictures; what was shared stays as it is for the others.
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/io/io.h"
#include "core/mesh/primitives.h"
#include "core/scene/edit.h"
#include "core/scene/materials.h"
#include "tests/data.h"

namespace mw {
namespace {

// Two cubes that share one material with extras of a file.
Document twoCubes()
{
    Scene s;
    Material paint;
    paint.name = "paint";
    paint.extras = R"({"kept":1})";
    const MaterialId id = s.add(paint);
    for (const char* name : {"left", "right"}) {
        MeshObject o;
        o.name = name;
        o.base = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(1)}}));
        o.materials = {id};
        Node n;
        n.name = name;
        n.mesh = s.add(std::move(o));
        s.add(n);
    }
    Document d;
    d.open(std::move(s), {}, "Open");
    return d;
}

void run(Document& d, std::string_view call)
{
    commitEdit(d, parsedEdit(call));
}

const MeshObject& object(const Document& d, const char* node)
{
    return *d.scene().find(d.scene().node(nodeOf(d.scene(), node)).mesh);
}

const Material& material(const Document& d, const char* node, size_t slot = 0)
{
    return *d.scene().find(object(d, node).materials.at(slot));
}

// A PNG of one grey pixel, written by hand from the PNG specification.
std::vector<uint8_t> tinyPng()
{
    return {0x89, 'P', 'N',  'G', '\r', '\n', 0x1A, '\n', 0,    0,    0, 13, 'I', 'H', 'D', 'R', 0,   0,    0,    1,    0,    0,    0,
            1,    8,   0,    0,   0,    0,    0x3A, 0x7E, 0x9B, 0x55, 0, 0,  0,   10,  'I', 'D', 'A', 'T',  0x78, 0x9C, 0x63, 0x68, 0,
            0,    0,   0x82, 0,   0x81, 0x77, 0xCD, 0x72, 0xB6, 0,    0, 0,  0,   'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};
}

std::filesystem::path written(const char* name, const std::vector<uint8_t>& bytes)
{
    const auto file = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + name);
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return file;
}

TEST(EditMaterial, ValuesOfASharedMaterialAndAnOwnCopy)
{
    Document d = twoCubes();
    run(d, "material:node=left,color=1/0.5/0,metallic=1,roughness=0.1,alpha=blend,opacity=0.4,double-sided=true");
    EXPECT_EQ(material(d, "right").baseColor, glm::dvec4(1, 0.5, 0, 0.4));
    EXPECT_EQ(material(d, "right").extras, R"({"kept":1})");
    EXPECT_EQ(users(d.scene(), object(d, "left").materials[0]), 2u);
    run(d, "own-material:node=left");
    EXPECT_EQ(users(d.scene(), object(d, "left").materials[0]), 1u);
    EXPECT_EQ(material(d, "left").name, "paint 2");
    run(d, "material:node=left,roughness=0.9");
    EXPECT_EQ(material(d, "right").roughness, 0.1);
    EXPECT_EQ(material(d, "left").metallic, 0);
    EXPECT_THROW(run(d, "own-material:node=left"), Error);
    EXPECT_THROW(run(d, "material:node=left,roughness=1.5"), Error);
    EXPECT_THROW(run(d, "material:node=left,slot=7"), Error);
    EXPECT_EQ(d.history().size(), 4u);
}

TEST(EditMaterial, ANewOneForSomeFacesLeavesTheOthersAsTheyWere)
{
    Document d;
    commitEdit(d, parsedEdit("add:op=icosphere,with=subdivisions=1,name=ball"));
    run(d, "new-material:node=ball,name=red,color=1/0/0,faces=0-9");
    ASSERT_EQ(object(d, "ball").materials.size(), 2u);
    EXPECT_EQ(object(d, "ball").materials[0], MaterialId{}) << "no material";
    EXPECT_EQ(material(d, "ball", 1).baseColor, glm::dvec4(1, 0, 0, 1));
    run(d, "new-material:node=ball,name=red,like=1,color=0/1/0");
    EXPECT_EQ(material(d, "ball", 2).name, "red 2");
    EXPECT_EQ(material(d, "ball", 2).baseColor, glm::dvec4(1, 0, 0, 1)) << "a copy has the colour of what it is like";
    run(d, "assign-material:node=ball,slot=2,faces=5-14");
    const Attribute* slots = object(d, "ball").base.find(names::material, Domain::Face);
    for (size_t f = 0; f < slots->size(); ++f) EXPECT_EQ(slots->at(f, 0), f < 5 ? 1 : f < 15 ? 2 : 0) << f;
    EXPECT_THROW(run(d, "new-material:node=ball,faces=80"), Error);
}

TEST(EditMaterial, SlotsAndFaces)
{
    Document d = twoCubes();
    run(d, "new-material:node=left,name=glass");
    run(d, "assign-material:node=left,slot=1,faces=0-9;20");
    const auto slots = [&] {
        const Attribute* a = object(d, "left").base.find(names::material, Domain::Face);
        size_t n = 0;
        for (size_t f = 0; f < a->size(); ++f) n += a->at(f, 0) == 1;
        return n;
    };
    EXPECT_EQ(slots(), 11u);
    EXPECT_THROW(run(d, "assign-material:node=left,slot=1,faces=0-99999"), Error);
    EXPECT_THROW(run(d, "assign-material:node=left,slot=2"), Error);
    run(d, "use-material:node=right,slot=0,material=glass");
    EXPECT_EQ(material(d, "right").name, "glass");
    run(d, "rename-material:node=right,name=clear glass");
    EXPECT_EQ(material(d, "left", 1).name, "clear glass");
    run(d, "remove-slot:node=left,slot=0");  // its user was the last
    EXPECT_EQ(d.scene().materials().size(), 1u);
    EXPECT_EQ(slots(), 0u);
    // The history as commands does the same again.
    Document again = twoCubes();
    for (const auto& entry : d.history())
        for (const EditCall& call : entry.calls) commitEdit(again, parsedEdit(commandText(call)));
    EXPECT_EQ(contentHash(again.scene()), contentHash(d.scene()));
}

TEST(EditMaterial, PicturesByFile)
{
    Document d = twoCubes();
    const auto png = written("tiny.png", tinyPng()), text = written("text.png", {'h', 'e', 'l', 'l', 'o'});
    std::vector<uint8_t> half = tinyPng();
    half.resize(20);
    const auto cut = written("cut.png", half);
    EXPECT_THROW(run(d, "texture:node=left,set=1"), Error);
    run(d, "texture:node=left,kind=normal,file=" + png.string());
    ASSERT_TRUE(material(d, "left").normalTexture.image);
    EXPECT_EQ(d.scene().find(material(d, "left").normalTexture.image)->mimeType, "image/png");
    run(d, "texture:node=left,kind=normal,set=1,repeat=false");
    EXPECT_EQ(material(d, "left").normalTexture.set, 1);
    EXPECT_FALSE(material(d, "left").normalTexture.repeat);
    EXPECT_EQ(d.scene().images().size(), 1u);
    for (const auto& wrong : {text, cut, std::filesystem::path("/no/such.png"), std::filesystem::temp_directory_path()}) {
        try {
            run(d, "texture:node=left,file=" + wrong.string());
            ADD_FAILURE() << wrong;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(wrong.string()), std::string::npos) << e.what();
        }
    }
    run(d, "clear-texture:node=left,kind=normal");
    EXPECT_TRUE(d.scene().images().empty());
    d.undo();
    EXPECT_EQ(d.scene().images().size(), 1u);
    for (const auto& file : {png, text, cut}) std::filesystem::remove(file);
}

TEST(EditMaterial, AJpegGoesThroughGltf)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    Imported spot = readFile(data / "meshes/closed_genus0/spot.obj");
    Document d;
    d.open(std::move(spot.scene), {}, "Open");
    const std::string node = nodeText(d.scene(), d.scene().roots().front());
    if (d.scene().find(d.scene().meshes().front())->materials.empty()) run(d, "new-material:node=" + node);
    const auto jpeg = data / "meshes/nonmanifold/SpiderTex.jpg";
    run(d, "texture:node=" + node + ",file=" + jpeg.string());
    const auto file = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "spot.glb");
    writeFile(d.scene(), file);
    const Imported back = readFile(file);
    ASSERT_EQ(back.scene.images().size(), 1u);
    EXPECT_EQ(back.scene.find(back.scene.images().front())->bytes->size(), std::filesystem::file_size(jpeg));
    std::filesystem::remove(file);
}

TEST(Edit, SeveralCallsAreOneEntry)
{
    Document d = twoCubes();
    commitEdits(d, "2 nodes: position", {parsedEdit("transform:node=left,position=1/0/0"), parsedEdit("transform:node=right,position=1/0/0")});
    ASSERT_EQ(d.history().size(), 2u);
    EXPECT_EQ(d.history()[1].calls.size(), 2u);
    EXPECT_THROW(commitEdits(d, "no", {parsedEdit("rename:node=left,name=other"), parsedEdit("rename:node=left,name=again")}), Error);
    EXPECT_EQ(d.history().size(), 2u);
    d.undo();
    EXPECT_EQ(d.scene().node(nodeOf(d.scene(), "right")).local.translation, glm::dvec3(0));
}

}  // namespace
}  // namespace mw
