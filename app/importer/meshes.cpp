// Meshes, their skins and their morph targets.
#include <algorithm>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <glm/geometric.hpp>

#include "app/importer/conversion.h"
#include "core/io/gltf_points.h"

namespace mw {

namespace {

constexpr Finding positionFinding{"nan-position", "vertex has no finite position: put at the centre",
                                  "vertices have no finite position: put at the centre"};
constexpr Finding cornerFinding{"face-index", "face uses a vertex that is not there: left out", "faces use vertices that are not there: left out"};
constexpr Finding weightFinding{"bad-weight", "weight is no number, negative or of a vertex that is not there: left out",
                                "weights are no numbers, negative or of vertices that are not there: left out"};
constexpr Finding boneFinding{"missing-bone", "bone is no node of the file: one was put where it was bound",
                              "bones are no nodes of the file: some were put where they were bound"};
constexpr Finding unboundFinding{"unbound-vertices", "vertex of a skinned mesh has no weights: it moves with the node of the mesh",
                                 "vertices of skinned meshes have no weights: they move with the nodes of the meshes"};
constexpr Finding manyFinding{"many-weights", "vertex has more than 32 weights: the strongest were kept",
                              "vertices have more than 32 weights: the strongest were kept"};
constexpr size_t mostWeights = 32;

struct Influence {
    uint32_t slot;
    float weight;
};

bool close(const glm::dmat4& a, const glm::dmat4& b)
{
    double size = 0, apart = 0;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) {
            size = std::max({size, std::abs(a[i][k]), std::abs(b[i][k])});
            apart = std::max(apart, std::abs(a[i][k] - b[i][k]));
        }
    return apart <= 1e-5 * size;
}

/// Meshes that are bound alike share a skin.
class Skins {
public:
    explicit Skins(Conversion& c) : c_(c) {}
    /// One that says nothing else about any of these joints and knows at least one of them; else a new one.
    SkinId fitting(const std::vector<std::pair<NodeId, glm::dmat4>>& bound, const std::string& name);
    uint32_t slot(SkinId id, NodeId joint, const glm::dmat4& inverseBind);

private:
    size_t find(const Skin& skin, NodeId joint) const
    {
        return size_t(std::find(skin.joints.begin(), skin.joints.end(), joint) - skin.joints.begin());
    }
    Conversion& c_;
};

SkinId Skins::fitting(const std::vector<std::pair<NodeId, glm::dmat4>>& bound, const std::string& name)
{
    for (const auto& [id, skin] : c_.parts.skins) {
        size_t known = 0, other = 0;
        for (const auto& [joint, inverseBind] : bound)
            if (const size_t i = find(skin, joint); i < skin.joints.size()) ++(close(skin.inverseBind[i], inverseBind) ? known : other);
        if (known > 0 && other == 0) return id;
    }
    return c_.keep(c_.parts.skins, Skin{name, {}, {}, {}});
}

uint32_t Skins::slot(SkinId id, NodeId joint, const glm::dmat4& inverseBind)
{
    Skin& skin = c_.parts.skins.at(id);
    size_t i = find(skin, joint);
    if (i < skin.joints.size() && !close(skin.inverseBind[i], inverseBind)) {
        // The same bone bound twice: a place of its own that stands where the bone stands.
        Node n;
        n.name = c_.parts.nodes.at(joint).name + " (bound again)";
        joint = c_.addNode(std::move(n), joint);
        i = skin.joints.size();
    }
    if (i == skin.joints.size()) {
        skin.joints.push_back(joint);
        skin.inverseBind.push_back(inverseBind);
        c_.bones.insert(joint);
    }
    return uint32_t(i);
}

/// Of Assimp's meshes that together are one of ours.
class MeshBuilder {
public:
    MeshBuilder(Conversion& c, Skins& skins, std::vector<const aiMesh*> pieces) : c_(c), skins_(skins), pieces_(std::move(pieces)) {}
    Mesh build(NodeId node, SkinId& skin);

private:
    void addPoints();
    void addFaces();
    void addCornerStreams();
    void addMorphs();
    NodeId jointOf(const aiBone& bone, const glm::dmat4& offset, NodeId node);
    void addSkin(NodeId node, SkinId& skin);
    void addUnbound(NodeId node, SkinId skin);
    void storeSkin();
    GltfStream& stream(std::string name, int components, bool ofVertex);
    template <class Has, class Write>
    void cornerStream(std::string name, int components, Has has, Write write);
    Mesh assembled();
    std::string where(const aiMesh& m) const { return "mesh \"" + text(m.mName) + "\""; }

