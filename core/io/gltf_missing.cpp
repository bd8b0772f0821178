// Stands in until the glTF reader and writer land; they remove this file.
#include "core/io/gltf.h"

namespace mw {

Imported readGltf(const std::filesystem::path& file, Progress*)
{
    throw Error(file.string(), "glTF is not read by this build; convert the file to OBJ or PLY");
}

std::vector<Warning> writeGltf(const Scene&, const std::filesystem::path& file, const WriteOptions&, Progress*)
{
    throw Error(file.string(), "glTF is not written by this build; choose .obj or .ply");
}

}  // namespace mw
