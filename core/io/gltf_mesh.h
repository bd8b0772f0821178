// One mesh of a glTF, all its primitives, as one of ours: points that were split for drawing become one vertex again, what differs between
// them (normals, texture coordinates, colours) lives on corners.
#pragma once
#include "core/io/gltf_document.h"
#include "core/mesh/mesh.h"
#include "core/steps/progress.h"

namespace mw {

struct GltfMesh {
    Mesh mesh;
    std::vector<std::optional<uint32_t>> materials;  ///< of the document, by slot; empty when no primitive names one
};

/// Throws Error, Cancelled; adds to the warnings of the document.
GltfMesh gltfMesh(GltfDocument& document, const JsonPlace& place, Progress* progress = nullptr);

}  // namespace mw
