#include "render/matcap.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace mw {
namespace {

using glm::vec3;

float facing(vec3 n, vec3 light)
{
    return std::max(glm::dot(n, glm::normalize(light)), 0.f);
}

float shine(vec3 n, vec3 light, float sharpness)
{
    return std::pow(facing(n, glm::normalize(light) + vec3(0, 0, 1)), sharpness);
}

/// 1 at the rim, 0 in the middle.
float rim(vec3 n, float power)
{
    return std::pow(1 - std::clamp(n.z, 0.f, 1.f), power);
}

vec3 clay(vec3 n)
{
    const vec3 base(0.50f, 0.43f, 0.375f);
    return base * (0.10f + 0.08f * n.y + 0.86f * facing(n, {-0.5f, 0.75f, 0.6f}) + 0.12f * facing(n, {0.9f, 0.1f, 0.4f})) +
           0.05f * shine(n, {-0.5f, 0.75f, 0.6f}, 10) + vec3(0.07f, 0.075f, 0.085f) * rim(n, 3);
}

vec3 porcelain(vec3 n)
{
    return vec3(0.74f, 0.75f, 0.76f) * (0.22f + 0.12f * n.y + 0.66f * facing(n, {-0.4f, 0.7f, 0.7f})) + 0.75f * shine(n, {-0.45f, 0.75f, 0.6f}, 160) +
           0.14f * shine(n, {0.8f, 0.3f, 0.4f}, 40) + vec3(0.10f, 0.11f, 0.13f) * rim(n, 4);
}

vec3 redWax(vec3 n)
{
    const float wrapped = std::clamp(0.35f + 0.65f * glm::dot(n, glm::normalize(vec3(-0.5f, 0.7f, 0.6f))), 0.f, 1.f);
    return glm::mix(vec3(0.10f, 0.008f, 0.006f), vec3(0.62f, 0.075f, 0.05f), wrapped) +
           vec3(0.55f, 0.5f, 0.48f) * shine(n, {-0.5f, 0.75f, 0.55f}, 60) + vec3(0.22f, 0.06f, 0.04f) * rim(n, 2.5f);
}

vec3 jade(vec3 n)
{
    // Light that goes in comes out again on the far side, too.
    const float through = std::pow(std::clamp(0.5f - 0.5f * glm::dot(n, glm::normalize(vec3(-0.4f, 0.8f, 0.4f))), 0.f, 1.f), 2.f);
    return vec3(0.035f, 0.155f, 0.085f) + vec3(0.16f, 0.40f, 0.24f) * facing(n, {-0.4f, 0.8f, 0.5f}) + vec3(0.12f, 0.26f, 0.10f) * through +
           vec3(0.7f) * shine(n, {-0.4f, 0.8f, 0.5f}, 110) + vec3(0.07f, 0.16f, 0.11f) * rim(n, 3);
}

/// A dark floor, a light horizon and a sky, mirrored.
vec3 room(vec3 n)
{
    const vec3 r = 2 * n.z * n - vec3(0, 0, 1);
    const float sky = glm::smoothstep(0.02f, 0.9f, r.y), floor = glm::smoothstep(-0.02f, -0.5f, r.y);
    float light = 0.55f * glm::smoothstep(-0.25f, 0.12f, r.y) * (1 - 0.55f * sky) + 0.10f + 0.05f * floor;
    light += 0.85f * glm::smoothstep(0.82f, 0.92f, glm::dot(r, glm::normalize(vec3(-0.55f, 0.65f, 0.55f))));
    light += 0.35f * glm::smoothstep(0.90f, 0.97f, glm::dot(r, glm::normalize(vec3(0.85f, 0.2f, 0.35f))));
    return vec3(light);
}

vec3 metal(vec3 n)
{
    return room(n) * vec3(0.80f, 0.83f, 0.87f);
}

vec3 gold(vec3 n)
{
    return glm::mix(vec3(1.0f, 0.62f, 0.17f), vec3(1.0f, 0.82f, 0.45f), rim(n, 2)) * room(n) + vec3(0.05f, 0.025f, 0.004f);
}

vec3 normals(vec3 n)
{
    const vec3 shown = 0.5f + 0.5f * n;  // as normal maps have it: the numbers are what is seen
    return glm::mix(shown / 12.92f, glm::pow((shown + 0.055f) / 1.055f, vec3(2.4f)), glm::step(vec3(0.04045f), shown));
}

/// Bands of light across the surface: a bump or a kink breaks them.
vec3 zebra(vec3 n)
{
    const vec3 r = 2 * n.z * n - vec3(0, 0, 1);
    const float band = std::sin(14 * std::atan2(r.y, std::sqrt(r.x * r.x + r.z * r.z)));
    return vec3(0.03f) + vec3(0.78f) * glm::smoothstep(-0.25f, 0.25f, band) * (0.75f + 0.25f * n.z);
}

constexpr Matcap table[] = {
    {"clay", "Clay", clay},         {"porcelain", "Porcelain", porcelain},
    {"wax", "Red wax", redWax},     {"jade", "Jade", jade},
    {"metal", "Metal", metal},      {"gold", "Gold", gold},
    {"normal", "Normals", normals}, {"zebra", "Zebra stripes", zebra},
};

uint8_t encoded(float linear)
{
    const float c = std::clamp(linear, 0.f, 1.f), s = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
    return uint8_t(std::lround(255 * s));
}

}  // namespace

std::span<const Matcap> matcaps()
{
    return table;
}

const Matcap* findMatcap(std::string_view name)
{
    for (const Matcap& m : table)
        if (name == m.name) return &m;
    return nullptr;
}

std::vector<uint8_t> matcapPixels(const Matcap& m, int side)
{
    std::vector<uint8_t> out;
    out.reserve(size_t(side) * size_t(side) * 4);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            glm::vec2 at = (2.f * (glm::vec2(float(x), float(y)) + 0.5f) / float(side) - 1.f) / 0.98f;  // the shader reads 0.98 of the picture
            const float r = glm::length(at);
            if (r > 1) at /= r;
            const vec3 c = m.shade({at, std::sqrt(std::max(0.f, 1 - glm::dot(at, at)))});
            for (int k = 0; k < 3; ++k) out.push_back(encoded(c[k]));
            out.push_back(255);
        }
    return out;
}

}  // namespace mw
