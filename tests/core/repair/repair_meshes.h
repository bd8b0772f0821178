// What the tests of repairs share: every mesh file of the data set.
#pragma once
#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/core/algorithm_meshes.h"

namespace mw::test {

/// Sorted, so that a test does the same everywhere. Those of `malformed` that can be read are meshes like any other.
inline std::vector<std::filesystem::path> meshFiles(const std::filesystem::path& data, std::initializer_list<const char*> folders, size_t mostBytes)
{
    std::vector<std::filesystem::path> files;
    for (const char* folder : folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(data / folder)) {
            const auto kind = entry.path().extension();
            if ((kind == ".obj" || kind == ".ply" || kind == ".off") && entry.file_size() <= mostBytes) files.push_back(entry.path());
        }
    std::sort(files.begin(), files.end());
    return files;
}

/// No mesh when the file cannot be read, or holds no face.
inline std::optional<Mesh> readableMesh(const std::filesystem::path& file)
{
    try {
        const Imported read = readFile(file);
        if (read.scene.meshes().empty()) return std::nullopt;
        const Mesh mesh = read.scene.find(read.scene.meshes().front())->base;
        return mesh.faceCount() > 0 ? std::optional<Mesh>(mesh) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace mw::test
