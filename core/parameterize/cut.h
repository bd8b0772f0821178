// Modifier: a mesh cut open along edges. Book 3.3.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Cut {
    enum class Method { Disk, Edges, Shortest, Seams };

    Method method = Method::Disk;
    std::string edges, vertices;

    template <class V>
    void describe(V& v)
    {
        v.choice(
            "method", method, {"disk", "edges", "shortest", "seams"},
            {.title = "Where",
             .help =
                 "Disk: as few edges as needed so that each piece can be laid flat. Edges: those given. Shortest: along edges from vertex to vertex. "
                 "Seams: where the texture coordinates are apart."});
        v.text("edges", edges,
               {.title = "Edges", .help = "Pairs of vertices, like 3~7;7~9. A single edge inside a surface opens nothing.", .when = "method=edges"});
        v.text("vertices", vertices,
               {.title = "Vertices", .help = "Two or more, in the order of the way, like 12;55;90.", .when = "method=shortest"});
    }
};

/// See core/mesh/cut_open.h and core/parameterize/cut_graph.h. Faces and corners stay as they are. A mesh that is cut already is not changed by
/// the same method again. Throws Error when the text is none, a vertex or edge is not there, or there is no way between two vertices.
Generator cut(Mesh input, Cut parameters, Stage<Mesh>& stage);

}  // namespace mw
