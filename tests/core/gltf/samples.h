// Small scenes and hand-made glTF for the tests of this folder.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/io/gltf.h"
#include "core/io/gltf_container.h"

namespace mw::test {

inline Array<float> numbers(std::initializer_list<float> v)
{
    return Array<float>(v.begin(), v.end());
}

/// A cube of quads, 8 vertices; corner texture coordinates, one colour a vertex, two material slots, a group, a crease.
inline Mesh cube()
{
    const Array<glm::vec3> p{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    const Array<uint32_t> corners{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 2, 3, 7, 6, 1, 2, 6, 5, 0, 4, 7, 3};
    Mesh m(p, Array<uint32_t>{0, 4, 8, 12, 16, 20, 24}, corners);
    Array<float> uv, color, crease(24, 0.f);
    for (int f = 0; f < 6; ++f)
        for (const float x : {0.f, 0.f, 1.f, 0.f, 1.f, 0.75f, 0.f, 0.75f}) uv.push_back(x);
    for (int v = 0; v < 8; ++v)
        for (int k = 0; k < 3; ++k) color.push_back(float((v >> k) & 1));
    crease[3] = 2;
    m = m.with(floatAttribute("texcoord", Domain::Corner, 2, uv)).with(floatAttribute("color", Domain::Vertex, 3, color));
    m = m.with(floatAttribute("crease", Domain::Corner, 1, crease));
    m = m.with(integerAttribute("material", Domain::Face, 1, {0, 0, 1, 0, 1, 0}))
            .with(integerAttribute("group", Domain::Face, 1, {0, 0, 0, 1, 1, 1}));
    return m.withGroupNames({"left", "right \"half\""});
}

/// n by n quads on a wavy sheet, cut into triangles, with a vertex count of (n+1)^2.
inline Mesh sheet(int n)
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    Array<float> uv;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) p.push_back({float(x) / float(n), float(y) / float(n), 0.1f * std::sin(float(x + y))});
    const auto at = [&](int x, int y) { return uint32_t(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) t.insert(t.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    for (const uint32_t v : t) uv.insert(uv.end(), {p[v].x, p[v].y});
    return Mesh::triangles(p, t).with(floatAttribute("texcoord", Domain::Corner, 2, uv));
}

inline Scene sceneWith(Mesh mesh, std::string name = "thing")
{
    Scene s;
    Node n;
    n.name = name;
    n.mesh = s.add(MeshObject{name, std::move(mesh), {}, {}});
    s.add(std::move(n));
    return s;
}

inline const MeshObject& onlyMesh(const Scene& s)
{
    if (s.meshes().size() != 1) throw Error("there are " + std::to_string(s.meshes().size()) + " meshes, not 1");
    return *s.find(s.meshes()[0]);
}

/// A picture of one grey pixel.
inline std::shared_ptr<const std::vector<uint8_t>> pixel()
{
    static const uint8_t png[] = {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00,
                                  0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00,
                                  0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9C, 0x63, 0x68, 0x00, 0x00, 0x00, 0x82, 0x00, 0x81,
                                  0x77, 0xCD, 0x72, 0xB6, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
    return std::make_shared<const std::vector<uint8_t>>(std::begin(png), std::end(png));
}

/// Two nodes that share a textured cube with a stack, a hidden sheet below one of them, and odd numbers in all places.
inline Scene richScene()
{
    Scene s;
    const ImageId image = s.add(Image{"grey", "image/png", pixel()});
    Material red, glass;
    red.name = "red";
    red.baseColor = {0.1 + 0.2, 0.1, 1.0 / 3, 1};
    red.baseColorTexture = {image, 0, false};
    red.normalTexture = {image, 0, true};
    red.extras = "{\"shine\":[1,2.5]}";
    glass.name = "glass";
    glass.alpha = Material::Alpha::Blend;
    glass.emissive = {0, 2.5, 0.5};
    glass.doubleSided = true;
    MeshObject cubes{"cube", cube(), {s.add(red), s.add(glass)}, {}};
    cubes.stack.push_back({s.newModifierId(),
                           "no-such-operation",
                           {{"levels", int64_t(2)}, {"share", 1.0}, {"at", glm::dvec3(0.1, 2, -3)}, {"on", true}, {"mode", std::string("a")}},
                           false});
    Node a, b, c;
    a.name = "first \xC3\xA4";
    a.mesh = b.mesh = s.add(cubes);
    a.local.translation = {1.0 / 3, 0, 1e-9};
    b.local.rotation = glm::normalize(glm::dquat(1, 0.2, 0.3, -0.4));
    b.local.scale = {1, 2, -1};
    b.extras = "{\"tag\":true}";
    c.name = "hidden";
    c.visible = false;
    c.mesh = s.add(MeshObject{"sheet", sheet(3), {}, {}});
    s.add(a);
    const NodeId second = s.add(b);
    s.add(c, second);
    return s;
}

/// A skinned, morphing strip on three joints and an end site, with a clip of every kind of channel; and a terrain of 5 by 3 samples.
inline Scene movingScene()
{
    Scene s;
    Node plain, body;
    plain.name = "rig";
    plain.local.translation = {0, 1, 0};
    const NodeId rig = s.add(plain);
    std::vector<NodeId> joints;
    for (int i = 0; i < 4; ++i) {
        Node j;
        j.name = "joint" + std::to_string(i);
        j.joint = i < 3 ? Node::Joint::Joint : Node::Joint::EndSite;
        j.local.translation = {0.5, 0, 0.1 * i};
        joints.push_back(s.add(j, i ? joints.back() : rig));
    }
    Mesh m = sheet(4);
    Array<int32_t> slots;
    Array<float> weights;
    for (size_t v = 0; v < m.vertexCount(); ++v) {
        const float x = m.positions()[v].x;
        slots.insert(slots.end(), {int32_t(x * 2), int32_t(std::min(x * 2 + 1, 2.f)), 0, 0});
        weights.insert(weights.end(), {0.75f, 0.25f, 0.f, 0.f});
    }
    m = m.with(integerAttribute("joints", Domain::Vertex, 4, slots)).with(floatAttribute("weights", Domain::Vertex, 4, weights));
    m = m.with(floatAttribute("morph:up", Domain::Vertex, 3, Array<float>(3 * m.vertexCount(), 0.125f)))
            .with(floatAttribute("morph:wide", Domain::Vertex, 3, Array<float>(3 * m.vertexCount(), -1.f)));
    Skin skin{"skin", {joints.begin(), joints.begin() + 3}, std::vector<glm::dmat4>(3, glm::dmat4(1)), joints[0]};
    skin.inverseBind[1][3] = {1.0 / 3, 0, 2, 1};
    body.name = "body";
    body.skin = s.add(skin);
    body.mesh = s.add(MeshObject{"body", m, {}, {}});
    body.morphWeights = {0.1, 0.7};
    const NodeId shown = s.add(body, rig);
    const Shared<double> times(Array<double>{0, 0.25, 1.0 / 3, 2}), others(Array<double>{0.5, 1.5});
    Clip walk{"walk", {}, 0}, still{"", {}, 1.0 / 120};
    const auto add = [](Clip& c, NodeId n, Channel::Path path, Channel::Interpolation i, int components, const Shared<double>& t, Array<double> v) {
        c.channels.push_back(std::make_shared<const Channel>(Channel{n, path, i, components, t, std::move(v)}));
    };
    using P = Channel::Path;
    using I = Channel::Interpolation;
    add(walk, joints[0], P::Translation, I::Linear, 3, times, {0, 0, 0, 1, 0, 0, 1, 2, 0, 0.1, 0.2, 0.3});
    add(walk, joints[1], P::Rotation, I::Linear, 4, times, {0, 0, 0, 1, 0, 0.6, 0, 0.8, 0.6, 0, 0, -0.8, 1, 0, 0, 0});
    add(walk, joints[1], P::Scale, I::Step, 3, others, {1, 1, 1, 2, 2, 0.5});
    add(walk, joints[2], P::Rotation, I::Cubic, 4, others, {0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
    add(walk, shown, P::Weights, I::Linear, 2, times, {0, 1, 0.5, 0, 1, 1, 0, 0});
    add(still, joints[0], P::PositionY, I::Linear, 1, others, {0, 0.5});
    for (const P p : {P::EulerZ, P::EulerX, P::EulerY}) add(still, joints[0], p, I::Linear, 1, others, {10, 400});
    s.add(walk);
    s.add(still);
    TerrainObject t;
    Array<float> heights;
    for (int i = 0; i < 15; ++i) heights.push_back(float(i % 4) / 3);
    t.terrain.name = "hills";
    t.terrain.map = HeightMap(5, 3, heights);
    t.terrain.extent = 1000.0 / 3;
    t.terrain.waterLevel = 12;
    t.terrain.detail.patches = 9;
    t.terrain.detail.corrected = false;
    t.terrain.layers.rockSlope = 41;
    t.sourceOperation = "diamond-square";
    t.sourceValues = {{"seed", int64_t(7)}, {"roughness", 0.5}};
    Node ground;
    ground.name = "ground";
    ground.terrain = s.add(t);
    s.add(ground);
    return s;
}

/// A .glb of one triangle, to be changed by `edit` before it is packed.
template <class Edit>
std::vector<uint8_t> triangleGlb(Edit edit)
{
    const float p[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<uint8_t> bin(44, 0);
    std::memcpy(bin.data(), p, 36);
    const uint16_t indices[] = {0, 1, 2};
    std::memcpy(bin.data() + 36, indices, 6);
    nlohmann::json j = nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "buffers": [{"byteLength": 44}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]})");
    edit(j, bin);
    return glbContent(j.dump(), bin);
}

inline bool warned(const std::vector<Warning>& warnings, const std::string& code)
{
    return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& w) { return w.code == code; });
}

}  // namespace mw::test
