#include "core/math/transform.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace mw {

glm::dmat4 Transform::matrix() const
{
    return glm::scale(glm::translate(glm::dmat4(1), translation) * glm::mat4_cast(rotation), scale);
}

Transform transformOf(const glm::dmat4& m, bool* exact)
{
    Transform t;
    t.translation = glm::dvec3(m[3]);
    glm::dmat3 r(m);
    for (int i = 0; i < 3; ++i) {
        t.scale[i] = glm::length(r[i]);
        if (t.scale[i] > 0) r[i] /= t.scale[i];
    }
    if (glm::determinant(r) < 0) {  // a mirror: one axis is turned round
        t.scale.x = -t.scale.x;
        r[0] = -r[0];
    }
    t.rotation = glm::normalize(glm::quat_cast(r));
    if (exact) {
        const glm::dmat4 back = t.matrix();
        double worst = 0, size = 0;
        for (int c = 0; c < 4; ++c)
            for (int k = 0; k < 4; ++k) {
                worst = std::max(worst, std::abs(back[c][k] - m[c][k]));
                size = std::max(size, std::abs(m[c][k]));
            }
        *exact = worst <= 1e-6 * size;
    }
    return t;
}

}  // namespace mw
