// Chains of points joined by strips of triangles.
#include "core/mesh/small_disks.h"

#include <glm/geometric.hpp>

namespace mw {
namespace {

class Shape {
public:
    uint32_t add(double x, double y, double z)
    {
        positions_.emplace_back(x, y, z);
        return uint32_t(positions_.size() - 1);
    }
    void triangle(uint32_t a, uint32_t b, uint32_t c) { corners_.insert(corners_.end(), {a, b, c}); }
    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
    {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    /// Triangles between two chains that run the same way, `right` to the right of `left` seen from outside: the shorter diagonal each time.
    void strip(const std::vector<uint32_t>& left, const std::vector<uint32_t>& right)
    {
        size_t i = 0, j = 0;
        while (i + 1 < left.size() || j + 1 < right.size()) {
            const auto gap = [&](uint32_t a, uint32_t b) { return glm::distance(positions_[a], positions_[b]); };
            const bool onLeft = j + 1 == right.size() || (i + 1 < left.size() && gap(left[i + 1], right[j]) <= gap(left[i], right[j + 1]));
            if (onLeft)
                triangle(left[i], right[j], left[i + 1]);
            else
                triangle(left[i], right[j], right[j + 1]);
            (onLeft ? i : j) += 1;
        }
    }
    Mesh mesh(double size)
    {
        for (glm::vec3& p : positions_) p = glm::vec3(size * glm::dvec3(p));
        return Mesh::triangles(std::move(positions_), std::move(corners_));
    }

private:
    Array<glm::vec3> positions_;
    Array<uint32_t> corners_;
};

}  // namespace

Generator house(SmallDisk p, Stage<Mesh>& stage)
{
    co_yield Step("make").progress(0);
    Shape s;
    // Corners and middles of the long sides, anticlockwise seen from above, on the ground and at the eaves.
    const double x[6] = {-0.5, -0.5, 0, 0.5, 0.5, 0}, z[6] = {-0.35, 0.35, 0.35, 0.35, -0.35, -0.35};
    std::vector<uint32_t> ground, eaves, ridge;
    for (int i = 0; i < 6; ++i) ground.push_back(s.add(x[i], 0, z[i]));
    for (int i = 0; i < 6; ++i) eaves.push_back(s.add(x[i], 0.5, z[i]));
    for (int i = 0; i < 3; ++i) ridge.push_back(s.add(-0.42 + 0.42 * i, 0.82, 0));
    for (size_t i = 0; i < 6; ++i) s.quad(ground[i], ground[(i + 1) % 6], eaves[(i + 1) % 6], eaves[i]);
    s.triangle(eaves[0], eaves[1], ridge[0]);
    s.quad(eaves[1], eaves[2], ridge[1], ridge[0]);
    s.quad(eaves[2], eaves[3], ridge[2], ridge[1]);
    s.triangle(eaves[3], eaves[4], ridge[2]);
    s.quad(eaves[4], eaves[5], ridge[1], ridge[2]);
    s.quad(eaves[5], eaves[0], ridge[0], ridge[1]);
    stage.finish(s.mesh(p.size));
}

Generator car(SmallDisk p, Stage<Mesh>& stage)
{
    co_yield Step("make").progress(0);
    Shape s;
    // From the rear to the front: the lower edge with two arches; boot, rear window, roof, windscreen, bonnet.
    constexpr double lowerX[10] = {-0.5, -0.37, -0.33, -0.21, -0.17, 0.17, 0.21, 0.33, 0.37, 0.5};
    constexpr double lowerY[10] = {0.08, 0.08, 0.17, 0.17, 0.08, 0.08, 0.17, 0.17, 0.08, 0.08};
    constexpr double upperX[6] = {-0.5, -0.36, -0.2, 0.08, 0.22, 0.48}, upperY[6] = {0.24, 0.26, 0.4, 0.4, 0.25, 0.2};
    std::vector<uint32_t> lower[2], upper[2];
    for (const int side : {0, 1}) {
        const double z = side == 0 ? 0.2 : -0.2;
        for (int i = 0; i < 10; ++i) lower[side].push_back(s.add(lowerX[i], lowerY[i], z));
        for (int i = 0; i < 6; ++i) upper[side].push_back(s.add(upperX[i], upperY[i], i == 2 || i == 3 ? 0.8 * z : z));
    }
    s.strip(upper[0], lower[0]);
    s.strip(upper[1], upper[0]);
    s.strip(lower[1], upper[1]);
    s.quad(lower[1][0], lower[0][0], upper[0][0], upper[1][0]);
    s.quad(lower[0][9], lower[1][9], upper[1][5], upper[0][5]);
    stage.finish(s.mesh(p.size));
}

}  // namespace mw
