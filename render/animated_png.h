// Pictures one after the other in one PNG file (APNG): browsers and most viewers play it, others show the first one.
#pragma once
#include <cstdio>
#include <memory>
#include <string>

#include "render/offscreen.h"

namespace mw {

class AnimatedPng {
public:
    /// `count` pictures will follow, each shown for `seconds`; it plays for ever. Throws Error when the file cannot be made.
    AnimatedPng(std::string file, int count, double seconds);
    ~AnimatedPng();  ///< without finish() no file is left
    /// All of one size. Throws Error when it cannot be written.
    void add(const Picture& picture);
    void finish();

private:
    void chunk(const char* type, const std::vector<uint8_t>& data);
    std::string file_;
    FILE* out_ = nullptr;
    int count_, added_ = 0;
    uint16_t milliseconds_;
    uint32_t sequence_ = 0;
};

}  // namespace mw
