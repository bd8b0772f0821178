#include "core/io/gltf_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <numeric>
#include <set>

namespace mw {

namespace {

Array<uint32_t> firstElements(size_t n)
{
    Array<uint32_t> all(n);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

Array<double> doubles(GltfDocument& document, const GltfAccessor& a, size_t count)
{
    document.charge(count * (4 + 8 * size_t(a.components)), a.pointer);
    const Array<float> values = document.floats(a, firstElements(count));
    return Array<double>(values.begin(), values.end());
}

bool allFinite(std::span<const double> values)
{
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

// The matrices of a skin; empty (and a warning) when they cannot be used.
std::vector<glm::dmat4> inverseBinds(GltfDocument& document, const JsonPlace& place, size_t joints)
{
    const auto index = place.index("inverseBindMatrices", document.accessors(), "accessor");
    if (!index) return std::vector<glm::dmat4>(joints, glm::dmat4(1));
    const auto refuse = [&](const std::string& why) {
        document.warnings().push_back({"bad-skin", place.pointer() + ": " + why + "; the skin was left out, its mesh stands still", {}});
        return std::vector<glm::dmat4>();
    };
    const GltfAccessor& a = document.accessor(*index);
    if (a.components != 16 || a.component != GltfComponent::Float32) return refuse("its inverse bind matrices are no MAT4 of floats");
    if (a.count < joints) return refuse(std::to_string(a.count) + " inverse bind matrices for " + std::to_string(joints) + " joints");
    const Array<double> values = doubles(document, a, joints);
    if (!allFinite(values)) return refuse("an inverse bind matrix has numbers that are none");
    std::vector<glm::dmat4> out;
    for (size_t i = 0; i < joints; ++i) out.push_back(glm::make_mat4(values.data() + 16 * i));
    return out;
}

std::optional<Skin> skinAt(GltfDocument& document, const JsonPlace& place, const GltfNodes& nodes)
{
    Skin skin;
    skin.name = place.text("name");
    const JsonPlace joints = place["joints"];
    document.charge(joints.size() * (sizeof(NodeId) + sizeof(glm::dmat4)), place.pointer());
    bool there = joints.size() > 0;
    for (size_t i = 0; i < joints.size(); ++i) {
        skin.joints.push_back(nodes.ids[joints[i].index(nodes.ids.size(), "node")]);
        there = there && skin.joints.back();
    }
    if (const auto root = place.index("skeleton", nodes.ids.size(), "node")) skin.skeleton = nodes.ids[*root];
    skin.inverseBind = inverseBinds(document, place, skin.joints.size());
    if (!there)
        document.warnings().push_back(
            {"bad-skin", place.pointer() + ": it has no joints, or some that the scene does not show; the skin was left out", {}});
    if (!there || skin.inverseBind.empty()) return std::nullopt;
    return skin;
}

class ClipReader {
public:
    ClipReader(GltfDocument& document, const GltfNodes& nodes) : document_(document), nodes_(nodes) {}
    Clip read(const JsonPlace& place);

private:
    struct Numbers {
        Shared<double> values;
        std::string wrong;  // why they cannot be used; empty when they can
    };
    std::shared_ptr<const Channel> channel(const JsonPlace& animation, const JsonPlace& place);
    bool findTarget(const JsonPlace& target, Channel& c);
    bool readKeys(const JsonPlace& place, const JsonPlace& sampler, Channel& c);
    const Numbers& times(uint32_t accessor);
    const Numbers& values(uint32_t accessor);
    bool leaveOut(const JsonPlace& place, const std::string& why)
    {
        document_.charge(256, place.pointer());
        document_.warnings().push_back({"bad-channel", place.pointer() + ": " + why + "; that channel was left out", {}});
        return false;
    }

    GltfDocument& document_;
    const GltfNodes& nodes_;
    std::map<uint32_t, Numbers> times_, values_;  // by accessor: what files share stays shared
};

Clip ClipReader::read(const JsonPlace& place)
{
    Clip clip;
    clip.name = place.text("name");
    const JsonPlace channels = place["channels"];
    std::set<std::pair<NodeId, Channel::Path>> driven;
    for (size_t i = 0; i < channels.size(); ++i) {
        const auto c = channel(place, channels[i]);
        if (!c) continue;
        if (driven.emplace(c->node, c->path).second)
            clip.channels.push_back(c);
        else
            leaveOut(channels[i], "another channel drives the same already");
    }
    return clip;
}

// Node and path; false (and a warning) when it is nothing of ours.
bool ClipReader::findTarget(const JsonPlace& target, Channel& c)
{
    static const std::map<std::string, Channel::Path> paths{{"translation", Channel::Path::Translation},
                                                            {"rotation", Channel::Path::Rotation},
                                                            {"scale", Channel::Path::Scale},
                                                            {"weights", Channel::Path::Weights}};
    const auto path = paths.find(target["path"].text());
    const auto node = target.index("node", nodes_.ids.size(), "node");
    if (path == paths.end()) return leaveOut(target, "\"" + target["path"].text().substr(0, 40) + "\" is no property that can be driven here");
    if (!node) return leaveOut(target, "it names no node");
    c.node = nodes_.ids[*node];
    c.path = path->second;
    if (!c.node) return leaveOut(target, "its node is not in the scene");
    c.components = c.path == Channel::Path::Rotation ? 4 : c.path == Channel::Path::Weights ? int(nodes_.morphTargets[*node]) : 3;
    return c.components > 0 || leaveOut(target, "its node has no morph targets");
}

std::shared_ptr<const Channel> ClipReader::channel(const JsonPlace& animation, const JsonPlace& place)
{
    document_.charge(sizeof(Channel) + 64, place.pointer());
    const JsonPlace samplers = animation["samplers"];
    const JsonPlace sampler = samplers[place["sampler"].index(samplers.size(), "sampler")];
    Channel c;
    if (!findTarget(place["target"], c) || !readKeys(place, sampler, c)) return nullptr;
    return std::make_shared<const Channel>(std::move(c));
}

bool ClipReader::readKeys(const JsonPlace& place, const JsonPlace& sampler, Channel& c)
{
    const std::string kind = sampler.text("interpolation");
    if (kind == "STEP")
        c.interpolation = Channel::Interpolation::Step;
    else if (kind == "CUBICSPLINE")
        c.interpolation = Channel::Interpolation::Cubic;
    else if (!kind.empty() && kind != "LINEAR")
        return leaveOut(place, "there is no interpolation \"" + kind.substr(0, 40) + "\"");
    const uint32_t input = sampler["input"].index(document_.accessors(), "accessor");
    const uint32_t output = sampler["output"].index(document_.accessors(), "accessor");
    const Numbers& t = times(input);
    if (!t.wrong.empty()) return leaveOut(place, t.wrong);
    const GltfAccessor& a = document_.accessor(output);
    const bool weights = c.path == Channel::Path::Weights;
    const size_t perKey = c.interpolation == Channel::Interpolation::Cubic ? 3 : 1, n = size_t(c.components);
    if (a.components != (weights ? 1 : c.components)) return leaveOut(place, a.pointer + " is of a type that does not fit");
    const double needed = double(t.values.size()) * double(perKey) * (weights ? double(n) : 1);
    if (double(a.count) != needed)
        return leaveOut(place, a.pointer + " has " + std::to_string(a.count) + " values where " + std::to_string(uint64_t(needed)) + " belong");
    const Numbers& v = values(output);
    if (!v.wrong.empty()) return leaveOut(place, v.wrong);
    for (size_t k = 0; c.path == Channel::Path::Rotation && k < t.values.size(); ++k) {
        const double* q = v.values.data() + 4 * (perKey * k + perKey / 2);
        if (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] < 1e-12)
            return leaveOut(place, "key " + std::to_string(k) + " of " + a.pointer + " is no rotation");
    }
    c.times = t.values;
    c.values = v.values;
    return true;
}

const ClipReader::Numbers& ClipReader::times(uint32_t accessor)
{
    const auto [known, fresh] = times_.try_emplace(accessor);
    Numbers& n = known->second;
    if (!fresh) return n;
    const GltfAccessor& a = document_.accessor(accessor);
    if (a.components != 1 || a.component != GltfComponent::Float32 || a.count == 0) {
        n.wrong = a.pointer + " holds no times";
        return n;
    }
    Array<double> t = doubles(document_, a, a.count);
    double last = -1;
    for (size_t i = 0; i < t.size() && n.wrong.empty(); last = t[i++]) {
        if (!(t[i] >= 0) || !std::isfinite(t[i]))
            n.wrong = "time " + std::to_string(i) + " of " + a.pointer + " is negative or no number";
        else if (!(t[i] > last))
            n.wrong = "time " + std::to_string(i) + " of " + a.pointer + " is not after the one before it";
    }
    n.values = std::move(t);
    return n;
}

const ClipReader::Numbers& ClipReader::values(uint32_t accessor)
{
    const auto [known, fresh] = values_.try_emplace(accessor);
    Numbers& n = known->second;
    if (!fresh) return n;
    const GltfAccessor& a = document_.accessor(accessor);
    if (a.component != GltfComponent::Float32 && !a.normalized) {
        n.wrong = a.pointer + " holds whole numbers that are not normalised";
        return n;
    }
    Array<double> v = doubles(document_, a, a.count);
    if (!allFinite(v)) n.wrong = a.pointer + " has values that are no numbers";
    n.values = std::move(v);
    return n;
}

}  // namespace

std::vector<std::optional<Skin>> gltfSkins(GltfDocument& document, const GltfNodes& nodes)
{
    std::vector<std::optional<Skin>> skins;
    for (size_t i = 0; i < document.root().sizeOf("skins"); ++i) skins.push_back(skinAt(document, document.root()["skins"][i], nodes));
    return skins;
}

std::vector<Clip> gltfClips(GltfDocument& document, const GltfNodes& nodes)
{
    std::vector<Clip> clips;
    ClipReader reader(document, nodes);
    for (size_t i = 0; i < document.root().sizeOf("animations"); ++i) {
        const JsonPlace place = document.root()["animations"][i];
        Clip clip = reader.read(place);
        if (clip.channels.empty())
            document.warnings().push_back({"empty-animation", place.pointer() + ": drives nothing and was left out", {}});
        else
            clips.push_back(std::move(clip));
    }
    return clips;
}

Mesh withinSlots(const Mesh& mesh, size_t slots, size_t& left)
{
    left = 0;
    const Attribute *j = mesh.find(names::joints, Domain::Vertex), *w = mesh.find(names::weights, Domain::Vertex);
    if (!j || !w) return mesh;
    Array<int32_t> joints(j->integers().begin(), j->integers().end());
    Array<float> weights(w->floats().begin(), w->floats().end());
    const size_t n = size_t(j->components);
    bool changed = false;
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        double sum = 0;
        bool lost = false;
        for (size_t k = n * v; k < n * (v + 1); ++k) {
            if (joints[k] < 0 || size_t(joints[k]) >= slots) {
                lost = lost || weights[k] > 0;
                changed = true;
                joints[k] = 0;
                weights[k] = 0;
            }
            sum += double(weights[k]);
        }
        left += lost;
        for (size_t k = n * v; lost && sum > 0 && k < n * (v + 1); ++k) weights[k] = float(double(weights[k]) / sum);
    }
    if (!changed) return mesh;
    Attribute newJoints = integerAttribute(j->name, Domain::Vertex, j->components, std::move(joints));
    newJoints.stored = j->stored;
    return mesh.with(std::move(newJoints)).with(floatAttribute(w->name, Domain::Vertex, w->components, std::move(weights)));
}

}  // namespace mw
