#include "render/materials.h"

#include <algorithm>

#include "render/image.h"

namespace mw {
namespace {

/// Unit, variant and content of the pictures, in the order of PictureUse.
struct Slot {
    TextureUnit unit;
    unsigned variant;
    bool color;  ///< sRGB; else numbers
    Material::Texture Material::*texture;
};
constexpr Slot slots[pictureUses] = {{baseColorUnit, variant::mapBase, true, &Material::baseColorTexture},
                                     {roughnessUnit, variant::mapRoughness, false, &Material::metallicRoughnessTexture},
                                     {normalUnit, variant::mapNormal, false, &Material::normalTexture},
                                     {occlusionUnit, variant::mapOcclusion, false, &Material::occlusionTexture},
                                     {emissiveUnit, variant::mapEmissive, true, &Material::emissiveTexture}};
constexpr unsigned allMaps = variant::mapBase | variant::mapRoughness | variant::mapNormal | variant::mapOcclusion | variant::mapEmissive;

const EncodedPicture* pictureOf(const DrawObject& o, uint32_t slot, size_t use)
{
    return slot < o.pictures.size() && o.pictures[slot][use] ? &o.pictures[slot][use] : nullptr;
}

template <class Wanted>
TexcoordSets setsOf(const DrawObject& o, Wanted wanted)
{
    TexcoordSets sets{-1, -1};
    for (uint32_t slot = 0; slot < o.materials.size(); ++slot)
        for (size_t use = 0; use < pictureUses; ++use) {
            if (!o.materials[slot] || !pictureOf(o, slot, use) || !wanted(*o.materials[slot], use)) continue;
            const int set = (*o.materials[slot].*slots[use].texture).set;
            if (sets[0] < 0) sets[0] = set;
            if (sets[0] != set && sets[1] < 0) sets[1] = set;
        }
    if (sets[1] >= 0 && sets[1] < sets[0]) std::swap(sets[0], sets[1]);
    return sets;
}

/// Binds one picture; returns its variant bit, 0 when the draw lacks it or its coordinates.
unsigned bindPicture(DrawContext& c, const DrawObject& o, uint32_t slot, size_t use, const TexcoordSets& sets, ObjectBlock& b)
{
    const Material* m = materialOf(o, slot);
    const EncodedPicture* picture = m ? pictureOf(o, slot, use) : nullptr;
    if (!picture) return 0;
    const Material::Texture& texture = m->*slots[use].texture;
    if (texture.set < 0 || (texture.set != sets[0] && texture.set != sets[1])) return 0;
    if (texture.set != sets[0]) b.ids.w |= 1 << use;
    c.texture(slots[use].unit, GL_TEXTURE_2D, imageTexture(c.gpu.cache, *picture, {texture.repeat, slots[use].color}));
    return slots[use].variant;
}

}  // namespace

const Material* materialOf(const DrawObject& o, uint32_t slot)
{
    return slot < o.materials.size() ? o.materials[slot].get() : nullptr;
}

bool isPlain(const Material& m)
{
    return m.metallic < 0.01 && m.roughness > 0.35 && m.alpha == Material::Alpha::Opaque && m.emissive == glm::dvec3(0);
}

TexcoordSets pictureSets(const DrawObject& o)
{
    return setsOf(o, [](const Material&, size_t) { return true; });
}

TexcoordSets maskSets(const DrawObject& o)
{
    return setsOf(o, [](const Material& m, size_t use) { return use == 0 && m.alpha == Material::Alpha::Mask; });
}

bool hasNormalMap(const DrawObject& o)
{
    for (uint32_t slot = 0; slot < o.materials.size(); ++slot)
        if (o.materials[slot] && pictureOf(o, slot, normalPicture)) return true;
    return false;
}

unsigned applyMaterial(DrawContext& c, const DrawObject& o, uint32_t slot, const TexcoordSets& sets, ObjectBlock& b)
{
    const unsigned lit = c.light.environment ? variant::material : 0;  // an environment is mirrored by everything
    const Material* m = materialOf(o, slot);
    if (!m) return lit;
    b.baseColor = m->baseColor;
    b.surface.x = float(std::clamp(m->metallic, 0.0, 1.0));
    b.surface.y = float(std::clamp(m->roughness, 0.0, 1.0));
    b.emissive = glm::vec4(m->emissive, m->occlusionStrength);
    b.maps.x = float(m->normalScale);
    if (m->doubleSided) b.look.z = 0;
    if (m->alpha == Material::Alpha::Mask) b.surface.w = float(m->alphaCutoff);
    if (m->alpha == Material::Alpha::Blend && !c.frame.options.xray) b.look.w = 1;
    unsigned maps = 0;
    for (size_t use = 0; use < pictureUses; ++use)
        if (use != normalPicture || c.frame.options.shading != Shading::Flat) maps |= bindPicture(c, o, slot, use, sets, b);
    if (!maps && isPlain(*m)) return lit;
    b.surface.z = 1;
    return variant::material | (maps & allMaps);
}

unsigned applyMask(DrawContext& c, const DrawObject& o, uint32_t slot, const TexcoordSets& sets, ObjectBlock& b)
{
    const Material* m = materialOf(o, slot);
    if (!m || m->alpha != Material::Alpha::Mask) return 0;
    b.baseColor = m->baseColor;
    b.surface.w = float(m->alphaCutoff);
    return bindPicture(c, o, slot, basePicture, sets, b) ? 1 : 0;
}

}  // namespace mw
