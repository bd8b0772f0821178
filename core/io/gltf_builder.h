// What a glTF is put together from when written: the JSON, and the one buffer with its views and accessors, aligned and padded.
#pragma once
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace mw {

class GltfBuilder {
public:
    nlohmann::json root = nlohmann::json::object();
    std::vector<uint8_t> bin;

    /// Appends bytes as a view of their own. `target` 34962 for vertices, 34963 for indices, 0 for anything else.
    size_t addView(std::span<const uint8_t> bytes, int target = 0, int stride = 0)
    {
        bin.resize((bin.size() + 7) & ~size_t(7), 0);
        nlohmann::json view{{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
        if (target) view["target"] = target;
        if (stride) view["byteStride"] = stride;
        bin.insert(bin.end(), bytes.begin(), bytes.end());
        return append("bufferViews", std::move(view));
    }
    template <class T>
    size_t addArray(std::span<const T> values)
    {
        return addView({reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()});
    }
    /// Adds to one of the lists at the root; gives the index.
    size_t append(const char* list, nlohmann::json entry)
    {
        nlohmann::json& all = root[list];
        all.push_back(std::move(entry));
        return all.size() - 1;
    }
    size_t views() const
    {
        const auto v = root.find("bufferViews");
        return v == root.end() ? 0 : v->size();
    }
};

/// Text of JSON; bytes of names that are no UTF-8 become the replacement character.
inline std::string textOf(const nlohmann::json& j, int indent = -1)
{
    return j.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace mw