    Conversion& c_;
    Skins& skins_;
    std::vector<const aiMesh*> pieces_;
    std::vector<size_t> firstPoint_;
    GltfPoints points_;
    Array<uint32_t> faceStart_{0u};
    std::vector<std::vector<Influence>> influences_;
};

void MeshBuilder::addPoints()
{
    for (const aiMesh* m : pieces_) {
        firstPoint_.push_back(points_.positions.size());
        for (unsigned v = 0; v < m->mNumVertices; ++v) {
            const bool good = finite(m->mVertices[v]);
            if (!good) c_.findings.add(positionFinding, [&] { return where(*m) + ", vertex " + std::to_string(v); });
            points_.positions.push_back(good ? glm::vec3(vector(m->mVertices[v])) + 0.f : glm::vec3(0));  // + 0: no minus zero
        }
    }
    if (points_.positions.size() >= none) throw Error("more vertices than 32 bits can number; split the mesh");
}

void MeshBuilder::addFaces()
{
    for (size_t p = 0; p < pieces_.size(); ++p) {
        const aiMesh& m = *pieces_[p];
        for (unsigned f = 0; f < m.mNumFaces; ++f) {
            const aiFace& face = m.mFaces[f];
            if (std::any_of(face.mIndices, face.mIndices + face.mNumIndices, [&](unsigned v) { return v >= m.mNumVertices; })) {
                c_.findings.add(cornerFinding, [&] { return where(m) + ", face " + std::to_string(f); });
                continue;
            }
            if (face.mNumIndices < 2) continue;
            Array<uint32_t>& to = face.mNumIndices == 2 ? points_.lines : points_.corners;
            for (unsigned k = 0; k < face.mNumIndices; ++k) to.push_back(uint32_t(firstPoint_[p] + face.mIndices[k]));
            if (face.mNumIndices == 2) continue;
            faceStart_.push_back(uint32_t(points_.corners.size()));
            points_.faceMaterial.push_back(uint32_t(p));
        }
    }
}

GltfStream& MeshBuilder::stream(std::string name, int components, bool ofVertex)
{
    GltfStream s;
    s.name = std::move(name);
    s.components = components;
    s.ofVertex = ofVertex;
    s.floats.assign(points_.positions.size() * size_t(components), 0.f);
    points_.streams.push_back(std::move(s));
    return points_.streams.back();
}

/// `has(mesh)` says whether a piece has it, `write(mesh, vertex, out)` gives its numbers.
template <class Has, class Write>
void MeshBuilder::cornerStream(std::string name, int components, Has has, Write write)
{
    if (std::none_of(pieces_.begin(), pieces_.end(), [&](const aiMesh* m) { return has(*m); })) return;
    GltfStream& s = stream(std::move(name), components, false);
    for (size_t p = 0; p < pieces_.size(); ++p) {
        if (!has(*pieces_[p])) continue;
        float* out = s.floats.data() + firstPoint_[p] * size_t(components);
        for (unsigned v = 0; v < pieces_[p]->mNumVertices; ++v, out += components) {
            write(*pieces_[p], v, out);
            for (int k = 0; k < components; ++k)
                if (!std::isfinite(out[k])) out[k] = 0;
        }
    }
}

void copy3(const aiVector3D& v, float* out)
{
    out[0] = v.x, out[1] = v.y, out[2] = v.z;
}

void MeshBuilder::addCornerStreams()
{
    cornerStream(
        std::string(names::normal), 3, [](const aiMesh& m) { return m.HasNormals(); },
        [](const aiMesh& m, unsigned v, float* out) {
            copy3(m.mNormals[v], out);
            const double length = std::sqrt(double(out[0]) * out[0] + double(out[1]) * out[1] + double(out[2]) * out[2]);
            if (length > 0 && std::isfinite(length))
                for (int k = 0; k < 3; ++k) out[k] = float(double(out[k]) / length);
        });
    for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++set)
        cornerStream(
            std::string(names::texcoord) + (set ? std::to_string(set) : ""), 2, [&](const aiMesh& m) { return m.HasTextureCoords(set); },
            [&](const aiMesh& m, unsigned v, float* out) { out[0] = m.mTextureCoords[set][v].x, out[1] = m.mTextureCoords[set][v].y; });
    for (unsigned set = 0; set < AI_MAX_NUMBER_OF_COLOR_SETS; ++set)
        cornerStream(
            std::string(names::color) + (set ? std::to_string(set) : ""), 4, [&](const aiMesh& m) { return m.HasVertexColors(set); },
            [&](const aiMesh& m, unsigned v, float* out) {
                const aiColor4D& c = m.mColors[set][v];
                out[0] = c.r, out[1] = c.g, out[2] = c.b, out[3] = c.a;
            });
    cornerStream(
        std::string(names::tangent), 4, [](const aiMesh& m) { return m.HasTangentsAndBitangents() && m.HasNormals(); },
        [](const aiMesh& m, unsigned v, float* out) {
            const aiVector3D t = aiVector3D(m.mTangents[v]).NormalizeSafe();
            copy3(t, out);
            out[3] = (m.mNormals[v] ^ t) * m.mBitangents[v] < 0 ? -1.f : 1.f;
        });
}

