// One mesh on its way out: polygons cut, corners split into the points that glTF draws, one primitive a material slot.
#pragma once
#include <string>
#include <vector>

#include "core/io/gltf_builder.h"
#include "core/mesh/mesh.h"
#include "core/steps/progress.h"

namespace mw {

/// What the material of a slot asks of the points drawn with it.
struct GltfSlot {
    int material = -1;    ///< of the file; -1: none
    int texcoords = 0;    ///< sets its textures use
    int tangentSet = -1;  ///< the set its normal map uses; -1: none
};

/// What the scene says of a mesh.
struct GltfMeshUse {
    std::vector<GltfSlot> slots;
    size_t joints = 0;  ///< of the skin that poses it; 0: none, its joints and weights are not written
    std::string name;
    bool tellLost = true;  ///< attributes that glTF cannot hold are worth a warning
};

/// "primitives" and what belongs to them. Null when the mesh has nothing to draw.
nlohmann::json gltfMeshOf(GltfBuilder& builder, const Mesh& mesh, const GltfMeshUse& use, std::vector<Warning>& warnings,
                          Progress* progress = nullptr);

}  // namespace mw
