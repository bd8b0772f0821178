// The node tree, and what a file says of lengths and axes.
#include <algorithm>
#include <assimp/scene.h>
#include <glm/gtc/matrix_transform.hpp>

#include "app/importer/conversion.h"
#include "core/io/file.h"
#include "core/io/placement.h"

namespace mw {

namespace {

constexpr Finding sheared{"sheared-matrix", "node shears, which translation, rotation and scale cannot say: the nearest was taken",
                          "nodes shear, which translation, rotation and scale cannot say: the nearest was taken"};
constexpr Finding notFinite{"bad-transform", "node has a transform that is no number: none was taken",
                            "nodes have transforms that are no numbers: none was taken"};

Transform localOf(Conversion& c, const glm::dmat4& m, const std::string& name)
{
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(m[i][k])) {
                c.findings.add(notFinite, [&] { return "\"" + name + "\""; });
                return {};
            }
    bool exact = true;
    Transform t = transformOf(m, &exact);
    if (!exact) c.findings.add(sheared, [&] { return "\"" + name + "\""; });
    for (int i = 0; i < 3; ++i)
        if (std::abs(t.scale[i] - 1) < 2e-6) t.scale[i] = 1;  // rounding of the decomposition
    return t;
}

// Names that Assimp gives to roots it makes up.
bool isMadeUp(const std::string& name)
{
    static const std::set<std::string> known{"", "ROOT", "RootNode", "$dummy_root", "<3DSRoot>", "<MD5_Root>", "<MD5_Hierarchy>"};
    return known.contains(name);
}

template <class T>
T meta(const aiScene& scene, const char* key, T otherwise)
{
    T value = otherwise;
    return scene.mMetaData && scene.mMetaData->Get(key, value) ? value : otherwise;
}

double unitScale(const aiScene& scene)
{
    const double narrow = double(meta<float>(scene, "UnitScaleFactor", 1.f));
    const double centimetres = meta<double>(scene, "UnitScaleFactor", narrow);
    return std::isfinite(centimetres) && centimetres > 0 ? centimetres / 100 : 0.01;
}

/// The text between two others; nothing when they are not there.
std::optional<std::string> between(const std::string& all, std::string_view before, std::string_view after)
{
    const size_t start = all.find(before), end = start == all.npos ? start : all.find(after, start + before.size());
    if (end == all.npos) return {};
    return all.substr(start + before.size(), end - start - before.size());
}

/// What stands in <asset>; COLLADA's own defaults are metres and +Y.
Placement colladaPlacement(const std::filesystem::path& file)
{
    const std::string start = readStart(file, size_t(1) << 16);
    Placement p;
    if (const auto unit = between(start, "<unit", ">"))
        if (const auto metres = between(*unit, "meter=\"", "\"")) p.metresPerUnit = metresOf(*metres).value_or(1);
    if (const auto axis = between(start, "<up_axis>", "<")) p.up = upAxisOf(*axis).value_or(UpAxis::Y);
    return p;
}

/// FBX: metres with +Y up from what its settings say. Others: Assimp has turned COLLADA already, the rest does not say.
glm::dmat4 conversionMatrix(Conversion& c)
{
    if (c.ending != ".fbx") return glm::dmat4(1);
    const auto axis = [&](const char* which, const char* sign, int otherwise) {
        glm::dvec3 a(0);
        const int index = meta<int32_t>(c.in, which, otherwise);
        a[index >= 0 && index < 3 ? index : otherwise] = meta<int32_t>(c.in, sign, 1) < 0 ? -1 : 1;
        return a;
    };
    glm::dvec3 up = axis("UpAxis", "UpAxisSign", 1), front = axis("FrontAxis", "FrontAxisSign", 2);
    if (glm::dot(up, front) != 0) up = {0, 1, 0}, front = {0, 0, 1};
    const glm::dvec3 right = glm::cross(up, front);
    if (glm::dot(right, axis("CoordAxis", "CoordAxisSign", 0)) < 0) c.warn("left-handed", "the file says it is left-handed; it may appear mirrored");
    const glm::dmat3 turn = glm::transpose(glm::dmat3(right, up, front));
    return glm::dmat4(turn * unitScale(c.in));
}

void addTree(Conversion& c, const aiNode& root, NodeId rootId)
{
    std::vector<std::pair<const aiNode*, NodeId>> open{{&root, rootId}};
    while (!open.empty()) {
        const auto [node, id] = open.back();
        open.pop_back();
        for (unsigned i = 0; i < node->mNumChildren; ++i) {
            const aiNode& child = *node->mChildren[i];
            Node n;
            n.name = text(child.mName);
            n.local = localOf(c, matrix(child.mTransformation), n.name);
            const NodeId childId = c.addNode(std::move(n), id);
            c.nodeOf[&child] = childId;
            open.emplace_back(&child, childId);
        }
    }
}

// In the order in which Assimp looks for a name: a node before its children, first child first.
void nameNodes(Conversion& c)
{
    std::vector<const aiNode*> open{c.in.mRootNode};
    while (!open.empty()) {
        const aiNode* node = open.back();
        open.pop_back();
        if (const NodeId id = c.nodeOf.at(node)) c.byName.emplace(node->mName.C_Str(), id);
        for (unsigned i = node->mNumChildren; i > 0; --i) open.push_back(node->mChildren[i - 1]);
    }
}

std::set<std::string> namesThatCount(const aiScene& scene)
{
    std::set<std::string> names;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b) names.insert(scene.mMeshes[m]->mBones[b]->mName.C_Str());
    for (unsigned a = 0; a < scene.mNumAnimations; ++a)
        for (unsigned k = 0; k < scene.mAnimations[a]->mNumChannels; ++k) names.insert(scene.mAnimations[a]->mChannels[k]->mNodeName.C_Str());
    return names;
}

}  // namespace

