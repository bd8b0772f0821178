// Values of every kind as files, and curves out of them.
#pragma once
#include <string>
#include <vector>

#include "core/catalog/catalog.h"
#include "core/steps/progress.h"

namespace mw::cli {

/// Throws Error naming the endings when a value of this kind cannot be written as that file; before any work is done.
void checkValueFile(Kind kind, const std::string& file);

/// By kind and ending: height maps as pictures (.png) or whatever a terrain can be written as; curves, poses and rotations as .json or .csv,
/// curves as lines of a mesh, too; meshes and tables as ever. All or nothing. Gives what the format could not hold.
std::vector<Warning> writeValueFile(const std::string& file, const std::string& operation, const Value& value, Progress* progress);

/// What a value is, in few words: "5 joints, the end 0.0004 m from its target".
std::string summaryOf(const Value& value);

/// Points from .csv: x,y or x,y,z a line, perhaps with a line of titles. Throws Error.
Curve readCurveFile(const std::string& file);

}  // namespace mw::cli
