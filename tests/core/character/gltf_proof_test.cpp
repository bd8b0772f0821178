// Every animated glTF file of the data set against an evaluation written here from the glTF 2.0 specification, on the raw accessors as another
// program's reader (tinygltf) gives them: morphed, skinned and placed corners at ten times of every clip, before and after writing.
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <tiny_gltf.h>
#include <unistd.h>

#include "core/io/io.h"
#include "core/scene/scene_pose.h"

#include "data.h"

namespace mw::test {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;

/// Places and directions of the corners of one node's mesh, primitive after primitive in the order of the indices.
struct Corners {
    std::vector<glm::dvec3> places, normals;
};
using Shown = std::map<int, Corners>;  ///< by node, in depth-first order

/// The specification, section by section.
class Evaluator {
public:
    explicit Evaluator(const fs::path& file)
    {
        tinygltf::TinyGLTF reader;
        std::string error, warning;
        const bool good = file.extension() == ".glb" ? reader.LoadBinaryFromFile(&m_, &error, &warning, file.string())
                                                     : reader.LoadASCIIFromFile(&m_, &error, &warning, file.string());
        EXPECT_TRUE(good) << error;
        std::vector<int> open(m_.scenes[size_t(std::max(m_.defaultScene, 0))].nodes);
        std::reverse(open.begin(), open.end());
        while (!open.empty()) {
            order_.push_back(open.back());
            open.pop_back();
            const std::vector<int>& children = m_.nodes[size_t(order_.back())].children;
            for (const int c : children) parent_[c] = order_.back();
            open.insert(open.end(), children.rbegin(), children.rend());
        }
    }

    size_t clips() const { return m_.animations.size(); }
    double duration(size_t clip) const
    {
        double last = 0;
        for (const auto& s : m_.animations[clip].samplers) last = std::max(last, numbers(s.input).back());
        return last;
    }
    /// At rest when `clip` is -1.
    Shown at(int clip, double time);

private:
    struct Local {
        Numbers translation{0, 0, 0}, rotation{0, 0, 0, 1}, scale{1, 1, 1}, weights;
        glm::dmat4 matrix(const tinygltf::Node& n) const;
    };

    // 3.6.2 Accessors: stride, normalisation, sparse values.
    double component(const uint8_t* p, const tinygltf::Accessor& a) const;
    Numbers numbers(int accessor) const;
    // 3.11, appendix C: interpolation.
    Numbers sampled(const tinygltf::AnimationSampler& s, double time, bool rotation) const;
    // 3.7: geometry, morph targets, skins.
    void addPrimitive(const tinygltf::Primitive& p, const Numbers& weights, const std::vector<glm::dmat4>& joints, const glm::dmat4& place,
                      Corners& to);

    tinygltf::Model m_;
    std::vector<int> order_;
    std::map<int, int> parent_;
};

double Evaluator::component(const uint8_t* p, const tinygltf::Accessor& a) const
{
    const auto as = [&](auto zero, double most) {
        std::memcpy(&zero, p, sizeof zero);
        return a.normalized ? std::max(double(zero) / most, -1.0) : double(zero);
    };
    switch (a.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return as(int8_t(), 127);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return as(uint8_t(), 255);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return as(int16_t(), 32767);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return as(uint16_t(), 65535);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return as(uint32_t(), 4294967295.0);
        default: {
            float f;
            std::memcpy(&f, p, 4);
            return double(f);
        }
    }
}

Numbers Evaluator::numbers(int accessor) const
{
    const tinygltf::Accessor& a = m_.accessors[size_t(accessor)];
    const size_t n = size_t(tinygltf::GetNumComponentsInType(uint32_t(a.type))),
                 size = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(a.componentType)));
    const auto bytesOf = [&](int view) {
        return m_.buffers[size_t(m_.bufferViews[size_t(view)].buffer)].data.data() + m_.bufferViews[size_t(view)].byteOffset;
    };
    Numbers out(a.count * n, 0);
    if (a.bufferView >= 0)
        for (size_t i = 0; i < a.count; ++i)
            for (size_t k = 0; k < n; ++k)
                out[i * n + k] =
                    component(bytesOf(a.bufferView) + a.byteOffset + i * size_t(a.ByteStride(m_.bufferViews[size_t(a.bufferView)])) + k * size, a);
    if (a.sparse.isSparse)
        for (size_t i = 0; i < size_t(a.sparse.count); ++i) {
            tinygltf::Accessor index;
            index.componentType = a.sparse.indices.componentType;
            const size_t width = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(index.componentType)));
            const size_t to = size_t(component(bytesOf(a.sparse.indices.bufferView) + a.sparse.indices.byteOffset + i * width, index));
            for (size_t k = 0; k < n; ++k)
                out[to * n + k] = component(bytesOf(a.sparse.values.bufferView) + a.sparse.values.byteOffset + (i * n + k) * size, a);
        }
    return out;
}

