// OBJ text to arrays. Numbers are read where they stand, arrays are made in the expected size first, and nothing is looked at twice: the time
// is that of two to three passes over the bytes.
#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "core/io/obj_data.h"

namespace mw {

namespace {

constexpr Finding numberFinding{"odd-number", "number was read up to its first odd character", "numbers were read up to their first odd character"};
constexpr Finding vertexFinding{"broken-vertex", "vertex line does not have three numbers", "vertex lines do not have three numbers"};
constexpr Finding weightFinding{"vertex-weight", "vertex has a weight other than 1: ignored", "vertices have a weight other than 1: ignored"};
constexpr Finding extraFinding{"extra-values", "line has more numbers than it should: ignored", "lines have more numbers than they should: ignored"};
constexpr Finding depthFinding{"texcoord-depth", "texture coordinate has a third value: ignored", "texture coordinates have a third value: ignored"};
constexpr Finding faceFinding{"broken-face", "face was not understood: left out", "faces were not understood: left out"};
constexpr Finding lineFinding{"broken-line", "line element was not understood: cut short", "line elements were not understood: cut short"};
constexpr Finding freeFormFinding{"free-form", "line of a free-form curve or surface: left out", "lines of free-form curves or surfaces: left out"};
constexpr Finding unknownFinding{"unknown-line", "line was not understood: left out", "lines were not understood: left out"};
constexpr Finding groupsFinding{"many-groups", "change of group beyond the first 65536 names: put into the last one",
                                "changes of group beyond the first 65536 names: put into the last one"};
constexpr Finding materialsFinding{"many-materials", "change of material beyond the first 4096 names: put into the last one",
                                   "changes of material beyond the first 4096 names: put into the last one"};

bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}
bool endsLine(char c)
{
    return c == '\n' || c == '\r' || c == '\0' || c == '#';
}

/// How many of each there will be, from a look at short pieces all over the file.
struct Expected {
    double vertices = 0, texcoords = 0, normals = 0, faces = 0, corners = 0;

    void count(const char* line, const char* end)
    {
        if (line[0] == 'v') {
            (line[1] == 't' ? texcoords : line[1] == 'n' ? normals : vertices) += 1;
        } else if (line[0] == 'f' && isBlank(line[1])) {
            faces += 1;
            for (const char* p = line + 1; p < end && *p != '\n'; ++p) corners += isBlank(p[0]) && !endsToken(p[1]);
        }
    }
    void operator*=(double k)
    {
        for (double* n : {&vertices, &texcoords, &normals, &faces, &corners}) *n *= k;
    }
};

Expected expected(const FileBytes& bytes)
{
    constexpr size_t windows = 256, window = 1024;
    const size_t step = std::max(window, bytes.size() / windows);
    Expected sum;
    size_t seen = 0;
    for (size_t at = 0; at < bytes.size(); at += step) {
        const char* end = bytes.begin() + std::min(bytes.size(), at + window);
        seen += size_t(end - bytes.begin()) - at;
        // A line counts where it starts; its rest may lie outside.
        const char* p = bytes.begin() + at;
        if (at > 0) p = static_cast<const char*>(std::memchr(p - 1, '\n', size_t(bytes.end() - p + 2))) + 1;
        while (p < end) {
            sum.count(p, bytes.end());
            p = static_cast<const char*>(std::memchr(p, '\n', size_t(bytes.end() - p + 1))) + 1;
        }
    }
    sum *= seen ? 1.03 * double(bytes.size()) / double(seen) : 0;
    return sum;
}

/// Names in the order of their first use.
class Names {
public:
    Names(std::vector<std::string>& list, size_t most) : list_(list), most_(most) {}
    /// `full` is set when there is no room for another.
    uint32_t number(const std::string& name, bool& full)
    {
        if (auto i = numbers_.find(name); i != numbers_.end()) return i->second;
        full = list_.size() == most_;
        if (full) return uint32_t(most_ - 1);
        list_.push_back(name);
        return numbers_[name] = uint32_t(list_.size() - 1);
    }

private:
    std::vector<std::string>& list_;
    std::unordered_map<std::string, uint32_t> numbers_;
    size_t most_;
};

class Parser {
public:
    Parser(const FileBytes& bytes, const std::string& file, ObjData& data, Progress* progress)
        : bytes_(bytes), file_(file), data_(data), progress_(progress), groups_(data.groupNames, 65536), materials_(data.materialNames, 4096)
    {}
    void run();

private:
    void reserve();
    const char* statement(const char* p);
    const char* endOfLine(const char* p);
    const char* skipBlanks(const char* p);
    const char* numbers(const char* p, float* to, int most, int& count);
    const char* vertex(const char* p);
    void color(const float* numbers, int count);
    const char* texcoord(const char* p);
    const char* normal(const char* p);
    const char* face(const char* p);
    bool hasPlainCorners() const { return data_.cornerTexcoord.size() + data_.cornerNormal.size() == 0; }
    const char* plainCorners(const char* p);
    const char* corner(const char* p);
    const char* index(const char* p, size_t count, uint32_t& to);
    void finishFace(uint32_t first, bool understood);
    void startRun(std::vector<ObjRun>& runs, Names& names, const std::string& name, const Finding& tooMany);
    const char* lineElement(const char* p);
    const char* named(const char* p);
    void comment(const char* p);
    std::string rest(const char* p) const;
    std::string here(std::string_view what) const { return "line " + std::to_string(line_) + (what.empty() ? "" : ": ") + std::string(what); }

