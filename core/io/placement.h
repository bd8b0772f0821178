// Units and axes: how the numbers of a file become metres with +Y up and back, and the words for it in files, on the command line and in the window.
#pragma once
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/io.h"

namespace mw {

/// Metres with +Y up from the numbers of a file, and back. Turns are by whole quarters, so that nothing is rounded but by the scale.
glm::dmat4 sceneFromFile(const Placement& p);
glm::dmat4 fileFromScene(const Placement& p);

/// "mm", "cm", "m", "km", "in", "ft", their names in either spelling and number ("millimeters"), or how many metres a unit is ("0.01", "1e-3 m").
std::optional<double> metresOf(std::string_view unit);
/// "y", "z", "x", also "+Z", "z-up", "Z_UP".
std::optional<UpAxis> upAxisOf(std::string_view axis);

std::string unitText(double metresPerUnit);  ///< "millimetres", or "units of 0.3 m"
const char* upText(UpAxis up);               ///< "y", "z", "x"

/// What comments of a file clearly say: "units: mm", "File units = centimeters", "up axis: z", "Z up".
struct Stated {
    std::optional<double> metresPerUnit;
    std::optional<UpAxis> up;
    void listen(std::string_view comment);
    /// Into what was read: nothing where nothing was said.
    void tell(Imported& in) const;
};
/// A comment that Stated understands: "units: metres, up: y".
std::string statement(const Placement& p);

}  // namespace mw
