#include "app/importer/read.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <cctype>

#include "app/importer/conversion.h"
#include "core/io/file.h"
#include "core/io/placement.h"

namespace mw {

namespace {

std::string endingOf(const std::filesystem::path& file)
{
    std::string e = file.extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

std::string formatOf(const aiScene& scene, const std::string& ending)
{
    std::string version;
    aiString value;
    if (scene.mMetaData && scene.mMetaData->Get("SourceAsset_FormatVersion", value)) version = text(value);
    if (ending == ".fbx") {
        if (version.size() == 4) version.insert(1, ".");  // 7400 is 7.4
        while (version.size() > 3 && version.back() == '0') version.pop_back();
        return "Autodesk FBX" + (version.empty() ? "" : " " + version);
    }
    if (ending == ".dae") return "COLLADA" + (version.empty() ? "" : " " + version);
    if (ending == ".3ds") return "3D Studio";
    return ending == ".x" ? "DirectX X" : "id Software MD5";
}

// The motion of an MD5 lies in a file of its own beside the mesh.
void checkMd5Files(const std::filesystem::path& file, const std::string& ending)
{
    checkMd5(readBytes(file).text(), ending == ".md5anim");
    std::filesystem::path motion = file;
    motion.replace_extension(".md5anim");
    std::error_code ignored;
    if (ending != ".md5mesh" || !std::filesystem::is_regular_file(motion, ignored)) return;
    try {
        checkMd5(readBytes(motion).text(), true);
    } catch (const Error& e) {
        throw Error(motion.filename().string() + " beside it: " + e.reason() + "; or move that file away");
    }
}

void listLost(Conversion& c)
{
    const auto lost = [&](unsigned n, const char* code, const char* what) {
        if (n)
            c.warn(code, std::to_string(n) + " " + (n == 1 ? std::string(what, std::strlen(what) - 1) + " was" : std::string(what) + " were") +
                             " left out");
    };
    lost(c.in.mNumCameras, "cameras", "cameras");
    lost(c.in.mNumLights, "lights", "lights");
}

}  // namespace

std::string text(const aiString& s)
{
    const std::string_view bytes(s.data, strnlen(s.data, std::min<size_t>(s.length, sizeof s.data)));
    std::string out;
    for (size_t i = 0; i < bytes.size();) {
        const auto c = uint8_t(bytes[i]);
        const size_t more = c < 0x80 ? 0 : c >= 0xC2 && c < 0xE0 ? 1 : c >= 0xE0 && c < 0xF0 ? 2 : c >= 0xF0 && c < 0xF5 ? 3 : 9;
        const bool whole = i + more < bytes.size() && std::all_of(bytes.begin() + ptrdiff_t(i) + 1, bytes.begin() + ptrdiff_t(i + more) + 1,
                                                                  [](char b) { return (uint8_t(b) & 0xC0) == 0x80; });
        if (whole) {
            if (c >= ' ' && c != 0x7f) out.append(bytes.substr(i, more + 1));
            i += more + 1;
        } else {  // Latin-1
            out += char(0xC0 | c >> 6);
            out += char(0x80 | (c & 0x3F));
            ++i;
        }
    }
    return out;
}

Imported readByAssimp(const std::filesystem::path& file)
{
    const std::string ending = endingOf(file);
    if (ending == ".md5mesh" || ending == ".md5anim") checkMd5Files(file, ending);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!scene || !scene->mRootNode) {
        const std::string why = importer.GetErrorString();
        if (why.find("bad_alloc") != why.npos || why.find("bad allocation") != why.npos) throw std::bad_alloc();
        throw Error("could not be read (" + (why.empty() ? "no reason was given" : text(aiString(why))) +
                    "); open it in another program and export it as glTF");
    }
    Conversion c(*scene, file, ending);
    addNodes(c);
    makeNamesUnique(c);
    addMeshes(c);
    addClips(c);
    markJoints(c);
    if (c.parts.meshes.empty() && c.parts.clips.empty() && c.bones.empty() && scene->mRootNode->mNumChildren == 0)
        throw Error("there is nothing in it, or nothing that could be understood; export it again");
    listLost(c);
    Imported out;
    out.warnings = c.findings.warnings();
    out.warnings.insert(out.warnings.end(), c.warnings.begin(), c.warnings.end());
    out.format = formatOf(*scene, ending);
    const std::optional<Placement> stated = statedPlacement(c);
    out.placement = stated.value_or(Placement{});
    out.placementFromFile = stated.has_value();
    out.units = stated ? unitText(stated->metresPerUnit) : "unknown";
    out.scene = Scene::restored(std::move(c.parts));
    return out;
}

}  // namespace mw
