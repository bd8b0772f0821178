// Skeletons and their motion as BVH text. Joints moved by angles and positions alone, as a BVH file has them, go out number by number; all others
// are measured in the world each frame, so that parents outside of the skeleton and scale put every joint in its place.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/io/bvh.h"
#include "core/io/bvh_data.h"
#include "core/io/text.h"
#include "core/io/text_out.h"
#include "core/scene/scene_pose.h"

namespace mw {

namespace {

constexpr double mostFrames = 1e8, mostMeasures = 1 << 23;
constexpr size_t deepestIndent = 40;  ///< a very deep hierarchy would be all tabs

/// One joint of the file.
struct Row {
    NodeId node;
    uint32_t parent = none;  ///< row
    bool end = false;
    size_t depth = 0;
    std::string name;
    glm::dvec3 offset{0};
    std::vector<Channel::Path> paths;
    std::vector<const Channel*> channels;  ///< one a path when its numbers go out as they are
    bool measured = false;
    size_t firstColumn = 0;
};

/// What is measured of one joint in one frame.
struct Measure {
    glm::dvec3 place, angles;  ///< relative to the joint above; degrees z, x, y
};

glm::dvec3 turnsNear(glm::dvec3 angles, const glm::dvec3& before)
{
    for (int i = 0; i < 3; ++i) angles[i] += 360 * std::round((before[i] - angles[i]) / 360);
    return angles;
}

/// R = Rz Rx Ry (7.6), of the triples of angles that mean it the one nearest to `before`.
glm::dvec3 anglesOf(const glm::dquat& rotation, const glm::dvec3& before)
{
    const glm::dmat3 m = glm::mat3_cast(rotation);  // m[column][row]
    const double sine = m[1][2], cosine = std::hypot(m[0][2], m[2][2]);
    if (cosine < 1e-6) {  // x is a quarter turn: z and y turn about one axis, y is left as it was
        const double s = sine < 0 ? -1 : 1, sum = glm::degrees(std::atan2(m[0][1], m[0][0]));
        return turnsNear({sum - s * before.z, s * 90, before.z}, before);
    }
    const glm::dvec3 one(glm::degrees(std::atan2(-m[1][0], m[1][1])), glm::degrees(std::atan2(sine, cosine)),
                         glm::degrees(std::atan2(-m[0][2], m[2][2])));
    const glm::dvec3 a = turnsNear(one, before), b = turnsNear({one.x + 180, 180 - one.y, one.z + 180}, before);
    const glm::dvec3 da = a - before, db = b - before;
    return glm::dot(da, da) <= glm::dot(db, db) ? a : b;
}

bool isAngle(Channel::Path p)
{
    return p >= Channel::Path::EulerX;
}
bool isPosition(Channel::Path p)
{
    return p >= Channel::Path::PositionX && p <= Channel::Path::PositionZ;
}

class Writer {
public:
    Writer(const Scene& scene, const std::filesystem::path& file, Progress* progress) : scene_(scene), file_(file), progress_(progress) {}
    std::vector<Warning> run();

private:
    void chooseClip();
    void addSkeleton(NodeId root);
    bool isPlain() const;
    void choosePaths(bool plain);
    void nameRows(bool plain);
    void chooseFrames();
    void measure();
    void measureFrame(size_t frame);
    void placeChannels();
    void lost();

    void hierarchy(OutputFile& out);
    void motion(OutputFile& out);
    void numbersOf(const Row& r, size_t frame, double* to) const;

