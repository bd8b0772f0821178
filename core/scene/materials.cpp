// Materials of meshes.
#include "core/scene/materials.h"

#include <algorithm>
#include <charconv>

namespace mw {

Material::Texture& textureOf(Material& m, TextureKind k)
{
    switch (k) {
        case TextureKind::MetallicRoughness:
            return m.metallicRoughnessTexture;
        case TextureKind::Normal:
            return m.normalTexture;
        case TextureKind::Occlusion:
            return m.occlusionTexture;
        case TextureKind::Emissive:
            return m.emissiveTexture;
        default:
            return m.baseColorTexture;
    }
}

const Material::Texture& textureOf(const Material& m, TextureKind k)
{
    return textureOf(const_cast<Material&>(m), k);
}

size_t users(const Scene& scene, MaterialId id)
{
    size_t n = 0;
    for (const MeshId mesh : scene.meshes()) {
        const auto& slots = scene.find(mesh)->materials;
        n += size_t(std::count(slots.begin(), slots.end(), id));
    }
    return n;
}

std::string materialText(const Scene& scene, MaterialId id)
{
    const std::string& name = scene.find(id)->name;
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '-' || c == ' ' || c >= 0x80; };
    size_t same = 0;
    for (const MaterialId m : scene.materials()) same += scene.find(m)->name == name;
    const bool good = !name.empty() && name.front() != ' ' && name.back() != ' ' && std::all_of(name.begin(), name.end(), plain);
    return same == 1 && good ? name : "#" + std::to_string(id.value);
}

MaterialId materialOf(const Scene& scene, std::string_view text)
{
    if (text.starts_with('#')) {
        uint32_t value = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && scene.find(MaterialId{value})) return {value};
        throw Error("there is no material " + std::string(text));
    }
    MaterialId found;
    for (const MaterialId m : scene.materials()) {
        if (scene.find(m)->name != text) continue;
        if (found) throw Error("several materials are called \"" + std::string(text) + "\"; name one by its number, #" + std::to_string(found.value));
        found = m;
    }
    if (!found) throw Error("there is no material \"" + std::string(text) + "\"");
    return found;
}

std::string freshMaterialName(const Scene& scene, const std::string& wanted)
{
    const auto taken = [&](const std::string& name) {
        for (const MaterialId m : scene.materials())
            if (scene.find(m)->name == name) return true;
        return false;
    };
    std::string name = wanted;
    for (int i = 2; taken(name); ++i) name = wanted + " " + std::to_string(i);
    return name;
}

MaterialId materialAt(const Scene& scene, NodeId node, int64_t slot)
{
    const Node& n = scene.node(node);
    const MeshObject* object = scene.find(n.mesh);
    if (!object) throw Error("\"" + n.name + "\" has no mesh, so no material");
    if (slot < 0 || slot >= int64_t(object->materials.size()))
        throw Error("\"" + n.name + "\" has " + std::to_string(object->materials.size()) + " material slots; there is no slot " +
                    std::to_string(slot));
    if (!scene.find(object->materials[size_t(slot)]))
        throw Error("slot " + std::to_string(slot) + " of \"" + n.name + "\" has no material; use one there first");
    return object->materials[size_t(slot)];
}

void dropUnusedPayloads(Scene& scene)
{
    scene.remove(scene.add(Node{}));  // what nobody uses goes with any node that goes
}

}  // namespace mw
