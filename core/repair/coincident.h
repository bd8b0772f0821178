// Vertices at the same place that should be one.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"
#include "core/steps/progress.h"

namespace mw {

/// The lowest vertex at exactly the place of each.
Array<uint32_t> lowestAtPlace(const Mesh& mesh);

/// Groups of vertices at one place of which `repair:weld=true` would join some; each ascending, in the order of their lowest. Copies that keep
/// a surface manifold (see fans.h) are no such group, vertices without a face neither.
std::vector<std::vector<uint32_t>> joinableVertices(const Mesh& mesh, Progress* progress = nullptr);

}  // namespace mw
