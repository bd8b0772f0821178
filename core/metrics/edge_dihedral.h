// Query: the cost of each edge by the angle between its faces and its length. Book 3.1.1, (3.11)-(3.13).
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct EdgeDihedral {
    enum class Form { AngleLength, Normalised, Cosine };
    Form form = Form::Normalised;
    double k1 = 1, k2 = 1;
    template <class V>
    void describe(V& v)
    {
        v.choice("form", form, {"angle-length", "normalised", "cosine"},
                 {.title = "Form",
                  .help = "angle-length (3.11): k1 angle + k2 length. normalised (3.12): both as shares of their greatest. cosine (3.13): without an "
                          "arc cosine, (1 - cosine) / 2 for the angle."});
        v.number("k1", k1, {.title = "k1", .help = "How much the angle between the faces counts.", .min = 0, .max = 1e6, .softMax = 2});
        v.number("k2", k2, {.title = "k2", .help = "How much the length of the edge counts.", .min = 0, .max = 1e6, .softMax = 2});
    }
};

/// A row an edge, in the order of Mesh::edges(): "cost", "angle" between the normals of its faces (degrees, 0 where they lie in one plane) and
/// "length". Border edges have no angle and count with 0. Of three faces and more, the sharpest pair counts; neighbours that run the same way
/// are taken as if one was turned round.
Generator edgeDihedral(Mesh input, EdgeDihedral parameters, Stage<Table>& stage);

}  // namespace mw
