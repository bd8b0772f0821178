#include "app/cli/worklist.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "core/mesh/topology.h"

namespace mw::cli {

namespace {

std::string callOf(const Defect& d)
{
    return d.repair + (d.repairParameters.empty() ? "" : ":" + d.repairParameters);
}

size_t elements(const Defect& d)
{
    size_t n = 0;
    for (const ElementSet& s : d.offenders) n += s.indices.size() / (s.kind == ElementKind::Edge ? 2 : 1);
    return n;
}

/// "5 holes of 223 edges"
std::string countOf(const Mesh& mesh, const Defect& d)
{
    const size_t n = d.offenders.size();
    if (d.id == "nonmanifold-edges") return counted(n, "edge has", "edges have") + " more than two faces";
    if (d.id == "nonmanifold-vertices") return counted(n, "vertex joins", "vertices join") + " more than one fan of faces";
    if (d.id == "coincident-vertices") return counted(elements(d), "vertex", "vertices") + " at " + counted(n, "place");
    if (d.id == "degenerate-faces") return counted(n, "face has", "faces have") + " fewer than three corners or a vertex twice";
    if (d.id == "duplicate-faces") return counted(n, "face has", "faces have") + " the same vertices as an earlier one";
    if (d.id == "orientation" && !mesh.topology().orientable) return "the surface has one side only";
    if (d.id == "orientation") return counted(n, "edge has", "edges have") + " neighbouring faces that face opposite ways";
    if (d.id == "self-intersections") return counted(elements(d), "face intersects", "faces intersect") + " others, in " + counted(n, "group");
    if (d.id == "tiny-components") return counted(n, "tiny component") + " of " + counted(elements(d), "face");
    if (d.id == "holes") return counted(n, "hole") + " with " + counted(elements(d), "edge");
    if (d.id == "isolated-vertices") return counted(n, "vertex belongs", "vertices belong") + " to no face";
    return counted(n, "offender") + " (" + d.title + ")";
}

/// The first few, to look at: of each offender its first element.
std::string someOf(const Defect& d)
{
    std::string out;
    for (size_t i = 0; i < std::min<size_t>(d.offenders.size(), 5); ++i) {
        const ElementSet& s = d.offenders[i];
        out += (i ? ", " : "") + std::to_string(s.indices[0]);
        if (s.kind == ElementKind::Edge) out += "-" + std::to_string(s.indices[1]);
    }
    return out + (d.offenders.size() > 5 ? ", ..." : "");
}

const char* kindOf(const Defect& d)
{
    const ElementKind kind = d.offenders[0].kind;
    return kind == ElementKind::Edge ? "edge" : kind == ElementKind::Face ? "face" : "vertex";
}

}  // namespace

nlohmann::json defectsJson(const std::vector<Defect>& defects)
{
    nlohmann::json out = nlohmann::json::array();
    for (const Defect& d : defects)
        out.push_back({{"id", d.id}, {"count", d.offenders.size()}, {"repair", d.repair.empty() ? nlohmann::json() : nlohmann::json(callOf(d))}});
    return out;
}

bool printWorklist(const Mesh& mesh, const std::vector<Defect>& defects)
{
    bool any = false;
    for (const Defect& d : defects) {
        if (d.passed()) continue;
        any = true;
        std::cout << "  - " << countOf(mesh, d) << " (at " << kindOf(d) << " " << someOf(d) << ")\n    " << d.explanation << '\n';
        if (!d.repair.empty()) std::cout << "    --op " << callOf(d) << '\n';
    }
    return any;
}

std::vector<std::string> repairCalls(const std::vector<Defect>& defects)
{
    // One repair does what several defects ask of it.
    std::vector<std::string> calls;
    std::string repair;
    for (const Defect& d : defects)
        if (!d.passed() && d.repair == "repair") {
            repair = repair.empty() ? "repair" : repair;
            if (!d.repairParameters.empty()) repair += (repair == "repair" ? ":" : ",") + d.repairParameters;
        }
    if (!repair.empty()) calls.push_back(repair);
    for (const Defect& d : defects)
        if (!d.passed() && !d.repair.empty() && d.repair != "repair") calls.push_back(callOf(d));
    return calls;
}

}  // namespace mw::cli
