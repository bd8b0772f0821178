// The camera of a view: it turns about a point, up stays up.
#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

namespace mw {

struct Ray {
    glm::dvec3 origin, direction;  ///< direction is unit
};

/// World space, +Y up. Angles in radians.
struct Camera {
    glm::dvec3 target{0};
    double distance = 5;
    double azimuth = 0.6, elevation = 0.35;  ///< 0, 0 looks along -Z (front view)
    double fieldOfView = 0.7;                ///< vertical
    bool perspective = true;
    double nearClip = 0.01, farClip = 1000;  ///< kept by fitClip()

    bool operator==(const Camera&) const = default;
    glm::dvec3 eye() const;
    glm::dmat4 viewFromWorld() const;
    glm::dmat4 clipFromView(double aspect) const;
    /// Pixel coordinates, origin top left.
    Ray ray(glm::dvec2 pixel, glm::dvec2 size) const;
    glm::dvec3 project(glm::dvec3 world, glm::dvec2 size) const;  ///< pixel x, y and depth 0..1

    void frame(const Bounds& bounds, double aspect);  ///< all of it in view, direction kept
    void fitClip(const Bounds& scene);
    void orbit(glm::dvec2 pixels, glm::dvec3 about);  ///< keeps `about` where it is on screen
    void pan(glm::dvec2 pixels, glm::dvec2 size);
    void zoom(double steps, glm::dvec2 pixel, glm::dvec2 size);  ///< towards the cursor
};

/// Collects points and then moves a camera, without turning it, to where it sees all of them as large as can be.
class CameraFit {
public:
    CameraFit(const Camera& camera, double aspect);
    void add(glm::dvec3 world);
    /// A camera that was given no point stays as it is.
    void apply(Camera& camera) const;

private:
    glm::dvec2 slopeOf(size_t k) const { return slope_ * (double(k + 1) / double(slopes)); }
    glm::dmat3 viewFromWorld_;  // rotation alone
    bool perspective_;
    glm::dvec2 slope_;  // of the sides of the view, or the aspect alone when parallel
    // How far points reach towards the upper and the lower side, x and y, for sides of k / 16 of the slope: what does not fill the view
    // one way is put into the middle of it, and where that is depends on how steeply it is seen.
    static constexpr size_t slopes = 16;
    std::array<glm::dvec2, slopes> right_{}, left_{};
    double front_ = 0, back_ = 0;
    bool empty_ = true;
};

/// "front", "back", "left", "right", "top", "bottom", or "azimuth,elevation" in degrees. False when it is neither.
bool setView(Camera& camera, std::string_view view);

}  // namespace mw