    const FileBytes& bytes_;
    const std::string& file_;
    ObjData& data_;
    Progress* progress_;
    Names groups_, materials_;
    uint64_t line_ = 1;
    bool wrong_ = false;      // this face names a vertex that is not there (yet)
    int64_t wrongIndex_ = 0;  // as it stands in the file
    bool newGroup_ = false, newMaterial_ = false;
    std::string object_, group_, material_;
};

void Parser::reserve()
{
    const Expected e = expected(bytes_);
    data_.positions.expect(size_t(e.vertices) + 16);
    data_.texcoords.expect(size_t(e.texcoords));
    data_.normals.expect(size_t(e.normals));
    data_.faceStart.expect(size_t(e.faces) + 16);
    data_.cornerVertex.expect(size_t(e.corners) + 16);
    data_.faceStart.push(0);
}

void Parser::run()
{
    reserve();
    const char* p = bytes_.begin();
    while (p < bytes_.end()) {
        while (isBlank(*p)) ++p;
        p = endOfLine(statement(p));
        ++line_;
        if (progress_ && (line_ & 0x7fff) == 0) progress_->at(float(double(p - bytes_.begin()) / double(bytes_.size())));
        if (data_.cornerVertex.size() >= none - 2 || data_.positions.size() >= none - 2)
            throw Error(file_, here("more elements than 32-bit indices can number; split the file"));
    }
}

const char* Parser::statement(const char* p)
{
    if (*p == 'v') {
        if (isBlank(p[1])) return vertex(p + 2);
        if (p[1] == 't' && isBlank(p[2])) return texcoord(p + 3);
        if (p[1] == 'n' && isBlank(p[2])) return normal(p + 3);
    } else if (*p == 'f' && (isBlank(p[1]) || p[1] == '\\')) {
        return face(p + 1);
    } else if (*p == 'l' && isBlank(p[1])) {
        return lineElement(p + 1);
    }
    if (*p == '#') comment(p + 1);
    return endsLine(*p) && *p != '\0' ? p : named(p);
}

/// To the start of the next line. A statement goes on where a backslash ends its line; comments do not.
const char* Parser::endOfLine(const char* p)
{
    if (*p == '\n') return p + 1;
    if (*p == '\r' && p[1] == '\n') return p + 2;
    while (p <= bytes_.end()) {
        const char* start = p;
        const char* end = static_cast<const char*>(std::memchr(p, '\n', size_t(bytes_.end() - p + 1)));
        p = end + 1;
        if (*start == '#') break;
        const char* last = end > start && end[-1] == '\r' ? end - 1 : end;
        if (last == start || last[-1] != '\\') break;
        ++line_;
    }
    return p;
}

inline const char* Parser::skipBlanks(const char* p)
{
    while (true) {
        while (isBlank(*p)) ++p;
        if (*p != '\\') return p;
        const char* q = p + 1 + (p[1] == '\r');
        if (*q != '\n') return p;
        p = q + 1;
        ++line_;
        if (p > bytes_.end()) return p;
    }
}

/// Up to `most` numbers, of which `count` are there; it is one more when there are further ones. What is no number is NaN.
const char* Parser::numbers(const char* p, float* to, int most, int& count)
{
    for (;; ++count) {
        p = skipBlanks(p);
        if (endsLine(*p)) return p;
        if (count == most) return ++count, p;
        const char* token = p;
        if (!parseNumber(p, to[count])) to[count] = std::numeric_limits<float>::quiet_NaN();
        if (endsToken(*p) || (*p == '\\' && p != token)) continue;
        if (*p == '#' && p != token) to[count] = std::numeric_limits<float>::quiet_NaN();  // "1.#QNAN" of old compilers
        const std::string_view text = tokenAt(token);
        data_.findings.add(numberFinding, [&] { return here(inQuotes(text)); });
        p = token + text.size();
    }
}

const char* Parser::vertex(const char* p)
{
    float n[7];
    int count = parseThree(p, n) ? 3 : 0;
    p = numbers(p, n, 7, count);
    if (count < 3) {
        data_.findings.add(
            vertexFinding, [&] { return here({}); }, uint32_t(data_.positions.size()));
        n[0] = n[1] = n[2] = std::numeric_limits<float>::quiet_NaN();
    }
    data_.positions.push({n[0], n[1], n[2]});
    if (count > 3 || data_.colors.size()) color(n, count);
    return p;
}

/// After x y z there may be w, or r g b, or r g b a.
void Parser::color(const float* n, int count)
{
    if (count == 4 && n[3] != 1) data_.findings.add(weightFinding, [&] { return here({}); });
    if (count == 5 || count > 7) data_.findings.add(extraFinding, [&] { return here({}); });
    const bool has = count == 6 || count == 7;
    if (!has && data_.colors.size() == 0) return;
    data_.colors.fill(data_.positions.size() - 1, glm::vec4(1));
    data_.colors.push(has ? glm::vec4(n[3], n[4], n[5], count == 7 ? n[6] : 1) : glm::vec4(1));
    data_.alpha = data_.alpha || count == 7;
}

const char* Parser::texcoord(const char* p)
{
    float n[3] = {0, 0, 0};
    int count = 0;
    p = numbers(p, n, 3, count);
    if (count >= 3 && n[2] != 0) data_.findings.add(depthFinding, [&] { return here({}); });
    data_.texcoords.push({n[0], n[1]});
    return p;
}

const char* Parser::normal(const char* p)
{
    float n[3] = {0, 0, 0};
    int count = parseThree(p, n) ? 3 : 0;
    p = numbers(p, n, 3, count);
    data_.normals.push({n[0], n[1], n[2]});
    return p;
}

/// One index, counted from 1 or backwards from -1. `to` is wrongIndex where it cannot be right. Null when there is no number.
inline const char* Parser::index(const char* p, size_t count, uint32_t& to)
{
    const bool back = *p == '-';
    if (back || *p == '+') ++p;
    uint64_t n = 0;
    if (!parseDigits(p, n)) return nullptr;
    if (back)
        to = n >= 1 && n <= count ? uint32_t(count - n) : ObjData::wrongIndex;
    else
        to = n >= 1 && n < ObjData::wrongIndex ? uint32_t(n - 1) : ObjData::wrongIndex;
    wrongIndex_ = back ? -int64_t(n) : int64_t(n);
    return p;
}

/// v, v/vt, v//vn or v/vt/vn. Null when it is none of them.
inline const char* Parser::corner(const char* p)
{
    uint32_t v = none, t = none, n = none;
    // Most are a vertex that has come, and no more.
    if (const char* q = p; parseShort(q, v) && endsToken(*q) && v - 1 < data_.positions.size() && hasPlainCorners()) {
        data_.cornerVertex.push(v - 1);
        return q;
    }
    const int64_t earlier = wrongIndex_;
    p = index(p, data_.positions.size(), v);
    if (!p) return nullptr;
    if (wrong_)
        wrongIndex_ = earlier;  // the first one is reported
    else
        wrong_ = v >= data_.positions.size();
    const int64_t reported = wrongIndex_;
    if (*p == '/') {
        ++p;
        if (*p != '/' && !endsToken(*p)) p = index(p, data_.texcoords.size(), t);
        if (p && *p == '/') {
            ++p;
            if (!endsToken(*p)) p = index(p, data_.normals.size(), n);
        }
        if (!p) return nullptr;
    }
    wrongIndex_ = reported;
    if (!endsToken(*p) && *p != '\\') return nullptr;
    const size_t corner = data_.cornerVertex.size();
    data_.cornerVertex.push(v);
    if (t != none || data_.cornerTexcoord.size()) {
        data_.cornerTexcoord.fill(corner, none);
        data_.cornerTexcoord.push(t);
    }
    if (n != none || data_.cornerNormal.size()) {
        data_.cornerNormal.fill(corner, none);
        data_.cornerNormal.push(n);
    }
    return p;
}

/// Of most faces: three vertices that have come, and no more than their numbers.
inline const char* Parser::plainCorners(const char* p)
{
    if (!hasPlainCorners()) return p;
    const size_t first = data_.cornerVertex.size(), vertices = data_.positions.size();
    uint32_t* v = data_.cornerVertex.room(3);
    const char* q = p + 1;
    if (*p != ' ' || !parseThree(q, v)) return p;
    for (int k = 0; k < 3; ++k)
        if (--v[k] >= vertices) return p;
    data_.cornerVertex.cut(first + 3);
    return q;
}

const char* Parser::face(const char* p)
{
    const uint32_t first = uint32_t(data_.cornerVertex.size());
    wrong_ = false;
    p = plainCorners(p);
    while (true) {
        p = skipBlanks(p);
        if (endsLine(*p)) break;
        const char* next = corner(p);
        if (!next) {
            data_.findings.add(faceFinding, [&] { return here(inQuotes(tokenAt(p))); });
            finishFace(first, false);
            return p;
        }
        p = next;
    }
    if (data_.cornerVertex.size() == first) data_.findings.add(faceFinding, [&] { return here("no vertices"); });
    finishFace(first, data_.cornerVertex.size() > first);
    return p;
}

void Parser::finishFace(uint32_t first, bool understood)
{
    if (data_.firstFaceLine == 0) data_.firstFaceLine = line_;
    if (!understood) {
        data_.cornerVertex.cut(first);
        if (data_.cornerTexcoord.size() > first) data_.cornerTexcoord.cut(first);
        if (data_.cornerNormal.size() > first) data_.cornerNormal.cut(first);
        return;
    }
    if (newGroup_) {
        startRun(data_.groupRuns, groups_, object_.empty() || group_.empty() ? object_ + group_ : object_ + "/" + group_, groupsFinding);
        newGroup_ = false;
    }
    if (newMaterial_) {
        startRun(data_.materialRuns, materials_, material_, materialsFinding);
        newMaterial_ = false;
    }
    const uint32_t face = uint32_t(data_.faceStart.size() - 1);
    if (wrong_ && data_.early.size() < 1000) data_.early.push_back({face, line_, wrongIndex_});
    data_.faceStart.push(uint32_t(data_.cornerVertex.size()));
}

void Parser::startRun(std::vector<ObjRun>& runs, Names& names, const std::string& name, const Finding& tooMany)
{
    bool full = false;
    const ObjRun run{uint32_t(data_.faceStart.size() - 1), names.number(name, full)};
    if (full) data_.findings.add(tooMany);
    if (runs.empty() || runs.back().name != run.name) runs.push_back(run);
}

/// A chain of segments.
const char* Parser::lineElement(const char* p)
{
    uint32_t before = none;
    while (true) {
        p = skipBlanks(p);
        if (endsLine(*p)) return p;
        uint32_t v = none, t = none;
        const char* next = index(p, data_.positions.size(), v);
        if (next && *next == '/') next = index(next + 1, data_.texcoords.size(), t);
        if (!next || (!endsToken(*next) && *next != '\\')) {
            data_.findings.add(lineFinding, [&] { return here(inQuotes(tokenAt(p))); });
            return p;
        }
        if (before != none) {
            data_.lines.push(before);
            data_.lines.push(v);
        }
        before = v;
        p = next;
    }
}

/// What follows a keyword, to the end of the line.
std::string Parser::rest(const char* p) const
{
    const char* end = static_cast<const char*>(std::memchr(p, '\n', size_t(bytes_.end() - p + 1)));
    return std::string(trimmed({p, size_t(end - p)}));
}

/// Only where programs say such things: a scan may have a comment a line.
void Parser::comment(const char* p)
{
    if (line_ <= 1000) data_.stated.listen(rest(p));
}

const char* Parser::named(const char* p)
{
    const std::string_view word = tokenAt(p);
    const char* after = p + word.size();
    if (word == "usemtl") {
        material_ = rest(after);
        newMaterial_ = true;
    } else if (word == "o" || word == "g") {
        (word == "o" ? object_ : group_) = rest(after);
        if (word == "o") group_.clear();
        newGroup_ = true;
    } else if (word == "mtllib") {
        if (data_.libraries.size() < 1000) data_.libraries.push_back(rest(after));
    } else if (word == "s" || word == "p" || word == "vp") {
        // Smoothing groups say less than normals; points are vertices already.
        if (word == "vp") data_.findings.add(freeFormFinding, [&] { return here(word); });
    } else {
        constexpr std::string_view freeForm[] = {"cstype", "deg",  "curv", "curv2", "surf", "parm", "trim",
                                                 "hole",   "scrv", "sp",   "end",   "con",  "bmat", "step"};
        constexpr std::string_view display[] = {"mg", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "maplib", "usemap"};
        if (std::find(std::begin(freeForm), std::end(freeForm), word) != std::end(freeForm))
            data_.findings.add(freeFormFinding, [&] { return here(word); });
        else if (std::find(std::begin(display), std::end(display), word) == std::end(display))
            data_.findings.add(unknownFinding, [&] { return here(inQuotes(word)); });
    }
    return after;
}

}  // namespace

void parseObj(const FileBytes& bytes, const std::string& file, ObjData& data, Progress* progress)
{
    Parser(bytes, file, data, progress).run();
}

}  // namespace mw
