// Writes many different scenes as glTF into a folder: what other people's programs are then shown.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>

#include "core/gltf/samples.h"
#include "core/io/foreign.h"
#include "core/io/gltf.h"
#include "core/scene/samples.h"

namespace mw {
namespace {

using test::sceneWith;

Mesh withArray(const Mesh& m, const char* name, Domain d, int components, float value)
{
    return m.with(floatAttribute(name, d, components, Array<float>(m.count(d) * size_t(components), value)));
}

// Attributes as no exporter should have to write them: no numbers, no length, out of range, gaps between sets.
Scene oddAttributes()
{
    Mesh m = test::sheet(4);
    m = withArray(withArray(m, "normal", Domain::Corner, 3, 0), "tangent", Domain::Corner, 4, std::nanf(""));
    m = withArray(withArray(m, "color", Domain::Vertex, 4, 7.5f), "color1", Domain::Corner, 3, -1);
    m = withArray(withArray(m, "texcoord3", Domain::Corner, 2, INFINITY), "_Heat Map", Domain::Vertex, 4, 1e38f);
    m = withArray(withArray(m, "morph:a", Domain::Vertex, 3, std::nanf("")), "morph:b", Domain::Vertex, 3, 0);
    m = withArray(withArray(m, "morph-normal:a", Domain::Corner, 3, 1), "morph-normal:b", Domain::Corner, 3, -0.f);
    m = withArray(m, "weights", Domain::Vertex, 4, 0.25f).with(integerAttribute("joints", Domain::Vertex, 4, Array<int32_t>(100, 3)));
    return sceneWith(m, "odd \"attributes\"");
}

// Colours of morph targets over colours of bytes.
Scene morphedColours(int components)
{
    const Mesh m = withArray(test::sheet(3), "color", Domain::Corner, components, 0.5f);
    Attribute own = *m.find("color");
    own.stored = Scalar::UInt8;
    return sceneWith(withArray(withArray(m.with(own), "morph:a", Domain::Vertex, 3, 1), "morph-color:a", Domain::Corner, components, -0.5f));
}

Scene byteColours(int components)
{
    Mesh m = test::sheet(3);
    Array<float> c;
    for (size_t i = 0; i < m.cornerCount() * size_t(components); ++i) c.push_back(float(i % 256) / 255);
    Attribute a = floatAttribute("color", Domain::Corner, components, c);
    a.stored = Scalar::UInt8;
    return sceneWith(m.with(a));
}

Scene looseThings(bool withFaces)
{
    const Mesh m = withFaces ? test::cube() : Mesh();
    Array<glm::vec3> p(m.positions().begin(), m.positions().end());
    for (int i = 0; i < 7; ++i) p.push_back({float(i), 3, 0});
    const uint32_t first = uint32_t(m.vertexCount());
    Mesh all(p, m.faceStart(), m.cornerVertex());
    all = withArray(all, "color", Domain::Vertex, 3, 0.5f).withLines(Array<uint32_t>{first, first + 1, first + 1, first + 2});
    return sceneWith(withArray(all, "morph:up", Domain::Vertex, 3, 1));
}

// Textures on a mesh that has no coordinates for them, a picture that is none, factors out of range.
Scene oddMaterials()
{
    Scene s;
    const ImageId good = s.add(Image{"good", "image/png", test::pixel()});
    const ImageId bad = s.add(Image{"bad", "image/png", std::make_shared<const std::vector<uint8_t>>(100, uint8_t(1))});
    Material m;
    m.baseColor = {-1, 2, std::nan(""), 0.5};
    m.metallic = 7;
    m.emissive = {1e4, -3, 0};
    m.normalScale = -2;
    m.occlusionStrength = 3;
    m.baseColorTexture = {good, 2, true};
    m.normalTexture = {good, 1, true};
    m.occlusionTexture = {bad, 5, true};
    m.alpha = Material::Alpha::Mask;
    m.alphaCutoff = -1;
    m.extras = "no JSON";
    Node n;
    n.local.rotation = {0, 0, 0, 0};
    n.local.scale = {0, 0, 0};
    n.mesh = s.add(MeshObject{"", test::cube().without("texcoord"), {s.add(m), MaterialId{}}, {}});
    s.add(n);
    return s;
}

Scene degenerate()
{
    const Array<glm::vec3> p{{0, 0, 0}, {0, 0, 0}, {1e-30f, 0, 0}, {3e38f, -3e38f, 3e38f}, {-3e38f, 3e38f, 1}};
    return sceneWith(Mesh(p, Array<uint32_t>{0, 1, 3, 6, 9, 13}, Array<uint32_t>{0, 0, 1, 0, 1, 2, 0, 3, 4, 0, 1, 2, 0}));
}

Scene deepTree()
{
    Scene s = sceneWith(test::sheet(1));
    Node n = s.node(s.roots()[0]);
    NodeId last = s.roots()[0];
    n.local.rotation = glm::normalize(glm::dquat(0.9, 0.1, 0.2, 0.3));
    for (int i = 0; i < 300; ++i) last = s.add(n, last);
    return s;
}

// A skinned node with a child and a transform, joints below several roots, a joint named twice; a vertex without weights,
// joints that are not there; keys that floats cannot tell apart, numbers that are none, a curve of one key, a scale that is driven twice.
Scene oddMotion()
{
    Scene s = test::movingScene();
    const NodeId rig = s.roots()[0], body = s.node(rig).children[1], hip = s.node(rig).children[0], knee = s.node(hip).children[0];
    Node child = s.node(rig);
    child.name = "below";
    s.add(child, body);
    s.reparent(knee, {});
    Skin skin = *s.find(s.skins()[0]);
    skin.joints.push_back(hip);
    skin.inverseBind.push_back(glm::dmat4(std::nan("")));
    s.set(s.skins()[0], skin);
    MeshObject o = *s.find(s.meshes()[0]);
    Array<float> weights(o.base.vertexCount() * 8, 0.3f);
    Array<int32_t> joints(weights.size(), 0);
    for (size_t i = 0; i < weights.size(); ++i) {
        joints[i] = int32_t(i % 7) - 1;
        if (i < 8) weights[i] = 0;
    }
    o.base = o.base.with(integerAttribute("joints", Domain::Vertex, 8, joints)).with(floatAttribute("weights", Domain::Vertex, 8, weights));
    s.set(s.meshes()[0], o);
    Clip odd{"odd", {}, 0};
    const auto add = [&](NodeId n, Channel::Path path, Channel::Interpolation i, int components, Array<double> t, Array<double> v) {
        odd.channels.push_back(std::make_shared<const Channel>(Channel{n, path, i, components, std::move(t), std::move(v)}));
    };
    using P = Channel::Path;
    using I = Channel::Interpolation;
    add(hip, P::Translation, I::Linear, 3, {1, 1 + 1e-12, 2}, {0, 0, 0, 1, 1, 1, 2, 2, 2});
    add(hip, P::Rotation, I::Cubic, 4, {1}, {0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0});
    add(hip, P::Scale, I::Linear, 3, {0}, {1, 1, 1});
    add(hip, P::Scale, I::Step, 3, {0, 3}, {1, 1, 1, 2, 2, 2});
    add(body, P::Translation, I::Linear, 3, {0}, {5, 0, 0});
    add(body, P::Weights, I::Step, 3, {0, 1}, {0, 1, 0.5, 1, 0, 0.5});
    add(knee, P::Rotation, I::Linear, 4, {0, 1}, {0, 0, 0, 0, 2, 0, 0, 0});
    add(knee, P::PositionX, I::Linear, 1, {0, 1}, {0, std::nan("")});
    add(rig, P::Weights, I::Linear, 1, {0}, {1});
    s.add(odd);
    Clip lost{"lost", {}, 0};
    lost.channels.push_back(odd.channels.back());
    s.add(lost);
    return s;
}

void both(const Scene& s, const std::filesystem::path& folder, const std::string& name)
{
    writeGltf(s, folder / (name + ".glb"));
    writeGltf(s, folder / (name + ".gltf"));
    writeGltf(s, folder / (name + "_project.glb"), {.project = true});
}

void generated(const std::filesystem::path& folder)
{
    both(Scene(), folder, "empty");
    both(sceneWith(Mesh()), folder, "empty mesh");
    both(test::movingScene(), folder, "moving");
    both(oddMotion(), folder, "odd_motion");
    both(test::richScene(), folder, "rich \xC3\xA4 #1");
    both(sceneWith(test::sheet(300)), folder, "large");  // 32-bit indices
    both(oddAttributes(), folder, "odd_attributes");
    both(byteColours(3), folder, "bytes3");
    both(byteColours(4), folder, "bytes4");
    both(morphedColours(3), folder, "morphed_colours3");
    both(morphedColours(4), folder, "morphed_colours4");
    both(looseThings(true), folder, "loose");
    both(looseThings(false), folder, "cloud");
    both(oddMaterials(), folder, "odd_materials");
    both(degenerate(), folder, "degenerate");
    both(deepTree(), folder, "deep");
    for (const Sample& s : samples()) both(s.make(), folder, "sample_" + std::string(s.id));
}

// With half of the faces of each mesh; what hangs on vertices goes through the stack.
Scene simplified(Scene s)
{
    for (const MeshId id : s.meshes()) {
        MeshObject o = *s.find(id);
        o.stack.push_back({s.newModifierId(), "decimate-quadric", {{"ratio", 0.5}}, true});
        s.set(id, std::move(o));
    }
    return s;
}

bool moves(const Scene& s)
{
    for (const MeshId id : s.meshes())
        for (const Attribute& a : s.find(id)->base.attributes())
            if (a.name.starts_with(names::morph)) return true;
    return !s.skins().empty();
}

void ofData(const std::filesystem::path& data, const std::filesystem::path& folder)
{
    const std::set<std::string> endings{".glb", ".gltf", ".obj", ".ply", ".bvh"};
    for (const char* sub : {"gltf", "characters", "bvh", "meshes"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(data / sub)) {
            std::string ending = entry.path().extension().string();
            std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
            if (!(endings.contains(ending) || isForeign(ending)) || entry.file_size() > 20000000) continue;
            std::string name = std::filesystem::relative(entry.path(), data).string();
            std::replace(name.begin(), name.end(), '/', '_');
            try {
                const Imported in = readFile(entry.path());
                writeGltf(in.scene, folder / (name + ".glb"), {.project = ending == ".glb"});
                if (moves(in.scene)) writeGltf(simplified(in.scene), folder / (name + "_simplified.glb"));
            } catch (const Error& e) {  // what cannot be read is the business of the readers' tests
                std::printf("not read: %s\n", e.what());
            }
        }
}

}  // namespace
}  // namespace mw

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    try {
        mw::generated(argv[1]);
        const char* data = std::getenv("MESHWRIGHT_DATA");
        if (data && std::filesystem::is_directory(data)) mw::ofData(data, argv[1]);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
