// Morph targets: a mesh gets the displacement of each of its points to the matching point of another mesh. Book 3.4.
#pragma once
#include "core/mesh/describe_length.h"
#include "core/mesh/mesh.h"
#include "core/mesh/other_mesh.h"
#include "core/steps/stage.h"

namespace mw {

/// The result has the vertex attribute morph:NAME, NAME being that of the other mesh: at weight 0 it is the input's surface, at weight 1 that of the
/// other mesh, with one face list for both.
///
/// corresponding: both have the same faces; vertex goes to vertex. cylinder-torus and sphere-torus: by formulas (3.57) to (3.62), onto the torus of
/// `radius` and `tube` about +Y, or onto the other mesh's when one is named and it is such a torus; the cylinder stands on its lower end, caps are
/// left out, the sphere is cut open at its poles. The others lay both meshes on one domain and overlay them with all crossings of their edges, so
/// that both ends are exact (core/morph/overlay.h): projective sees both from a point that sees all of each; spherical spreads two closed meshes
/// without holes over the sphere, barycentric two disks over one convex region. auto takes the first of these that fits and says why when none does.
///
/// Overlays make triangles. Attributes of the input are interpolated on its surface, faces keep those of the face they are cut from. Of the other
/// mesh the colours come along: "morph-color:NAME" is what they differ by from the input's (white where it has none). Vertices that belong to no
/// face are left out. O((n + k) log n) for n triangles and k crossings.
struct Morph {
    enum class Method { Auto, CylinderTorus, SphereTorus, Projective, Barycentric, Corresponding, Spherical };
    enum class Align { Automatic, None };

    OtherMesh other;
    Method method = Method::Auto;
    Align align = Align::Automatic;
    double radius = 1, tube = 0.35, height = 0;

    template <class V>
    void describe(V& v)
    {
        v.object("other", other,
                 {.title = "Other mesh",
                  .help = "What it turns into: a node that shows a mesh, a file, or a source (\"torus\"). The tori of methods cylinder-torus and "
                          "sphere-torus need none.",
                  .optional = true});
        v.choice("method", method, {"auto", "cylinder-torus", "sphere-torus", "projective", "barycentric", "corresponding", "spherical"},
                 {.title = "Method",
                  .help = "How points of the two are matched. projective: by rays from a common centre. barycentric: two disks by their planar maps. "
                          "spherical: two closed meshes by their maps on the sphere. corresponding: vertex to vertex of equal meshes."});
        v.choice("align", align, {"automatic", "none"},
                 {.title = "Alignment",
                  .help = "barycentric and spherical: turn the maps so that matching points are as near as can be, or leave them as they are.",
                  .when = "method=auto|barycentric|spherical"});
        describeLength(v, "radius", radius, "Radius R", "Of the target torus: from the axis to the middle of the tube.",
                       "method=cylinder-torus|sphere-torus");
        describeLength(v, "tube", tube, "Tube r", "Of the target torus: radius of the tube.", "method=cylinder-torus|sphere-torus");
        v.number("height", height,
                 {.title = "Height H",
                  .help = "Of the cylinder, from its lower end; 0: as high as the mesh is.",
                  .unit = "m",
                  .min = 0,
                  .max = 1e6,
                  .softMin = 0,
                  .softMax = 10,
                  .advanced = true,
                  .when = "method=cylinder-torus"});
    }
};

Generator morph(Mesh input, Morph parameters, Stage<Mesh>& stage);

/// The part of a name that a morph target is called by: "torus" of "torus:radius=2", "cow" of "models/cow.obj".
std::string targetName(const std::string& other);

}  // namespace mw
