// What lights a frame: three lights that go with the camera, or an environment; and where its key light casts shadows.
#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <map>

#include "render/environment.h"
#include "render/gl.h"

namespace mw {

struct DrawContext;

struct FrameLight {
    const Environment* environment = nullptr;  ///< null: three lights
    glm::dvec3 key{0, 1, 0};                   ///< towards the key light, world, unit
    bool shadows = false;                      ///< wanted, and there is something to cast them
    float groundShade = 0;                     ///< how much darker the ground is where the key light does not arrive
    glm::dmat4 shadowFromWorld{1};             ///< clip space of the shadow map
    double texel = 0;                          ///< of it, metres
};

/// Environments on the graphics card, made when first asked for (0.1 s each).
class EnvironmentTextures {
public:
    struct Made {
        gl::Texture mirrored;  ///< cube, rougher from level to level
        std::array<glm::vec3, 9> harmonics{};
        glm::vec3 key{0};
    };
    const Made& get(const Environment& e);
    GLuint reflectance();  ///< the table

private:
    std::map<const Environment*, Made> made_;
    gl::Texture reflectance_;
};

inline constexpr int shadowSide = 2048;
inline constexpr float softOnObjects = 2.5f, softOnGround = 14;  ///< radius of the edge of shadows, texels of the map

/// The light of the frame, and its block to the card.
void lightFrame(DrawContext& c);

}  // namespace mw
