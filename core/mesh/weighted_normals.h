// Normals of vertices and corners as sums over the faces around, weighted. Book 2.7.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

/// What a face counts at a vertex: its area, its angle there, or as much as any other (the plain sum of (2.6)).
enum class NormalWeight { Area, Angle, Plain };

/// Unit normal of every vertex: the sum over its faces of weight times unit normal, made unit; 0 where there is none. Mesh::vertexNormals() keeps
/// those weighted by area.
Array<glm::vec3> vertexNormalsOf(const Mesh& mesh, NormalWeight weight);
/// Unit normal of every corner: the sum over those faces at its vertex that hang together with its own across edges of at most `degrees` (an edge
/// of one face, or of more than two, parts them). 0 where there is none.
Array<glm::vec3> cornerNormalsOf(const Mesh& mesh, NormalWeight weight, double degrees);

struct Normals {
    NormalWeight weight = NormalWeight::Area;
    enum class On { Vertices, Corners } on = On::Vertices;
    double crease = 30;
    template <class V>
    void describe(V& v)
    {
        v.choice("weight", weight, {"area", "angle", "plain"},
                 {.title = "Weight",
                  .help = "What a face counts at a vertex: its area, the angle it has there (does not depend on how faces are cut), or 1."});
        v.choice("on", on, {"vertices", "corners"},
                 {.title = "On", .help = "One normal a vertex; or one a corner, so that edges bent by more than the crease angle stay sharp."});
        v.number(
            "crease", crease,
            {.title = "Crease angle", .help = "Edges bent by more than this stay sharp.", .unit = "°", .min = 0, .max = 180, .when = "on=corners"});
    }
};

/// Writes the attribute "normal" (in place of any there was); where there is no normal, +Z.
Generator normals(Mesh input, Normals parameters, Stage<Mesh>& stage);

}  // namespace mw
