// What the costs of vertices and edges are made of: area, normal and centroid of each face, the average plane of a fan, and the way along the
// border. Book 3.1.1. Any faces; polygons by their triangles.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/connectivity.h"
#include "core/mesh/mesh.h"
#include "core/mesh/table.h"

namespace mw {

struct alignas(64) FaceMeasure {
    glm::dvec3 normal;  ///< unit; 0 where there is no area
    double area;
    glm::dvec3 centroid;
};
/// Of every face.
Array<FaceMeasure> faceMeasuresOf(const Mesh& mesh);
FaceMeasure measureOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// (3.1): mean normal and mean point of the faces at a vertex, weighted by area.
class AveragePlane {
public:
    void add(const FaceMeasure& f)
    {
        normal_ += f.area * f.normal;
        point_ += f.area * f.centroid;
        area_ += f.area;
    }
    /// False where there is no area, or the normals cancel each other.
    bool defined() const { return glm::length(normal_) > 1e-12 * area_; }
    glm::dvec3 normal() const { return glm::normalize(normal_); }  ///< made unit: the sum alone is shorter than 1
    glm::dvec3 point() const { return point_ / area_; }
    /// (3.3): how far v is off the plane, on the side of the normal.
    double height(const glm::dvec3& v) const { return glm::dot(normal(), v - point()); }

private:
    glm::dvec3 normal_{0}, point_{0};
    double area_ = 0;
};

/// The faces at a vertex, in the order of its corners.
std::vector<uint32_t> facesAt(const Mesh& mesh, const FaceCorners& corners, uint32_t vertex);

/// Adds a column of `rows` values that are not there yet.
void addColumn(Table& table, const char* name, const char* unit, size_t rows);

/// For a table's summary, of the values that are numbers: how many, "mean" and "greatest".
decltype(Table::summary) summaryOfMeasured(const Array<double>& values);

/// (3.5): distance of v from the line through its two neighbours on the border; from them where they are one place.
inline double distanceToLine(const glm::dvec3& v, const glm::dvec3& p, const glm::dvec3& q)
{
    const double length = glm::distance(p, q);
    return length > 0 ? glm::length(glm::cross(v - p, q - p)) / length : glm::distance(v, p);
}

/// How each vertex lies on the border: an edge of one face is border. Degenerate faces are left out.
struct BorderNeighbours {
    enum class Place : uint8_t { Inside, Border, Branch };  ///< Branch: more than two border edges meet
    Array<Place> place;
    Array<uint32_t> neighbour;  ///< two a vertex, the lower edge's first; `none` where there are none
};
BorderNeighbours borderNeighboursOf(const Mesh& mesh);

}  // namespace mw
