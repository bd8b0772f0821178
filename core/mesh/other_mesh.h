// A further mesh that an operation works with: a parameter says which, whoever starts the operation looks it up.
#pragma once
#include <string>

#include "core/mesh/mesh.h"

namespace mw {

/// `name` is what the person gave: a node, a file, or a source with its parameters ("torus:radius=2"). `mesh` is what that stands for, as it is
/// shown (after its modifiers), in its own space; empty until it was looked up (core/catalog/others.h).
struct OtherMesh {
    std::string name;
    Mesh mesh;
};

}  // namespace mw
