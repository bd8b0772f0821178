#include "core/catalog/cost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace mw {
namespace {

/// Of an operation at a size: nanoseconds, faces that come out, bytes beyond input and output.
struct Estimate {
    double nanoseconds, faces, workBytes;
};

double numberOf(const Operation& op, const ParameterValues& values, const char* name, double ifNone)
{
    for (const Parameter& p : op.parameters) {
        if (p.name != name) continue;
        const ParameterValue v = valueOf(p, values);
        if (const auto* whole = std::get_if<int64_t>(&v)) return double(*whole);
        if (const auto* real = std::get_if<double>(&v)) return *real;
    }
    return ifNone;
}

bool chosen(const Operation& op, const ParameterValues& values, const char* name, const char* choice)
{
    for (const Parameter& p : op.parameters)
        if (p.name == name) return valueOf(p, values) == ParameterValue(std::string(choice));
    return false;
}

// The heap of the textbook makes it n log n. How far an error carries is not known beforehand: half the faces, say.
Estimate decimation(const Operation& op, double n, const ParameterValues& values)
{
    double left = numberOf(op, values, "ratio", 0.5) * n;
    if (chosen(op, values, "stop", "faces")) left = numberOf(op, values, "faces", left);
    if (chosen(op, values, "stop", "error")) left = 0.5 * n;
    left = std::clamp(left, 0.0, n);
    // The quick qualities are linear but for caches, which end at some ten thousand faces.
    const double caches = 1 + 0.05 * std::log2(n / 1e4 + 1);
    const double each = chosen(op, values, "quality", "fast") ? 500 : chosen(op, values, "quality", "best") ? 1000 : 750;
    if (!chosen(op, values, "quality", "textbook")) return {caches * (n * 200 + (n - left) * each), left, 130 * n};
    return {n * 150 + (n - left) * 150 * std::log2(n + 2), left, 200 * n};
}

// Each level makes four of one (sqrt(3): three; n-adic: n^2); all levels count.
Estimate subdivision(const Operation& op, double n, const ParameterValues& values)
{
    const double parts = numberOf(op, values, "n", 2), factor = op.id == "subdivide-sqrt3" ? 3 : parts * parts;
    const double out = n * std::pow(factor, std::clamp(numberOf(op, values, "levels", 1), 1.0, 12.0));
    // A face of the result, and one of the input where its edges are found first.
    if (op.id == "subdivide-loop") return {130 * n + 24 * (out - n), out, 36 * out};
    if (op.id == "subdivide-catmull-clark") return {130 * n + 45 * (out - n), out, 36 * out};
    static const std::map<std::string, double> perFace{
        {"split-dyadic", 80}, {"split-nadic", 260}, {"subdivide-butterfly", 300}, {"subdivide-sqrt3", 160}};
    const auto known = perFace.find(op.id);
    return {(known == perFace.end() ? 100 : known->second) * (out - n) * factor / (factor - 1), out, 60 * out};
}

Estimate smoothing(const Operation& op, double n, const ParameterValues& values)
{
    const double round = chosen(op, values, "weights", "cotangent") ? 61 : 36, half = chosen(op, values, "method", "laplacian") ? 0.6 : 1;
    return {n * (276 + numberOf(op, values, "iterations", 10) * round * half), n, 120 * n};
}

// Factors of n^1.5 operations; sweeps go on until they settle, which takes the more of them the larger the mesh.
Estimate planarEmbedding(const Operation& op, double n, const ParameterValues& values)
{
    if (chosen(op, values, "solver", "direct")) return {n * (700 + 0.7 * std::sqrt(n)), n, 800 * n};
    const double sweeps = std::min(numberOf(op, values, "iterations", 10000), 0.4 * n);
    return {n * (300 + 10 * sweeps), n, 250 * n};
}

Estimate sphericalEmbedding(const Operation& op, double n, const ParameterValues& values)
{
    return {n * (3300 + 60 * numberOf(op, values, "iterations", 50)), n, 400 * n};
}

// An overlay of two meshes of about the same size has some four to five times as many faces; the others keep theirs.
Estimate morphing(const Operation& op, double n, const ParameterValues& values)
{
    for (const char* method : {"corresponding", "cylinder-torus", "sphere-torus"})
        if (chosen(op, values, "method", method)) return {200 * n, n, 100 * n};
    return {18000 * n, 4.5 * n, 1400 * n};
}

Estimate estimate(const Operation& op, double n, const ParameterValues& values)
{
    if (op.id == "decimate-quadric") return decimation(op, n, values);
    if (op.category == "Subdivide") return subdivision(op, n, values);
    if (op.id == "smooth") return smoothing(op, n, values);
    if (op.id == "embed-planar") return planarEmbedding(op, n, values);
    if (op.id == "embed-spherical") return sphericalEmbedding(op, n, values);
    if (op.id == "morph") return morphing(op, n, values);
    static const std::map<std::string, double> perFace{{"weld", 80},     {"repair", 340},  {"orient", 190},  {"fill-holes", 350},
                                                       {"normalise", 3}, {"reorder", 200}, {"normals", 150}, {"decimate-vertices", 2500},
                                                       {"cut", 1000}};
    const auto known = perFace.find(op.id);
    return {n * (known == perFace.end() ? 300 : known->second), n, 100 * n};
}

}  // namespace

