// The one list of operations. Modifier stack, menus, step player, lessons and command line read it; nothing else knows an algorithm.
#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/catalog/parameters.h"
#include "core/character/pose.h"
#include "core/math/rotations.h"
#include "core/mesh/curve.h"
#include "core/mesh/mesh.h"
#include "core/mesh/table.h"
#include "core/steps/progress.h"
#include "core/steps/stage.h"
#include "core/terrain/height_map.h"

namespace mw {

/// What operations accept and yield. Mesh to Mesh is a modifier, Nothing to X a source, X to Table or Selection a query.
enum class Kind { Nothing, Mesh, Curve, HeightMap, Patches, Clip, Pose, Rotations, Selection, Table };
const char* kindName(Kind k);  ///< "mesh", "height-map", ...

/// A value of one of those kinds. Kinds that have no type yet are added with their first operation.
using Value = std::variant<std::monostate, Mesh, ElementSet, Table, HeightMap, Curve, Pose, Rotations>;
Kind kindOf(const Value& v);
Value valueOf(const Snapshot& s);
uint64_t contentHash(const Value& v);

/// What happens to the attributes of a domain; the contract test checks that it is true.
enum class Carried {
    Same,      ///< elements keep their values
    Stencil,   ///< mixed with the operation's own weights
    Surface,   ///< read off the old surface (barycentric)
    Gathered,  ///< each new element takes those of one old one
    Dropped,
    NotApplicable
};
struct AttributePolicy {
    Carried vertex = Carried::NotApplicable, corner = Carried::NotApplicable, face = Carried::NotApplicable;
};

/// The meshes that parameters of type object stand for, by parameter name (core/catalog/others.h looks them up).
using Others = std::map<std::string, Mesh, std::less<>>;

struct Operation {
    std::string id, title;     ///< "decimate-quadric", "Simplify by quadrics"
    std::string section = {};  ///< of the book: "3.1.3"; empty when it is not in the book
    std::string summary;       ///< one line: what it does
    std::string category;      ///< menu and popup: "Simplify", "Subdivide", "Repair", "Primitives", "Query", ...
    Kind accepts = Kind::Mesh, yields = Kind::Mesh;
    bool steps = false;  ///< worth stepping: a lesson file resources/lessons/ID.json exists
    AttributePolicy attributes = {};
    std::string source;  ///< its file: "core/simplify/decimate_quadric.cpp"
    std::vector<Parameter> parameters = {};
    /// Starts it. `input` is of kind `accepts`, `values` have been checked().
    std::function<std::unique_ptr<Run>(const Value& input, const ParameterValues& values, const Others& others, bool watched)> start = {};
};

/// All operations, in menu order.
std::span<const Operation> catalog();
/// Null when there is none.
const Operation* findOperation(std::string_view id);
/// Throws Error that lists what is near.
const Operation& operation(std::string_view id);

/// Checks kind and parameters, runs to the end, nobody watching. Throws Error, Cancelled. `input` is never changed.
Value apply(const Operation& op, const Value& input, const ParameterValues& values, Progress* progress = nullptr, const Others& others = {});
/// For Stepper: checks, then starts as often as asked.
StartRun stepping(const Operation& op, Value input, const ParameterValues& values, Others others = {});

}  // namespace mw