std::string targetName(const aiAnimMesh& a, size_t i)
{
    const std::string name = text(a.mName);
    return name.empty() ? "target" + std::to_string(i) : name;
}

// Assimp has the places where vertices go, we have how far.
void MeshBuilder::addMorphs()
{
    std::map<std::string, size_t> seen;
    size_t most = 0;
    for (const aiMesh* m : pieces_) most = std::max<size_t>(most, m->mNumAnimMeshes);
    std::set<std::string> taken;
    for (size_t t = 0; t < most; ++t) {
        std::string name;
        for (const aiMesh* m : pieces_)
            if (name.empty() && t < m->mNumAnimMeshes) name = targetName(*m->mAnimMeshes[t], t);
        while (!taken.insert(name).second) name += "_" + std::to_string(t);
        const auto has = [&](const aiMesh& m) {
            return t < m.mNumAnimMeshes && m.mAnimMeshes[t]->mNumVertices == m.mNumVertices && m.mAnimMeshes[t]->HasPositions();
        };
        cornerStream(std::string(names::morph) + name, 3, has,
                     [&](const aiMesh& m, unsigned v, float* out) { copy3(m.mAnimMeshes[t]->mVertices[v] - m.mVertices[v], out); });
        if (!points_.streams.empty() && points_.streams.back().name.starts_with(names::morph)) points_.streams.back().ofVertex = true;
        cornerStream(
            "morph-normal:" + name, 3, [&](const aiMesh& m) { return has(m) && m.HasNormals() && m.mAnimMeshes[t]->HasNormals(); },
            [&](const aiMesh& m, unsigned v, float* out) { copy3(m.mAnimMeshes[t]->mNormals[v] - m.mNormals[v], out); });
    }
}

NodeId MeshBuilder::jointOf(const aiBone& bone, const glm::dmat4& offset, NodeId node)
{
    const std::string name = bone.mName.C_Str();
    if (const auto found = c_.byName.find(name); found != c_.byName.end()) return found->second;
    c_.findings.add(boneFinding, [&] { return "\"" + text(bone.mName) + "\""; });
    Node n;
    n.name = name.empty() ? "Bone" : text(bone.mName);
    // Below the mesh, so that what it holds rests where the mesh has it.
    if (std::abs(glm::determinant(offset)) > 1e-30) n.local = transformOf(glm::inverse(offset));
    return c_.byName[name] = c_.addNode(std::move(n), node);
}

