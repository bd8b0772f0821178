#include "render/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace mw {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float pi = std::numbers::pi_v<float>;

/// 1 inside a rectangle that is looked at along `axis`, 0 outside; `soft` is the width of its edge.
float panel(vec3 d, vec3 axis, vec2 halfSize, float soft)
{
    const float ahead = glm::dot(d, axis);
    if (ahead <= 0.05f) return 0;
    const vec3 side = glm::normalize(glm::cross(vec3(0, 1, 0), axis)), up = glm::cross(axis, side);
    const vec2 at = glm::abs(vec2(glm::dot(d, side), glm::dot(d, up)) / ahead);
    const vec2 inside = 1.f - glm::smoothstep(halfSize - soft, halfSize + soft, at);
    return inside.x * inside.y;
}

const vec3 studioKey = glm::normalize(vec3(-0.55f, 0.75f, 0.55f));

vec3 studio(vec3 d)
{
    // A room that is light above and dim below, with a broad light from the right and a narrow one from behind.
    const vec3 room = glm::mix(vec3(0.10f, 0.098f, 0.095f), vec3(0.36f, 0.37f, 0.385f), glm::smoothstep(-0.7f, 0.9f, d.y));
    const float fill = panel(d, glm::normalize(vec3(0.95f, 0.25f, 0.35f)), {0.42f, 0.8f}, 0.06f);
    const float rim = panel(d, glm::normalize(vec3(0.30f, 0.45f, -0.9f)), {0.8f, 0.16f}, 0.05f);
    return room + fill * vec3(0.95f, 1.0f, 1.06f) + rim * vec3(2.4f, 2.45f, 2.5f);
}

vec3 studioSoftbox(vec3 d)
{
    return panel(d, studioKey, {0.48f, 0.48f}, 0.05f) * vec3(2.6f, 2.52f, 2.4f);
}

vec3 overcast(vec3 d)
{
    // Moon and Spencer's sky: three times as bright above as at the horizon; the ground sends a fifth back.
    const float sky = 0.86f * (1 + 2 * std::max(d.y, 0.f)) / 3;
    const vec3 ground = vec3(0.155f, 0.15f, 0.14f);
    return glm::mix(ground, sky * vec3(0.96f, 0.99f, 1.05f), glm::smoothstep(-0.06f, 0.03f, d.y));
}

const vec3 eveningSun = glm::normalize(vec3(-0.80f, 0.34f, 0.48f));

vec3 sunset(vec3 d)
{
    const float towards = 0.5f + 0.5f * glm::dot(glm::normalize(vec3(d.x, 1e-4f, d.z)), glm::normalize(vec3(eveningSun.x, 0, eveningSun.z)));
    const vec3 low = glm::mix(vec3(0.42f, 0.32f, 0.38f), vec3(1.25f, 0.56f, 0.22f), towards * towards);
    const vec3 sky = glm::mix(low, vec3(0.16f, 0.25f, 0.46f), std::pow(glm::clamp(d.y, 0.f, 1.f), 0.45f));
    const float near = std::max(glm::dot(d, eveningSun), 0.f);
    const vec3 glow = vec3(1.5f, 0.72f, 0.28f) * std::pow(near, 24.f) + vec3(0.25f, 0.12f, 0.05f) * std::pow(near, 4.f);
    const vec3 ground = vec3(0.115f, 0.085f, 0.07f);
    return glm::mix(ground, sky + glow, glm::smoothstep(-0.05f, 0.02f, d.y));
}

vec3 even(vec3)
{
    return vec3(1);
}

vec3 dark(vec3)
{
    return vec3(0);
}

const Environment table[] = {
    {"studio", "Studio", "A large soft light from the upper left, a fill from the right, a narrow one from behind", studio, studioSoftbox, studioKey,
     vec3(0)},
    {"overcast", "Overcast sky", "Soft light from above, hardly any shadow", overcast, nullptr, glm::normalize(vec3(-0.2f, 1, 0.25f)), vec3(0.22f)},
    {"sunset", "Sunset", "A low warm sun and a blue sky", sunset, nullptr, eveningSun, vec3(1.15f, 0.66f, 0.36f)},
    {"even", "Even light", "White from everywhere: colours as the materials have them, no shape", even, nullptr, vec3(0, 1, 0), vec3(0)},
    {"sun", "Sun alone", "One hard light and nothing else", dark, nullptr, glm::normalize(vec3(-0.45f, 0.72f, 0.62f)), vec3(1)},
};

/// Sums over texels of a cube: `f(direction, solid angle)`.
template <class F>
void overSphere(int side, F f)
{
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const vec2 at = 2.f * (vec2(float(x), float(y)) + 0.5f) / float(side) - 1.f;
                const float r2 = 1 + glm::dot(at, at);
                f(cubeDirection(face, at), 4 / (float(side * side) * r2 * std::sqrt(r2)));
            }
}

/// Points that fill the unit square evenly.
vec2 hammersley(uint32_t i, uint32_t n)
{
    uint32_t b = i;
    b = b << 16 | b >> 16;
    b = (b & 0x55555555u) << 1 | (b & 0xAAAAAAAAu) >> 1;
    b = (b & 0x33333333u) << 2 | (b & 0xCCCCCCCCu) >> 2;
    b = (b & 0x0F0F0F0Fu) << 4 | (b & 0xF0F0F0F0u) >> 4;
    b = (b & 0x00FF00FFu) << 8 | (b & 0xFF00FF00u) >> 8;
    return {(float(i) + 0.5f) / float(n), float(b) * 2.3283064365386963e-10f};
}