    const Scene& scene_;
    const std::filesystem::path& file_;
    Progress* progress_;
    const Clip* clip_ = nullptr;
    std::map<NodeId, std::vector<const Channel*>> driven_;
    std::vector<NodeId> roots_;
    std::vector<Row> rows_;
    std::map<NodeId, uint32_t> rowOf_;
    size_t frames_ = 1, columns_ = 0;
    double frameTime_ = defaultFrameTime;
    std::vector<uint32_t> measuredRows_;
    std::vector<Measure> measures_;  ///< frames times measured rows
    bool scaled_ = false;
    bool endSites_ = false;  ///< joints without children get one: what is no BVH file has none, and programs want them
    std::vector<Warning> warnings_;
};

void Writer::chooseClip()
{
    const std::vector<ClipId> clips = scene_.clips();
    if (clips.empty()) return;
    clip_ = scene_.find(clips[0]);
    for (const auto& c : clip_->channels)
        if (c->keys() > 0) driven_[c->node].push_back(c.get());
    if (clips.size() > 1)
        warnings_.push_back(
            {"clips-lost",
             "BVH holds one clip: \"" + clip_->name + "\" is written, " + std::to_string(clips.size() - 1) + " further ones are left out",
             {}});
}

void Writer::addSkeleton(NodeId root)
{
    const Pose rest = poseOf(scene_, root);
    const uint32_t first = uint32_t(rows_.size());
    for (size_t i = 0; i < rest.size(); ++i) {
        const Joint& j = rest.skeleton->joints[i];
        Row r;
        r.node = j.node;
        r.end = j.end;
        r.offset = j.rest.translation;
        r.name = j.name;
        if (j.parent != none) {
            r.parent = first + j.parent;
            r.depth = rows_[r.parent].depth + 1;
        }
        rowOf_[j.node] = uint32_t(rows_.size());
        rows_.push_back(std::move(r));
    }
}

/// Local numbers are those of a BVH file: nothing is scaled, and nothing outside of the skeletons moves them.
bool Writer::isPlain() const
{
    bool angles = false;
    for (const auto& [node, channels] : driven_)
        for (const Channel* c : channels) {
            if (c->path == Channel::Path::Scale && rowOf_.contains(node)) return false;
            angles = angles || isAngle(c->path) || isPosition(c->path);
        }
    for (const Row& r : rows_)
        if (scene_.node(r.node).local.scale != glm::dvec3(1)) return false;
    for (const NodeId root : roots_)
        for (NodeId a = scene_.node(root).parent; a; a = scene_.node(a).parent)
            if (driven_.contains(a) || scene_.node(a).local.matrix() != glm::dmat4(1)) return false;
    return angles;
}

void Writer::choosePaths(bool plain)
{
    using Path = Channel::Path;
    for (uint32_t i = 0; i < rows_.size(); ++i) {
        Row& r = rows_[i];
        const auto found = driven_.find(r.node);
        const std::vector<const Channel*> channels = found == driven_.end() ? std::vector<const Channel*>() : found->second;
        const bool only = std::all_of(channels.begin(), channels.end(), [](const Channel* c) { return isAngle(c->path) || isPosition(c->path); });
        const bool turned = std::any_of(channels.begin(), channels.end(), [](const Channel* c) { return isAngle(c->path); });
        if (plain && only && (turned || scene_.node(r.node).local.rotation == glm::dquat(1, 0, 0, 0))) {
            r.channels = channels;
            for (const Channel* c : channels) r.paths.push_back(c->path);
        } else if (!r.end || !channels.empty()) {
            r.measured = true;
            if (r.parent == none) r.paths = {Path::PositionX, Path::PositionY, Path::PositionZ};
            r.paths.insert(r.paths.end(), {Path::EulerZ, Path::EulerX, Path::EulerY});
        }
        if (r.measured || !plain) measuredRows_.push_back(i);
    }
}

/// Names of BVH files go out as they are. Others get what programs that read word by word need: one word, each once.
void Writer::nameRows(bool plain)
{
    std::set<std::string> used;
    for (Row& r : rows_) {
        for (char& c : r.name)
            if (uint8_t(c) < ' ' || c == '{' || c == '}' || (!plain && c == ' ')) c = '_';
        r.name = trimmed(r.name);
        if (plain || r.end) continue;
        const std::string base = r.name.empty() ? "joint" : r.name;
        r.name = base;
        for (int i = 2; !used.insert(r.name).second; ++i) r.name = base + "_" + std::to_string(i);
    }
}

void Writer::chooseFrames()
{
    if (!clip_) return;
    if (clip_->frameTime > 0) frameTime_ = clip_->frameTime;
    const double frames = std::ceil(duration(*clip_) / frameTime_ - 1e-6) + 1;
    if (!(frames <= mostFrames && frames * double(measuredRows_.size()) <= mostMeasures))
        throw Error(file_.string(), "clip \"" + clip_->name + "\" has too many frames; shorten it or use longer frames");
    frames_ = size_t(std::max(1.0, frames));
}

void Writer::measureFrame(size_t frame)
{
    const size_t n = measuredRows_.size();
    const ScenePose pose = clip_ ? poseAt(scene_, *clip_, double(frame) * frameTime_) : ScenePose();
    std::vector<Transform> worlds(rows_.size());
    for (const NodeId root : roots_) {
        const Pose p = poseOf(scene_, root, pose);
        const std::vector<glm::dmat4> matrices = worldMatrices(p);
        for (size_t i = 0; i < p.size(); ++i) worlds[rowOf_.at(p.skeleton->joints[i].node)] = transformOf(matrices[i]);
    }
    for (size_t k = 0; k < n; ++k) {
        const Row& r = rows_[measuredRows_[k]];
        const Transform &w = worlds[measuredRows_[k]], above = r.parent == none ? Transform() : worlds[r.parent];
        const glm::dquat back = glm::conjugate(above.rotation);
        Measure& m = measures_[frame * n + k];
        m.place = back * (w.translation - above.translation);
        m.angles = anglesOf(back * w.rotation, frame ? measures_[(frame - 1) * n + k].angles : glm::dvec3(0));
        const glm::dvec3 off = glm::abs(w.scale - glm::dvec3(1));
        scaled_ = scaled_ || std::max({off.x, off.y, off.z}) > 1e-4;
    }
}

void Writer::measure()
{
    if (measuredRows_.empty()) return;
    measures_.resize(frames_ * measuredRows_.size());
    for (size_t f = 0; f < frames_; ++f) {
        if (progress_) progress_->at(0.7f * float(f) / float(frames_));
        measureFrame(f);
    }
    placeChannels();
}

/// Offsets are those of the first frame; a joint that leaves it gets channels for its place. A root stands at 0 and has them always, because
/// programs do not agree whether a position is added to an offset.
void Writer::placeChannels()
{
    using Path = Channel::Path;
    const size_t n = measuredRows_.size();
    double size = 0;
    for (size_t k = 0; k < n; ++k) size = std::max(size, glm::length(measures_[k].place));
    for (size_t k = 0; k < n; ++k) {
        Row& r = rows_[measuredRows_[k]];
        r.offset = r.parent == none ? glm::dvec3(0) : measures_[k].place;
        if (r.parent == none || !r.measured) continue;
        double farthest = 0;
        for (size_t f = 0; f < frames_; ++f) farthest = std::max(farthest, glm::length(measures_[f * n + k].place - r.offset));
        if (farthest > 1e-6 * size) r.paths.insert(r.paths.begin(), {Path::PositionX, Path::PositionY, Path::PositionZ});
    }
}

void Writer::lost()
{
    size_t weights = 0, others = 0;
    for (const auto& [node, channels] : driven_)
        for (const Channel* c : channels) {
            if (c->path == Channel::Path::Weights)
                ++weights;
            else if (!rowOf_.contains(node))
                ++others;
        }
    const auto say = [&](bool when, const char* code, const std::string& text) {
        if (when) warnings_.push_back({code, text, {}});
    };
    say(roots_.size() > 1, "several-roots", std::to_string(roots_.size()) + " skeletons are written, each a ROOT; many programs refuse such files");
    say(scaled_, "scale-lost", "BVH has no scale: joints stand where they should, but their scale is left out");
    say(weights > 0, "morph-lost", "BVH has no morph targets: " + std::to_string(weights) + " channels of weights are left out");
    say(others > 0, "motion-lost",
        std::to_string(others) + " channels move nodes that are no joints; where these carry no skeleton they are left out");
    say(!scene_.meshes().empty(), "mesh-lost", "BVH holds skeletons and motion only: meshes are left out");
}

const char* tabs(size_t depth)
{
    static const std::string all(deepestIndent, '\t');
    return all.c_str() + (deepestIndent - std::min(depth, deepestIndent));
}

void Writer::hierarchy(OutputFile& file)
{
    TextOut out(file);
    file.write("HIERARCHY\n");
    for (size_t i = 0; i < rows_.size(); ++i) {
        const Row& r = rows_[i];
        const std::string indent = tabs(r.depth);
        const bool named = r.name.starts_with("End ");
        file.write(indent + (r.end ? (named ? r.name : "End Site") : (r.parent == none ? "ROOT " : "JOINT ") + r.name) + "\n" + indent + "{\n");
        out.begin(3 + 2);
        out.word(tabs(r.depth + 1));
        out.word("OFFSET");
        for (int k = 0; k < 3; ++k) {
            out.put(' ');
            out.number(r.offset[k]);
        }
        out.end();
        if (!r.end || !r.paths.empty()) {
            std::string line = std::string(tabs(r.depth + 1)) + "CHANNELS " + std::to_string(r.paths.size());
            for (const Channel::Path p : r.paths) (line += ' ') += bvhChannelNames[int(p) - int(Channel::Path::PositionX)];
            file.write(line + "\n");
        }
        const size_t next = i + 1 < rows_.size() ? rows_[i + 1].depth : 0;
        if (endSites_ && !r.end && next <= r.depth) {
            const std::string inner = tabs(r.depth + 1);
            file.write(inner + "End Site\n" + inner + "{\n" + tabs(r.depth + 2) + "OFFSET 0 0 0\n" + inner + "}\n");
        }
        for (size_t d = r.depth + 1; d-- > next;) file.write(std::string(tabs(d)) + "}\n");
    }
}

void Writer::numbersOf(const Row& r, size_t frame, double* to) const
{
    if (!r.measured) {
        for (size_t i = 0; i < r.channels.size(); ++i) sample(*r.channels[i], double(frame) * frameTime_, to + i);
        return;
    }
    const size_t k = size_t(std::lower_bound(measuredRows_.begin(), measuredRows_.end(), rowOf_.at(r.node)) - measuredRows_.begin());
    const Measure& m = measures_[frame * measuredRows_.size() + k];
    if (r.paths.size() > 3)
        for (int i = 0; i < 3; ++i) *to++ = m.place[i] - r.offset[i];
    for (int i = 0; i < 3; ++i) *to++ = m.angles[i];
}

void Writer::motion(OutputFile& file)
{
    TextOut out(file);
    file.write("MOTION\nFrames: " + std::to_string(frames_) + "\n");
    out.begin(1);
    out.word("Frame Time: ");
    out.number(frameTime_);
    out.end();
    std::vector<double> numbers(columns_);
    for (size_t f = 0; f < frames_; ++f) {
        for (const Row& r : rows_) numbersOf(r, f, numbers.data() + r.firstColumn);
        out.begin(columns_);
        for (size_t i = 0; i < columns_; ++i) {
            if (i) out.put(' ');
            out.number(numbers[i]);
        }
        out.end();
        if (progress_) progress_->at(0.7f + 0.3f * float(f) / float(frames_));
    }
}

std::vector<Warning> Writer::run()
{
    roots_ = skeletonRoots(scene_);
    if (roots_.empty()) throw Error(file_.string(), "there is no skeleton to write; BVH holds skeletons and their motion");
    chooseClip();
    for (const NodeId root : roots_) addSkeleton(root);
    const bool plain = isPlain();
    endSites_ = !plain;
    choosePaths(plain);
    nameRows(plain);
    chooseFrames();
    measure();
    for (Row& r : rows_) {
        r.firstColumn = columns_;
        columns_ += r.paths.size();
    }
    lost();
    OutputFile out(file_);
    hierarchy(out);
    motion(out);
    out.commit();
    return std::move(warnings_);
}

}  // namespace

std::vector<Warning> writeBvh(const Scene& scene, const std::filesystem::path& file, Progress* progress)
{
    return Writer(scene, file, progress).run();
}

}  // namespace mw
