// Which method fits two meshes, and the one that was chosen.
#include "core/morph/morph.h"

#include <algorithm>

#include "core/error.h"
#include "core/mesh/topology.h"
#include "core/morph/morph_mesh.h"
#include "core/morph/overlay_morph.h"
#include "core/morph/parametric_morph.h"
#include "core/morph/star_centre.h"

namespace mw {

namespace {

using Method = Morph::Method;

enum class Shape { Sphere, Disk, Tube, Ring, Else };

struct Kind {
    Shape shape = Shape::Else;
    std::string words;
};

std::string counted(size_t n, const char* one, const char* many)
{
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

Kind kindOf(const Mesh& mesh)
{
    const TopologyReport& t = mesh.topology();
    if (t.faces == 0) return {Shape::Else, "has no faces"};
    if (!t.manifold()) return {Shape::Else, "has edges or vertices where more than two faces meet; repair it first"};
    if (!t.orientable) return {Shape::Else, "has only one side"};
    if (!t.consistentlyOriented) return {Shape::Else, "has faces turned against each other; orient it first"};
    if (t.components != 1) return {Shape::Else, "has " + counted(t.components, "piece", "pieces")};
    const size_t loops = t.boundaryLoops.size();
    const long genus = (2 - long(loops) - t.euler) / 2;
    if (genus == 0 && loops == 0) return {Shape::Sphere, "is closed, without holes"};
    if (genus == 0 && loops == 1) return {Shape::Disk, "is a disk"};
    if (genus == 0 && loops == 2) return {Shape::Tube, "is a tube open at both ends"};
    if (genus == 1 && loops == 0) return {Shape::Ring, "is closed, with one handle"};
    return {Shape::Else, "has " + counted(loops, "border", "borders") + " and " + counted(size_t(std::max(0L, genus)), "handle", "handles")};
}

bool sameFaces(const Mesh& a, const Mesh& b)
{
    return a.vertexCount() == b.vertexCount() && std::ranges::equal(a.faceStart(), b.faceStart()) &&
           std::ranges::equal(a.cornerVertex(), b.cornerVertex());
}

bool starShaped(const Mesh& mesh)
{
    const MorphMesh m = MorphMesh::of(mesh);
    return starCentre(m.positions, m.corners).has_value();
}

Method chosen(const Mesh& mesh, const Mesh& other)
{
    if (sameFaces(mesh, other)) return Method::Corresponding;
    const Kind a = kindOf(mesh), b = kindOf(other);
    if (a.shape == Shape::Sphere && b.shape == Shape::Sphere) return starShaped(mesh) && starShaped(other) ? Method::Projective : Method::Spherical;
    if (a.shape == Shape::Disk && b.shape == Shape::Disk) return Method::Barycentric;
    if (b.shape == Shape::Ring && a.shape == Shape::Tube) return Method::CylinderTorus;
    if (b.shape == Shape::Ring && a.shape == Shape::Sphere) return Method::SphereTorus;
    throw Error("there is no morph between these two: this mesh " + a.words + ", the other " + b.words +
                "; give two closed meshes without holes, two disks, or a cylinder or a sphere and a torus");
}

void require(const Mesh& mesh, Shape shape, const char* method, const char* which)
{
    const Kind k = kindOf(mesh);
    if (k.shape == shape) return;
    throw Error(std::string(method) + " wants " + (shape == Shape::Disk ? "disks (one piece with one border)" : "closed meshes without holes") +
                "; " + which + " " + k.words);
}

}  // namespace

std::string targetName(const std::string& other)
{
    std::string name = other.substr(0, other.find(':'));
    if (const size_t slash = name.find_last_of("/\\"); slash != name.npos) name = name.substr(slash + 1);
    if (const size_t dot = name.rfind('.'); dot != name.npos && dot > 0) name = name.substr(0, dot);
    return name.empty() ? "target" : name;
}

Generator morph(Mesh input, Morph parameters, Stage<Mesh>& stage)
{
    const bool torus = parameters.method == Method::CylinderTorus || parameters.method == Method::SphereTorus;
    if (!torus && parameters.other.mesh.faceCount() == 0)
        throw Error(parameters.other.name.empty() ? "choose the other mesh: the node, file or source that it turns into"
                                                  : "\"" + parameters.other.name + "\" has no faces to turn into");
    if (parameters.method == Method::Auto) parameters.method = chosen(input, parameters.other.mesh);
    switch (parameters.method) {
        case Method::CylinderTorus:
            return cylinderTorus(std::move(input), std::move(parameters), stage);
        case Method::SphereTorus:
            return sphereTorus(std::move(input), std::move(parameters), stage);
        case Method::Corresponding:
            return correspondingMorph(std::move(input), std::move(parameters), stage);
        default:
            break;
    }
    const bool disks = parameters.method == Method::Barycentric;
    const char* name = disks ? "barycentric" : parameters.method == Method::Projective ? "projective" : "spherical";
    require(input, disks ? Shape::Disk : Shape::Sphere, name, "this mesh");
    require(parameters.other.mesh, disks ? Shape::Disk : Shape::Sphere, name, "the other");
    return overlayMorph(std::move(input), std::move(parameters), stage);
}

}  // namespace mw
