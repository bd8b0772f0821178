// What every Mesh promises (core/mesh/mesh.h), as a check for tests of readers and operations.
#pragma once
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/mesh/mesh.h"

namespace mw::test {

inline ::testing::AssertionResult failed(const std::string& what)
{
    return ::testing::AssertionFailure() << what;
}

/// EXPECT_TRUE(checkMesh(mesh)): offsets ascend from 0, indices are in range, positions are finite, attributes have one value an element,
/// well-known attributes their form and finite numbers, groups a name.
inline ::testing::AssertionResult checkMesh(const Mesh& mesh)
{
    const auto start = mesh.faceStart().span();
    if (start.empty() && mesh.cornerCount() > 0) return failed("corners without faces");
    if (!start.empty() && start.front() != 0) return failed("face offsets do not begin with 0");
    if (!std::is_sorted(start.begin(), start.end())) return failed("face offsets do not ascend");
    if (!start.empty() && start.back() != mesh.cornerCount()) return failed("face offsets do not end at the number of corners");
    for (uint32_t v : mesh.cornerVertex())
        if (v >= mesh.vertexCount()) return failed("a corner is at vertex " + std::to_string(v) + " of " + std::to_string(mesh.vertexCount()));
    if (mesh.lines().size() % 2) return failed("an odd number of line ends");
    for (uint32_t v : mesh.lines())
        if (v >= mesh.vertexCount()) return failed("a line ends at vertex " + std::to_string(v) + " of " + std::to_string(mesh.vertexCount()));
    for (const glm::vec3& p : mesh.positions())
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return failed("a position is not finite");
    for (const Attribute& a : mesh.attributes()) {
        if (a.components < 1) return failed(a.name + " has no components");
        const size_t values = std::visit([](const auto& v) { return v.size(); }, a.values);
        if (values != mesh.count(a.domain) * size_t(a.components)) return failed(a.name + " has " + std::to_string(values) + " values");
        const bool known = a.name == names::normal || a.name == names::texcoord || a.name == names::color || a.name == names::tangent;
        if (known && a.floats().size() != values) return failed(a.name + " is not of floats");
        for (float v : a.floats())
            if (known && !std::isfinite(v)) return failed(a.name + " has a value that is not finite");
        if (a.name == names::normal && a.components != 3) return failed("normals without three components");
        if (a.name == names::texcoord && a.components != 2) return failed("texture coordinates without two components");
        if (a.name == names::color && a.components != 3 && a.components != 4) return failed("colours without three or four components");
        if (a.name == names::group && a.domain == Domain::Face)
            for (int32_t g : a.integers())
                if (g < 0 || size_t(g) >= mesh.groupNames().size()) return failed("group " + std::to_string(g) + " has no name");
        if (a.name == names::material && a.domain == Domain::Face && (!a.integral() || a.components != 1))
            return failed("material slots are no whole numbers");
    }
    return ::testing::AssertionSuccess();
}

}  // namespace mw::test
