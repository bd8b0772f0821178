#include "core/io/gltf_write_skinning.h"

#include <algorithm>
#include <cmath>

namespace mw {

namespace {

// One vertex; false when nothing holds it.
bool tidy(std::span<uint16_t> joints, std::span<float> weights)
{
    double sum = 0;
    for (size_t k = 0; k < weights.size(); ++k) {
        if (weights[k] <= 0) continue;
        for (size_t earlier = 0; earlier < k; ++earlier)
            if (weights[earlier] > 0 && joints[earlier] == joints[k]) {
                weights[earlier] += weights[k];
                weights[k] = 0;
                break;
            }
    }
    for (size_t k = 0; k < weights.size(); ++k) {
        if (weights[k] == 0) joints[k] = 0;
        sum += double(weights[k]);
    }
    if (!(sum > 0)) {
        weights[0] = 1;
        return false;
    }
    if (std::abs(sum - 1) > 2e-7)  // within rounding they stay as they are, to the last bit
        for (float& w : weights) w = float(double(w) / sum);
    return true;
}

}  // namespace

GltfSkinning gltfSkinning(const Mesh& mesh, size_t joints)
{
    GltfSkinning out;
    const Attribute *j = mesh.find(names::joints, Domain::Vertex), *w = mesh.find(names::weights, Domain::Vertex);
    constexpr size_t most = 65536;
    if (!j || !w || !joints) return out;
    const size_t from = size_t(std::min(j->components, w->components)), n = (from + 3) / 4 * 4;
    const auto limit = double(std::min(joints, most));
    out.joints.resize(mesh.vertexCount() * n, 0);
    out.weights.resize(mesh.vertexCount() * n, 0);
    size_t used = 1;
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        for (size_t k = 0; k < from; ++k) {
            const double joint = j->at(v, int(k)), weight = w->at(v, int(k));
            if (!(joint >= 0 && joint < limit) || !(weight > 0) || !std::isfinite(weight)) continue;
            out.joints[n * v + k] = uint16_t(joint);
            out.weights[n * v + k] = float(weight);
        }
        out.unbound += !tidy({out.joints.data() + n * v, n}, {out.weights.data() + n * v, n});
        for (size_t k = 0; k < n; ++k)
            if (out.weights[n * v + k] > 0) used = std::max(used, k / 4 + 1);
    }
    out.sets = n / 4;
    if (used == out.sets) return out;
    // Sets that hold nothing are left out.
    GltfSkinning narrow{used, {}, {}, out.unbound};
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        const auto at = std::ptrdiff_t(n * v), end = at + std::ptrdiff_t(4 * used);
        narrow.joints.insert(narrow.joints.end(), out.joints.begin() + at, out.joints.begin() + end);
        narrow.weights.insert(narrow.weights.end(), out.weights.begin() + at, out.weights.begin() + end);
    }
    return narrow;
}

}  // namespace mw