Numbers normalised(Numbers q)
{
    double sum = 0;
    for (const double v : q) sum += v * v;
    for (double& v : q) v /= std::sqrt(sum);
    return q;
}

Numbers Evaluator::sampled(const tinygltf::AnimationSampler& s, double time, bool rotation) const
{
    const Numbers times = numbers(s.input), all = numbers(s.output);
    const bool cubic = s.interpolation == "CUBICSPLINE";
    const size_t n = all.size() / times.size() / (cubic ? 3 : 1);
    const auto value = [&](size_t key, size_t part) {
        const size_t from = cubic ? (3 * key + part) * n : key * n;
        return Numbers(all.begin() + std::ptrdiff_t(from), all.begin() + std::ptrdiff_t(from + n));
    };
    size_t k = 0;
    while (k + 1 < times.size() && times[k + 1] <= time) ++k;
    Numbers out = value(k, 1);
    if (time > times[0] && k + 1 < times.size() && s.interpolation != "STEP") {
        const double distance = times[k + 1] - times[k], t = (time - times[k]) / distance;
        const Numbers next = value(k + 1, 1);
        if (cubic) {
            const Numbers leave = value(k, 2), arrive = value(k + 1, 0);
            for (size_t i = 0; i < n; ++i)
                out[i] = (2 * t * t * t - 3 * t * t + 1) * out[i] + distance * (t * t * t - 2 * t * t + t) * leave[i] +
                         (-2 * t * t * t + 3 * t * t) * next[i] + distance * (t * t * t - t * t) * arrive[i];
        } else if (rotation) {
            double cosine = 0;
            for (size_t i = 0; i < 4; ++i) cosine += out[i] * next[i];
            const double sign = cosine < 0 ? -1 : 1, a = std::acos(std::min(1.0, std::abs(cosine)));
            for (size_t i = 0; i < 4; ++i)
                out[i] = a < 1e-7 ? out[i] + t * (sign * next[i] - out[i])
                                  : std::sin(a * (1 - t)) / std::sin(a) * out[i] + sign * std::sin(a * t) / std::sin(a) * next[i];
        } else {
            for (size_t i = 0; i < n; ++i) out[i] += t * (next[i] - out[i]);
        }
    }
    return rotation ? normalised(out) : out;
}

glm::dmat4 Evaluator::Local::matrix(const tinygltf::Node& n) const
{
    if (!n.matrix.empty()) return glm::make_mat4(n.matrix.data());
    const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    const glm::dmat4 turn(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,  //
                          2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,  //
                          2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0, 0, 0, 0, 1);
    return glm::scale(glm::translate(glm::dmat4(1), glm::make_vec3(translation.data())) * turn, glm::make_vec3(scale.data()));
}

void Evaluator::addPrimitive(const tinygltf::Primitive& p, const Numbers& weights, const std::vector<glm::dmat4>& joints, const glm::dmat4& place,
                             Corners& to)
{
    Numbers positions = numbers(p.attributes.at("POSITION")), normals;
    if (p.attributes.count("NORMAL")) normals = numbers(p.attributes.at("NORMAL"));
    for (size_t t = 0; t < p.targets.size(); ++t) {
        const double w = t < weights.size() ? weights[t] : 0;
        const auto add = [&](const char* name, Numbers& base) {
            if (!p.targets[t].count(name)) return;
            const Numbers d = numbers(p.targets[t].at(name));
            for (size_t i = 0; i < base.size(); ++i) base[i] += w * d[i];
        };
        add("POSITION", positions);
        add("NORMAL", normals);
    }
    std::vector<glm::dmat4> moves(positions.size() / 3, place);
    if (!joints.empty()) {
        std::vector<double> sums(moves.size(), 0);
        std::fill(moves.begin(), moves.end(), glm::dmat4(0));
        for (int set = 0; p.attributes.count("JOINTS_" + std::to_string(set)); ++set) {
            const Numbers j = numbers(p.attributes.at("JOINTS_" + std::to_string(set))),
                          w = numbers(p.attributes.at("WEIGHTS_" + std::to_string(set)));
            for (size_t i = 0; i < j.size(); ++i) {
                moves[i / 4] += w[i] * joints[size_t(j[i])];
                sums[i / 4] += w[i];
            }
        }
        // "The linear sum should be 1": files that miss it by rounding are made to.
        for (size_t i = 0; i < moves.size(); ++i) moves[i] *= 1 / sums[i];
    }
    Numbers indices;
    if (p.indices >= 0) indices = numbers(p.indices);
    for (size_t i = 0; indices.size() < positions.size() / 3 && p.indices < 0; ++i) indices.push_back(double(i));
    for (const double index : indices) {
        const size_t v = size_t(index);
        to.places.push_back(moves[v] * glm::dvec4(glm::make_vec3(&positions[3 * v]), 1));
        if (!normals.empty()) to.normals.push_back(glm::normalize(glm::inverseTranspose(glm::dmat3(moves[v])) * glm::make_vec3(&normals[3 * v])));
    }
}

