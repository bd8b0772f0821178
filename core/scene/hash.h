// Hashing the content of a scene, piece by piece (64-bit FNV-1a over words; not for secrets). A name of its own: core/math has a Hasher.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "core/catalog/parameters.h"

namespace mw {

class SceneHasher {
public:
    template <class T>
    requires std::is_arithmetic_v<T> SceneHasher& add(T v) { return bytes(&v, sizeof v); }
    SceneHasher& add(const std::string& s)
    {
        add(s.size());
        return bytes(s.data(), s.size());
    }
    SceneHasher& add(const ParameterValues& values)
    {
        for (const auto& [name, value] : values) {
            add(name).add(value.index());
            std::visit(
                [&](const auto& v) {
                    if constexpr (std::is_same_v<std::decay_t<decltype(v)>, glm::dvec3>)
                        add(v.x).add(v.y).add(v.z);
                    else
                        add(v);
                },
                value);
        }
        return *this;
    }
    SceneHasher& bytes(const void* data, size_t n)
    {
        const auto* p = static_cast<const unsigned char*>(data);
        for (; n >= 8; p += 8, n -= 8) {
            uint64_t word;
            std::memcpy(&word, p, 8);
            mix(word);
        }
        uint64_t rest = n;
        for (size_t i = 0; i < n; ++i) rest = rest << 8 | p[i];
        mix(rest);
        return *this;
    }
    uint64_t value() const { return hash_ ^ hash_ >> 29; }

private:
    void mix(uint64_t word)
    {
        hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15u;
        hash_ ^= hash_ >> 32;
    }
    uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace mw
