// OFF text to arrays: numbers one after the other, wherever lines end; only the colour of a face is bound to the line of its last index.
#include <algorithm>
#include <cstring>

#include "core/io/off_data.h"

namespace mw {

namespace {

constexpr Finding extraFinding{"extra-values", "line has more numbers than it should: ignored", "lines have more numbers than they should: ignored"};
constexpr Finding unannouncedFinding{"unannounced-color",
                                     "file has numbers after its positions that its first word does not announce: taken as colours",
                                     "files have numbers that their first word does not announce"};
constexpr Finding colorFinding{"broken-color", "face has a colour that was not understood: left out",
                               "faces have colours that were not understood: left out"};
constexpr Finding trailingFinding{"trailing-text", "file goes on after its last face: ignored", "files go on after their last face"};

class Parser {
public:
    Parser(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress)
        : bytes_(bytes), header_(header), file_(file), data_(data), progress_(progress), p_(bytes.begin() + header.bodyStart), line_(header.line)
    {}
    void run();

private:
    void counts();
    void layout();
    void vertices();
    void faces();
    void face(size_t f);
    void faceColor(size_t f);

    bool skip();
    void skipBlanks();
    bool atLineEnd() const { return *p_ == '\n' || *p_ == '#' || p_ >= bytes_.end(); }
    bool endsNumber() const { return endsToken(*p_) || *p_ == '#'; }
    uint64_t count(const char* of);
    float value(size_t vertex);
    glm::vec3 triple(size_t vertex);
    uint32_t cornerCount();
    uint32_t index();
    size_t left() const { return size_t(bytes_.end() - p_); }
    void report(float from, float share, size_t done, size_t all);
    std::string here() const { return "line " + std::to_string(line_); }
    [[noreturn]] void fail(const std::string& what) const { throw Error(file_, here() + ": " + what); }
    [[noreturn]] void failHere(const std::string& expected) const { fail("expected " + expected + ", found " + inQuotes(tokenAt(p_))); }

