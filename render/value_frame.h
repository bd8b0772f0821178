// One way of drawing a kind of value, for viewport, labs, pictures and gallery: the value as it stands, and the focus of a step on it.
#pragma once
#include "core/catalog/catalog.h"
#include "render/renderer.h"

namespace mw {

/// True for kinds that have a picture: meshes, height maps, curves, poses, rotations.
bool isDrawable(const Value& value);

/// Adds what shows `value` at a place of the world: surfaces, bones, polylines, the sphere of orientations. Tables and selections show nothing.
/// A height map stands on a square of side 1 round the origin.
void addValue(Frame& frame, const Value& value, NodeId node, const glm::dmat4& worldFromLocal);

/// The marks of a step's focus by role, shape as well as colour, whatever kind is stepped; elements that the value has not are passed over.
///   mesh        Vertex, Edge, Face, Corner
///   height map  Vertex: a sample, row * width + column; Edge: two samples; Cell: four samples, row * (width - 1) + column;
///               Point, Segment: (column, height, row)
///   curve       Vertex: a point; Edge: two points
///   pose        Joint; Edge: two joints
///   rotations   Point, Segment: on the unit sphere
void addFocus(Frame& frame, const StepRecord& step, const Value& value, NodeId node, const glm::dmat4& worldFromLocal);

/// Where the elements in focus are, in the world.
Bounds focusBounds(const StepRecord& step, const Value& value, const glm::dmat4& worldFromLocal);

}  // namespace mw
