// Materials and their pictures, inside the file or beside it.
#include <algorithm>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <cctype>
#include <png.h>

#include "app/importer/conversion.h"
#include "core/io/file.h"
#include "core/io/picture.h"

namespace mw {

namespace {

using Bytes = std::vector<uint8_t>;

// Pixels that lie bare in the file become a PNG.
std::shared_ptr<const Bytes> pngOf(const aiTexture& t)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = t.mWidth;
    image.height = t.mHeight;
    image.format = PNG_FORMAT_BGRA;  // as aiTexel lies in memory
    png_alloc_size_t size = 0;
    if (!png_image_write_to_memory(&image, nullptr, &size, 0, t.pcData, 0, nullptr)) return nullptr;
    Bytes bytes(size);
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, t.pcData, 0, nullptr)) return nullptr;
    bytes.resize(size);
    return std::make_shared<const Bytes>(std::move(bytes));
}

std::shared_ptr<const Bytes> bytesOf(const aiTexture& t)
{
    if (t.mHeight > 0) return pngOf(t);
    const auto* from = reinterpret_cast<const uint8_t*>(t.pcData);
    return std::make_shared<const Bytes>(from, from + t.mWidth);
}

bool sameLetters(std::string a, std::string b)
{
    const auto lower = [](std::string& s) { std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return char(std::tolower(c)); }); };
    lower(a), lower(b);
    return a == b;
}

/// Where a picture lies that a file names, often by a path of another machine: as named, else of that name beside the model, in whatever case.
std::filesystem::path foundBeside(const std::filesystem::path& model, const std::string& name)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path folder = model.has_parent_path() ? model.parent_path() : fs::path(".");
    if (const fs::path p = insideFolder(folder, name); !p.empty() && fs::is_regular_file(p, ignored)) return p;
    const std::string last = name.substr(name.find_last_of("/\\") == name.npos ? 0 : name.find_last_of("/\\") + 1);
    if (const fs::path p = insideFolder(folder, last); !p.empty() && fs::is_regular_file(p, ignored)) return p;
    size_t looked = 0;
    for (const fs::directory_entry& e : fs::directory_iterator(folder, ignored))
        if (++looked > 10000)
            break;
        else if (sameLetters(e.path().filename().string(), last) && e.is_regular_file(ignored))
            return e.path();
    return {};
}

class Materials {
public:
    explicit Materials(Conversion& c) : c_(c) {}
    Material material(const aiMaterial& m, unsigned index);

private:
    bool texture(const aiMaterial& m, Material::Texture& to, std::initializer_list<aiTextureType> types);
    ImageId image(const std::string& raw, const std::string& name);
    ImageId added(std::shared_ptr<const Bytes> bytes, const std::string& name);

    Conversion& c_;
};

ImageId Materials::added(std::shared_ptr<const Bytes> bytes, const std::string& name)
{
    const std::string type = bytes ? pictureType(*bytes) : "";
    if (type.empty()) {
        c_.warn("unknown-image", "the picture \"" + name + "\" is neither PNG nor JPEG and was left out; convert the picture");
        return {};
    }
    return c_.keep(c_.parts.images, Image{name, type, std::move(bytes)});
}

ImageId Materials::image(const std::string& raw, const std::string& name)
{
    if (const auto known = c_.imageOf.find(raw); known != c_.imageOf.end()) return known->second;
    ImageId id;
    const std::string shortName = name.substr(name.find_last_of("/\\") == name.npos ? 0 : name.find_last_of("/\\") + 1);
    if (const aiTexture* embedded = c_.in.GetEmbeddedTexture(raw.c_str())) {
        const std::string own = text(embedded->mFilename);
        id = added(bytesOf(*embedded), own.empty() ? shortName : own.substr(own.find_last_of("/\\") == own.npos ? 0 : own.find_last_of("/\\") + 1));
    } else if (const std::filesystem::path p = foundBeside(c_.file, raw); p.empty()) {
        c_.warn("missing-image", "the picture \"" + name + "\" is not beside the model; the mesh is shown without it");
    } else {
        const FileBytes b = readBytes(p, uint64_t(1) << 30);
        id = added(std::make_shared<const Bytes>(b.begin(), b.end()), shortName);
    }
    c_.imageOf[raw] = id;
    return id;
}