std::optional<Placement> statedPlacement(const Conversion& c)
{
    if (c.ending == ".dae") return colladaPlacement(c.file);
    if (c.ending != ".fbx") return {};
    const int32_t up = meta<int32_t>(c.in, "UpAxis", 1);
    return Placement{unitScale(c.in), up == 2 ? UpAxis::Z : up == 0 ? UpAxis::X : UpAxis::Y};
}

NodeId Conversion::addNode(Node node, NodeId parent)
{
    node.parent = parent;
    const NodeId id = keep(parts.nodes, std::move(node));
    if (parent)
        parts.nodes.at(parent).children.push_back(id);
    else
        parts.roots.push_back(id);
    return id;
}

void addNodes(Conversion& c)
{
    const aiNode& root = *c.in.mRootNode;
    const std::string stem = c.file.stem().string();
    const std::set<std::string> used = namesThatCount(c.in);
    const bool moves = used.contains(root.mName.C_Str());
    const glm::dmat4 conversion = conversionMatrix(c), own = matrix(root.mTransformation);
    const bool madeUp = isMadeUp(root.mName.C_Str());
    NodeId above;
    if (moves && conversion != glm::dmat4(1)) {  // a motion replaces the root's transform
        Node n;
        n.name = stem;
        n.local = transformOf(conversion);
        above = c.addNode(std::move(n), {});
    }
    Node n;
    n.name = madeUp && !moves ? stem : text(root.mName);
    n.local = localOf(c, above ? own : conversion * own, n.name);
    const NodeId id = c.addNode(std::move(n), above);
    c.nodeOf[&root] = id;
    addTree(c, root, id);
    // A root that says nothing is not needed.
    if (madeUp && !moves && !root.mNumMeshes && root.mNumChildren && c.parts.nodes.at(id).local == Transform{}) {
        c.parts.roots = c.parts.nodes.at(id).children;
        for (const NodeId child : c.parts.roots) c.parts.nodes.at(child).parent = {};
        c.parts.nodes.erase(id);
        c.nodeOf[&root] = {};
    }
    nameNodes(c);
}

