#include <algorithm>
#include <array>

#include "core/io/ply_rows.h"

namespace mw {

namespace {

struct TypeName {
    const char *name, *other;
    size_t bytes;
};
/// In the order of Scalar.
constexpr std::array<TypeName, 8> types{{{"float", "float32", 4},
                                         {"double", "float64", 8},
                                         {"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4}}};

class HeaderReader {
public:
    HeaderReader(const FileBytes& bytes, const std::string& file) : bytes_(bytes), file_(file) {}
    PlyHeader run();

private:
    bool nextLine();
    void keyword();
    void format();
    void element();
    void property();
    Scalar type(std::string_view word, bool count);
    [[noreturn]] void fail(const std::string& what) const { throw Error(file_, "line " + std::to_string(line_) + ": " + what); }

    const FileBytes& bytes_;
    const std::string& file_;
    PlyHeader header_;
    size_t at_ = 0;
    uint64_t line_ = 0;
    bool carriageReturns_ = false;  // lines end in '\r' alone
    bool hasFormat_ = false;
    std::string_view text_;
    std::vector<std::string_view> words_;
};

/// The next line and its words; false at the end of the file.
bool HeaderReader::nextLine()
{
    if (at_ >= bytes_.size()) return false;
    const std::string_view rest = bytes_.text().substr(at_);
    if (line_ == 0) {
        const size_t end = rest.find_first_of("\r\n");
        carriageReturns_ = end != rest.npos && rest[end] == '\r' && rest.substr(end + 1, 1) != "\n";
    }
    const size_t end = std::min(rest.size(), rest.find(carriageReturns_ ? '\r' : '\n'));
    text_ = trimmed(rest.substr(0, end));
    at_ += std::min(end + 1, rest.size());
    ++line_;
    words_.clear();
    for (std::string_view t = text_; !t.empty() && words_.size() < 16;) {
        const size_t n = size_t(std::find_if(t.begin(), t.end(), endsToken) - t.begin());
        words_.push_back(t.substr(0, n));
        t = trimmed(t.substr(n));
    }
    return true;
}

PlyHeader HeaderReader::run()
{
    if (bytes_.size() == 0) throw Error(file_, "is empty; export it again");
    if (!nextLine() || text_ != "ply") fail("a PLY file begins with \"ply\", this one with " + inQuotes(text_) + "; check that it is a PLY file");
    while (true) {
        if (!nextLine()) fail("the file ends within its header, before \"end_header\"; copy or export it again");
        if (text_ == "end_header") break;
        keyword();
    }
    if (!hasFormat_) fail("the header has no \"format\" line; export the file again");
    header_.bodyStart = at_;
    header_.bodyLine = line_ + 1;
    return std::move(header_);
}

void HeaderReader::keyword()
{
    if (words_.empty()) return;
    if (words_[0] == "comment" || words_[0] == "obj_info") {
        header_.stated.listen(text_.substr(words_[0].size()));
        if (words_.size() > 1 && words_[1] == "group" && words_[0] == "comment")
            header_.groupNames.emplace_back(trimmed(text_.substr(text_.find("group") + 5)));
    } else if (words_[0] == "format") {
        format();
    } else if (words_[0] == "element") {
        element();
    } else if (words_[0] == "property") {
        property();
    } else {
        fail(inQuotes(words_[0]) + " is no keyword of a PLY header (format, element, property, comment, obj_info, end_header)");
    }
}

void HeaderReader::format()
{
    const std::string_view word = words_.size() > 1 ? words_[1] : "";
    if (word == "ascii")
        header_.encoding = PlyHeader::Encoding::Text;
    else if (word == "binary_little_endian")
        header_.encoding = PlyHeader::Encoding::Little;
    else if (word == "binary_big_endian")
        header_.encoding = PlyHeader::Encoding::Big;
    else
        fail("format " + inQuotes(word) + " is not known (ascii, binary_little_endian, binary_big_endian)");
    hasFormat_ = true;
}

void HeaderReader::element()
{
    uint64_t count = 0;
    const char* p = words_.size() == 3 ? words_[2].data() : nullptr;
    if (!p || !parseDigits(p, count) || p != words_[2].data() + words_[2].size()) fail("expected \"element NAME COUNT\", found " + inQuotes(text_));
    for (const PlyElement& e : header_.elements)
        if (e.name == words_[1]) fail("element " + inQuotes(words_[1]) + " is declared twice");
    if (header_.elements.size() == 256) fail("more than 256 kinds of elements; this is no mesh");
    header_.elements.push_back({std::string(words_[1]), count, {}});
}

void HeaderReader::property()
{
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty p;
    p.list = words_.size() > 1 && words_[1] == "list";
    if (words_.size() != (p.list ? 5u : 3u)) fail("expected \"property TYPE NAME\" or \"property list TYPE TYPE NAME\", found " + inQuotes(text_));
    if (p.list) p.countType = type(words_[2], true);
    p.type = type(words_[p.list ? 3 : 1], false);
    p.name = words_.back();
    std::vector<PlyProperty>& all = header_.elements.back().properties;
    if (std::any_of(all.begin(), all.end(), [&](const PlyProperty& o) { return o.name == p.name; }))
        fail("property " + inQuotes(p.name) + " is declared twice");
    if (all.size() == 1024) fail("more than 1024 properties of one element");
    all.push_back(std::move(p));
}

Scalar HeaderReader::type(std::string_view word, bool count)
{
    for (size_t i = 0; i < types.size(); ++i)
        if (word == types[i].name || word == types[i].other) {
            if (count && !isInteger(Scalar(i))) fail("the length of a list must be a whole number, not " + inQuotes(word));
            return Scalar(i);
        }
    fail("type " + inQuotes(word) + " is not known (char, uchar, short, ushort, int, uint, float, double)");
}

}  // namespace

size_t byteSize(Scalar type)
{
    return types[size_t(type)].bytes;
}
const char* plyName(Scalar type)
{
    return types[size_t(type)].name;
}
bool isInteger(Scalar type)
{
    return type != Scalar::Float32 && type != Scalar::Float64;
}

PlyHeader readPlyHeader(const FileBytes& bytes, const std::string& file)
{
    return HeaderReader(bytes, file).run();
}

}  // namespace mw
