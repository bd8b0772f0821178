// One way of drawing a kind of value, for viewport, labs, pictures and gallery: the value as it stands, and the focus of a step on it.
#pragma once
#include "core/catalog/catalog.h"
#include "render/renderer.h"

namespace mw {

/// Adds what shows `value` at a place of the world: surfaces, bones, polylines, the sphere of orientations. Tables and selections show nothing.
void addValue(Frame& frame, const Value& value, NodeId node, const glm::dmat4& worldFromLocal);
/// The marks of a step's focus, whatever kind is stepped; elements that the value has not are passed over.
void addFocus(Frame& frame, const StepRecord& step, const Value& value, NodeId node, const glm::dmat4& worldFromLocal);

}  // namespace mw
