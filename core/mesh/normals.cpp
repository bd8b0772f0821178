// Normals from positions alone, on flat arrays. Cross products are in float: the differences of neighbouring positions are as exact as the
// positions. They are brought to a size of about 1 first, so that neither very small nor very large models leave the range of float.
#include "core/mesh/normals.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace mw {

namespace {

/// A power of two that makes the diagonal of the mesh about 1.
float unitScale(const Mesh& mesh)
{
    const double d = mesh.bounds().diagonal();
    if (!(d > 0)) return 1;
    return float(std::ldexp(1.0, std::min(120, std::max(-120, -std::ilogb(d)))));
}

glm::vec3 unit(glm::vec3 n)
{
    const float square = n.x * n.x + n.y * n.y + n.z * n.z;
    if (square > 1e-30f) return n * (1.f / std::sqrt(square));
    const glm::dvec3 fine(n);  // the square of a short one is outside of float
    const double length = std::sqrt(fine.x * fine.x + fine.y * fine.y + fine.z * fine.z);
    return length > 0 ? glm::vec3(fine / length) : glm::vec3(0);
}

glm::vec3 crossOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float scale)
{
    const glm::vec3 u = (b - a) * scale, v = (c - a) * scale;
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

glm::vec3 scaledAreaVector(const glm::vec3* p, const uint32_t* corner, size_t n, float scale)
{
    glm::vec3 sum(0);
    for (size_t i = 1; i + 1 < n; ++i) sum += crossOf(p[corner[0]], p[corner[i]], p[corner[i + 1]], scale);
    return sum;
}

}  // namespace

Array<glm::vec3> faceNormalsOf(const Mesh& mesh)
{
    const float scale = unitScale(mesh);
    const glm::vec3* p = mesh.positions().data();
    Array<glm::vec3> normals(mesh.faceCount());
    for (size_t f = 0; f < normals.size(); ++f) {
        const auto face = mesh.face(f);
        normals[f] = unit(scaledAreaVector(p, face.data(), face.size(), scale));
    }
    return normals;
}

Array<glm::vec3> vertexNormalsOf(const Mesh& mesh)
{
    const float scale = unitScale(mesh);
    const glm::vec3* p = mesh.positions().data();
    const uint32_t* v = mesh.cornerVertex().data();
    Array<glm::vec3> normals(mesh.vertexCount(), glm::vec3(0));
    glm::vec3* sum = normals.data();
    if (mesh.isTriangles()) {
        for (const uint32_t* end = v + mesh.cornerCount(); v != end; v += 3) {
            const glm::vec3 n = crossOf(p[v[0]], p[v[1]], p[v[2]], scale);
            sum[v[0]] += n;
            sum[v[1]] += n;
            sum[v[2]] += n;
        }
    } else {
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto face = mesh.face(f);
            const glm::vec3 n = scaledAreaVector(p, face.data(), face.size(), scale);
            for (const uint32_t w : face) sum[w] += n;
        }
    }
    for (glm::vec3& n : normals) n = unit(n);
    return normals;
}

glm::dvec3 areaVector(const Mesh& mesh, size_t f)
{
    const auto face = mesh.face(f);
    const auto& p = mesh.positions();
    glm::dvec3 sum(0);
    for (size_t i = 1; i + 1 < face.size(); ++i) {
        const glm::dvec3 a(p[face[0]]);
        sum += glm::cross(glm::dvec3(p[face[i]]) - a, glm::dvec3(p[face[i + 1]]) - a);
    }
    return sum;
}

}  // namespace mw