/// A half vector about +Z, as often as Trowbridge-Reitz has facets that way.
vec3 halfVector(vec2 u, float roughness)
{
    const float a = roughness * roughness, angle = 2 * pi * u.y;
    const float z = std::sqrt((1 - u.x) / (1 + (a * a - 1) * u.x)), r = std::sqrt(std::max(0.f, 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

vec3 mirrored(const Environment& e, vec3 n, float roughness, uint32_t samples)
{
    const vec3 x = glm::normalize(std::abs(n.y) < 0.9f ? glm::cross(vec3(0, 1, 0), n) : glm::cross(vec3(1, 0, 0), n)), y = glm::cross(n, x);
    vec3 sum(0);
    float weight = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        const vec3 h = halfVector(hammersley(i, samples), roughness);
        const float cosine = 2 * h.z * h.z - 1;  // of the reflected ray; eye, normal and mirror direction are one
        if (cosine <= 0) continue;
        sum += cosine * radiance(e, 2 * h.z * (h.x * x + h.y * y + h.z * n) - n);
        weight += cosine;
    }
    return sum / weight;
}

/// Height-correlated Smith shadowing over 4 * nl * nv (Heitz 2014).
float visibility(float nl, float nv, float a2)
{
    return 0.5f / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
}

vec2 reflectance(float nv, float roughness, uint32_t samples)
{
    const vec3 v(std::sqrt(1 - nv * nv), 0, nv);
    const float a2 = std::pow(roughness, 4.f);
    vec2 sum(0);
    for (uint32_t i = 0; i < samples; ++i) {
        const vec3 h = halfVector(hammersley(i, samples), roughness);
        const float vh = glm::dot(v, h), nl = 2 * vh * h.z - v.z;
        if (nl <= 0 || vh <= 0) continue;
        const float share = 4 * nl * visibility(nl, nv, a2) * vh / h.z, grazing = std::pow(1 - vh, 5.f);
        sum += share * vec2(1 - grazing, grazing);
    }
    return sum / float(samples);
}

}  // namespace

std::span<const Environment> environments()
{
    return table;
}

const Environment* findEnvironment(std::string_view name)
{
    for (const Environment& e : table)
        if (name == e.name) return &e;
    return nullptr;
}

glm::vec3 keyOf(const Environment& e)
{
    if (!e.key) return e.keyLight;
    vec3 sum(0);
    overSphere(64, [&](vec3 d, float angle) { sum += e.key(d) * std::max(glm::dot(d, e.keyDirection), 0.f) * angle; });
    return sum / pi;
}

glm::vec3 radiance(const Environment& e, glm::vec3 direction)
{
    return e.key ? e.around(direction) + e.key(direction) : e.around(direction);
}

std::array<glm::vec3, 9> harmonicsOf(const Environment& e)
{
    std::array<vec3, 9> c{};
    overSphere(32, [&](vec3 d, float angle) {
        const vec3 l = e.around(d) * angle;
        const std::array<float, 9> basis{1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
        for (size_t i = 0; i < 9; ++i) c[i] += l * basis[i];
    });
    // Squares of the basis' norms, times the share of the cosine lobe (1, 2/3, 1/4).
    constexpr std::array<float, 9> factor{1 / (4 * pi),   0.5f / pi,     0.5f / pi,      0.5f / pi,     15 / (16 * pi),
                                          15 / (16 * pi), 5 / (64 * pi), 15 / (16 * pi), 15 / (64 * pi)};
    for (size_t i = 0; i < 9; ++i) c[i] *= factor[i];
    return c;
}

glm::vec3 evaluate(const std::array<glm::vec3, 9>& c, glm::vec3 d)
{
    return c[0] + c[1] * d.y + c[2] * d.z + c[3] * d.x + c[4] * (d.x * d.y) + c[5] * (d.y * d.z) + c[6] * (3 * d.z * d.z - 1) + c[7] * (d.x * d.z) +
           c[8] * (d.x * d.x - d.y * d.y);
}

glm::vec3 cubeDirection(int face, glm::vec2 at)
{
    const vec3 d[] = {{1, -at.y, -at.x}, {-1, -at.y, at.x}, {at.x, 1, at.y}, {at.x, -1, -at.y}, {at.x, -at.y, 1}, {-at.x, -at.y, -1}};
    return glm::normalize(d[face]);
}

std::vector<glm::vec3> prefiltered(const Environment& e, int face, int level)
{
    const int side = environmentSide >> level;
    const float roughness = float(level) / float(environmentLevels - 1);
    const uint32_t samples = level == 1 ? 64 : 256;  // the first one is narrow, and has the most texels
    std::vector<vec3> out;
    out.reserve(size_t(side) * size_t(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vec3 d = cubeDirection(face, 2.f * (vec2(float(x), float(y)) + 0.5f) / float(side) - 1.f);
            out.push_back(level == 0 ? radiance(e, d) : mirrored(e, d, roughness, samples));
        }
    return out;
}

std::vector<glm::vec2> reflectanceTable()
{
    std::vector<vec2> out;
    for (int y = 0; y < reflectanceSide; ++y)
        for (int x = 0; x < reflectanceSide; ++x) {
            const float last = float(reflectanceSide - 1);
            out.push_back(reflectance(std::max(float(x) / last, 1e-3f), std::max(float(y) / last, 0.03f), 256));
        }
    return out;
}

}  // namespace mw
