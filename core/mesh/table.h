// Rows of numbers about a mesh: what queries and metrics give. Bound to vertices, edges or faces it is a heat map.
#pragma once
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/steps/step.h"

namespace mw {

struct Column {
    std::string name, unit;
    Array<double> values;      ///< one a row; NaN where undefined
    bool categorical = false;  ///< colours tell apart, they do not rank (strip numbers)
};

/// `rows` says what a row is: Vertex, Face (payload indices 0..n-1), Edge (then `edges` has the vertex pairs) or Object (free rows).
struct Table {
    ElementKind rows = ElementKind::Object;
    std::vector<Column> columns;  ///< the first one is shown as heat map unless asked otherwise
    Array<uint32_t> edges;
    std::vector<std::pair<std::string, double>> summary;               ///< a few numbers about the whole
    std::vector<std::pair<std::string, std::vector<uint32_t>>> lists;  ///< index lists that are part of the result (strips)
};

size_t byteSize(const Table& t);
uint64_t contentHash(const Table& t);

/// A set of elements of one mesh.
struct ElementSet {
    ElementKind kind = ElementKind::Vertex;
    std::vector<uint32_t> indices;  ///< ascending; for edges pairs of vertices, flattened
};

size_t byteSize(const ElementSet& s);
uint64_t contentHash(const ElementSet& s);

}  // namespace mw
