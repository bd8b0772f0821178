// The camera's mathematics: one rotation by two angles, and moves that keep the right point where it is on screen.
#include "render/camera.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <optional>
#include <string_view>

namespace mw {
namespace {

constexpr double halfTurn = std::numbers::pi;
constexpr double nearest = 1e-6, farthest = 1e9;

/// The camera's axes in world space: x right, y up, z from the target to the eye.
struct Axes {
    glm::dvec3 right, up, back;
};

Axes axesOf(const Camera& c)
{
    const double sa = std::sin(c.azimuth), ca = std::cos(c.azimuth), se = std::sin(c.elevation), ce = std::cos(c.elevation);
    return {{ca, 0, -sa}, {-sa * se, ce, -ca * se}, {sa * ce, se, ca * ce}};
}

double halfHeight(const Camera& c)
{
    return c.distance * std::tan(0.5 * c.fieldOfView);
}

std::array<glm::dvec3, 8> corners(const Bounds& b)
{
    std::array<glm::dvec3, 8> r;
    for (int i = 0; i < 8; ++i) r[size_t(i)] = {i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
    return r;
}

std::optional<double> number(std::string_view text)
{
    double v = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(v)) return {};
    return v;
}

}  // namespace

glm::dvec3 Camera::eye() const
{
    return target + distance * axesOf(*this).back;
}

glm::dmat4 Camera::viewFromWorld() const
{
    const Axes a = axesOf(*this);
    glm::dmat4 m(1);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = a.right[i];
        m[i][1] = a.up[i];
        m[i][2] = a.back[i];
    }
    m[3] = {-glm::dot(a.right, target), -glm::dot(a.up, target), -glm::dot(a.back, target) - distance, 1};
    return m;
}

glm::dmat4 Camera::clipFromView(double aspect) const
{
    if (perspective) return glm::perspective(fieldOfView, aspect, nearClip, farClip);
    const double h = halfHeight(*this);
    return glm::ortho(-h * aspect, h * aspect, -h, h, nearClip, farClip);
}

Ray Camera::ray(glm::dvec2 pixel, glm::dvec2 size) const
{
    const Axes a = axesOf(*this);
    const glm::dvec2 ndc{2 * pixel.x / size.x - 1, 1 - 2 * pixel.y / size.y};
    const glm::dvec2 at = ndc * halfHeight(*this) * glm::dvec2(size.x / size.y, 1);  // on the plane through the target
    const glm::dvec3 point = target + at.x * a.right + at.y * a.up;
    if (perspective) return {eye(), glm::normalize(point - eye())};
    return {point + distance * a.back, -a.back};
}

glm::dvec3 Camera::project(glm::dvec3 world, glm::dvec2 size) const
{
    const glm::dvec4 c = clipFromView(size.x / size.y) * viewFromWorld() * glm::dvec4(world, 1);
    const glm::dvec3 ndc = glm::dvec3(c) / c.w;
    return {0.5 * (ndc.x + 1) * size.x, 0.5 * (1 - ndc.y) * size.y, 0.5 * (ndc.z + 1)};
}

CameraFit::CameraFit(const Camera& camera, double aspect) : viewFromWorld_(camera.viewFromWorld()), perspective_(camera.perspective)
{
    constexpr double margin = 1.08;
    slope_ = std::tan(0.5 * camera.fieldOfView) / margin * glm::dvec2(aspect, 1);
}

void CameraFit::add(glm::dvec3 world)
{
    const glm::dvec3 p = viewFromWorld_ * world;
    // A side of the view is x = slope * (eye - z): a point needs the eye's x + slope * z to be at least its own.
    for (size_t k = 0; k < slopes; ++k) {
        const glm::dvec2 shear = perspective_ ? slopeOf(k) * p.z : glm::dvec2(0);
        const glm::dvec2 r = glm::dvec2(p) + shear, l = -glm::dvec2(p) + shear;
        right_[k] = empty_ ? r : glm::max(right_[k], r);
        left_[k] = empty_ ? l : glm::max(left_[k], l);
    }
    front_ = empty_ ? p.z : std::max(front_, p.z);
    back_ = empty_ ? p.z : std::min(back_, p.z);
    empty_ = false;
}