void MeshBuilder::addSkin(NodeId node, SkinId& skin)
{
    struct Bound {
        const aiBone* bone;
        size_t piece;
        NodeId joint;
        glm::dmat4 inverseBind;
    };
    std::vector<Bound> bounds;
    std::vector<std::pair<NodeId, glm::dmat4>> joints;
    for (size_t p = 0; p < pieces_.size(); ++p)
        for (unsigned b = 0; b < pieces_[p]->mNumBones; ++b) {
            const aiBone& bone = *pieces_[p]->mBones[b];
            const glm::dmat4 offset = matrix(bone.mOffsetMatrix);
            if (!std::isfinite(glm::dot(offset * glm::dvec4(1), glm::dvec4(1)))) {
                c_.findings.add(weightFinding, [&] { return "bone \"" + text(bone.mName) + "\""; });
                continue;
            }
            const NodeId joint = jointOf(bone, offset, node);
            bounds.push_back({&bone, p, joint, offset});
            joints.emplace_back(joint, offset);
        }
    if (bounds.empty()) return;
    skin = skins_.fitting(joints, c_.parts.nodes.at(node).name);
    influences_.resize(points_.positions.size());
    for (const Bound& b : bounds) {
        const uint32_t slot = skins_.slot(skin, b.joint, b.inverseBind);
        for (unsigned w = 0; w < b.bone->mNumWeights; ++w) {
            const aiVertexWeight& weight = b.bone->mWeights[w];
            if (weight.mWeight == 0) continue;
            if (weight.mVertexId >= pieces_[b.piece]->mNumVertices || !(weight.mWeight > 0) || !std::isfinite(weight.mWeight))
                c_.findings.add(weightFinding, [&] { return "bone \"" + text(b.bone->mName) + "\""; });
            else
                influences_[firstPoint_[b.piece] + weight.mVertexId].push_back({slot, float(weight.mWeight)});
        }
    }
    addUnbound(node, skin);
    storeSkin();
}

/// A skinned mesh stands by its joints alone, so a vertex without any is bound to the node of the mesh.
void MeshBuilder::addUnbound(NodeId node, SkinId skin)
{
    uint32_t slot = none;
    for (std::vector<Influence>& list : influences_) {
        if (!list.empty()) continue;
        if (slot == none) slot = skins_.slot(skin, node, glm::dmat4(1));
        c_.findings.add(unboundFinding);
        list.push_back({slot, 1});
    }
}

void MeshBuilder::storeSkin()
{
    size_t most = 1;
    for (std::vector<Influence>& list : influences_) {
        std::stable_sort(list.begin(), list.end(),
                         [](const Influence& a, const Influence& b) { return a.weight != b.weight ? a.weight > b.weight : a.slot < b.slot; });
        if (list.size() > mostWeights) {
            c_.findings.add(manyFinding);
            list.resize(mostWeights);
        }
        most = std::max(most, list.size());
    }
    const size_t width = (most + 3) / 4 * 4;
    GltfStream weights = std::move(stream(std::string(names::weights), int(width), true));
    points_.streams.pop_back();
    GltfStream joints;
    joints.name = names::joints;
    joints.components = int(width);
    joints.ofVertex = joints.integral = true;
    joints.stored = Scalar::UInt16;
    joints.integers.assign(influences_.size() * width, 0);
    for (size_t v = 0; v < influences_.size(); ++v) {
        double sum = 0;
        for (const Influence& i : influences_[v]) sum += double(i.weight);
        for (size_t k = 0; k < influences_[v].size(); ++k) {
            joints.integers[v * width + k] = int32_t(influences_[v][k].slot);
            weights.floats[v * width + k] = float(double(influences_[v][k].weight) / sum);
        }
    }
    influences_ = {};
    points_.streams.push_back(std::move(joints));
    points_.streams.push_back(std::move(weights));
}

template <class T>
Array<T> picked(const Array<T>& from, int components, const Array<uint32_t>& rows)
{
    const auto k = size_t(components);
    Array<T> out(rows.size() * k);
    for (size_t i = 0; i < rows.size(); ++i) std::copy_n(from.data() + rows[i] * k, k, out.data() + i * k);
    return out;
}

