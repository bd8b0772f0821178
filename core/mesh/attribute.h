// Named data on the vertices, corners or faces of a mesh, and the one way in which operations carry it.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/mesh/array.h"

namespace mw {

enum class Domain : uint8_t { Vertex, Corner, Face };

/// How a file stored a number; writers use it to write it back as it was.
enum class Scalar : uint8_t { Float32, Float64, Int8, UInt8, Int16, UInt16, Int32, UInt32 };

/// Well-known names. Anything else is a property of the file's, carried along.
///   normal    3, corner (files) or vertex          texcoord  2, corner; further sets texcoord1, texcoord2, ...; v up (as OBJ)
///   color     3 or 4, vertex or corner, 0 to 1 linear RGB(A); color1, ...   tangent 4, corner
///   joints    4n integers, vertex, with weights    4n, vertex, summing to 1; slots of a skin
///   morph:NAME  3, vertex: displacement of the position at weight 1; morph-normal:NAME 3, corner
///   material  1 integer, face: slot of the mesh object, 0 where absent     group 1 integer, face: index into Mesh::groupNames
///   crease    1, corner: sharpness of the edge from this corner to the next, 0 smooth, >= 1 infinitely sharp
namespace names {
inline constexpr std::string_view normal = "normal", texcoord = "texcoord", color = "color", tangent = "tangent", joints = "joints",
                                  weights = "weights", material = "material", group = "group", crease = "crease", morph = "morph:";
}

/// `components` numbers an element, one after the other. Integers are kept exactly; doubles where a file has doubles.
struct Attribute {
    std::string name;
    Domain domain = Domain::Vertex;
    int components = 1;
    std::variant<Shared<float>, Shared<double>, Shared<int32_t>> values;
    Scalar stored = Scalar::Float32;

    size_t size() const;  ///< elements
    bool integral() const { return std::holds_alternative<Shared<int32_t>>(values); }
    /// Any type as double.
    double at(size_t element, int component) const;
    /// The floats; empty span when stored otherwise.
    std::span<const float> floats() const;
    std::span<const int32_t> integers() const;
    const void* id() const;
    size_t bytes() const;
};

Attribute floatAttribute(std::string name, Domain domain, int components, Array<float> values);
Attribute integerAttribute(std::string name, Domain domain, int components, Array<int32_t> values);

/// Row i of a sparse matrix says how new element i is mixed from old ones: sum over k in [start[i], start[i+1]) of
/// weight[k] * old[source[k]]. Weights of a row sum to 1 unless the operation says otherwise.
struct Stencils {
    Array<uint32_t> start{0u};
    Array<uint32_t> source;
    Array<float> weight;

    size_t size() const { return start.size() - 1; }
    void add(uint32_t s, double w)
    {
        source.push_back(s);
        weight.push_back(float(w));
    }
    void endRow() { start.push_back(uint32_t(source.size())); }
};

/// Mixes by rows. Integers are not mixed: the source of greatest weight wins. Normals and tangents are made unit again.
Attribute blended(const Attribute& a, const Stencils& rows);
/// New element i is old element from[i].
Attribute gathered(const Attribute& a, std::span<const uint32_t> from);
/// joints and weights together: lists are merged, the strongest `slots` kept, weights made to sum to 1.
struct SkinWeights {
    Attribute joints, weights;
};
SkinWeights blendedSkin(const Attribute& joints, const Attribute& weights, const Stencils& rows);

}  // namespace mw