    const FileBytes& bytes_;
    const OffHeader& header_;
    const std::string& file_;
    OffData& data_;
    Progress* progress_;
    const char* p_;
    uint64_t line_;
    size_t vertexCount_ = 0, faceCount_ = 0;
    size_t colorValues_ = 0, extraValues_ = 0;  // of each vertex
    size_t face_ = 0;
};

/// To the next token; false at the end of the file.
inline bool Parser::skip()
{
    while (true) {
        while (endsToken(*p_)) {
            if (p_ >= bytes_.end()) return false;
            line_ += *p_++ == '\n';
        }
        if (*p_ != '#') return true;
        const char* end = static_cast<const char*>(std::memchr(p_, '\n', size_t(bytes_.end() - p_ + 1)));
        if (line_ <= 1000) data_.stated.listen({p_ + 1, size_t(end - p_ - 1)});
        p_ = end;
    }
}

inline void Parser::skipBlanks()
{
    while (*p_ == ' ' || *p_ == '\t' || *p_ == '\r') ++p_;
}

uint64_t Parser::count(const char* of)
{
    if (!skip()) fail(std::string("the file ends before the number of ") + of + "; copy or export it again");
    uint64_t n = 0;
    const char* start = p_;
    if (!parseDigits(p_, n) || !endsNumber()) {
        p_ = start;
        failHere(std::string("the number of ") + of);
    }
    return n;
}

void Parser::counts()
{
    if (header_.dimensions && count("dimensions") != 3) fail("its vertices have not three dimensions; only such can be shown");
    const uint64_t vertices = count("vertices"), line = line_, faces = count("faces");
    // The number of edges is of no use to anyone and left out by some: it is only taken where it must be one.
    skipBlanks();
    if (line_ != line || !atLineEnd()) count("edges");
    // A value takes a digit and a blank, or the file's end.
    const size_t room = left() + 1;
    if (vertices > room / (2 * header_.plainValues()))
        fail("announces " + std::to_string(vertices) + " vertices, but there is room for " + std::to_string(room / (2 * header_.plainValues())) +
             " at most; copy or export it again");
    if (faces > room / 2)
        fail("announces " + std::to_string(faces) + " faces, but there is room for " + std::to_string(room / 2) +
             " at most; copy or export it again");
    vertexCount_ = size_t(vertices);
    faceCount_ = size_t(faces);
    if (vertexCount_ == 0) fail("announces no vertices; there is nothing to show");
}

/// The first vertex's line tells how many numbers make a colour, and whether there are more than the first word announces.
void Parser::layout()
{
    if (!skip()) return;
    const size_t plain = header_.plainValues();
    size_t values = 0;
    bool bytes = true;  // what there is beyond the plain values
    for (const char* q = p_; q <= bytes_.end() && *q != '\n' && *q != '#';) {
        if (endsToken(*q)) {
            ++q;
            continue;
        }
        const char* token = q;
        while (!endsToken(*q) && *q != '#') ++q;
        if (++values > plain) bytes = bytes && std::all_of(token, q, isDigit);
    }
    const size_t over = values > plain ? values - plain : 0;
    if (header_.color) {
        colorValues_ = over == 3 ? 3 : 4;
        extraValues_ = over > 4 ? over - 4 : 0;
    } else if ((over == 3 || over == 4) && bytes) {
        colorValues_ = over;
        data_.findings.add(unannouncedFinding, [&] { return here(); });
    } else {
        extraValues_ = over;
    }
    if (extraValues_) data_.findings.add(extraFinding, [&] { return here(); });
    data_.colorSize = int(colorValues_);
    const size_t least = 2 * (plain + colorValues_ + extraValues_);
    if (vertexCount_ > (left() + 1) / least)
        fail("announces " + std::to_string(vertexCount_) + " vertices, but the file is too short for them; copy or export it again");
}

inline float Parser::value(size_t vertex)
{
    if (!skip())
        fail("the file ends within vertex " + std::to_string(vertex) + " of " + std::to_string(vertexCount_) +
             ", counted from 0; copy or export it again");
    const char* start = p_;
    float v = 0;
    if (!parseNumber(p_, v) || !endsNumber()) {
        p_ = start;
        failHere("a number of vertex " + std::to_string(vertex) + ", counted from 0");
    }
    return v;
}

inline glm::vec3 Parser::triple(size_t vertex)
{
    glm::vec3 v;
    if (skip() && parseThree(p_, &v.x)) return v;
    for (int k = 0; k < 3; ++k) v[k] = value(vertex);
    return v;
}

void Parser::report(float from, float share, size_t done, size_t all)
{
    if (progress_ && (done & 0x7fff) == 0) progress_->at(from + share * float(done) / float(all));
}

void Parser::vertices()
{
    data_.positions.expect(vertexCount_);
    if (header_.normal) data_.normals.expect(vertexCount_);
    if (header_.texcoord) data_.texcoords.expect(vertexCount_);
    if (colorValues_) data_.colors.expect(vertexCount_);
    for (size_t i = 0; i < vertexCount_; ++i) {
        glm::vec3 p = triple(i);
        if (header_.homogeneous) {
            const float w = value(i);
            p = glm::vec3(glm::dvec3(p) / double(w));
        }
        data_.positions.push(p);
        if (header_.normal) data_.normals.push(triple(i));
        if (colorValues_) {
            glm::vec4 c(1);
            for (int k = 0; k < int(colorValues_); ++k) c[k] = value(i);
            data_.colors.push(c);
        }
        if (header_.texcoord) {
            glm::vec2 t;
            for (int k = 0; k < 2; ++k) t[k] = value(i);
            data_.texcoords.push(t);
        }
        for (size_t k = 0; k < extraValues_; ++k) value(i);
        report(0, 0.5f, i, vertexCount_);
    }
}

inline uint32_t Parser::index()
{
    // Nearly always a blank or the end of the line before, then a few digits.
    const char* q = p_ + endsToken(*p_);
    if (uint32_t plain = 0; parseShort(q, plain) && endsToken(*q)) {
        line_ += *p_ == '\n';
        p_ = q;
        return plain;
    }
    if (!skip())
        fail("the file ends within face " + std::to_string(face_) + " of " + std::to_string(faceCount_) +
             ", counted from 0; copy or export it again");
    const char* start = p_;
    const bool minus = *p_ == '-';
    if (minus || *p_ == '+') ++p_;
    uint64_t n = 0;
    if (!parseDigits(p_, n) || !endsNumber()) {
        p_ = start;
        failHere("an index of face " + std::to_string(face_) + ", counted from 0");
    }
    return n < OffData::wrongIndex && !(minus && n > 0) ? uint32_t(n) : OffData::wrongIndex;
}

/// Nearly always one digit at the start of a line.
inline uint32_t Parser::cornerCount()
{
    if (*p_ != '\n' || !isDigit(p_[1]) || p_[2] != ' ') return index();
    ++line_;
    p_ += 2;
    return uint32_t(p_[-1] - '0');
}

inline void Parser::face(size_t f)
{
    face_ = f;
    const uint32_t corners = cornerCount();
    if (corners > (left() + 1) / 2)
        fail("face " + std::to_string(f) + ", counted from 0, announces " +
             (corners >= OffData::wrongIndex ? "a wrong number of" : std::to_string(corners)) +
             " corners, more than the rest of the file can hold; copy or export it again");
    uint32_t c = 0;
    if (const char* q = p_ + 1; corners >= 3 && *p_ == ' ' && parseThree(q, data_.cornerVertex.room(3))) {
        data_.cornerVertex.cut(data_.cornerVertex.size() + 3);
        p_ = q;
        c = 3;
    }
    for (; c < corners; ++c) data_.cornerVertex.push(index());
    if (data_.cornerVertex.size() >= none - 2) fail("more corners than 32-bit indices can number; split the file");
    data_.faceStart.push(uint32_t(data_.cornerVertex.size()));
    skipBlanks();
    if (atLineEnd())
        data_.addFaceColor(f, OffData::Color::None, glm::vec4(1));
    else
        faceColor(f);
}

/// The rest of the line: one number is an index into a colour map, three or four are a colour, whole numbers up to 255 or fractions.
void Parser::faceColor(size_t f)
{
    using Color = OffData::Color;
    glm::vec4 c(1);
    int n = 0;
    bool whole = true, understood = true;
    for (; !atLineEnd() && understood; skipBlanks()) {
        const std::string_view token = tokenAt(p_);
        float v = 0;
        understood = parseNumber(p_, v) && endsNumber();
        whole = whole && token.find_first_of(".eE") == token.npos;
        if (understood && n < 4) c[n] = v;
        ++n;
    }
    const Color kind = !understood       ? Color::None
                       : n == 1 && whole ? Color::Index
                       : n == 3          ? whole ? Color::Whole3 : Color::Fraction3
                       : n >= 4          ? whole ? Color::Whole4 : Color::Fraction4
                                         : Color::None;
    if (kind == Color::None)
        data_.findings.add(
            colorFinding, [&] { return here(); }, uint32_t(f));
    if (n > 4) data_.findings.add(extraFinding, [&] { return here(); });
    data_.addFaceColor(f, kind, c);
    while (!atLineEnd()) ++p_;
}

void Parser::faces()
{
    data_.faceStart.expect(faceCount_ + 1);
    data_.cornerVertex.expect(std::min(3 * faceCount_, left() / 2 + 1));
    data_.faceStart.push(0);
    for (size_t f = 0; f < faceCount_; ++f) {
        face(f);
        report(0.5f, 0.5f, f, faceCount_);
    }
    if (skip()) data_.findings.add(trailingFinding, [&] { return here(); });
}

void Parser::run()
{
    counts();
    layout();
    vertices();
    faces();
}

}  // namespace

bool readOffHeader(std::string_view text, OffHeader& header)
{
    header = {};
    size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
    while (at < text.size() && (endsToken(text[at]) || text[at] == '#')) {
        if (text[at] == '#') at = std::min(text.size(), text.find('\n', at));
        if (at < text.size()) header.line += text[at++] == '\n';
    }
    // The letters may come in any order.
    while (true) {
        const std::string_view rest = text.substr(std::min(at, text.size()));
        if (rest.starts_with("OFF")) break;
        bool* letter = rest.starts_with("ST")  ? &header.texcoord
                       : rest.starts_with("C") ? &header.color
                       : rest.starts_with("N") ? &header.normal
                       : rest.starts_with("4") ? &header.homogeneous
                       : rest.starts_with("n") ? &header.dimensions
                                               : nullptr;
        if (!letter || *letter) {
            header = {};
            return false;
        }
        *letter = true;
        at += letter == &header.texcoord ? 2 : 1;
    }
    at += 3;
    // Some programs forget the blank: "OFF8 6 12".
    if (at < text.size() && !endsToken(text[at]) && text[at] != '#' && !isDigit(text[at])) return header = {}, false;
    size_t word = at;
    while (word < text.size() && (text[word] == ' ' || text[word] == '\t')) ++word;
    if (text.substr(word).starts_with("BINARY") && word > at) {
        header.binary = true;
        at = word + 6;
        while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r')) ++at;
        if (at < text.size() && text[at] == '\n') ++at;
    }
    header.bodyStart = at;
    return true;
}

void parseOff(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress)
{
    Parser(bytes, header, file, data, progress).run();
}

}  // namespace mw
