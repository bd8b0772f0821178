// The edit that puts a picture on a material. It stands here and not beside the other edits because it reads a file.
#include "core/io/file.h"
#include "core/io/picture.h"
#include "core/scene/edit_entries.h"
#include "core/scene/materials.h"

namespace mw {
namespace {

constexpr uint64_t largestPicture = uint64_t(160) << 20;

struct TextureFile {
    std::string node, file;
    int64_t slot = 0, set = 0;
    TextureKind kind = TextureKind::BaseColor;
    bool repeat = true;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "The one whose mesh it is."});
        v.integer("slot", slot, {.title = "Slot", .help = "Material slot of its mesh, from 0.", .min = 0, .max = 4095});
        v.choice("kind", kind, textureKinds(), {.title = "Kind", .help = "What the picture says."});
        v.integer("set", set, {.title = "Coordinates", .help = "Which texture coordinates it uses; 0 are the first.", .min = 0, .max = 63});
        v.flag("repeat", repeat, {.title = "Repeat", .help = "Outside 0 to 1 the picture goes on; else its border does."});
        v.file("file", file, {.title = "Picture", .help = "PNG or JPEG file; empty: the picture stays."});
    }
};

Image readPicture(const std::filesystem::path& file)
{
    const FileBytes bytes = readBytes(file, largestPicture);
    auto content = std::make_shared<const std::vector<uint8_t>>(bytes.begin(), bytes.end());
    const std::string type = pictureType(*content);
    if (type.empty()) throw Error(file.string() + ": is no PNG or JPEG picture; convert it to one");
    const auto sound = portablePicture(content);
    if (!sound) throw Error(file.string() + ": the picture is cut off or damaged; save it again");
    return {file.filename().string(), type, sound};
}

void setTexture(Scene& scene, const TextureFile& p, EditRun&)
{
    const MaterialId id = materialAt(scene, nodeOf(scene, p.node), p.slot);
    Material m = *scene.find(id);
    Material::Texture& t = textureOf(m, p.kind);
    if (p.file.empty() && !t.image) throw Error("\"" + m.name + "\" has no picture of that kind yet; name a file");
    if (!p.file.empty()) t.image = scene.add(readPicture(p.file));
    t.set = int(p.set);
    t.repeat = p.repeat;
    scene.set(id, std::move(m));
    if (!p.file.empty()) dropUnusedPayloads(scene);
}

std::string textureName(const Scene& scene, const TextureFile& p)
{
    const std::string name = scene.find(materialAt(scene, nodeOf(scene, p.node), p.slot))->name;
    return name + ": texture " + (p.file.empty() ? "settings" : std::filesystem::path(p.file).filename().string());
}

}  // namespace

std::vector<Edit> textureEdits()
{
    return {editEntry<TextureFile>("texture", "Texture", "Puts a picture file on a material, or changes how its picture is laid.", setTexture,
                                   textureName)};
}

}  // namespace mw