bool Materials::texture(const aiMaterial& m, Material::Texture& to, std::initializer_list<aiTextureType> types)
{
    for (const aiTextureType type : types) {
        aiString path;
        aiTextureMapMode mode[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
        unsigned set = 0;
        if (m.GetTexture(type, 0, &path, nullptr, &set, nullptr, nullptr, mode) != aiReturn_SUCCESS || path.length == 0) continue;
        to.image = image(path.C_Str(), text(path));
        to.set = int(std::min(set, 31u));
        to.repeat = mode[0] != aiTextureMapMode_Clamp;
        return bool(to.image);
    }
    return false;
}

double factor(const aiMaterial& m, const char* key, unsigned type, unsigned index, double otherwise)
{
    ai_real value = 0;
    return m.Get(key, type, index, value) == aiReturn_SUCCESS && std::isfinite(value) ? double(value) : otherwise;
}

glm::dvec3 colour(const aiMaterial& m, const char* key, glm::dvec3 otherwise)
{
    aiColor4D c;
    if (m.Get(key, 0, 0, c) != aiReturn_SUCCESS || !std::isfinite(c.r + c.g + c.b)) return otherwise;
    return glm::clamp(glm::dvec3(c.r, c.g, c.b), 0.0, 1.0);
}

// Old formats say gloss by an exponent; this is the roughness of a highlight of that size.
double roughnessOf(const aiMaterial& m)
{
    const double exponent = factor(m, AI_MATKEY_SHININESS, 0);
    const glm::dvec3 specular = colour(m, "$clr.specular", glm::dvec3(0));
    const double guess = exponent > 1 && specular != glm::dvec3(0) ? std::sqrt(2 / (exponent + 2)) : 0.8;
    return std::clamp(factor(m, AI_MATKEY_ROUGHNESS_FACTOR, guess), 0.0, 1.0);
}

Material Materials::material(const aiMaterial& m, unsigned index)
{
    Material out;
    aiString name;
    if (m.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) out.name = text(name);
    const bool pictured = texture(m, out.baseColorTexture, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    texture(m, out.normalTexture, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
    texture(m, out.emissiveTexture, {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR});
    texture(m, out.occlusionTexture, {aiTextureType_AMBIENT_OCCLUSION, aiTextureType_LIGHTMAP});
    const double opacity = factor(m, AI_MATKEY_OPACITY, 1);
    // A picture stands for the colour. An opacity of 0 is a slip of exporters: nobody models what cannot be seen.
    out.baseColor = glm::dvec4(pictured ? glm::dvec3(1) : colour(m, "$clr.diffuse", glm::dvec3(0.8)), opacity > 0 && opacity < 1 ? opacity : 1);
    if (out.baseColor.a < 1) out.alpha = Material::Alpha::Blend;
    out.emissive = out.emissiveTexture.image ? glm::dvec3(1) : colour(m, "$clr.emissive", glm::dvec3(0));
    out.metallic = std::clamp(factor(m, AI_MATKEY_METALLIC_FACTOR, 0), 0.0, 1.0);
    out.roughness = roughnessOf(m);
    int both = 0;
    out.doubleSided = m.Get(AI_MATKEY_TWOSIDED, both) == aiReturn_SUCCESS && both != 0;
    if (out.name.empty() && pictured) out.name = std::filesystem::path(c_.parts.images.at(out.baseColorTexture.image).name).stem().string();
    if (out.name.empty()) out.name = "material " + std::to_string(index + 1);
    return out;
}

}  // namespace

MaterialId materialOf(Conversion& c, unsigned index)
{
    if (index >= c.in.mNumMaterials) return {};
    if (const auto known = c.materialOf.find(index); known != c.materialOf.end()) return known->second;
    return c.materialOf[index] = c.keep(c.parts.materials, Materials(c).material(*c.in.mMaterials[index], index));
}

}  // namespace mw