Mesh MeshBuilder::assembled()
{
    Array<uint32_t> representative;
    const Array<uint32_t> vertexOf = weldedPoints(points_, representative);
    const auto vertices = [&](const Array<uint32_t>& of) {
        Array<uint32_t> out(of.size());
        for (size_t i = 0; i < of.size(); ++i) out[i] = vertexOf[of[i]];
        return out;
    };
    const bool triangles =
        faceStart_.size() - 1 == points_.corners.size() / 3 && points_.corners.size() % 3 == 0 &&
        std::adjacent_find(faceStart_.begin(), faceStart_.end(), [](uint32_t a, uint32_t b) { return b - a != 3; }) == faceStart_.end();
    Array<glm::vec3> positions = picked(points_.positions, 1, representative);
    Mesh mesh = triangles ? Mesh::triangles(std::move(positions), vertices(points_.corners))
                          : Mesh(std::move(positions), std::move(faceStart_), vertices(points_.corners));
    if (!points_.lines.empty()) mesh = mesh.withLines(vertices(points_.lines));
    for (const GltfStream& s : points_.streams) {
        const bool ofVertex = s.ofVertex || points_.corners.empty();
        const Array<uint32_t>& rows = ofVertex ? representative : points_.corners;
        const Domain domain = ofVertex ? Domain::Vertex : Domain::Corner;
        Attribute a = s.integral ? integerAttribute(s.name, domain, s.components, picked(s.integers, s.components, rows))
                                 : floatAttribute(s.name, domain, s.components, picked(s.floats, s.components, rows));
        a.stored = s.stored;
        mesh = mesh.with(std::move(a));
    }
    if (pieces_.size() > 1)
        mesh = mesh.with(integerAttribute(std::string(names::material), Domain::Face, 1,
                                          Array<int32_t>(points_.faceMaterial.begin(), points_.faceMaterial.end())));
    return mesh;
}

Mesh MeshBuilder::build(NodeId node, SkinId& skin)
{
    addPoints();
    addFaces();
    addCornerStreams();
    addMorphs();
    addSkin(node, skin);
    return assembled();
}

// Assimp cuts a mesh where its material changes; the pieces keep the name. In MD5 equal names say nothing.
std::vector<std::vector<unsigned>> groups(const Conversion& c, const aiNode& node)
{
    std::vector<std::vector<unsigned>> out;
    std::map<std::string, size_t> known;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const unsigned m = node.mMeshes[i];
        if (m >= c.in.mNumMeshes) continue;
        const std::string name = c.ending == ".md5mesh" ? std::to_string(i) : c.in.mMeshes[m]->mName.C_Str();
        const auto [at, fresh] = known.emplace(name, out.size());
        if (fresh) out.emplace_back();
        out[at->second].push_back(m);
    }
    return out;
}

struct Built {
    MeshId mesh;
    SkinId skin;
};

Built built(Conversion& c, Skins& skins, const std::vector<unsigned>& group, NodeId node)
{
    std::vector<const aiMesh*> pieces;
    MeshObject object;
    for (const unsigned m : group) {
        pieces.push_back(c.in.mMeshes[m]);
        object.materials.push_back(materialOf(c, c.in.mMeshes[m]->mMaterialIndex));
    }
    object.name = text(pieces[0]->mName);
    if (object.name.empty() || c.ending == ".3ds") object.name = c.parts.nodes.at(node).name;  // 3DS: only numbers
    Built b;
    object.base = MeshBuilder(c, skins, std::move(pieces)).build(node, b.skin);
    b.mesh = c.keep(c.parts.meshes, std::move(object));
    return b;
}

}  // namespace

void addMeshes(Conversion& c)
{
    if (c.ending == ".md5anim") return;  // Assimp draws its joints as a mesh
    Skins skins(c);
    std::map<std::vector<unsigned>, Built> known;
    std::vector<const aiNode*> open{c.in.mRootNode};
    while (!open.empty()) {
        const aiNode* node = open.back();
        open.pop_back();
        for (unsigned i = node->mNumChildren; i > 0; --i) open.push_back(node->mChildren[i - 1]);
        const std::vector<std::vector<unsigned>> all = groups(c, *node);
        for (const std::vector<unsigned>& group : all) {
            NodeId at = c.nodeOf.at(node);
            if (all.size() > 1) {
                Node below;
                below.name = text(c.in.mMeshes[group[0]]->mName);
                if (below.name.ends_with(".msh")) below.name = std::filesystem::path(below.name).stem().stem().string();
                if (below.name.empty()) below.name = c.parts.nodes.at(at).name + " " + std::to_string(&group - all.data() + 1);
                at = c.addNode(std::move(below), at);
            }
            auto found = known.find(group);
            if (found == known.end()) found = known.emplace(group, built(c, skins, group, at)).first;
            Node& shown = c.parts.nodes.at(at);
            shown.mesh = found->second.mesh;
            shown.skin = found->second.skin;
        }
    }
}

}  // namespace mw