Shown Evaluator::at(int clip, double time)
{
    std::map<int, Local> locals;
    for (const int id : order_) {
        const tinygltf::Node& n = m_.nodes[size_t(id)];
        Local& l = locals[id];
        if (!n.translation.empty()) l.translation = n.translation;
        if (!n.rotation.empty()) l.rotation = n.rotation;
        if (!n.scale.empty()) l.scale = n.scale;
        if (n.mesh >= 0) l.weights = n.weights.empty() ? m_.meshes[size_t(n.mesh)].weights : n.weights;
    }
    if (clip >= 0)
        for (const tinygltf::AnimationChannel& c : m_.animations[size_t(clip)].channels) {
            Numbers v = sampled(m_.animations[size_t(clip)].samplers[size_t(c.sampler)], time, c.target_path == "rotation");
            Local& l = locals[c.target_node];
            (c.target_path == "translation" ? l.translation
             : c.target_path == "rotation"  ? l.rotation
             : c.target_path == "scale"     ? l.scale
                                            : l.weights) = v;
        }
    std::map<int, glm::dmat4> worlds;
    for (const int id : order_) {
        const glm::dmat4 local = locals[id].matrix(m_.nodes[size_t(id)]);
        worlds[id] = parent_.count(id) ? worlds[parent_[id]] * local : local;
    }
    Shown shown;
    for (const int id : order_) {
        const tinygltf::Node& n = m_.nodes[size_t(id)];
        if (n.mesh < 0) continue;
        std::vector<glm::dmat4> joints;
        if (n.skin >= 0) {
            const tinygltf::Skin& skin = m_.skins[size_t(n.skin)];
            const Numbers inverse = skin.inverseBindMatrices >= 0 ? numbers(skin.inverseBindMatrices) : Numbers();
            for (size_t j = 0; j < skin.joints.size(); ++j)
                joints.push_back(worlds[skin.joints[j]] * (inverse.empty() ? glm::dmat4(1) : glm::make_mat4(&inverse[16 * j])));
        }
        Corners& to = shown[int(std::find(order_.begin(), order_.end(), id) - order_.begin())];
        for (const tinygltf::Primitive& p : m_.meshes[size_t(n.mesh)].primitives)
            if (p.mode == TINYGLTF_MODE_TRIANGLES || p.mode < 0) addPrimitive(p, locals[id].weights, joints, worlds[id], to);
    }
    return shown;
}

/// The same of our scene.
Shown shownBy(const Scene& s, const ScenePose& pose)
{
    Shown shown;
    const auto worlds = worldMatrices(s, pose);
    int number = 0;
    for (const NodeId id : s.nodes()) {
        const MeshObject* o = s.find(s.node(id).mesh);
        const int place = number++;
        if (!o) continue;
        const auto how = meshPose(s, id, o->base, pose, worlds);
        const Mesh mesh = how ? posed(o->base, *how) : o->base;
        const glm::dmat4 world = worldFromMesh(s, id, worlds);
        const Attribute* normal = mesh.find("normal", Domain::Corner);
        for (size_t c = 0; c < mesh.cornerCount(); ++c) {
            shown[place].places.push_back(world * glm::dvec4(mesh.positions()[mesh.cornerVertex()[c]], 1));
            if (normal)
                shown[place].normals.push_back(
                    glm::normalize(glm::inverseTranspose(glm::dmat3(world)) * glm::dvec3(normal->at(c, 0), normal->at(c, 1), normal->at(c, 2))));
        }
    }
    return shown;
}

