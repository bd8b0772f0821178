#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "core/scene/hash.h"

namespace mw {

namespace {

template <class Map, class Key>
auto pointerTo(const Map& map, Key id) -> decltype(map.begin()->second.get())
{
    const auto i = map.find(id);
    return i == map.end() ? nullptr : i->second.get();
}

template <class Map>
auto keysOf(const Map& map)
{
    std::vector<typename Map::key_type> keys;
    for (const auto& entry : map) keys.push_back(entry.first);
    return keys;
}

// The image of each texture of a material, so that all five are treated alike.
template <class M>
auto texturesOf(M& m)
{
    return std::array{&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture};
}

}  // namespace

const Node* Scene::find(NodeId id) const
{
    return pointerTo(nodes_, id);
}
const MeshObject* Scene::find(MeshId id) const
{
    return pointerTo(meshes_, id);
}
const Material* Scene::find(MaterialId id) const
{
    return pointerTo(materials_, id);
}
const Image* Scene::find(ImageId id) const
{
    return pointerTo(images_, id);
}
const Skin* Scene::find(SkinId id) const
{
    return pointerTo(skins_, id);
}
const Clip* Scene::find(ClipId id) const
{
    return pointerTo(clips_, id);
}
const TerrainObject* Scene::find(TerrainId id) const
{
    return pointerTo(terrains_, id);
}
const Node& Scene::node(NodeId id) const
{
    return *nodes_.at(id);
}

std::shared_ptr<const MeshObject> Scene::shared(MeshId id) const
{
    const auto i = meshes_.find(id);
    return i == meshes_.end() ? nullptr : i->second;
}

std::shared_ptr<const Material> Scene::shared(MaterialId id) const
{
    const auto i = materials_.find(id);
    return i == materials_.end() ? nullptr : i->second;
}

std::vector<NodeId> Scene::nodes() const
{
    std::vector<NodeId> all, open(roots_.rbegin(), roots_.rend());
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        all.push_back(id);
        const std::vector<NodeId>& children = node(id).children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return all;
}

std::vector<MeshId> Scene::meshes() const
{
    return keysOf(meshes_);
}
std::vector<MaterialId> Scene::materials() const
{
    return keysOf(materials_);
}
std::vector<ImageId> Scene::images() const
{
    return keysOf(images_);
}
std::vector<SkinId> Scene::skins() const
{
    return keysOf(skins_);
}
std::vector<ClipId> Scene::clips() const
{
    return keysOf(clips_);
}
std::vector<TerrainId> Scene::terrains() const
{
    return keysOf(terrains_);
}

size_t Scene::users(MeshId id) const
{
    return size_t(std::count_if(nodes_.begin(), nodes_.end(), [&](const auto& n) { return n.second->mesh == id; }));
}

glm::dmat4 Scene::worldFromLocal(NodeId id) const
{
    glm::dmat4 m(1);
    for (const Node* n = find(id); n; n = find(n->parent)) m = n->local.matrix() * m;
    return m;
}

NodeId Scene::add(Node n, NodeId parent)
{
    const NodeId id{next_++};
    n.parent = find(parent) ? parent : NodeId{};
    n.children.clear();
    if (n.parent) {
        Node changed = node(n.parent);
        changed.children.push_back(id);
        nodes_[n.parent] = std::make_shared<const Node>(std::move(changed));
    } else {
        roots_.push_back(id);
    }
    nodes_[id] = std::make_shared<const Node>(std::move(n));
    return id;
}

MeshId Scene::add(MeshObject object)
{
    const MeshId id{next_++};
    meshes_[id] = std::make_shared<const MeshObject>(std::move(object));
    return id;
}

MaterialId Scene::add(Material material)
{
    const MaterialId id{next_++};
    materials_[id] = std::make_shared<const Material>(std::move(material));
    return id;
}

ImageId Scene::add(Image image)
{
    const ImageId id{next_++};
    images_[id] = std::make_shared<const Image>(std::move(image));
    return id;
}

SkinId Scene::add(Skin skin)
{
    const SkinId id{next_++};
    skins_[id] = std::make_shared<const Skin>(std::move(skin));
    return id;
}

ClipId Scene::add(Clip clip)
{
    const ClipId id{next_++};
    clips_[id] = std::make_shared<const Clip>(std::move(clip));
    return id;
}

TerrainId Scene::add(TerrainObject terrain)
{
    const TerrainId id{next_++};
    terrains_[id] = std::make_shared<const TerrainObject>(std::move(terrain));
    return id;
}

void Scene::set(NodeId id, Node n)
{
    const Node& old = node(id);
    n.parent = old.parent;
    n.children = old.children;
    nodes_[id] = std::make_shared<const Node>(std::move(n));
}

void Scene::set(MeshId id, MeshObject object)
{
    meshes_.at(id) = std::make_shared<const MeshObject>(std::move(object));
}
void Scene::set(MaterialId id, Material material)
{
    materials_.at(id) = std::make_shared<const Material>(std::move(material));
}
void Scene::set(SkinId id, Skin skin)
{
    skins_.at(id) = std::make_shared<const Skin>(std::move(skin));
}
void Scene::set(ClipId id, Clip clip)
{
    clips_.at(id) = std::make_shared<const Clip>(std::move(clip));
}
void Scene::set(TerrainId id, TerrainObject terrain)
{
    terrains_.at(id) = std::make_shared<const TerrainObject>(std::move(terrain));
}
void Scene::remove(ClipId id)
{
    clips_.erase(id);
}

void Scene::unlink(NodeId id)
{
    const NodeId parent = node(id).parent;
    if (!parent) {
        std::erase(roots_, id);
        return;
    }
    Node changed = node(parent);
    std::erase(changed.children, id);
    nodes_[parent] = std::make_shared<const Node>(std::move(changed));
}

void Scene::remove(NodeId id)
{
    if (!find(id)) return;
    unlink(id);
    std::vector<NodeId> open{id};
    while (!open.empty()) {
        const NodeId n = open.back();
        open.pop_back();
        const std::vector<NodeId>& children = node(n).children;
        open.insert(open.end(), children.begin(), children.end());
        nodes_.erase(n);
    }
    dropUnused();
    dropDeadChannels();
}

// Channels whose node is gone, and clips that drive nothing any more. Skins keep their slots: a joint that is gone stands still.
void Scene::dropDeadChannels()
{
    const auto dead = [&](const std::shared_ptr<const Channel>& c) { return !find(c->node); };
    for (auto i = clips_.begin(); i != clips_.end();) {
        const Clip& clip = *i->second;
        const bool some = std::any_of(clip.channels.begin(), clip.channels.end(), dead);
        if (!some) {
            ++i;
            continue;
        }
        Clip kept = clip;
        std::erase_if(kept.channels, dead);
        if (kept.channels.empty())
            i = clips_.erase(i);
        else
            (i++)->second = std::make_shared<const Clip>(std::move(kept));
    }
}

void Scene::dropUnused()
{
    std::set<MeshId> meshes;
    std::set<MaterialId> materials;
    std::set<ImageId> images;
    std::set<SkinId> skins;
    std::set<TerrainId> terrains;
    for (const auto& [id, n] : nodes_) {
        meshes.insert(n->mesh);
        skins.insert(n->skin);
        terrains.insert(n->terrain);
    }
    std::erase_if(meshes_, [&](const auto& m) { return !meshes.contains(m.first); });
    std::erase_if(skins_, [&](const auto& k) { return !skins.contains(k.first); });
    std::erase_if(terrains_, [&](const auto& t) { return !terrains.contains(t.first); });
    for (const auto& [id, m] : meshes_) materials.insert(m->materials.begin(), m->materials.end());
    std::erase_if(materials_, [&](const auto& m) { return !materials.contains(m.first); });
    for (const auto& [id, m] : materials_)
        for (const Material::Texture* t : texturesOf(*m)) images.insert(t->image);
    std::erase_if(images_, [&](const auto& i) { return !images.contains(i.first); });
}

void Scene::reparent(NodeId id, NodeId parent)
{
    for (NodeId a = parent; a; a = node(a).parent)
        if (a == id) throw Error("\"" + node(id).name + "\" cannot be moved below itself");
    unlink(id);
    Node moved = node(id);
    moved.parent = parent;
    nodes_[id] = std::make_shared<const Node>(std::move(moved));
    if (!parent) {
        roots_.push_back(id);
        return;
    }
    Node changed = node(parent);
    changed.children.push_back(id);
    nodes_[parent] = std::make_shared<const Node>(std::move(changed));
}

std::vector<NodeId> Scene::merge(const Scene& other)
{
    // Ids of the other scene are moved behind ours; 0 stays "none".
    const uint32_t shift = next_ - 1;
    const auto moved = [&](auto id) {
        if (id) id.value += shift;
        return id;
    };
    for (const auto& [id, image] : other.images_) images_[moved(id)] = image;
    for (const auto& [id, material] : other.materials_) {
        Material m = *material;
        for (Material::Texture* t : texturesOf(m)) t->image = moved(t->image);
        materials_[moved(id)] = std::make_shared<const Material>(std::move(m));
    }
    for (const auto& [id, object] : other.meshes_) {
        MeshObject o = *object;
        for (MaterialId& m : o.materials) m = moved(m);
        for (Modifier& m : o.stack) m.id = moved(m.id);
        meshes_[moved(id)] = std::make_shared<const MeshObject>(std::move(o));
    }
    for (const auto& [id, skin] : other.skins_) {
        Skin k = *skin;
        for (NodeId& j : k.joints) j = moved(j);
        k.skeleton = moved(k.skeleton);
        skins_[moved(id)] = std::make_shared<const Skin>(std::move(k));
    }
    for (const auto& [id, clip] : other.clips_) {
        Clip c = *clip;
        for (auto& channel : c.channels) {
            Channel changed = *channel;
            changed.node = moved(changed.node);
            channel = std::make_shared<const Channel>(std::move(changed));
        }
        clips_[moved(id)] = std::make_shared<const Clip>(std::move(c));
    }
    for (const auto& [id, terrain] : other.terrains_) terrains_[moved(id)] = terrain;
    for (const auto& [id, node] : other.nodes_) {
        Node n = *node;
        n.parent = moved(n.parent);
        n.mesh = moved(n.mesh);
        n.skin = moved(n.skin);
        n.terrain = moved(n.terrain);
        for (NodeId& c : n.children) c = moved(c);
        nodes_[moved(id)] = std::make_shared<const Node>(std::move(n));
    }
    std::vector<NodeId> added;
    for (NodeId r : other.roots_) added.push_back(moved(r));
    roots_.insert(roots_.end(), added.begin(), added.end());
    next_ += other.next_ - 1;
    return added;
}

size_t Scene::bytes() const
{
    std::set<const void*> seen;
    size_t total = 0;
    for (const auto& [id, m] : meshes_)
        if (seen.insert(m.get()).second) total += m->base.bytes();
    for (const auto& [id, i] : images_)
        if (i->bytes && seen.insert(i->bytes.get()).second) total += i->bytes->size();
    for (const auto& [id, c] : clips_)
        for (const auto& channel : c->channels)
            if (seen.insert(channel.get()).second) total += channel->values.bytes();
    for (const auto& [id, t] : terrains_) {
        const HeightMap& map = t->terrain.map;
        for (uint32_t y = 0; y < map.tilesY(); ++y)
            for (uint32_t x = 0; x < map.tilesX(); ++x)
                if (seen.insert(map.tile(x, y).id()).second) total += map.tile(x, y).bytes();
    }
    return total;
}

Scene Scene::restored(Parts parts)
{
    Scene s;
    const auto take = [&](auto& from, auto& to) {
        for (auto& [id, value] : from) {
            s.next_ = std::max(s.next_, id.value + 1);
            using T = std::decay_t<decltype(value)>;
            to[id] = std::make_shared<const T>(std::move(value));
        }
    };
    take(parts.images, s.images_);
    take(parts.materials, s.materials_);
    take(parts.meshes, s.meshes_);
    take(parts.nodes, s.nodes_);
    take(parts.skins, s.skins_);
    take(parts.clips, s.clips_);
    take(parts.terrains, s.terrains_);
    for (const auto& [id, m] : s.meshes_)
        for (const Modifier& modifier : m->stack) s.next_ = std::max(s.next_, modifier.id.value + 1);
    s.roots_ = std::move(parts.roots);
    s.checkTree();
    return s;
}

// Every node is reached exactly once from the roots, and all it names is there.
void Scene::checkTree() const
{
    std::set<NodeId> seen;
    std::vector<NodeId> open(roots_);
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        const Node* n = find(id);
        if (!n || !seen.insert(id).second) throw Error("node " + std::to_string(id.value) + " is missing or has two parents");
        if (n->mesh && !find(n->mesh)) throw Error("node \"" + n->name + "\" shows a mesh that is not there");
        if (n->skin && !find(n->skin)) throw Error("node \"" + n->name + "\" has a skin that is not there");
        if (n->terrain && !find(n->terrain)) throw Error("node \"" + n->name + "\" shows a terrain that is not there");
        for (NodeId c : n->children)
            if (!find(c) || find(c)->parent != id) throw Error("node \"" + n->name + "\" has a child that does not know it");
        open.insert(open.end(), n->children.begin(), n->children.end());
    }
    if (seen.size() != nodes_.size()) throw Error("some nodes hang nowhere in the tree");
    for (const auto& [id, skin] : skins_) {
        if (skin->joints.size() != skin->inverseBind.size()) throw Error("skin \"" + skin->name + "\" has not one matrix a joint");
        for (NodeId j : skin->joints)
            if (!find(j)) throw Error("skin \"" + skin->name + "\" has a joint that is not there");
    }
    for (const auto& [id, clip] : clips_)
        for (const auto& channel : clip->channels)
            if (!find(channel->node)) throw Error("clip \"" + clip->name + "\" drives a node that is not there");
}

