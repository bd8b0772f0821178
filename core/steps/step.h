// One pause of an algorithm: the phase, the elements in focus, a few named numbers. Light, because algorithms make millions of them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace mw {

enum class ElementKind : uint8_t { Object, Vertex, Edge, Face, Corner, Point, Segment, Joint, Cell };
enum class Role : uint8_t { Current, Neighbour, New, Removed, Rejected };

/// An element in focus. Indices are payload indices of the value as it stands at this step. An edge is its two end vertices.
/// A Point or Segment is given by place, for things that are not (yet) elements.
struct Focus {
    ElementKind kind;
    Role role;
    const char* label;  ///< a letter of the formula shown beside the element ("v"), or null; static storage
    uint32_t index, other;
    glm::vec3 at, to;
};

/// A named number of a step. `name` has static storage; the lesson text says how it is shown.
struct Number {
    const char* name;
    double value;
};

/// Built by chained setters inside a co_yield: `co_yield Step("collapse").edge(a, b, Role::Current).number("cost", c);`
/// Owns nothing: spans and names must live until the algorithm is resumed. Whatever exceeds the fixed room is left out.
/// No aggregate, on purpose: g++ 12 miscompiles co_yield of owning aggregates, of ?: and of nested lists.
class Step {
public:
    static constexpr size_t maxFocus = 16, maxNumbers = 24, maxRings = 4;

    explicit Step(const char* phase) : phase_(phase) {}

    Step&& vertex(uint32_t v, Role r, const char* label = nullptr) && { return focus({ElementKind::Vertex, r, label, v, 0, {}, {}}); }
    Step&& edge(uint32_t a, uint32_t b, Role r, const char* label = nullptr) && { return focus({ElementKind::Edge, r, label, a, b, {}, {}}); }
    Step&& face(uint32_t f, Role r, const char* label = nullptr) && { return focus({ElementKind::Face, r, label, f, 0, {}, {}}); }
    Step&& point(glm::vec3 p, Role r, const char* label = nullptr) && { return focus({ElementKind::Point, r, label, 0, 0, p, {}}); }
    Step&& segment(glm::vec3 a, glm::vec3 b, Role r, const char* label = nullptr) && { return focus({ElementKind::Segment, r, label, 0, 0, a, b}); }
    Step&& element(ElementKind k, uint32_t i, Role r, const char* label = nullptr) && { return focus({k, r, label, i, 0, {}, {}}); }
    /// Many elements of one kind and role; edges as pairs of vertices.
    Step&& ring(ElementKind kind, Role role, std::span<const uint32_t> indices) &&
    {
        if (rings_ < maxRings) ring_[rings_++] = {kind, role, indices};
        return std::move(*this);
    }
    Step&& number(const char* name, double value) &&
    {
        if (numbers_ < maxNumbers) number_[numbers_++] = {name, value};
        return std::move(*this);
    }
    /// Share of the whole run done, 0 to 1.
    Step&& progress(double p) &&
    {
        progress_ = float(p);
        return std::move(*this);
    }

    struct Ring {
        ElementKind kind;
        Role role;
        std::span<const uint32_t> indices;
    };
    const char* phase() const { return phase_; }
    std::span<const Focus> focus() const { return {focus_.data(), focuses_}; }
    std::span<const Ring> rings() const { return {ring_.data(), rings_}; }
    std::span<const Number> numbers() const { return {number_.data(), numbers_}; }
    float progress() const { return progress_; }

private:
    Step&& focus(const Focus& f)
    {
        if (focuses_ < maxFocus) focus_[focuses_++] = f;
        return std::move(*this);
    }
    const char* phase_;
    float progress_ = -1;  // negative: as before
    uint32_t focuses_ = 0, rings_ = 0, numbers_ = 0;
    // Left uninitialised: a step costs only what is put into it.
    std::array<Focus, maxFocus> focus_;
    std::array<Ring, maxRings> ring_;
    std::array<Number, maxNumbers> number_;
};

}  // namespace mw
