// STL text to arrays, word by word: programs disagree about lines, blanks and capitals.
#include <cstring>
#include <unordered_map>

#include "core/io/stl_data.h"

namespace mw {

namespace {

constexpr Finding unknownFinding{"unknown-word", "word was not understood: left out", "words were not understood: left out"};
constexpr Finding numberFinding{"odd-number", "vertex does not have three numbers: what is missing counts as not finite",
                                "vertices do not have three numbers: what is missing counts as not finite"};
constexpr Finding loopFinding{"broken-face", "facet has fewer than three vertices: left out", "facets have fewer than three vertices: left out"};
constexpr Finding polygonFinding{"polygon", "facet has more than three vertices: kept as a polygon",
                                 "facets have more than three vertices: kept as polygons"};
constexpr Finding cutFinding{"truncated", "file ends before its last solid does: what it has is read", "files end before their last solid does"};
constexpr Finding namesFinding{"many-groups", "solid beyond the first 65536 names: put into the last one",
                               "solids beyond the first 65536 names: put into the last one"};

bool isWord(const char* p, std::string_view word)
{
    for (char w : word)
        if ((*p++ | 0x20) != w) return false;
    return endsToken(*p);
}

class Parser {
public:
    Parser(const FileBytes& bytes, StlData& data, Progress* progress) : bytes_(bytes), data_(data), progress_(progress), p_(bytes.begin()) {}
    void run();

private:
    bool skip();
    void word();
    void vertex();
    void endFacet();
    void solid();
    void skipNumbers();
    std::string here() const { return "line " + std::to_string(line_); }

    const FileBytes& bytes_;
    StlData& data_;
    Progress* progress_;
    const char* p_;
    uint64_t line_ = 1;
    std::unordered_map<std::string, int32_t> numbers_;
    int32_t solid_ = -1;
    size_t first_ = 0;  // corner of this facet
    bool open_ = false;
};

inline bool Parser::skip()
{
    while (endsToken(*p_)) {
        if (p_ >= bytes_.end()) return false;
        line_ += *p_++ == '\n';
    }
    return true;
}

void Parser::run()
{
    data_.corners.expect(bytes_.size() / 80);  // a facet takes some 250 bytes
    data_.faceStart.expect(bytes_.size() / 240);
    data_.faceStart.push(0);
    for (size_t words = 0; skip(); ++words) {
        word();
        if (progress_ && (words & 0x7fff) == 0) progress_->at(float(double(p_ - bytes_.begin()) / double(bytes_.size())));
    }
    endFacet();
    if (open_) data_.findings.add(cutFinding, [&] { return here(); });
}

void Parser::word()
{
    if (isWord(p_, "vertex")) return vertex();
    if (isWord(p_, "facet")) {
        endFacet();
        p_ += 5;
        return skipNumbers();
    }
    if (isWord(p_, "outer") || isWord(p_, "endloop") || isWord(p_, "loop")) {
        p_ += tokenAt(p_).size();
    } else if (isWord(p_, "endfacet")) {
        endFacet();
        p_ += 8;
    } else if (isWord(p_, "solid") || isWord(p_, "endsolid")) {
        endFacet();
        solid();
    } else {
        data_.findings.add(unknownFinding, [&] { return here() + ": " + inQuotes(tokenAt(p_)); });
        p_ += tokenAt(p_).size();
    }
}

/// After "facet": the word "normal" and what it says, which follows from the vertices.
void Parser::skipNumbers()
{
    if (!skip() || !isWord(p_, "normal")) return;
    p_ += 6;
    for (int k = 0; k < 3 && skip(); ++k) {
        const char first = *p_;
        // A word of letters is the next keyword, unless it is "nan" or "inf".
        if (!isDigit(first) && !std::strchr("+-.nNiI", first)) return;
        p_ += tokenAt(p_).size();
    }
}

void Parser::vertex()
{
    p_ += 6;
    glm::vec3 v(std::numeric_limits<float>::quiet_NaN());
    bool complete = true;
    for (int k = 0; k < 3 && complete; ++k) {
        complete = skip();
        const char* start = p_;
        if (complete && (!parseNumber(p_, v[k]) || !endsToken(*p_))) {
            p_ = start;
            complete = false;
        }
    }
    // What the end of the file cuts off belongs to the facet that is cut.
    if (!complete && p_ >= bytes_.end()) return;
    if (!complete) data_.findings.add(numberFinding, [&] { return here(); });
    data_.corners.push(v);
}

void Parser::endFacet()
{
    const size_t n = data_.corners.size() - first_;
    if (n == 0) return;
    if (n < 3) {
        data_.findings.add(loopFinding, [&] { return here(); });
        data_.corners.cut(first_);
        return;
    }
    if (n > 3) data_.findings.add(polygonFinding, [&] { return here(); });
    first_ = data_.corners.size();
    data_.faceStart.push(uint32_t(first_));
    if (solid_ >= 0 || data_.solid.size()) {
        data_.solid.fill(data_.faceStart.size() - 2, -1);
        data_.solid.push(solid_);
    }
}

/// The name goes to the end of the line and may have blanks.
void Parser::solid()
{
    open_ = (*p_ | 0x20) == 's';
    p_ += open_ ? 5 : 8;
    const char* end = static_cast<const char*>(std::memchr(p_, '\n', size_t(bytes_.end() - p_ + 1)));
    const std::string name(trimmed({p_, size_t(end - p_)}));
    p_ = end;
    if (!open_) return;
    if (const auto known = numbers_.find(name); known != numbers_.end()) {
        solid_ = known->second;
    } else if (data_.solidNames.size() == 65536) {
        data_.findings.add(namesFinding, [&] { return here(); });
        solid_ = 65535;
    } else {
        solid_ = numbers_[name] = int32_t(data_.solidNames.size());
        data_.solidNames.push_back(name);
    }
}

}  // namespace

void parseStlText(const FileBytes& bytes, const std::string& file, StlData& data, Progress* progress)
{
    if (bytes.size() / 6 >= none - 2) throw Error(file, "more elements than 32-bit indices can number; split the file");
    Parser(bytes, data, progress).run();
}

}  // namespace mw
