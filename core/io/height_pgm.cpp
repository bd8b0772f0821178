// Portable graymap: text (P2) and binary (P5), up to 16 bits.
#include <algorithm>
#include <charconv>

#include "core/io/height_picture_data.h"

namespace mw {

namespace {

/// Reads numbers between white space and comments.
class Words {
public:
    Words(const FileBytes& bytes, const std::string& file) : bytes_(bytes), file_(file), at_(bytes.begin() + 2) {}

    uint64_t number(const char* what)
    {
        skip();
        uint64_t value = 0;
        const auto [end, error] = std::from_chars(at_, bytes_.end(), value);
        if (error != std::errc())
            throw Error(file_, "byte " + std::to_string(at_ - bytes_.begin()) + ": " + what +
                                   (at_ == bytes_.end() ? " is missing, the file ends too early" : " is no whole number") + "; get it again");
        at_ = end;
        return value;
    }
    const char* at() const { return at_; }
    size_t left() const { return size_t(bytes_.end() - at_); }

private:
    void skip()
    {
        const auto space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
        while (at_ < bytes_.end() && (space(*at_) || *at_ == '#')) at_ = *at_ == '#' ? std::find(at_, bytes_.end(), '\n') : at_ + 1;
    }

    const FileBytes& bytes_;
    const std::string& file_;
    const char* at_;
};

void readText(Words& in, HeightPicture& out, uint64_t white, size_t& tooBright, Progress* progress)
{
    for (uint32_t y = 0; y < out.height; ++y) {
        if (progress && y % 64 == 0) progress->at(float(y) / float(out.height));
        for (uint32_t x = 0; x < out.width; ++x) {
            const uint64_t v = in.number("a pixel");
            tooBright += v > white;
            out.heights[size_t(y) * out.width + x] = float(double(std::min(v, white)) / double(white));
        }
    }
}

void readBinary(const uint8_t* at, HeightPicture& out, uint64_t white, size_t& tooBright)
{
    const bool wide = white > 255;
    for (size_t i = 0; i < out.heights.size(); ++i) {
        const uint64_t v = wide ? uint64_t(at[2 * i] << 8 | at[2 * i + 1]) : at[i];
        tooBright += v > white;
        out.heights[i] = float(double(std::min(v, white)) / double(white));
    }
}

}  // namespace

HeightPicture readPgm(const FileBytes& bytes, const std::string& file, Progress* progress)
{
    const bool text = bytes.data()[1] == '2';
    Words in(bytes, file);
    const uint64_t width = in.number("the width"), height = in.number("the height"), white = in.number("the value of white");
    checkPictureSize(width, height, file);
    if (white < 1 || white > 65535) throw Error(file, "says that white is " + std::to_string(white) + "; it must lie in 1 to 65535");
    const uint64_t count = width * height, needed = text ? 2 * count - 1 : 1 + count * (white > 255 ? 2 : 1);
    if (in.left() < needed)
        throw Error(file, "ends too early: its header announces " + std::to_string(width) + " x " + std::to_string(height) + " pixels, its " +
                              std::to_string(bytes.size()) + " bytes do not hold them; get it again");
    HeightPicture out{uint32_t(width), uint32_t(height), Array<float>(size_t(count)), white > 255 ? "PGM, 16 bits" : "PGM, 8 bits", {}};
    size_t tooBright = 0;
    if (text)
        readText(in, out, white, tooBright, progress);
    else
        readBinary(reinterpret_cast<const uint8_t*>(in.at()) + 1, out, white, tooBright);
    if (tooBright > 0)
        out.warnings.push_back(
            {"height-cut",
             std::to_string(tooBright) + " pixels are brighter than the white of the header, " + std::to_string(white) + "; they became white",
             {}});
    return out;
}

}  // namespace mw
