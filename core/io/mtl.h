// MTL material libraries: read into materials and pictures, and written. Used by the OBJ reader and writer.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/io/findings.h"
#include "core/scene/scene.h"

namespace mw {

/// How a library's colours and exponents become a metallic-roughness material, and back: Kd is the base colour as it stands, d (or 1 - Tr)
/// its alpha, Ke the emission, Pr and Pm roughness and metalness; without Pr the roughness is sqrt(2 / (Ns + 2)), the width of Blinn's highlight.
/// What a Material has no place for (Ka, Ks, illum, ...) is kept as lines in its `extras`, {"mtl": ["Ka 1 1 1", ...]}, and written back.
class MtlReader {
public:
    /// Pictures are added to `scene`.
    MtlReader(std::filesystem::path folder, Scene& scene, Findings& findings) : folder_(std::move(folder)), scene_(scene), findings_(findings) {}
    /// A "mtllib" line: one name with blanks, or several names.
    void readLibraries(const std::string& names);
    const std::map<std::string, Material>& materials() const { return materials_; }

private:
    bool readLibrary(const std::string& name);
    std::filesystem::path lookUp(const std::string& name);
    void readLines(std::string_view text);
    void finish();
    void line(Material& material, std::string_view keyword, std::string_view rest);
    bool texture(Material& material, std::string_view keyword, std::string_view rest);
    ImageId image(const std::string& name);

    std::filesystem::path folder_;
    Scene& scene_;
    Findings& findings_;
    std::map<std::string, Material> materials_;
    std::map<std::filesystem::path, ImageId> images_;
    std::set<std::filesystem::path> libraries_;
    Material* current_ = nullptr;
    std::vector<std::string> kept_;  // lines of the present material without a place in it
    uint64_t imageBytes_ = 0, libraryBytes_ = 0;
    size_t lookups_ = 0;
    bool roughnessGiven_ = false;  // the present material has a Pr line: Ns says no more
};

/// The text of a library. `pictureName` gives the file name of each picture used.
std::string mtlText(const std::vector<const Material*>& materials, const std::vector<std::string>& names,
                    const std::map<ImageId, std::string>& pictureName, std::vector<Warning>& warnings);

}  // namespace mw
