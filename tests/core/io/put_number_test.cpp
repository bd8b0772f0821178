// The text of numbers is that of std::to_chars, byte by byte; text is read as by std::from_chars, bit by bit.
#include "core/io/put_number.h"

#include <bit>
#include <charconv>
#include <gtest/gtest.h>
#include <random>

#include "core/io/file.h"
#include "core/io/text.h"

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

template <class T>
void expectRead(const std::string& text)
{
    const std::string padded = text + std::string(mw::textPadding, '\0');
    const char* p = padded.c_str();
    T ours = 0, theirs = 0;
    const bool read = mw::parseNumber(p, ours);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), theirs);
    if (error == std::errc::result_out_of_range) return;  // becomes 0 or infinite here, is refused there
    if (read != (error == std::errc()) || (read && (ours != theirs || p - padded.c_str() != end - text.data()))) {
        ADD_FAILURE() << text << ": " << ours << " instead of " << theirs;
    }
}

/// Digits, a point and an exponent, each there or not, and what may follow.
TEST(ParseNumber, AnyText)
{
    std::mt19937 random(4);
    const auto digits = [&](unsigned most) {
        std::string s(random() % (most + 1), '0');
        for (char& c : s) c = char('0' + random() % 10);
        return s;
    };
    for (int i = 0; i < 300'000 && !HasFailure(); ++i) {
        std::string text = (random() % 2 ? "-" : "") + digits(random() % 4 ? 4 : 21);
        if (random() % 8) text += "." + digits(random() % 4 ? 9 : 21);
        if (random() % 8 == 0) text += std::string("e") + (random() % 2 ? "-" : "") + digits(2);
        text += std::string_view(" \n\t/,#x.-").substr(random() % 9, 1);
        expectRead<float>(text);
        expectRead<double>(text);
    }
}

/// Three at once are the three read one by one: wherever both read them, and wherever they stand plainly.
template <class T, class One>
void expectThree(const std::string& text, bool plain, const One& one)
{
    const std::string padded = text + "\n" + std::string(mw::FileBytes::padding, '\0');
    const char *p = padded.c_str(), *q = p;
    T ours[3], theirs[3];
    const bool read = mw::parseThree(p, ours);
    bool all = true;
    for (int k = 0; all && k < 3; ++k) all = (k == 0 || *q++ == ' ') && one(q, theirs[k]) && mw::endsToken(*q);
    const bool same = !read || (all && p == q && std::equal(ours, ours + 3, theirs));
    EXPECT_TRUE(same && (read || !plain) && (read || p == padded.c_str())) << text;
}

TEST(ParseNumber, ThreeAtOnce)
{
    std::mt19937 random(6);
    const std::string_view odd[] = {"",  "-",   ".", "1e5", "-2.5E-3", "+7", "inf", "1#", "12345678", "123456789012345678901234567890.5",
                                    "x", "\t1", " 1"};
    const auto number = [&](bool whole) {
        return std::to_string(random() >> (12 + random() % 20)) + (whole ? "" : "." + std::to_string(random() % 10'000'000));
    };
    for (int i = 0; i < 200'000 && !HasFailure(); ++i) {
        const bool whole = random() % 2, plain = random() % 2;
        std::string text;
        for (int k = 0; k < 3; ++k) {
            if (k) text += plain || random() % 8 ? " " : std::string(std::string_view("\n\t/  ").substr(random() % 4, 1 + random() % 2));
            text += plain || random() % 4 ? number(whole) : std::string(odd[random() % std::size(odd)]);
        }
        if (random() % 2) text += std::string_view(" \r\n").substr(random() % 3, 1);
        expectThree<float>(text, plain, [](const char*& p, float& v) { return mw::parseNumber(p, v); });
        expectThree<uint32_t>(text, plain && whole, [](const char*& p, uint32_t& v) {
            uint64_t n = 0;
            const bool read = mw::parseDigits(p, n);
            v = uint32_t(n);
            return read;
        });
    }
}

TEST(ParseNumber, WhatWasWritten)
{
    std::mt19937 random(5);
    for (int i = 0; i < 300'000 && !HasFailure(); ++i) {
        char text[64];
        const char* end = mw::putNumber(text, fromBits((random() & 0x807fffff) | (87 + random() % 74) << 23));
        expectRead<float>(std::string(text, size_t(end - text)) + "\n");
    }
}

}  // namespace