void expectSame(const Shown& ours, const Shown& theirs)
{
    ASSERT_FALSE(theirs.empty());
    ASSERT_EQ(ours.size(), theirs.size());
    glm::dvec3 low(1e300), high(-1e300);
    for (const auto& [node, c] : theirs)
        for (const glm::dvec3& p : c.places) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    const double tolerance = 1e-4 * glm::length(high - low);
    for (const auto& [node, c] : theirs) {
        ASSERT_TRUE(ours.count(node));
        const Corners& o = ours.at(node);
        ASSERT_EQ(o.places.size(), c.places.size());
        double worst = 0, turned = 0;
        for (size_t i = 0; i < c.places.size(); ++i) worst = std::max(worst, glm::length(o.places[i] - c.places[i]));
        EXPECT_LE(worst, tolerance) << "node " << node;
        if (c.normals.size() != c.places.size()) continue;
        ASSERT_EQ(o.normals.size(), c.normals.size());
        for (size_t i = 0; i < c.normals.size(); ++i) turned = std::max(turned, glm::length(o.normals[i] - c.normals[i]));
        EXPECT_LE(turned, 2e-3) << "node " << node;
    }
}

class GltfProof : public testing::TestWithParam<const char*> {};

/// `body` is called with the clip (-1: at rest) and the time.
void atTenTimes(const Evaluator& e, const std::function<void(int, double)>& body)
{
    body(-1, 0);
    for (size_t clip = 0; clip < e.clips(); ++clip)
        for (int i = 0; i < 10; ++i) body(int(clip), e.duration(clip) * i / 9);
}

TEST_P(GltfProof, CornersStandWhereTheSpecificationSays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    Evaluator e(data / GetParam());
    const Scene s = readFile(data / GetParam()).scene;
    ASSERT_EQ(s.clips().size(), e.clips());
    atTenTimes(e, [&](int clip, double time) {
        SCOPED_TRACE("clip " + std::to_string(clip) + " at " + std::to_string(time));
        const ScenePose pose = clip < 0 ? ScenePose() : poseAt(s, *s.find(s.clips()[size_t(clip)]), time);
        expectSame(shownBy(s, pose), e.at(clip, time));
    });
}

/// Corners of all nodes together as places along a slanted line, ascending: for files whose nodes are in another order.
std::vector<double> alongALine(const Shown& shown, double& size)
{
    glm::dvec3 low(1e300), high(-1e300);
    std::vector<double> all;
    for (const auto& [node, c] : shown)
        for (const glm::dvec3& p : c.places) {
            low = glm::min(low, p);
            high = glm::max(high, p);
            all.push_back(p.x + 0.618 * p.y + 0.271 * p.z);
        }
    size = glm::length(high - low);
    std::sort(all.begin(), all.end());
    return all;
}

// What we write, read by the other program and evaluated by the specification, stands where the first file's did.
TEST_P(GltfProof, WrittenFilesStandThereToo)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const fs::path copy = fs::temp_directory_path() / ("meshwright-" + std::to_string(::getpid()) + ".glb");
    writeFile(readFile(data / GetParam()).scene, copy);
    Evaluator before(data / GetParam()), after(copy);
    fs::remove(copy);
    ASSERT_EQ(after.clips(), before.clips());
    atTenTimes(before, [&](int clip, double time) {
        SCOPED_TRACE("clip " + std::to_string(clip) + " at " + std::to_string(time));
        double size = 0, sizeAfter = 0;
        const std::vector<double> a = alongALine(before.at(clip, time), size), b = alongALine(after.at(clip, time), sizeAfter);
        EXPECT_NEAR(size, sizeAfter, 1e-4 * size);
        ASSERT_EQ(a.size(), b.size());
        for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1.5e-4 * size);
    });
}

INSTANTIATE_TEST_SUITE_P(Data, GltfProof,
                         testing::Values("characters/cesium_man.gltf", "characters/rigged_simple.gltf", "characters/robot.glb",
                                         "characters/simple_skin.gltf", "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf",
                                         "gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf", "gltf/MorphPrimitivesTest/MorphPrimitivesTest.gltf",
                                         "gltf/SimpleMorph/SimpleMorph.gltf", "gltf/BoxTextured/BoxTextured.gltf", "gltf/BoxTextured.glb"));

}  // namespace
}  // namespace mw::test
