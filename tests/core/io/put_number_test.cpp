// The text of numbers is that of std::to_chars, byte by byte.
#include "core/io/put_number.h"

#include <bit>
#include <charconv>
#include <gtest/gtest.h>
#include <random>

namespace {

template <class T>
void expectSame(T v)
{
    char ours[64], theirs[64];
    const std::string_view a(ours, size_t(mw::putNumber(ours, v) - ours));
    const std::string_view b(theirs, size_t(std::to_chars(theirs, theirs + sizeof theirs, v).ptr - theirs));
    if (a != b) {
        ADD_FAILURE() << a << " instead of " << b;
    }
}

float fromBits(uint32_t bits)
{
    return std::bit_cast<float>(bits);
}

TEST(PutNumber, AnyFloat)
{
    std::mt19937 random(1);
    for (int i = 0; i < 500'000 && !HasFailure(); ++i) expectSame(fromBits(random()));
}

/// Coordinates as meshes have them: 1e-12 to 1e10.
TEST(PutNumber, FloatsOfMeshes)
{
    std::mt19937 random(2);
    for (int i = 0; i < 1'000'000 && !HasFailure(); ++i) expectSame(fromBits((random() & 0x807fffff) | (87 + random() % 74) << 23));
}

TEST(PutNumber, FewDigits)
{
    for (int i = -100'000; i <= 100'000 && !HasFailure(); ++i)
        for (float unit : {1.f, 0.1f, 0.01f, 0.001f, 1e-5f, 1e-9f, 1 / 256.f, 100.f}) expectSame(float(i) * unit);
    for (int i = 0; i <= 1'000'000 && !HasFailure(); ++i) expectSame(float(i / 1e6));
}

/// Where the distance to the next float changes, and the ends of what there is.
TEST(PutNumber, NextToPowersOfTwo)
{
    for (uint32_t e = 0; e < 512; ++e)
        for (uint32_t d = 0; d < 16; ++d) expectSame(fromBits((e << 23) + d - 8));
}

TEST(PutNumber, WholeNumbers)
{
    std::mt19937 random(3);
    for (uint32_t shift = 0; shift < 32; ++shift)
        for (int i = 0; i < 10'000; ++i) expectSame(uint32_t(random() >> shift));
    for (uint32_t power = 1; power < 1'000'000'000; power *= 10)
        for (uint32_t v : {power - 1, power, power + 1}) expectSame(v);
    expectSame(0u);
    expectSame(~0u);
}

}  // namespace
