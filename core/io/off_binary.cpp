// Binary OFF. Geomview's has big-endian numbers and after each face the number of its colour's values; other programs write little-endian numbers
// and no colours. Nothing in the header tells: the way is taken in which the counts agree with the bytes there are.
#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "core/io/off_data.h"

namespace mw {

namespace {

constexpr Finding trailingFinding{"trailing-bytes", "file goes on after its last face: ignored", "files go on after their last face"};

struct Layout {
    bool big = true, faceColors = true;
    size_t colorValues = 0;  // of a vertex
};

class Reader {
public:
    Reader(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress)
        : bytes_(bytes), header_(header), file_(file), data_(data), progress_(progress)
    {}
    bool run();

private:
    uint32_t word(size_t at) const
    {
        uint32_t v;
        std::memcpy(&v, bytes_.data() + at, 4);
        return layout_.big == (std::endian::native == std::endian::big) ? v : __builtin_bswap32(v);
    }
    float number(size_t at) const { return std::bit_cast<float>(word(at)); }
    size_t left(size_t at) const { return at < bytes_.size() ? bytes_.size() - at : 0; }
    size_t start() const { return header_.bodyStart + (header_.dimensions ? 4 : 0); }
    size_t vertexBytes() const { return 4 * (header_.plainValues() + layout_.colorValues); }
    std::optional<size_t> end() const;
    Layout bestLayout();
    void vertices();
    void faces();
    void report(float from, size_t done, size_t all) const
    {
        if (progress_ && (done & 0x7fff) == 0) progress_->at(from + 0.5f * float(done) / float(all));
    }

    const FileBytes& bytes_;
    const OffHeader& header_;
    const std::string& file_;
    OffData& data_;
    Progress* progress_;
    Layout layout_;
    size_t vertexCount_ = 0, faceCount_ = 0, at_ = 0;
};

/// Where the file ends when it is laid out so; nothing when it cannot be.
std::optional<size_t> Reader::end() const
{
    if (left(start()) < 12) return {};
    if (header_.dimensions && word(header_.bodyStart) != 3) return {};
    const size_t vertices = word(start()), faces = word(start() + 4);
    size_t at = start() + 12;
    if (vertices == 0 || vertices > left(at) / vertexBytes()) return {};
    at += vertices * vertexBytes();
    if (faces > left(at) / 4) return {};
    for (size_t f = 0; f < faces; ++f) {
        if (left(at) < 4) return {};
        const size_t corners = word(at);
        at += 4;
        if (corners > left(at) / 4) return {};
        at += 4 * corners;
        if (!layout_.faceColors) continue;
        if (left(at) < 4) return {};
        const size_t values = word(at);
        at += 4;
        if (values > 4 || values > left(at) / 4) return {};
        at += 4 * values;
    }
    return at;
}

/// The first layout that uses all bytes; else the first that fits into them.
Layout Reader::bestLayout()
{
    std::optional<Layout> fitting;
    for (const size_t colorValues : {4, 3})
        for (const bool faceColors : {true, false})
            for (const bool big : {true, false}) {
                layout_ = {big, faceColors, header_.color ? colorValues : 0};
                const std::optional<size_t> e = end();
                if (e == bytes_.size()) return layout_;
                if (e && !fitting) fitting = layout_;
            }
    if (fitting) {
        data_.findings.add(trailingFinding);
        return *fitting;
    }
    std::string counts = left(start()) < 8 ? "none" : "";
    if (counts.empty())
        for (const bool big : {true, false}) {
            layout_ = {big, true, 0};
            counts += (big ? "" : ", or ") + std::to_string(word(start())) + " vertices and " + std::to_string(word(start() + 4)) + " faces (" +
                      (big ? "big" : "little") + "-endian)";
        }
    throw Error(file_, "byte " + std::to_string(header_.bodyStart) + ": its counts (" + counts +
                           ") do not agree with the bytes that follow, or it has not three dimensions; copy or export it again");
}

void Reader::vertices()
{
    data_.positions.expect(vertexCount_);
    for (size_t i = 0; i < vertexCount_; ++i) {
        const auto next = [&] {
            at_ += 4;
            return number(at_ - 4);
        };
        glm::vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = next();
        if (header_.homogeneous) p = glm::vec3(glm::dvec3(p) / double(next()));
        data_.positions.push(p);
        if (header_.normal) {
            glm::vec3 n;
            for (int k = 0; k < 3; ++k) n[k] = next();
            data_.normals.push(n);
        }
        if (layout_.colorValues) {
            glm::vec4 c(1);
            for (int k = 0; k < int(layout_.colorValues); ++k) c[k] = next();
            data_.colors.push(c);
        }
        if (header_.texcoord) {
            glm::vec2 t;
            for (int k = 0; k < 2; ++k) t[k] = next();
            data_.texcoords.push(t);
        }
        report(0, i, vertexCount_);
    }
}

void Reader::faces()
{
    using Color = OffData::Color;
    data_.faceStart.expect(faceCount_ + 1);
    data_.faceStart.push(0);
    for (size_t f = 0; f < faceCount_; ++f) {
        const size_t corners = word(at_);
        at_ += 4;
        for (size_t c = 0; c < corners; ++c, at_ += 4) data_.cornerVertex.push(std::min(word(at_), OffData::wrongIndex));
        if (data_.cornerVertex.size() >= none - 2) throw Error(file_, "more corners than 32-bit indices can number; split the file");
        data_.faceStart.push(uint32_t(data_.cornerVertex.size()));
        const size_t values = layout_.faceColors ? word(at_) : 0;
        at_ += layout_.faceColors ? 4 : 0;
        glm::vec4 color(1);
        if (values == 1)
            color[0] = float(int32_t(word(at_)));
        else
            for (size_t k = 0; k < values; ++k) color[int(k)] = number(at_ + 4 * k);
        at_ += 4 * values;
        data_.addFaceColor(f, values == 1 ? Color::Index : values == 3 ? Color::Fraction3 : values == 4 ? Color::Fraction4 : Color::None, color);
        report(0.5f, f, faceCount_);
    }
}

bool Reader::run()
{
    layout_ = bestLayout();
    data_.colorSize = int(layout_.colorValues);
    vertexCount_ = word(start());
    faceCount_ = word(start() + 4);
    at_ = start() + 12;
    vertices();
    faces();
    // Four values are the rule: where none is transparent they were three.
    bool opaque = true;
    for (size_t i = 0; i < data_.colors.size() && opaque; ++i) opaque = data_.colors[i].a == 1;
    if (opaque && data_.colorSize == 4) data_.colorSize = 3;
    return layout_.big;
}

}  // namespace

bool parseBinaryOff(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress)
{
    return Reader(bytes, header, file, data, progress).run();
}

}  // namespace mw