MeshSize sizeOf(const Mesh& mesh)
{
    size_t bytes = mesh.positions().bytes() + mesh.faceStart().bytes() + mesh.cornerVertex().bytes() + mesh.lines().bytes();
    for (const Attribute& a : mesh.attributes()) bytes += a.bytes();
    return {mesh.faceCount(), bytes};
}

std::optional<Cost> expectedCost(const Operation& op, MeshSize input, const ParameterValues& values, const CostRecord* record)
{
    if (op.accepts != Kind::Mesh || op.yields != Kind::Mesh) return std::nullopt;
    const double n = double(input.faces);
    const Estimate e = estimate(op, n, values);
    const double outBytes = double(input.bytes) * (n > 0 ? e.faces / n : 1);
    Cost cost;
    cost.seconds = 1e-9 * e.nanoseconds * (record ? record->factor(op.id) : 1);
    cost.bytes = e.workBytes + outBytes;
    cost.result = {size_t(std::min(e.faces, 1e15)), size_t(std::min(outBytes, 1e18))};
    return cost;
}

void CostRecord::learn(const Operation& op, MeshSize input, const ParameterValues& values, double seconds)
{
    const auto told = expectedCost(op, input, values);
    if (!told || !(seconds > 0.02) || !(told->seconds > 0) || !std::isfinite(seconds)) return;  // too short to tell anything
    const double ratio = std::clamp(std::log(seconds / told->seconds), std::log(0.05), std::log(20.0));
    const auto [i, first] = logs_.try_emplace(op.id, ratio);
    if (!first) i->second += 0.4 * (ratio - i->second);
}

double CostRecord::factor(const std::string& operation) const
{
    const auto i = logs_.find(operation);
    return i == logs_.end() ? 1 : std::exp(i->second);
}

std::string CostRecord::text() const
{
    return nlohmann::json(logs_).dump();
}

CostRecord CostRecord::fromText(const std::string& text)
{
    CostRecord record;
    const nlohmann::json j = nlohmann::json::parse(text, nullptr, false);
    if (!j.is_object()) return record;
    for (const auto& [id, log] : j.items())
        if (log.is_number() && record.logs_.size() < 1000) record.logs_[id] = std::clamp(log.get<double>(), std::log(0.05), std::log(20.0));
    return record;
}

std::string costText(const Cost& cost)
{
    if (cost.seconds < 0.5 && cost.bytes < 1e9) return {};
    char text[80];
    const double s = cost.seconds;
    if (s < 9.5)
        std::snprintf(text, sizeof text, "about %.1g s", s);
    else if (s < 99)
        std::snprintf(text, sizeof text, "about %.0f s", s);
    else if (s < 5400)
        std::snprintf(text, sizeof text, "about %.0f min", s / 60);
    else
        std::snprintf(text, sizeof text, "about %.0f h", s / 3600);
    std::string out = text;
    if (cost.bytes < 1e9) return out;
    std::snprintf(text, sizeof text, ", %.2g GB", cost.bytes / 1e9);
    return out + text;
}

}  // namespace mw
