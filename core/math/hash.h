// A fast 64-bit hash of bytes: the same on every run and every machine of one byte order. Not for secrets.
#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace mw {

/// Feed it pieces in order; value() at any time. Sizes are part of the hash, so ("ab", "c") and ("a", "bc") differ.
class Hasher {
public:
    void number(uint64_t x) { state_ = mix(state_ ^ x, secret1); }
    void bytes(const void* data, size_t size);
    void text(std::string_view s) { bytes(s.data(), s.size()); }
    template <class T>
    void array(std::span<const T> a)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(a.data(), a.size_bytes());
    }
    uint64_t value() const { return mix(state_ ^ secret0, secret1); }

    /// Both halves of the 128-bit product: every bit of both factors counts.
    static uint64_t mix(uint64_t a, uint64_t b)
    {
        const unsigned __int128 p = static_cast<unsigned __int128>(a) * b;
        return uint64_t(p) ^ uint64_t(p >> 64);
    }

private:
    static constexpr uint64_t secret0 = 0xa0761d6478bd642full, secret1 = 0xe7037ed1a0b428dbull, secret2 = 0x8ebc6af09c88c6e3ull;
    uint64_t state_ = secret2;
};

inline void Hasher::bytes(const void* data, size_t size)
{
    const auto* p = static_cast<const unsigned char*>(data);
    auto word = [](const unsigned char* q) {
        uint64_t x;
        std::memcpy(&x, q, 8);
        return x;
    };
    uint64_t a = state_ ^ size, b = state_ + secret0;  // two chains, so that multiplications overlap
    size_t left = size;
    for (; left >= 32; left -= 32, p += 32) {
        a = mix(word(p) ^ secret0, word(p + 8) ^ a);
        b = mix(word(p + 16) ^ secret1, word(p + 24) ^ b);
    }
    unsigned char tail[32] = {};
    if (left) std::memcpy(tail, p, left);
    a = mix(word(tail) ^ secret0, word(tail + 8) ^ a);
    b = mix(word(tail + 16) ^ secret1, word(tail + 24) ^ b);
    state_ = mix(a ^ secret2, b ^ size);
}

}  // namespace mw
