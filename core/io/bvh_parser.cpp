// The text of a BVH file to joints and rows of numbers. Braces are counted, not recursed into; the header's number of frames is only compared
// with the rows there are, never believed.
#include <algorithm>
#include <cmath>

#include "core/io/bvh_data.h"
#include "core/io/findings.h"
#include "core/io/text.h"

namespace mw {

namespace {

constexpr size_t mostJoints = size_t(1) << 18;  ///< a joint takes much more memory than its few characters
constexpr double largest = 1e30;                ///< what is larger leaves the range of floats when joints add up

constexpr Finding rowFinding{"broken-row", "row of motion does not have one number a channel: left out",
                             "rows of motion do not have one number a channel: left out"};
constexpr Finding valueFinding{"nan-value", "number of the motion is not finite: the frame before counts",
                               "numbers of the motion are not finite: the frame before counts"};
constexpr Finding countFinding{"channel-count", "joint has not as many channels as it says: those listed are taken",
                               "joints have not as many channels as they say: those listed are taken"};
constexpr Finding offsetFinding{"no-offset", "joint has no offset: 0 0 0 is taken", "joints have no offset: 0 0 0 is taken"};
constexpr Finding rootFinding{"several-roots", "further root: read as a skeleton of its own; many programs refuse such files",
                              "further roots: read as skeletons of their own; many programs refuse such files"};

bool same(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

bool usable(double v)
{
    return std::abs(v) <= largest;
}

class Parser {
public:
    Parser(const FileBytes& bytes, const std::string& file, Progress* progress)
        : p_(bytes.begin()), begin_(bytes.begin()), end_(bytes.end()), file_(file), progress_(progress)
    {}
    BvhData run();

private:
    // Reading
    [[noreturn]] void fail(const std::string& reason) const { throw Error(file_, "line " + std::to_string(line_) + ": " + reason); }
    std::string place() const { return "line " + std::to_string(line_); }
    void skip();              ///< blanks and line ends
    void skipInLine();        ///< blanks
    std::string_view peek();  ///< the next word; a brace or a colon is one, too. Empty at the end
    std::string_view word();
    void expect(std::string_view what);
    std::string restOfLine();
    double number(const char* what);

    // Hierarchy
    void hierarchy();
    void open(bool end);
    void offset();
    void channels();

    // Motion
    void motion();
    double header(std::string_view first, std::string_view second);
    void rows();
    void row();
    void useLines(double said);
    void setFrameTime(double seconds);
    void mendValues();

    const char *p_, *begin_, *end_;
    const std::string& file_;
    Progress* progress_;
    uint64_t line_ = 1;
    BvhData data_;
    Findings findings_;
    std::vector<uint32_t> open_;  ///< joints whose brace is not closed yet
    std::vector<bool> hasOffset_;
    Filling<double> values_;
    struct OddLine {
        uint64_t line;
        size_t first, count;  ///< of its values
    };
    std::vector<OddLine> oddLines_;
    size_t lines_ = 0;
};

void Parser::skip()
{
    for (; p_ < end_ && endsToken(*p_); ++p_) line_ += *p_ == '\n';
}

void Parser::skipInLine()
{
    while (p_ < end_ && *p_ != '\n' && endsToken(*p_)) ++p_;
}

std::string_view Parser::peek()
{
    skip();
    if (p_ >= end_) return {};
    const auto single = [](char c) { return c == '{' || c == '}' || c == ':'; };
    if (single(*p_)) return {p_, 1};
    const char* q = p_;
    while (!endsToken(*q) && !single(*q)) ++q;
    return {p_, size_t(q - p_)};
}

std::string_view Parser::word()
{
    const std::string_view w = peek();
    p_ += w.size();
    return w;
}

void Parser::expect(std::string_view what)
{
    const std::string_view w = word();
    if (!same(w, what))
        fail((w.empty() ? "the file ends" : inQuotes(w) + " stands") + std::string(" where ") + inQuotes(what) +
             " is wanted; check that it is a whole BVH file");
}

/// Names may hold blanks.
std::string Parser::restOfLine()
{
    const char* q = p_;
    while (q < end_ && *q != '\n' && *q != '{') ++q;
    std::string name(trimmed({p_, size_t(q - p_)}));
    p_ = q;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return uint8_t(c) < ' '; }, ' ');
    return name;
}

double Parser::number(const char* what)
{
    const std::string_view w = peek();
    double v = 0;
    const char* q = p_;
    if (w.empty()) fail(std::string("the file ends where ") + what + " is wanted; it was cut off");
    if (!parseNumber(q, v) || q != w.data() + w.size())
        fail(inQuotes(w) + " stands where " + what + " is wanted; numbers are written with a point, like 0.5");
    p_ = q;
    return v;
}

void Parser::open(bool end)
{
    const std::string_view keyword = word();  // ROOT, JOINT, End
    if (data_.joints.size() == mostJoints) fail("more than " + std::to_string(mostJoints) + " joints; split the file");
    BvhData::Joint j;
    j.end = end;
    j.name = restOfLine();
    if (end) j.name = j.name.empty() ? "End Site" : "End " + j.name;
    if (!open_.empty()) j.parent = open_.back();
    if (open_.empty() && !data_.joints.empty())
        findings_.add(
            rootFinding, [&] { return place(); }, uint32_t(data_.joints.size()));
    if (open_.empty() && !same(keyword, "ROOT")) fail(inQuotes(keyword) + " stands outside of any ROOT");
    expect("{");
    open_.push_back(uint32_t(data_.joints.size()));
    data_.joints.push_back(std::move(j));
    hasOffset_.push_back(false);
}

void Parser::offset()
{
    word();
    BvhData::Joint& j = data_.joints[open_.back()];
    for (int i = 0; i < 3; ++i) {
        j.offset[i] = number("a number of an offset");
        if (!usable(j.offset[i])) fail("an offset is not finite; check the program that wrote the file");
    }
    hasOffset_[open_.back()] = true;
}

void Parser::channels()
{
    word();
    BvhData::Joint& j = data_.joints[open_.back()];
    const double said = number("a number of channels");
    const size_t before = j.channels.size();
    while (true) {
        const std::string_view w = peek();
        const auto* known =
            std::find_if(std::begin(bvhChannelNames), std::end(bvhChannelNames), [&](std::string_view name) { return same(w, name); });
        if (known == std::end(bvhChannelNames)) {
            const bool fewer = double(j.channels.size() - before) < said, keyword = w == "{" || w == "}" || same(w, "JOINT") || same(w, "End");
            if (fewer && !keyword && !w.empty())
                fail(inQuotes(w) + " is no channel; known are Xposition, Yposition, Zposition, Xrotation, Yrotation, Zrotation");
            break;
        }
        word();
        j.channels.push_back(Channel::Path(int(Channel::Path::PositionX) + int(known - std::begin(bvhChannelNames))));
    }
    const size_t listed = j.channels.size() - before;
    data_.channels += listed;
    if (double(listed) != said)
        findings_.add(
            countFinding, [&] { return place() + ": " + std::to_string(listed) + " listed"; }, open_.back());
}

void Parser::hierarchy()
{
    expect("HIERARCHY");
    while (true) {
        const std::string_view w = peek();
        if (w.empty() && open_.empty()) return;
        if (w.empty()) fail("the file ends inside of \"" + data_.joints[open_.back()].name + "\"; it was cut off");
        const bool within = !open_.empty(), inEnd = within && data_.joints[open_.back()].end;
        if (same(w, "ROOT") && !within) {
            open(false);
        } else if (same(w, "JOINT") && !inEnd) {
            open(false);
        } else if (same(w, "End") && within && !inEnd) {
            open(true);
        } else if (same(w, "OFFSET") && within) {
            offset();
        } else if (same(w, "CHANNELS") && within) {
            channels();
        } else if (w == "}" && within) {
            word();
            if (!hasOffset_[open_.back()])
                findings_.add(
                    offsetFinding, [&] { return place(); }, open_.back());
            open_.pop_back();
        } else if (same(w, "MOTION") && !within) {
            return;
        } else {
            fail(inQuotes(w) + (within ? " stands inside of \"" + data_.joints[open_.back()].name + "\"; a brace may be missing"
                                       : std::string(" stands where ROOT or MOTION is wanted")));
        }
    }
}

/// "Frames: 10", "Frame Time: .1"; the number is NaN when there is none.
double Parser::header(std::string_view first, std::string_view second)
{
    expect(first);
    if (!second.empty()) expect(second);
    expect(":");
    skipInLine();
    double v = 0;
    if (parseNumber(p_, v)) return v;
    while (p_ < end_ && *p_ != '\n') ++p_;
    return NAN;
}

/// One line, if there is anything in it.
void Parser::row()
{
    const size_t first = values_.size();
    for (skipInLine(); p_ < end_ && *p_ != '\n'; skipInLine()) {
        double v = 0;
        const char* q = p_;
        if (!parseNumber(q, v) || !endsToken(*q)) {
            const std::string_view w = tokenAt(p_);
            fail(inQuotes(w) + " is no number; numbers are written with a point, like 0.5, and blanks between them");
        }
        p_ = q;
        values_.push(v);
    }
    const size_t count = values_.size() - first;
    if (count == 0) return;
    ++lines_;
    if (count != data_.channels) oddLines_.push_back({line_, first, count});
}

void Parser::rows()
{
    values_.expect(size_t(end_ - p_) / 8);
    while (p_ < end_) {
        row();
        if (p_ < end_) ++p_, ++line_;
        if (progress_ && (line_ & 0xff) == 0) progress_->at(float(p_ - begin_) / float(end_ - begin_));
    }
}

/// Lines and rows are the same, but for odd lines, which are left out.
void Parser::useLines(double said)
{
    Array<double> all = values_.take();
    data_.rows = lines_ - oddLines_.size();
    if (data_.rows == 0)
        throw Error(file_, "line " + std::to_string(oddLines_[0].line) + ": a row of " + std::to_string(oddLines_[0].count) +
                               " numbers, but the hierarchy has " + std::to_string(data_.channels) + " channels; check the program that wrote it");
    if (said != double(data_.rows)) {
        const std::string text = std::isfinite(said) && said >= 0 && said < 1e15 ? std::to_string(uint64_t(said)) : "something else";
        data_.warnings.push_back(
            {"frame-count", "the header says " + text + " frames; the " + std::to_string(data_.rows) + " rows there are are read", {}});
    }
    size_t to = 0, from = 0;
    for (const OddLine& odd : oddLines_) {
        findings_.add(rowFinding, [&] {
            return "line " + std::to_string(odd.line) + ": " + std::to_string(odd.count) + " of " + std::to_string(data_.channels);
        });
        std::copy(all.begin() + std::ptrdiff_t(from), all.begin() + std::ptrdiff_t(odd.first), all.begin() + std::ptrdiff_t(to));
        to += odd.first - from;
        from = odd.first + odd.count;
    }
    std::copy(all.begin() + std::ptrdiff_t(from), all.end(), all.begin() + std::ptrdiff_t(to));
    all.resize(data_.rows * data_.channels);
    data_.values = std::move(all);
}

void Parser::setFrameTime(double seconds)
{
    data_.frameTime = seconds;
    if (seconds > 0 && seconds * double(data_.rows) <= largest) return;
    data_.frameTime = defaultFrameTime;
    data_.warnings.push_back({"frame-time", "the time of a frame is no positive number: 1/30 s is taken", {}});
}

/// What is not finite holds the value of the frame before; in the first frame it is 0.
void Parser::mendValues()
{
    for (size_t i = 0; i < data_.values.size(); ++i) {
        if (usable(data_.values[i])) continue;
        findings_.add(valueFinding,
                      [&] { return "frame " + std::to_string(i / data_.channels + 1) + ", channel " + std::to_string(i % data_.channels + 1); });
        data_.values[i] = i < data_.channels ? 0 : data_.values[i - data_.channels];
    }
}

void Parser::motion()
{
    if (peek().empty()) {
        data_.warnings.push_back({"no-motion", "there is no MOTION: the skeleton alone is read", {}});
        return;
    }
    expect("MOTION");
    const double said = header("Frames", {}), seconds = header("Frame", "Time");
    rows();
    if (data_.channels == 0 || values_.size() == 0) {
        data_.warnings.push_back(
            {"no-motion",
             values_.size() ? "no joint has a channel: the skeleton alone is read" : "there are no frames: the skeleton alone is read",
             {}});
        return;
    }
    if (!oddLines_.empty() && said == double(values_.size()) / double(data_.channels)) {
        data_.rows = size_t(said);  // rows that are spread over several lines
        data_.values = values_.take();
    } else {
        useLines(said);
    }
    setFrameTime(seconds);
    mendValues();
}

BvhData Parser::run()
{
    hierarchy();
    if (data_.joints.empty()) fail("there is no ROOT; check that it is a whole BVH file");
    motion();
    for (Warning& w : findings_.warnings()) data_.warnings.push_back(std::move(w));
    return std::move(data_);
}

}  // namespace

BvhData parseBvh(const FileBytes& bytes, const std::string& file, Progress* progress)
{
    return Parser(bytes, file, progress).run();
}

}  // namespace mw