void makeNamesUnique(Conversion& c)
{
    const std::set<std::string> used = namesThatCount(c.in);
    std::map<std::string, size_t> count;
    std::set<std::string> taken;
    for (const auto& [id, n] : c.parts.nodes) taken.insert(n.name);
    size_t renamed = 0;
    std::string first;
    std::map<NodeId, const aiNode*> ordered;
    for (const auto& [node, id] : c.nodeOf)
        if (id) ordered[id] = node;
    for (const auto& [id, node] : ordered) {
        std::string& name = c.parts.nodes.at(id).name;
        const std::string raw = node->mName.C_Str();
        const bool again = used.contains(raw) && c.byName.at(raw) != id;
        if (!name.empty() && !again) continue;
        if (again && renamed++ == 0) first = name;
        const std::string stem = name.empty() ? "Node" : name;
        size_t& n = count[stem];
        do name = stem + " " + std::to_string(++n + (again ? 1 : 0));
        while (!taken.insert(name).second);
    }
    if (renamed)
        c.warn("duplicate-names", std::to_string(renamed) + (renamed == 1 ? " node has" : " nodes have") + " a name that another has before it (\"" +
                                      first + "\"): renamed; bones and motions of that name go to the first");
}

namespace {

std::vector<NodeId> pathTo(const Conversion& c, NodeId id)
{
    std::vector<NodeId> path;
    for (; id; id = c.parts.nodes.at(id).parent) path.push_back(id);
    std::reverse(path.begin(), path.end());
    return path;
}

// Joints of one skeleton: all on the way from their last common ancestor, and that one too unless it only holds the file together.
void markSkeleton(Conversion& c, const std::set<NodeId>& bones)
{
    std::vector<std::vector<NodeId>> paths;
    for (const NodeId b : bones) paths.push_back(pathTo(c, b));
    std::vector<NodeId> common = paths.front();
    for (const std::vector<NodeId>& p : paths)
        common.resize(size_t(std::mismatch(common.begin(), common.end(), p.begin(), p.end()).first - common.begin()));
    const auto holds = [&](NodeId id) {  // more than a skeleton hangs there
        const Node& n = c.parts.nodes.at(id);
        return n.mesh || (!n.parent && n.name == c.file.stem().string());
    };
    size_t from = common.size();
    if (from > 0 && (bones.contains(common.back()) || !holds(common.back()))) --from;
    while (from > 0 && from < common.size() && c.parts.nodes.at(common[from - 1]).children.size() == 1 && !holds(common[from - 1])) --from;
    for (const std::vector<NodeId>& p : paths) {
        bool inside = !common.empty();  // without a common ancestor each begins at its first bone
        for (size_t i = from; i < p.size(); ++i) {
            Node& n = c.parts.nodes.at(p[i]);
            inside = inside || bones.contains(p[i]);
            if (inside && (!n.mesh || bones.contains(p[i]))) n.joint = Node::Joint::Joint;
        }
    }
}

// A file of motions alone: chains of nodes that turn. Cameras and lights move, too, but nothing hangs on them.
std::set<NodeId> drivenChains(const Conversion& c)
{
    std::set<NodeId> chains;
    for (const NodeId id : c.driven) {
        const Node& n = c.parts.nodes.at(id);
        const bool linked =
            c.driven.contains(n.parent) || std::any_of(n.children.begin(), n.children.end(), [&](NodeId k) { return c.driven.contains(k); });
        if (linked && !n.mesh) chains.insert(id);
    }
    return chains;
}

}  // namespace

void markJoints(Conversion& c)
{
    for (const auto& [id, skin] : c.parts.skins) {
        const std::set<NodeId> bones(skin.joints.begin(), skin.joints.end());
        if (!bones.empty()) markSkeleton(c, bones);
    }
    if (c.parts.skins.empty())
        for (const NodeId id : drivenChains(c)) c.parts.nodes.at(id).joint = Node::Joint::Joint;
    // What hangs on joints belongs to them: driven ones, and places where the last one ends. Ids ascend from parents to children.
    for (auto& [id, n] : c.parts.nodes) {
        if (n.joint != Node::Joint::No || !n.parent || n.mesh || c.parts.nodes.at(n.parent).joint != Node::Joint::Joint) continue;
        if (c.driven.contains(id))
            n.joint = Node::Joint::Joint;
        else if (n.children.empty())
            n.joint = Node::Joint::EndSite;
    }
}

}  // namespace mw
