#include "render/lights.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/draw_context.h"

namespace mw {
namespace {

/// As in resources/shaders/lights.glsl.
struct LightsBlock {
    glm::vec4 direction[3], light[3], sky{0}, ground{0}, halfway{0};
    glm::mat4 environmentFromView{1}, shadowFromView{1};
    glm::vec4 harmonics[9]{};
    glm::vec4 shadow{0};
};

glm::vec4 towards(glm::vec3 d)
{
    return glm::vec4(glm::normalize(d), 0);
}

/// Chosen so that a scan reads as clay; they go with the camera.
LightsBlock threeLights()
{
    LightsBlock l;
    l.direction[0] = towards({-0.45f, 0.72f, 0.62f});
    l.direction[1] = towards({0.85f, 0.1f, 0.45f});
    l.direction[2] = towards({0.25f, 0.5f, -0.85f});
    l.light[0] = glm::vec4(0.66f * glm::vec3(1.0f, 0.985f, 0.96f), 1);
    l.light[1] = glm::vec4(0.10f * glm::vec3(0.85f, 0.93f, 1.0f), 1);
    l.light[2] = glm::vec4(0.22f * glm::vec3(0.92f, 0.96f, 1.0f), 1);
    l.sky = glm::vec4(0.13f * glm::vec3(0.93f, 0.97f, 1.05f), 0);
    l.ground = glm::vec4(0.035f * glm::vec3(1.05f, 1.0f, 0.95f), 0);
    return l;
}

LightsBlock environmentLights(DrawContext& c, const Environment& e)
{
    LightsBlock l;
    const EnvironmentTextures::Made& made = c.gpu.environments.get(e);
    const glm::dmat4 worldFromEnvironment = glm::rotate(glm::dmat4(1), c.frame.options.environmentTurn, {0, 1, 0});
    const glm::dmat3 viewFromEnvironment(c.viewFromWorld * worldFromEnvironment);
    for (glm::vec4& d : l.direction) d = towards(viewFromEnvironment * glm::dvec3(e.keyDirection));
    l.light[0] = glm::vec4(made.key, e.key ? 0.f : 1.f);
    l.light[1] = l.light[2] = glm::vec4(0);
    l.environmentFromView = glm::mat4(glm::dmat4(glm::transpose(viewFromEnvironment)));
    for (size_t i = 0; i < 9; ++i) l.harmonics[i] = glm::vec4(made.harmonics[i], 0);
    return l;
}

float brightness(glm::vec3 c)
{
    return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

/// Of what lights the ground, the share that the key light has.
float keyShareOnGround(const FrameLight& light, const LightsBlock& l)
{
    std::array<glm::vec3, 9> h;
    for (size_t i = 0; i < 9; ++i) h[i] = l.harmonics[i];
    const float key = brightness(l.light[0]) * std::max(float(light.key.y), 0.f);
    const float other =
        light.environment ? brightness(glm::max(evaluate(h, {0, 1, 0}), glm::vec3(0))) : brightness(l.sky) + 0.5f * brightness(l.light[2]);
    return key > 0 ? key / (key + other) : 0;
}

/// A box along the key light round everything that casts; false when nothing does.
bool aimShadows(const DrawContext& c, FrameLight& light)
{
    const glm::dvec3 z = light.key, x = glm::normalize(glm::cross(std::abs(z.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), z)),
                     y = glm::cross(z, x);
    const glm::dmat3 lightFromWorld = glm::transpose(glm::dmat3(x, y, z));
    glm::dvec3 low(1e300), high(-1e300);
    for (const DrawObject& o : c.frame.objects) {
        const Bounds b = o.mesh.faceCount() ? worldBounds(o) : Bounds();
        for (int i = 0; i < 8 && !b.empty; ++i) {
            const glm::dvec3 p = lightFromWorld * glm::dvec3(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z);
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    const double size = std::max(high.x - low.x, high.y - low.y);
    if (!(size > 0) || !std::isfinite(size)) return false;
    const double half = 0.51 * size + 1e-9, deep = std::max(high.z - low.z, 1e-6 * size);
    const glm::dvec3 middle = 0.5 * (low + high);
    light.texel = 2 * half / shadowSide;
    glm::dmat4 m(glm::dmat3(1 / half, 0, 0, 0, 1 / half, 0, 0, 0, -1.98 / deep) * lightFromWorld);
    m[3] = glm::dvec4(-middle.x / half, -middle.y / half, 1.98 * middle.z / deep, 1);
    light.shadowFromWorld = m;
    return true;
}

void fillTable(gl::Texture& texture)
{
    const std::vector<glm::vec2> table = reflectanceTable();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, reflectanceSide, reflectanceSide, 0, GL_RG, GL_FLOAT, table.data());
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
}

void fillCube(gl::Texture& texture, const Environment& e)
{
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture.id());
    for (int level = 0; level < environmentLevels; ++level)
        for (int face = 0; face < 6; ++face) {
            const std::vector<glm::vec3> texels = prefiltered(e, face, level);
            const int side = environmentSide >> level;
            glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level, GL_RGB16F, side, side, 0, GL_RGB, GL_FLOAT, texels.data());
        }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, environmentLevels - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

}  // namespace

const EnvironmentTextures::Made& EnvironmentTextures::get(const Environment& e)
{
    Made& m = made_[&e];
    if (m.mirrored) return m;
    fillCube(m.mirrored, e);
    m.harmonics = harmonicsOf(e);
    m.key = keyOf(e);
    return m;
}

GLuint EnvironmentTextures::reflectance()
{
    if (!reflectance_) fillTable(reflectance_);
    return reflectance_.get();
}

void lightFrame(DrawContext& c)
{
    FrameLight& light = c.light;
    const ViewOptions& options = c.frame.options;
    if (options.lighting == Lighting::Environment) {
        light.environment = findEnvironment(options.environment);
        if (!light.environment) light.environment = &environments().front();
    }
    glActiveTexture(GL_TEXTURE0 + environmentUnit);
    LightsBlock l = light.environment ? environmentLights(c, *light.environment) : threeLights();
    if (light.environment) {
        c.texture(environmentUnit, GL_TEXTURE_CUBE_MAP, c.gpu.environments.get(*light.environment).mirrored.get());
        c.texture(reflectanceUnit, GL_TEXTURE_2D, c.gpu.environments.reflectance());
    }
    l.halfway = towards(glm::vec3(l.direction[0]) + glm::vec3(0, 0, 1.0001f));
    const glm::dmat4 worldFromView = glm::inverse(c.viewFromWorld);
    light.key = glm::normalize(glm::dmat3(worldFromView) * glm::dvec3(l.direction[0]));
    light.groundShade = 0.85f * keyShareOnGround(light, l);
    const bool any = options.shadows && options.shading != Shading::Wire && options.shading != Shading::Matcap && brightness(l.light[0]) > 0;
    light.shadows = any && aimShadows(c, light);
    if (light.shadows) {
        const glm::dmat4 half = glm::translate(glm::dmat4(1), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1), glm::dvec3(0.5));
        l.shadowFromView = half * light.shadowFromWorld * worldFromView;
        l.shadow = {1.f / shadowSide, float(light.texel), softOnObjects, softOnGround};
    }
    gl::uploadBlock(c.gpu.lightsBlock, lightsBlock, l);
}

}  // namespace mw
