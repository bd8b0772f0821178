// What an operation will take, told before it runs: time and memory, from the size of the mesh and the values.
//
// The defaults were measured with tests/bench/cost_check.cpp (one core of a server of 2020, g++ -O2) on real meshes of three sizes without
// attributes: bust and bunny (10,540 and 69,451 faces), armadillo (86,482), dragon (871,414). For each operation they are nanoseconds of processor
// time a unit of work; a unit is a face made or removed, or a face visited in a round. Memory is the peak beyond the input. There, what was told is
// within a factor of 2 of what was taken from 10 thousand to 1 million faces. Another machine, or attributes, shift the time: a CostRecord learns by
// how much from the runs that were made.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "core/catalog/catalog.h"

namespace mw {

struct MeshSize {
    size_t faces = 0, bytes = 0;
};
MeshSize sizeOf(const Mesh& mesh);

struct Cost {
    double seconds = 0;
    double bytes = 0;      ///< peak beyond the input
    MeshSize result = {};  ///< what the next operation will have
    bool heavy() const { return seconds > 10 || bytes > 2e9; }
};

/// How much slower or quicker runs were than the defaults tell, by operation. A value; kept between sessions as text.
class CostRecord {
public:
    void learn(const Operation& op, MeshSize input, const ParameterValues& values, double seconds);
    /// 1 until something was learnt; 0.05 to 20.
    double factor(const std::string& operation) const;
    std::string text() const;
    static CostRecord fromText(const std::string& text);  ///< of text that is none: an empty record

private:
    std::map<std::string, double> logs_;  // mean of the logarithms of ratios, the last runs counting most
};

/// Nothing for operations that take no mesh to a mesh. `values` are checked() or fewer.
std::optional<Cost> expectedCost(const Operation& op, MeshSize input, const ParameterValues& values, const CostRecord* record = nullptr);
/// "about 14 s", "about 14 s, 2.1 GB" from a gigabyte on; empty under half a second.
std::string costText(const Cost& cost);

}  // namespace mw
