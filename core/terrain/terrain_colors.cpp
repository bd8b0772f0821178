// The middle colours and bands of resources/shaders/terrain.frag.
#include "core/terrain/terrain_colors.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace mw {

namespace {

constexpr glm::dvec3 grass(0.1195, 0.1820, 0.0490), rock(0.1811, 0.1635, 0.1461), sand(0.3355, 0.2645, 0.1465), snow(0.834, 0.8695, 0.911);
constexpr glm::dvec3 waterDeep(0.0120, 0.0620, 0.1420), waterShallow(0.0700, 0.2300, 0.3000), waterEdge(0.4, 0.47, 0.45);

double step(double from, double to, double x)
{
    const double w = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return w * w * (3 - 2 * w);
}

}  // namespace

glm::vec3 groundColor(const Terrain& t, double height, double rise)
{
    const double scale = t.maximumHeight != 0 ? t.maximumHeight : 1, h = height / scale, depth = (t.waterLevel - height) / std::abs(scale);
    if (depth > 0) {
        const glm::dvec3 body = glm::mix(waterShallow, waterDeep, 1 - std::exp(-9 * depth));
        return glm::vec3(glm::mix(waterEdge, body, step(0, 0.012, depth)));
    }
    const Terrain::Layers& l = t.layers;
    const double steepest = std::cos(l.rockSlope * std::numbers::pi / 180);
    glm::dvec3 c = glm::mix(sand, grass, step(l.sandTo - 0.02, l.sandTo + 0.02, h));
    c = glm::mix(c, rock, step(l.grassTo - 0.03, l.grassTo + 0.05, h));
    c = glm::mix(c, rock, 1 - step(steepest - 0.05, steepest + 0.05, rise));
    return glm::vec3(glm::mix(c, snow, step(l.snowFrom - 0.03, l.snowFrom + 0.06, h) * step(steepest - 0.30, steepest - 0.02, rise)));
}

}  // namespace mw