void CameraFit::apply(Camera& camera) const
{
    if (empty_) return;
    const auto need = [&](size_t k) { return 0.5 * (right_[k] + left_[k]) / slopeOf(k); };
    const glm::dvec2 whole = need(slopes - 1);
    const double depth = 0.5 * (front_ + back_);
    const double eye = std::max(whole.x, whole.y) + (perspective_ ? 0 : depth);  // when parallel `need` is a size, not a place
    glm::dvec2 middle(0);
    for (int axis = 0; axis < 2; ++axis) {
        size_t k = slopes - 1;
        while (perspective_ && k > 0 && need(k - 1)[axis] <= eye) --k;  // the narrowest sides that hold it from there
        middle[axis] = 0.5 * (right_[k] - left_[k])[axis];
    }
    camera.target = glm::transpose(viewFromWorld_) * glm::dvec3(middle, depth);
    const double d = eye - depth;
    camera.distance = d > 0 ? std::clamp(d, nearest, farthest) : 1;  // a single point is shown from one unit away
}

void Camera::frame(const Bounds& bounds, double aspect)
{
    if (bounds.empty) return;
    CameraFit fit(*this, aspect);
    for (const glm::dvec3& corner : corners(bounds)) fit.add(corner);
    fit.apply(*this);
    fitClip(bounds);
}

void Camera::fitClip(const Bounds& scene)
{
    double low = distance, high = distance;
    if (!scene.empty) {
        const glm::dmat4 view = viewFromWorld();
        for (const glm::dvec3& corner : corners(scene)) {
            const double depth = -(view * glm::dvec4(corner, 1)).z;
            low = std::min(low, depth);
            high = std::max(high, depth);
        }
    }
    const double pad = 0.02 * (high - low) + 1e-3 * distance;
    farClip = std::max(high + pad, 4 * distance);  // room for the ground behind the model and before it
    nearClip = std::min(low - pad, perspective ? 0.08 * distance : -distance);
    if (perspective) nearClip = std::clamp(nearClip, 2e-4 * farClip, 0.5 * farClip);  // what a depth buffer can still tell apart
}

void Camera::orbit(glm::dvec2 pixels, glm::dvec3 about)
{
    constexpr double perPixel = 0.0085;
    const Axes before = axesOf(*this);
    const glm::dvec3 offset = about - target;
    const glm::dvec3 seen{glm::dot(offset, before.right), glm::dot(offset, before.up), glm::dot(offset, before.back)};
    azimuth = std::remainder(azimuth - perPixel * pixels.x, 2 * halfTurn);
    elevation = std::clamp(elevation + perPixel * pixels.y, -0.5 * halfTurn, 0.5 * halfTurn);
    const Axes after = axesOf(*this);
    target = about - (seen.x * after.right + seen.y * after.up + seen.z * after.back);
}

void Camera::pan(glm::dvec2 pixels, glm::dvec2 size)
{
    const Axes a = axesOf(*this);
    const double perPixel = 2 * halfHeight(*this) / size.y;
    target += perPixel * (pixels.y * a.up - pixels.x * a.right);
}

void Camera::zoom(double steps, glm::dvec2 pixel, glm::dvec2 size)
{
    const Axes a = axesOf(*this);
    const glm::dvec2 ndc{2 * pixel.x / size.x - 1, 1 - 2 * pixel.y / size.y};
    const glm::dvec2 at = ndc * halfHeight(*this) * glm::dvec2(size.x / size.y, 1);
    const glm::dvec3 fixed = target + at.x * a.right + at.y * a.up;
    const double wanted = std::clamp(distance * std::pow(0.87, steps), nearest, farthest);
    // Shrinking the whole camera about that point leaves the ray under the cursor where it is.
    target = fixed + (target - fixed) * (wanted / distance);
    distance = wanted;
}

bool setView(Camera& camera, std::string_view view)
{
    struct Named {
        std::string_view name;
        double azimuth, elevation;
    };
    static constexpr Named named[] = {{"front", 0, 0}, {"back", 180, 0}, {"left", -90, 0}, {"right", 90, 0}, {"top", 0, 90}, {"bottom", 0, -90}};
    constexpr double degree = halfTurn / 180;
    for (const Named& n : named) {
        if (n.name != view) continue;
        camera.azimuth = n.azimuth * degree;
        camera.elevation = n.elevation * degree;
        return true;
    }
    const size_t comma = view.find(',');
    if (comma == std::string_view::npos) return false;
    const auto azimuth = number(view.substr(0, comma)), elevation = number(view.substr(comma + 1));
    if (!azimuth || !elevation || std::abs(*elevation) > 90) return false;
    camera.azimuth = std::remainder(*azimuth * degree, 2 * halfTurn);
    camera.elevation = *elevation * degree;
    return true;
}

}  // namespace mw