uint64_t contentHash(const Scene& s)
{
    SceneHasher h;
    for (NodeId id : s.nodes()) {
        const Node& n = s.node(id);
        h.add(id.value).add(n.parent.value).add(n.mesh.value).add(n.visible).add(n.name).add(n.extras);
        h.add(n.skin.value).add(n.terrain.value).add(int(n.joint)).add(n.morphWeights.size());
        for (const double w : n.morphWeights) h.add(w);
        for (int i = 0; i < 3; ++i) h.add(n.local.translation[i]).add(n.local.scale[i]);
        h.add(n.local.rotation.w).add(n.local.rotation.x).add(n.local.rotation.y).add(n.local.rotation.z);
    }
    for (MeshId id : s.meshes()) {
        const MeshObject& o = *s.find(id);
        h.add(id.value).add(o.name).add(contentHash(o.base));
        for (MaterialId m : o.materials) h.add(m.value);
        for (const Modifier& m : o.stack) h.add(m.id.value).add(m.operation).add(m.enabled).add(m.values);
    }
    for (MaterialId id : s.materials()) {
        const Material& m = *s.find(id);
        h.add(id.value).add(m.name).add(m.extras).add(int(m.alpha)).add(m.doubleSided);
        for (int i = 0; i < 4; ++i) h.add(m.baseColor[i]);
        for (int i = 0; i < 3; ++i) h.add(m.emissive[i]);
        h.add(m.metallic).add(m.roughness).add(m.normalScale).add(m.occlusionStrength).add(m.alphaCutoff);
        for (const Material::Texture* t : texturesOf(m)) h.add(t->image.value).add(t->set).add(t->repeat);
    }
    for (ImageId id : s.images()) {
        const Image& i = *s.find(id);
        h.add(id.value).add(i.name).add(i.mimeType);
        if (i.bytes) h.bytes(i.bytes->data(), i.bytes->size());
    }
    for (SkinId id : s.skins()) h.add(id.value).add(contentHash(*s.find(id)));
    for (ClipId id : s.clips()) h.add(id.value).add(contentHash(*s.find(id)));
    for (TerrainId id : s.terrains()) {
        const TerrainObject& t = *s.find(id);
        h.add(id.value).add(contentHash(t.terrain)).add(t.sourceOperation).add(t.sourceValues);
    }
    return h.value();
}

}  // namespace mw
