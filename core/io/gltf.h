// glTF 2.0 in and out (.gltf and .glb). A Meshwright project is a .glb that carries the extension MESHWRIGHT_project (project.h).
// The way in: gltf_container (GLB chunks, JSON) -> gltf_document (buffers, views, accessors, all checked) -> gltf_mesh, gltf_scene (materials,
// tree), gltf_motion (skins, animations).
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "core/io/io.h"

namespace mw {

struct GltfReadOptions {
    /// What to do with a project inside. A project whose plain part was changed by another program since is opened only with Always;
    /// otherwise the plain part is read and the warning "project-core-changed" says so.
    enum class Project { WhenIntact, Always, Never } project = Project::WhenIntact;
};

/// Throws Error, Cancelled. Reads nothing outside the folder of the file.
Imported readGltf(const std::filesystem::path& file, Progress* progress = nullptr);
Imported readGltf(const std::filesystem::path& file, const GltfReadOptions& options, Progress* progress = nullptr);
/// The same from memory. `folder` is where further files may lie; when it is empty, the content must not name any.
Imported readGltf(std::span<const uint8_t> content, const std::filesystem::path& folder, const GltfReadOptions& options = {},
                  Progress* progress = nullptr);

/// By ending: .glb is one file, .gltf has a .bin of the same name beside it. Gives what glTF could not hold.
std::vector<Warning> writeGltf(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options = {}, Progress* progress = nullptr);
/// A .glb in memory.
std::vector<uint8_t> glbOf(const Scene& scene, const WriteOptions& options = {}, std::vector<Warning>* warnings = nullptr,
                           Progress* progress = nullptr);

}  // namespace mw
