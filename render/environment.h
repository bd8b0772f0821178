// Light from all round, made by formulas: what is mirrored, what falls on matt surfaces, and the key light that casts shadows. No GL here.
// World space, +Y up; radiance is linear, 1 shows white.
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace mw {

struct Environment {
    const char* name;   ///< "studio", ...
    const char* title;  ///< as the menu says it
    const char* about;
    glm::vec3 (*around)(glm::vec3 direction);  ///< radiance without the key light
    glm::vec3 (*key)(glm::vec3 direction);     ///< radiance of a key light with an extent, which is mirrored as seen; null: it is a point
    glm::vec3 keyDirection;                    ///< towards it, unit
    glm::vec3 keyLight;                        ///< what white sends back under it head on; of an extended one see keyOf()
};

std::span<const Environment> environments();
/// The one of that name; null when there is none.
const Environment* findEnvironment(std::string_view name);

/// What white sends back under the key light head on.
glm::vec3 keyOf(const Environment& e);
/// All that is seen in a direction but point lights.
glm::vec3 radiance(const Environment& e, glm::vec3 direction);

/// Light on matt white by its normal, without the key light, as nine coefficients of
/// 1, y, z, x, xy, yz, 3zz-1, xz, xx-yy (Ramamoorthi and Hanrahan 2001, factors folded in).
std::array<glm::vec3, 9> harmonicsOf(const Environment& e);
glm::vec3 evaluate(const std::array<glm::vec3, 9>& harmonics, glm::vec3 normal);

/// Mirrored light by roughness: level i is for roughness i / 5, its cube faces have environmentSide >> i texels a side.
inline constexpr int environmentSide = 128, environmentLevels = 6;
/// One face of a level, rows as the graphics card wants them (faces +X -X +Y -Y +Z -Z).
std::vector<glm::vec3> prefiltered(const Environment& e, int face, int level);
/// Towards a texel of a cube face; `at` in -1..1.
glm::vec3 cubeDirection(int face, glm::vec2 at);

/// Reflectance of a rough surface under even light is f0 * x + y; rows are roughness, columns the cosine to the normal, both 0 to 1.
inline constexpr int reflectanceSide = 32;
std::vector<glm::vec2> reflectanceTable();

}  // namespace mw
