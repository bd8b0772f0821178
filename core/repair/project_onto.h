// Every vertex goes to the closest point of another surface (shrink-wrap): a simplified or remeshed shape comes back onto the one it was made from.
#pragma once
#include "core/mesh/mesh.h"
#include "core/mesh/other_mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct ProjectOnto {
    OtherMesh other;
    double amount = 1;
    template <class V>
    void describe(V& v)
    {
        v.object("other", other, {.title = "Onto", .help = "The mesh whose surface is gone to: a node, a file, or a source."});
        v.number("amount", amount, {.title = "Amount", .help = "Share of the way to the surface.", .min = 0, .max = 1});
    }
};

/// Both meshes as they are in their own spaces. Faces and attributes stay; corner normals are a file's own and stay, too. Throws Error when the
/// other mesh has no face.
Generator projectOnto(Mesh input, ProjectOnto parameters, Stage<Mesh>& stage);

}  // namespace mw
