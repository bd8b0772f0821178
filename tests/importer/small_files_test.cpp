// Small files made here: by Assimp's own exporters from a box, and by hand.
#include <assimp/Exporter.hpp>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <unistd.h>

#include "app/importer/read.h"
#include "core/mesh/topology.h"
#include "core/scene/scene_pose.h"

#include "assimp_pose.h"
#include "gtest/gtest.h"

#ifdef __SANITIZE_ADDRESS__
// Assimp 5.2 does not free the animation of a morph channel; the importer is a program that ends after one file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libassimp";
}
#endif

using namespace mw;
namespace fs = std::filesystem;

namespace {

// A box of 2 by 4 by 6 about (1, 2, 3), six quads, two materials.
constexpr const char* boxObj =
    "mtllib box.mtl\no box\nv 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl red\nf 1/1 4/2 3/3 2/4\nf 5/1 6/2 7/3 8/4\nf 1/1 2/2 6/3 5/4\n"
    "usemtl blue\nf 3/1 4/2 8/3 7/4\nf 2/1 3/2 7/3 6/4\nf 1/1 5/2 8/3 4/4\n";
constexpr const char* boxMtl = "newmtl red\nKd 1 0 0\nmap_Kd picture.png\nnewmtl blue\nKd 0 0 1\nd 0.5\n";

class SmallFiles : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("meshwright-importer-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        write("box.obj", boxObj);
        write("box.mtl", boxMtl);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path write(const std::string& name, const std::string& content)
    {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    std::string content(const std::string& name)
    {
        std::ostringstream all;
        all << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
        return all.str();
    }
    /// The box by one of Assimp's exporters.
    fs::path exported(const char* format, const std::string& name, bool oneName = false)
    {
        Assimp::Importer importer;
        importer.ReadFile((folder_ / "box.obj").string(), 0);
        const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
        EXPECT_TRUE(scene);
        if (oneName) scene->mMeshes[1]->mName = scene->mMeshes[0]->mName;
        Assimp::Exporter exporter;
        EXPECT_EQ(exporter.Export(scene.get(), format, (folder_ / name).string()), aiReturn_SUCCESS) << exporter.GetErrorString();
        return folder_ / name;
    }
    static Bounds worldBounds(const Scene& s)
    {
        Bounds b;
        for (const NodeId id : s.nodes())
            if (s.node(id).mesh)
                for (const glm::vec3& p : s.find(s.node(id).mesh)->base.positions()) b.add(glm::dvec3(s.worldFromLocal(id) * glm::dvec4(p, 1)));
        return b;
    }
    static void expectBounds(const Scene& s, glm::dvec3 min, glm::dvec3 max)
    {
        const Bounds b = worldBounds(s);
        EXPECT_LT(glm::distance(b.min, min), 1e-5) << b.min.x << ' ' << b.min.y << ' ' << b.min.z;
        EXPECT_LT(glm::distance(b.max, max), 1e-5) << b.max.x << ' ' << b.max.y << ' ' << b.max.z;
    }
    static bool warned(const Imported& in, const std::string& code)
    {
        return std::any_of(in.warnings.begin(), in.warnings.end(), [&](const Warning& w) { return w.code == code; });
    }
    fs::path folder_;
};

/// Six quads, three of each material, on meshes of 8 vertices (those of one material have 7 or 8).
void expectBox(const Scene& s, size_t meshes)
{
    ASSERT_EQ(s.meshes().size(), meshes);
    std::map<std::string, size_t> facesOf;
    for (const MeshId id : s.meshes()) {
        const MeshObject& object = *s.find(id);
        const Attribute* slots = object.base.find(names::material);
        EXPECT_LE(object.base.vertexCount(), 8u);
        EXPECT_TRUE(object.base.find(names::texcoord, Domain::Corner));
        ASSERT_EQ(object.materials.size(), 3 - meshes);
        for (size_t f = 0; f < object.base.faceCount(); ++f) {
            EXPECT_EQ(object.base.face(f).size(), 4u);
            ++facesOf[s.find(object.materials[slots ? size_t(slots->at(f, 0)) : 0])->name];
        }
    }
    EXPECT_EQ(facesOf, (std::map<std::string, size_t>{{"blue", 3}, {"red", 3}}));
    for (const MaterialId id : s.materials())
        if (s.find(id)->name == "blue") {
            EXPECT_EQ(glm::dvec3(s.find(id)->baseColor), glm::dvec3(0, 0, 1));
        }
}

TEST_F(SmallFiles, ColladaKeepsPolygonsAndMetres)
{
    const Imported in = readByAssimp(exported("collada", "box.dae"));
    expectBox(in.scene, 2);
    expectBounds(in.scene, {0, 0, 0}, {2, 4, 6});
    EXPECT_EQ(in.units, "metres");
    EXPECT_EQ(in.format, "COLLADA 1.4.1");
    EXPECT_TRUE(warned(in, "missing-image"));
}

TEST_F(SmallFiles, PiecesOfOneNameAreOneMesh)
{
    const Imported in = readByAssimp(exported("collada", "box.dae", true));
    expectBox(in.scene, 1);
    EXPECT_EQ(in.scene.find(in.scene.meshes()[0])->base.vertexCount(), 8u);
}

TEST_F(SmallFiles, ColladaSaysUnitAndAxis)
{
    exported("collada", "box.dae");
    std::string dae = content("box.dae");
    const size_t unit = dae.find("<unit"), end = dae.find("/>", unit), axis = dae.find("Y_UP");
    ASSERT_TRUE(unit != dae.npos && axis != dae.npos);
    dae.replace(axis, 4, "Z_UP");
    dae.replace(unit, end + 2 - unit, "<unit name=\"inch\" meter=\"0.0254\"/>");
    const Imported in = readByAssimp(write("inch.dae", dae));
    EXPECT_EQ(in.units, "inches");
    EXPECT_EQ(in.placement, (Placement{0.0254, UpAxis::Z}));
    EXPECT_TRUE(in.placementFromFile);
    expectBounds(in.scene, glm::dvec3(0, 0, -4) * 0.0254, glm::dvec3(2, 6, 0) * 0.0254);  // z was up, so y points to us
}

TEST_F(SmallFiles, ThreeDStudio)
{
    const Imported in = readByAssimp(exported("3ds", "box.3ds"));
    ASSERT_GE(in.scene.meshes().size(), 1u);
    size_t faces = 0;
    for (const MeshId id : in.scene.meshes()) {
        faces += in.scene.find(id)->base.faceCount();
        EXPECT_TRUE(in.scene.find(id)->base.isTriangles());
    }
    EXPECT_EQ(faces, 12u);
    EXPECT_EQ(in.scene.materials().size(), 2u);
    EXPECT_EQ(in.units, "unknown");
    EXPECT_EQ(in.format, "3D Studio");
    const glm::dvec3 size = worldBounds(in.scene).size();
    EXPECT_NEAR(size.x * size.y * size.z, 48, 1e-4);
}

TEST_F(SmallFiles, FbxAsText)
{
    const Imported in = readByAssimp(exported("fbxa", "box.fbx"));
    expectBox(in.scene, 2);
    expectBounds(in.scene, {0, 0, 0}, {0.02, 0.04, 0.06});
    EXPECT_EQ(in.units, "centimetres");
    EXPECT_EQ(in.placement, (Placement{0.01, UpAxis::Y}));
    EXPECT_TRUE(in.placementFromFile);
    EXPECT_EQ(in.format, "Autodesk FBX 7.5");
}

TEST_F(SmallFiles, FbxSaysUnitAndAxis)
{
    exported("fbxa", "box.fbx");
    std::string fbx = content("box.fbx");
    const auto set = [&](const std::string& key, const std::string& value) {
        const size_t at = fbx.find("P: \"" + key + "\"");
        ASSERT_NE(at, fbx.npos) << key;
        const size_t end = fbx.find('\n', at), comma = fbx.rfind(',', end);
        fbx.replace(comma + 1, end - comma - 1, " " + value);
    };
    set("UpAxis", "2"), set("FrontAxis", "1"), set("FrontAxisSign", "-1"), set("UnitScaleFactor", "100");
    const Scene s = readByAssimp(write("z.fbx", fbx)).scene;
    expectBounds(s, {0, 0, -4}, {2, 6, 0});  // metres; (x, y, z) is now (x, z, -y)
    EXPECT_GT(enclosedVolume(s.find(s.meshes()[0])->base) * glm::determinant(s.worldFromLocal(s.nodes().back())), 0);  // outside stays outside
}

TEST_F(SmallFiles, PictureBesideTheModelUnderAnotherFolderAndCase)
{
    // One black pixel.
    static const unsigned char png[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0};
    write("box.mtl", "newmtl red\nKd 1 0 0\nmap_Kd C:\\art\\Picture.PNG\nnewmtl blue\nKd 0 0 1\n");
    write("picture.png", std::string(reinterpret_cast<const char*>(png), sizeof png));
    const Imported in = readByAssimp(exported("collada", "box.dae"));
    ASSERT_EQ(in.scene.images().size(), 1u);
    EXPECT_EQ(in.scene.find(in.scene.images()[0])->mimeType, "image/png");
    EXPECT_EQ(in.scene.find(in.scene.images()[0])->bytes->size(), sizeof png);
    size_t pictured = 0;
    for (const MaterialId id : in.scene.materials()) pictured += bool(in.scene.find(id)->baseColorTexture.image);
    EXPECT_EQ(pictured, 1u);
}

// Two joints of one name, six bones at one vertex, keys of both signs, no ticks, a nameless frame, vertices that coincide.
std::string skinnedX()
{
    std::string x = "xof 0303txt 0032\n";
    const std::string identity = "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;";
    const auto frame = [&](const std::string& name, const std::string& inside) {
        return "Frame " + name + " { FrameTransformMatrix { " + identity + " } " + inside + " }\n";
    };
    std::string mesh =
        "Mesh sheet { 6; 0.0;0.0;0.0;, 1.0;0.0;0.0;, 1.0;1.0;0.0;, 0.0;0.0;0.0;, 1.0;1.0;0.0;, 0.0;1.0;0.0;; 2; 3;0,1,2;, 3;3,4,5;; XSkinMeshHeader "
        "{ 6; 6; 6; }\n";
    for (int b = 0; b < 6; ++b) mesh += "SkinWeights { \"b" + std::to_string(b) + "\"; 6; 0,1,2,3,4,5; 0.1,0.1,0.1,0.1,0.1,0.1; " + identity + " }\n";
    x += frame("body", mesh + " }");
    x += frame("b0", frame("b1", "") + frame("b2", "") + frame("", "") + frame("b3", "") + frame("b4", frame("b5", "") + frame("b1", "")));
    x += "AnimationSet wave { Animation { {b0} AnimationKey { 0; 3; 0;4;1.0,0.0,0.0,0.0;;, 25;4;-0.9238795,0.0,0.0,-0.3826834;;, "
         "50;4;0.7071068,0.0,0.0,0.7071068;;; "
         "} } }\n";
    return x;
}

TEST_F(SmallFiles, NamesWeightsAndKeysOfAnXFile)
{
    const Imported in = readByAssimp(write("skinned.x", skinnedX()));
    const Scene& s = in.scene;
    ASSERT_EQ(s.meshes().size(), 1u);
    const Mesh& m = s.find(s.meshes()[0])->base;
    EXPECT_EQ(m.vertexCount(), 4u);
    const Attribute *joints = m.find(names::joints), *weights = m.find(names::weights);
    ASSERT_TRUE(joints && weights);
    EXPECT_EQ(joints->components, 8);
    std::set<double> slots;
    for (int k = 0; k < 6; ++k) {
        EXPECT_NEAR(weights->at(0, k), 1.0 / 6, 1e-6);
        slots.insert(joints->at(0, k));
    }
    EXPECT_EQ(slots.size(), 6u);
    EXPECT_TRUE(warned(in, "duplicate-names"));
    EXPECT_TRUE(warned(in, "no-ticks"));
    std::set<std::string> names;
    for (const NodeId id : s.nodes()) {
        EXPECT_FALSE(s.node(id).name.empty());
        EXPECT_TRUE(names.insert(s.node(id).name).second) << s.node(id).name;
    }
    ASSERT_EQ(s.skins().size(), 1u);
    for (const NodeId j : s.find(s.skins()[0])->joints) EXPECT_EQ(s.node(j).joint, Node::Joint::Joint);
    ASSERT_EQ(s.clips().size(), 1u);
    const Clip& clip = *s.find(s.clips()[0]);
    EXPECT_DOUBLE_EQ(duration(clip), 2);  // 50 ticks of 1/25 s
    for (const auto& c : clip.channels) {
        if (c->path != Channel::Path::Rotation) continue;
        for (size_t k = 4; k < c->values.size(); k += 4) {
            double dot = 0;
            for (size_t i = 0; i < 4; ++i) dot += c->values[k + i] * c->values[k + i - 4];
            EXPECT_GT(dot, 0);
        }
    }
}

// A square of one quad; its third corner goes up by 3 in the first second.
constexpr const char* morphFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
GlobalSettings:  {
 Version: 1000
 Properties70:  {
  P: "UnitScaleFactor", "double", "Number", "",100
 }
}
Objects:  {
 Geometry: 10, "Geometry::sheet", "Mesh" {
  Vertices: *12 {
   a: 0,0,0,1,0,0,1,1,0,0,1,0
  }
  PolygonVertexIndex: *4 {
   a: 0,1,2,-4
  }
  GeometryVersion: 124
 }
 Geometry: 11, "Geometry::up", "Shape" {
  Version: 100
  Indexes: *1 {
   a: 2
  }
  Vertices: *3 {
   a: 0,0,3
  }
  Normals: *3 {
   a: 0,0,0
  }
 }
 Model: 12, "Model::sheet", "Mesh" {
  Version: 232
 }
 Deformer: 13, "Deformer::blend", "BlendShape" {
  Version: 100
 }
 Deformer: 14, "SubDeformer::up", "BlendShapeChannel" {
  Version: 100
  DeformPercent: 0
  FullWeights: *1 {
   a: 100
  }
 }
 AnimationStack: 20, "AnimStack::move", "" {
 }
 AnimationLayer: 21, "AnimLayer::base", "" {
 }
 AnimationCurveNode: 22, "AnimCurveNode::DeformPercent", "" {
  Properties70:  {
   P: "d|DeformPercent", "Number", "", "A",0
  }
 }
 AnimationCurve: 23, "AnimCurve::", "" {
  Default: 0
  KeyVer: 4008
  KeyTime: *2 {
   a: 0,46186158000
  }
  KeyValueFloat: *2 {
   a: 0,100
  }
  KeyAttrFlags: *1 {
   a: 24836
  }
  KeyAttrDataFloat: *4 {
   a: 0,0,0,0
  }
  KeyAttrRefCount: *1 {
   a: 2
  }
 }
}
Connections:  {
 C: "OO",12,0
 C: "OO",10,12
 C: "OO",13,10
 C: "OO",14,13
 C: "OO",11,14
 C: "OO",21,20
 C: "OO",22,21
 C: "OP",22,14, "DeformPercent"
 C: "OP",23,22, "d|DeformPercent"
}
)";

TEST_F(SmallFiles, MorphTargetsAndTheirMotion)
{
    const Scene s = readByAssimp(write("morph.fbx", morphFbx)).scene;
    ASSERT_EQ(s.meshes().size(), 1u);
    const Mesh& m = s.find(s.meshes()[0])->base;
    EXPECT_EQ(m.faceCount(), 1u);
    const Attribute* up = m.find("morph:up", Domain::Vertex);
    ASSERT_TRUE(up);
    for (size_t v = 0; v < 4; ++v) EXPECT_EQ(up->at(v, 2), m.positions()[v] == glm::vec3(1, 1, 0) ? 3 : 0);
    ASSERT_EQ(s.clips().size(), 1u);
    const Clip& clip = *s.find(s.clips()[0]);
    ASSERT_EQ(clip.channels.size(), 1u);
    const Channel& c = *clip.channels[0];
    EXPECT_EQ(c.path, Channel::Path::Weights);
    EXPECT_TRUE(s.node(c.node).mesh);
    double weight = -1;
    sample(c, 0.5, &weight);
    EXPECT_NEAR(weight, 0.5, 1e-6);
    EXPECT_DOUBLE_EQ(duration(clip), 1);
    const ScenePose half = poseAt(s, clip, 0.5);
    EXPECT_NEAR(half.weights.at(c.node).at(0), 0.5, 1e-6);
}

TEST_F(SmallFiles, NothingUsableIsRefused)
{
    for (const char* name : {"a.fbx", "a.x", "a.dae", "a.3ds", "a.md5mesh", "a.md5anim"}) {
        EXPECT_THROW(readByAssimp(write(name, "")), Error) << name;
        EXPECT_THROW(readByAssimp(write(name, "nonsense {{{{ 1 2 3")), Error) << name;
    }
}

TEST_F(SmallFiles, Md5CountsThatLie)
{
    const std::string sound =
        "MD5Version 10\ncommandline \"\"\nnumJoints 1\nnumMeshes 1\njoints {\n \"a\" -1 ( 0 0 0 ) ( 0 0 0 )\n}\nmesh {\n shader \"s\"\n numverts 3\n"
        " vert 0 ( 0 0 ) 0 1\n vert 1 ( 1 0 ) 1 1\n vert 2 ( 0 1 ) 2 1\n numtris 1\n tri 0 0 1 2\n numweights 3\n weight 0 0 1 ( 0 0 0 )\n"
        " weight 1 0 1 ( 1 0 0 )\n weight 2 0 1 ( 0 1 0 )\n}\n";
    const Scene s = readByAssimp(write("sound.md5mesh", sound)).scene;
    ASSERT_EQ(s.meshes().size(), 1u);
    EXPECT_EQ(s.find(s.meshes()[0])->base.faceCount(), 1u);
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"numJoints 1", "numJoints 2"},
                                                                                   {"numMeshes 1", "numMeshes 9"},
                                                                                   {"\"a\" -1", "\"a\" 0"},
                                                                                   {"numverts 3", "numverts 4000000000"},
                                                                                   {"numverts 3", "numverts 2"},
                                                                                   {"tri 0 0 1 2", "tri 0 0 1 3"},
                                                                                   {"tri 0 0 1 2", "tri 4294967295 0 1 2"},
                                                                                   {"numweights 3", "numweights -1"},
                                                                                   {") 2 1", ") 2 2"},
                                                                                   {"weight 0 0 1", "weight 0 1 1"},
                                                                                   {"weight 2 0", "weight 3 0"}}) {
        std::string broken = sound;
        broken.replace(broken.find(from), from.size(), to);
        EXPECT_THROW(readByAssimp(write("broken.md5mesh", broken)), Error) << to;
    }
}

}  // namespace
