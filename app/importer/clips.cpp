// Motions.
#include <algorithm>
#include <assimp/anim.h>
#include <assimp/scene.h>
#include <glm/gtc/quaternion.hpp>
#include <memory>

#include "app/importer/conversion.h"

namespace mw {

namespace {

constexpr Finding nodeFinding{"missing-node", "motion is of a node that is not there: left out", "motions are of nodes that are not there: left out"};
constexpr Finding keyFinding{"bad-key", "key is no number or at the time of another: left out",
                             "keys are no numbers or at the time of another: left out"};
constexpr double defaultTicks = 25;

/// Keys of any of Assimp's kinds as times and numbers: in order, finite, one at a time.
template <class Key, class Write>
Channel channelOf(Conversion& c, const Key* keys, unsigned count, double ticks, double shift, int components, Write write)
{
    std::vector<unsigned> order(count);
    for (unsigned k = 0; k < count; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) { return keys[a].mTime < keys[b].mTime; });
    Array<double> times, values;
    std::vector<double> v(static_cast<size_t>(components));
    for (const unsigned k : order) {
        const double time = (keys[k].mTime + shift) / ticks;
        write(keys[k], v.data());
        const bool good = std::isfinite(time) && time >= 0 && std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
        if (!good || (!times.empty() && time <= times.back())) {
            c.findings.add(keyFinding);
            continue;
        }
        times.push_back(time);
        values.insert(values.end(), v.begin(), v.end());
    }
    Channel out;
    out.components = components;
    out.times = std::move(times);
    out.values = std::move(values);
    return out;
}

// Quaternions of both signs are the same rotation; neighbours get the same sign, all unit length.
Channel continuous(const Channel& in)
{
    Array<double> v(in.values.begin(), in.values.end());
    glm::dquat last(1, 0, 0, 0);
    for (size_t i = 0; i < v.size(); i += 4) {
        glm::dquat q(v[i + 3], v[i], v[i + 1], v[i + 2]);
        q = glm::length(q) > 1e-9 ? glm::normalize(q) : last;
        if (i > 0 && glm::dot(q, last) < 0) q = -q;
        v[i] = q.x, v[i + 1] = q.y, v[i + 2] = q.z, v[i + 3] = q.w;
        last = q;
    }
    Channel out = in;
    out.values = std::move(v);
    return out;
}

// Assimp writes keys of scale for every node that turns, although a file has none.
bool saysNothing(const Channel& scale, const glm::dvec3& rest)
{
    for (size_t i = 0; i < scale.values.size(); ++i)
        if (std::abs(scale.values[i] - rest[int(i % 3)]) > 2e-6 * std::max(1.0, std::abs(rest[int(i % 3)]))) return false;
    return true;
}

class ClipReader {
public:
    ClipReader(Conversion& c, const aiAnimation& in, double ticks) : c_(c), in_(in), ticks_(ticks) { findStart(); }
    Clip read(std::string name);

private:
    void findStart();
    void readNode(const aiNodeAnim& a, NodeId node);
    void readMorph(const aiMeshMorphAnim& a);
    void add(Channel channel, NodeId node, Channel::Path path);

