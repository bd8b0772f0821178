// The data layer of a glTF: buffers, buffer views and accessors, every number checked against the bytes that are there, and decoding of
// accessors into flat arrays. Nothing is decoded before it is asked for, and all decoding together is bounded by the size of the files.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/io/gltf_container.h"
#include "core/io/gltf_json.h"
#include "core/mesh/array.h"

namespace mw {

/// Component types of the format.
enum class GltfComponent : uint32_t { Int8 = 5120, UInt8 = 5121, Int16 = 5122, UInt16 = 5123, UInt32 = 5125, Float32 = 5126 };
size_t sizeOf(GltfComponent c);

struct GltfView {
    uint32_t buffer = 0;
    size_t offset = 0, length = 0, stride = 0;  ///< stride 0: tightly packed
};

struct GltfAccessor {
    std::optional<uint32_t> view;  ///< none: all zero
    size_t offset = 0, count = 0;
    GltfComponent component = GltfComponent::Float32;
    int components = 1;
    bool normalized = false;
    struct Sparse {
        size_t count = 0, indexOffset = 0, valueOffset = 0;
        uint32_t indexView = 0, valueView = 0;
        GltfComponent indexComponent = GltfComponent::UInt32;
    };
    std::optional<Sparse> sparse;
    std::string pointer;
    size_t elementSize = 4;
};

class GltfDocument {
public:
    /// Checks everything of the data layer. `content` must outlive the document. Throws Error.
    GltfDocument(std::span<const uint8_t> content, std::filesystem::path folder);

    JsonPlace root() const { return {container_.root, ""}; }
    bool binary() const { return container_.binary; }
    std::vector<Warning>& warnings() { return container_.warnings; }

    size_t views() const { return views_.size(); }
    std::span<const uint8_t> viewBytes(size_t view) const;
    /// The first buffer as a whole; empty when there is none.
    std::span<const uint8_t> firstBuffer() const { return buffers_.empty() ? std::span<const uint8_t>() : buffers_[0]; }
    size_t accessors() const { return accessors_.size(); }
    const GltfAccessor& accessor(size_t i) const { return accessors_[i]; }

    /// Says that `bytes` of memory are about to be taken; throws Error when a file of this size cannot mean that much.
    void charge(uint64_t bytes, const std::string& pointer);

    /// The elements named (ascending, each below count) as floats, normalised integers mapped to -1..1 or 0..1.
    Array<float> floats(const GltfAccessor& a, std::span<const uint32_t> elements);
    Array<int32_t> integers(const GltfAccessor& a, std::span<const uint32_t> elements);
    /// All of an accessor of indices.
    Array<uint32_t> indices(const GltfAccessor& a);

    /// What an "uri" holds: data: URIs and files of the folder only. Bytes are shared when two name one file.
    std::shared_ptr<const std::vector<uint8_t>> resource(const JsonPlace& uri);

private:
    void readBuffers();
    std::span<const uint8_t> bufferOf(const JsonPlace& place, size_t index);
    GltfView viewOf(const JsonPlace& place) const;
    GltfAccessor accessorOf(const JsonPlace& place);
    void checkSparse(GltfAccessor& a, const JsonPlace& place) const;
    size_t stride(const GltfAccessor& a) const;
    template <class Out>
    Array<Out> decoded(const GltfAccessor& a, std::span<const uint32_t> elements);

    GltfContainer container_;
    std::filesystem::path folder_;
    std::map<std::filesystem::path, std::shared_ptr<const std::vector<uint8_t>>> files_;
    std::vector<std::shared_ptr<const std::vector<uint8_t>>> owned_;
    std::vector<std::span<const uint8_t>> buffers_;
    std::vector<GltfView> views_;
    std::vector<GltfAccessor> accessors_;
    uint64_t inputBytes_ = 0, charged_ = 0;
};

/// The file that a relative URI names. Throws Error (with the reason only) unless it lies inside `folder`.
std::filesystem::path fileOfUri(const std::string& uri, const std::filesystem::path& folder);

}  // namespace mw
