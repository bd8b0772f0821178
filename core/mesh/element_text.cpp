// Sets of elements as text: how an edit of a selection is kept in the history and given on a command line.
#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "core/mesh/select.h"

namespace mw {

namespace {

struct Range {
    uint32_t first, last;  // both belong to it
    bool operator<(const Range& r) const { return first < r.first; }
};

[[noreturn]] void refuse(std::string_view part, const std::string& why)
{
    throw Error("elements: \"" + std::string(part.substr(0, 40)) + "\" " + why);
}

uint32_t numberOf(std::string_view digits, std::string_view part, size_t below)
{
    uint32_t n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    if (error == std::errc::result_out_of_range || (error == std::errc{} && n >= below))
        refuse(part, "is beyond the last element: indices are below " + std::to_string(below));
    if (error != std::errc{} || end != digits.data() + digits.size()) refuse(part, "is no index; write them like 0-99;105, edges like 3~7");
    return n;
}

/// body(part) for every part between semicolons that is not empty.
template <class Body>
void forParts(std::string_view text, const Body& body)
{
    while (!text.empty()) {
        const size_t end = std::min(text.find(';'), text.size());
        if (end > 0) body(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::vector<uint32_t> parsedEdges(std::string_view text, size_t below)
{
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    forParts(text, [&](std::string_view part) {
        const size_t mark = part.find('~');
        if (mark == part.npos) refuse(part, "is no edge; write its two vertices like 3~7");
        const uint32_t a = numberOf(part.substr(0, mark), part, below), b = numberOf(part.substr(mark + 1), part, below);
        if (a == b) refuse(part, "is no edge: its two vertices are the same");
        edges.push_back(std::minmax(a, b));
    });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<uint32_t> flat;
    flat.reserve(2 * edges.size());
    for (const auto& [a, b] : edges) flat.push_back(a), flat.push_back(b);
    return flat;
}

// Ranges are joined before they are written out: overlapping ones cost nothing.
std::vector<uint32_t> parsedIndices(std::string_view text, size_t below)
{
    std::vector<Range> ranges;
    forParts(text, [&](std::string_view part) {
        const size_t mark = part.find('-');
        const uint32_t first = numberOf(part.substr(0, mark), part, below);
        const uint32_t last = mark == part.npos ? first : numberOf(part.substr(mark + 1), part, below);
        if (last < first) refuse(part, "runs backwards");
        ranges.push_back({first, last});
    });
    std::sort(ranges.begin(), ranges.end());
    std::vector<uint32_t> indices;
    for (const Range& r : ranges)
        for (uint64_t i = indices.empty() ? r.first : std::max<uint64_t>(r.first, uint64_t(indices.back()) + 1); i <= r.last; ++i)
            indices.push_back(uint32_t(i));
    return indices;
}

}  // namespace

std::string elementText(const ElementSet& set)
{
    std::string text;
    const auto& i = set.indices;
    const auto separate = [&] {
        if (!text.empty()) text += ';';
    };
    if (set.kind == ElementKind::Edge) {
        for (size_t k = 0; k + 1 < i.size(); k += 2) {
            separate();
            text += std::to_string(i[k]) + '~' + std::to_string(i[k + 1]);
        }
        return text;
    }
    for (size_t k = 0; k < i.size();) {
        size_t last = k;
        while (last + 1 < i.size() && i[last + 1] == i[last] + 1) ++last;
        separate();
        text += std::to_string(i[k]);
        if (last > k) text += '-' + std::to_string(i[last]);
        k = last + 1;
    }
    return text;
}

ElementSet parsedElements(ElementKind kind, std::string_view text, size_t below)
{
    if (kind != ElementKind::Vertex && kind != ElementKind::Edge && kind != ElementKind::Face)
        throw Error("elements: only vertices, edges and faces can be given as text");
    return {kind, kind == ElementKind::Edge ? parsedEdges(text, below) : parsedIndices(text, below)};
}

}  // namespace mw