    Conversion& c_;
    const aiAnimation& in_;
    double ticks_, shift_ = 0;
    Clip clip_;
};

// Times before 0 move the whole clip.
void ClipReader::findStart()
{
    double first = 0;
    const auto look = [&](const auto* keys, unsigned n) {
        for (unsigned k = 0; k < n; ++k)
            if (std::isfinite(keys[k].mTime)) first = std::min(first, keys[k].mTime);
    };
    for (unsigned i = 0; i < in_.mNumChannels; ++i) {
        const aiNodeAnim& a = *in_.mChannels[i];
        look(a.mPositionKeys, a.mNumPositionKeys);
        look(a.mRotationKeys, a.mNumRotationKeys);
        look(a.mScalingKeys, a.mNumScalingKeys);
    }
    for (unsigned i = 0; i < in_.mNumMorphMeshChannels; ++i) look(in_.mMorphMeshChannels[i]->mKeys, in_.mMorphMeshChannels[i]->mNumKeys);
    shift_ = -first;
}

void ClipReader::add(Channel channel, NodeId node, Channel::Path path)
{
    if (channel.times.empty()) return;
    channel.node = node;
    channel.path = path;
    for (const auto& known : clip_.channels)  // times that are the same are kept once
        if (std::ranges::equal(known->times, channel.times)) {
            channel.times = known->times;
            break;
        }
    clip_.channels.push_back(std::make_shared<const Channel>(std::move(channel)));
    c_.driven.insert(node);
}

void ClipReader::readNode(const aiNodeAnim& a, NodeId node)
{
    const auto three = [](const aiVectorKey& k, double* out) {
        for (unsigned i = 0; i < 3; ++i) out[i] = double(k.mValue[i]);
    };
    add(channelOf(c_, a.mPositionKeys, a.mNumPositionKeys, ticks_, shift_, 3, three), node, Channel::Path::Translation);
    add(continuous(channelOf(c_, a.mRotationKeys, a.mNumRotationKeys, ticks_, shift_, 4,
                             [](const aiQuatKey& k, double* out) {
                                 out[0] = double(k.mValue.x), out[1] = double(k.mValue.y), out[2] = double(k.mValue.z), out[3] = double(k.mValue.w);
                             })),
        node, Channel::Path::Rotation);
    Channel scale = channelOf(c_, a.mScalingKeys, a.mNumScalingKeys, ticks_, shift_, 3, three);
    if (!saysNothing(scale, c_.parts.nodes.at(node).local.scale)) add(std::move(scale), node, Channel::Path::Scale);
}

size_t targetsOf(const Conversion& c, NodeId node)
{
    const Node& n = c.parts.nodes.at(node);
    if (!n.mesh) return 0;
    size_t count = 0;
    for (const Attribute& a : c.parts.meshes.at(n.mesh).base.attributes()) count += a.name.starts_with(names::morph);
    return count;
}

void ClipReader::readMorph(const aiMeshMorphAnim& a)
{
    std::string name = a.mName.data;  // its length may lie
    if (const size_t star = name.find('*'); star != name.npos) name.resize(star);
    auto found = c_.byName.find(name);
    if (found == c_.byName.end() || !targetsOf(c_, found->second)) {
        // Some formats go by the name of the mesh.
        for (auto it = c_.byName.begin(); it != c_.byName.end() && (found == c_.byName.end() || !targetsOf(c_, found->second)); ++it)
            if (const MeshId mesh = c_.parts.nodes.at(it->second).mesh; mesh && c_.parts.meshes.at(mesh).name == name) found = it;
    }
    const size_t targets = found == c_.byName.end() ? 0 : targetsOf(c_, found->second);
    if (targets == 0 || targets > 4096) {
        c_.findings.add(nodeFinding, [&] { return "weights of \"" + text(aiString(name)) + "\""; });
        return;
    }
    add(channelOf(c_, a.mKeys, a.mNumKeys, ticks_, shift_, int(targets),
                  [&](const aiMeshMorphKey& k, double* out) {
                      std::fill_n(out, targets, 0.0);
                      for (unsigned i = 0; i < k.mNumValuesAndWeights; ++i)
                          if (k.mValues[i] < targets) out[k.mValues[i]] = k.mWeights[i];
                  }),
        found->second, Channel::Path::Weights);
}

Clip ClipReader::read(std::string name)
{
    clip_.name = std::move(name);
    for (unsigned i = 0; i < in_.mNumChannels; ++i) {
        const aiNodeAnim& a = *in_.mChannels[i];
        const auto found = c_.byName.find(a.mNodeName.C_Str());
        if (found == c_.byName.end())
            c_.findings.add(nodeFinding, [&] { return "\"" + text(a.mNodeName) + "\""; });
        else
            readNode(a, found->second);
    }
    for (unsigned i = 0; i < in_.mNumMorphMeshChannels; ++i) readMorph(*in_.mMorphMeshChannels[i]);
    return std::move(clip_);
}

}  // namespace

void addClips(Conversion& c)
{
    std::set<std::string> taken;
    for (unsigned i = 0; i < c.in.mNumAnimations; ++i) {
        const aiAnimation& a = *c.in.mAnimations[i];
        std::string name = text(a.mName);
        if (name.empty()) name = c.in.mNumAnimations == 1 ? c.file.stem().string() : c.file.stem().string() + " " + std::to_string(i + 1);
        const std::string stem = name;
        for (size_t n = 2; !taken.insert(name).second; ++n) name = stem + " " + std::to_string(n);
        const bool known = std::isfinite(a.mTicksPerSecond) && a.mTicksPerSecond > 0;
        if (!known) c.warn("no-ticks", "clip \"" + name + "\" does not say how fast it is: 25 ticks a second were taken");
        if (a.mNumMeshChannels) c.warn("mesh-channels", "clip \"" + name + "\" exchanges whole meshes, which was left out");
        Clip clip = ClipReader(c, a, known ? a.mTicksPerSecond : defaultTicks).read(name);
        if (!clip.channels.empty()) c.keep(c.parts.clips, std::move(clip));
    }
}

}  // namespace mw
