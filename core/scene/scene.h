// The scene as a value: a tree of nodes over arrays of shared, immutable payloads (book Fig. 7.2). Copying is cheap; an edit makes a new
// one. Camera, playhead and panel layout are no part of it.
#pragma once
#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/catalog/catalog.h"
#include "core/character/clip.h"
#include "core/character/skin.h"
#include "core/mesh/mesh.h"
#include "core/terrain/terrain.h"

namespace mw {

using MeshId = Id<struct MeshTag>;
using MaterialId = Id<struct MaterialTag>;
using ImageId = Id<struct ImageTag>;
using ModifierId = Id<struct ModifierTag>;
using SkinId = Id<struct SkinTag>;
using ClipId = Id<struct ClipTag>;
using TerrainId = Id<struct TerrainTag>;

/// One row of a modifier stack. `operation` may be unknown to this version: it is then kept and skipped with an error.
struct Modifier {
    ModifierId id;
    std::string operation;
    ParameterValues values;
    bool enabled = true;
    bool operator==(const Modifier&) const = default;
};

/// An encoded picture as the file had it.
struct Image {
    std::string name, mimeType;  ///< "image/png" or "image/jpeg"
    std::shared_ptr<const std::vector<uint8_t>> bytes;
};

/// Metallic-roughness, as in glTF 2.0. Colours are linear.
struct Material {
    struct Texture {
        ImageId image;
        int set = 0;  ///< texcoord, texcoord1, ...
        bool repeat = true;
    };
    std::string name;
    glm::dvec4 baseColor{0.8, 0.8, 0.8, 1};
    double metallic = 0, roughness = 0.6;
    glm::dvec3 emissive{0};
    double normalScale = 1, occlusionStrength = 1, alphaCutoff = 0.5;
    enum class Alpha { Opaque, Mask, Blend } alpha = Alpha::Opaque;
    bool doubleSided = false;
    Texture baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
    std::string extras;  ///< JSON text of what a file said beyond this; empty when nothing
};

/// A mesh as the scene has it: base, material slots (face attribute "material" indexes them) and modifier stack.
struct MeshObject {
    std::string name;
    Mesh base;
    std::vector<MaterialId> materials;
    std::vector<Modifier> stack;
};

/// A terrain as the scene has it. `source` tells how its map was made, when it was made here.
struct TerrainObject {
    Terrain terrain;
    std::string sourceOperation;  ///< id of a source of height maps; empty: from a picture, or painted
    ParameterValues sourceValues;
};

struct Node {
    std::string name;
    Transform local;
    NodeId parent;
    std::vector<NodeId> children;
    bool visible = true;
    MeshId mesh = {};  ///< several nodes may share one
    SkinId skin = {};  ///< poses the mesh; the node's own transform then does not count
    TerrainId terrain = {};
    enum class Joint : uint8_t { No, Joint, EndSite } joint = Joint::No;  ///< drawn as bones; an end site only says where the last one ends
    std::vector<double> morphWeights = {};                                ///< in the order of the mesh's morph targets; empty: all 0
    std::string extras = {};                                              ///< JSON text kept from a file
};

/// A value. Readers share it by shared_ptr<const Scene>; editors copy it, change the copy and hand it to Document::commit.
class Scene {
public:
    const Node* find(NodeId id) const;
    const Node& node(NodeId id) const;  ///< precondition: it exists
    const std::vector<NodeId>& roots() const { return roots_; }
    std::vector<NodeId> nodes() const;  ///< depth first
    const MeshObject* find(MeshId id) const;
    const Material* find(MaterialId id) const;
    const Image* find(ImageId id) const;
    const Skin* find(SkinId id) const;
    const Clip* find(ClipId id) const;
    const TerrainObject* find(TerrainId id) const;
    std::shared_ptr<const MeshObject> shared(MeshId id) const;
    std::shared_ptr<const Material> shared(MaterialId id) const;
    std::vector<MeshId> meshes() const;
    std::vector<MaterialId> materials() const;
    std::vector<ImageId> images() const;
    std::vector<SkinId> skins() const;
    std::vector<ClipId> clips() const;
    std::vector<TerrainId> terrains() const;
    size_t users(MeshId id) const;  ///< nodes that show it
    glm::dmat4 worldFromLocal(NodeId id) const;

    NodeId add(Node node, NodeId parent = {});  ///< parent and children of `node` are ignored
    MeshId add(MeshObject object);
    MaterialId add(Material material);
    ImageId add(Image image);
    SkinId add(Skin skin);
    ClipId add(Clip clip);
    TerrainId add(TerrainObject terrain);
    void set(NodeId id, Node node);  ///< parent and children stay as they are
    void set(MeshId id, MeshObject object);
    void set(MaterialId id, Material material);
    void set(SkinId id, Skin skin);
    void set(ClipId id, Clip clip);
    void set(TerrainId id, TerrainObject terrain);
    void remove(ClipId id);
    void remove(NodeId id);                   ///< with its children; payloads nobody uses and channels without a node go too
    void reparent(NodeId id, NodeId parent);  ///< throws Error on a cycle
    ModifierId newModifierId() { return {next_++}; }
    /// All of another scene as further roots; its ids are renamed. Returns the new roots.
    std::vector<NodeId> merge(const Scene& other);

    size_t bytes() const;  ///< of payloads, each counted once

    /// What a project file holds, with the ids it was saved with. Throws Error when the parts do not fit together.
    struct Parts {
        std::map<NodeId, Node> nodes;
        std::map<MeshId, MeshObject> meshes;
        std::map<MaterialId, Material> materials;
        std::map<ImageId, Image> images;
        std::map<SkinId, Skin> skins;
        std::map<ClipId, Clip> clips;
        std::map<TerrainId, TerrainObject> terrains;
        std::vector<NodeId> roots;
    };
    static Scene restored(Parts parts);

private:
    void unlink(NodeId id);
    void dropUnused();
    void dropDeadChannels();
    void checkTree() const;

    std::map<NodeId, std::shared_ptr<const Node>> nodes_;
    std::map<MeshId, std::shared_ptr<const MeshObject>> meshes_;
    std::map<MaterialId, std::shared_ptr<const Material>> materials_;
    std::map<ImageId, std::shared_ptr<const Image>> images_;
    std::map<SkinId, std::shared_ptr<const Skin>> skins_;
    std::map<ClipId, std::shared_ptr<const Clip>> clips_;
    std::map<TerrainId, std::shared_ptr<const TerrainObject>> terrains_;
    std::vector<NodeId> roots_;
    uint32_t next_ = 1;
};

/// Of everything a project file keeps.
uint64_t contentHash(const Scene& s);

}  // namespace mw
