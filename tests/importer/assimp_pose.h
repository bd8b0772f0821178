// Where Assimp's own structures put every corner at a time: written from their documentation, apart from what the program does.
#pragma once
#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <map>
#include <string>
#include <vector>

namespace mw::test {

inline const aiScene* readPlainly(Assimp::Importer& importer, const std::string& file)
{
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    return importer.ReadFile(file, 0);
}

class AssimpPose {
public:
    AssimpPose(const aiScene& scene, const aiAnimation* animation, double ticks) : scene_(scene), animation_(animation), ticks_(ticks)
    {
        walk(*scene.mRootNode, aiMatrix4x4());
    }
    /// In the order of nodes (parents first), their meshes, faces and corners.
    std::vector<aiVector3D> corners() const
    {
        std::vector<aiVector3D> all;
        collect(*scene_.mRootNode, all);
        return all;
    }
    /// Vertices without any weight, and those of bones that are no nodes, stay with the node of the mesh.
    std::vector<aiVector3D> vertices(const aiMesh& mesh, const aiNode& node) const
    {
        const aiMatrix4x4& own = world_.at(&node);
        std::vector<aiVector3D> out(mesh.mNumVertices);
        if (!mesh.mNumBones) {
            for (unsigned v = 0; v < mesh.mNumVertices; ++v) out[v] = own * mesh.mVertices[v];
            return out;
        }
        std::vector<double> sum(mesh.mNumVertices, 0);
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiBone& bone = *mesh.mBones[b];
            const aiNode* joint = scene_.mRootNode->FindNode(bone.mName);
            const aiMatrix4x4 m = joint ? world_.at(joint) * bone.mOffsetMatrix : own;
            for (unsigned w = 0; w < bone.mNumWeights; ++w) {
                out[bone.mWeights[w].mVertexId] += bone.mWeights[w].mWeight * (m * mesh.mVertices[bone.mWeights[w].mVertexId]);
                sum[bone.mWeights[w].mVertexId] += double(bone.mWeights[w].mWeight);
            }
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) out[v] = sum[v] > 0 ? out[v] / ai_real(sum[v]) : own * mesh.mVertices[v];
        return out;
    }
    const aiMatrix4x4& world(const aiNode& node) const { return world_.at(&node); }

private:
    template <class Key>
    static std::pair<unsigned, double> between(const Key* keys, unsigned n, double t)
    {
        if (t <= keys[0].mTime) return {0, 0.0};
        for (unsigned k = 0; k + 1 < n; ++k)
            if (t < keys[k + 1].mTime) return {k, (t - keys[k].mTime) / (keys[k + 1].mTime - keys[k].mTime)};
        return {n - 1, 0.0};
    }
    static aiVector3D mixed(const aiVectorKey* keys, unsigned n, double t)
    {
        const auto [k, u] = between(keys, n, t);
        return u > 0 ? keys[k].mValue + ai_real(u) * (keys[k + 1].mValue - keys[k].mValue) : keys[k].mValue;
    }
    aiMatrix4x4 local(const aiNode& node) const
    {
        for (unsigned c = 0; animation_ && c < animation_->mNumChannels; ++c) {
            const aiNodeAnim& a = *animation_->mChannels[c];
            if (a.mNodeName != node.mName) continue;
            const auto [k, u] = between(a.mRotationKeys, a.mNumRotationKeys, ticks_);
            aiQuaternion q = a.mRotationKeys[k].mValue;
            if (u > 0) aiQuaternion::Interpolate(q, a.mRotationKeys[k].mValue, a.mRotationKeys[k + 1].mValue, ai_real(u));
            return aiMatrix4x4(mixed(a.mScalingKeys, a.mNumScalingKeys, ticks_), q.Normalize(), mixed(a.mPositionKeys, a.mNumPositionKeys, ticks_));
        }
        return node.mTransformation;
    }
    void walk(const aiNode& node, const aiMatrix4x4& parent)
    {
        const aiMatrix4x4 here = parent * local(node);
        world_[&node] = here;
        for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], here);
    }
    void collect(const aiNode& node, std::vector<aiVector3D>& all) const
    {
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]];
            const std::vector<aiVector3D> at = vertices(mesh, node);
            for (unsigned f = 0; f < mesh.mNumFaces; ++f)
                for (unsigned k = 0; k < mesh.mFaces[f].mNumIndices; ++k) all.push_back(at[mesh.mFaces[f].mIndices[k]]);
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) collect(*node.mChildren[i], all);
    }
    const aiScene& scene_;
    const aiAnimation* animation_;
    double ticks_;
    std::map<const aiNode*, aiMatrix4x4> world_;
};

}  // namespace mw::test
