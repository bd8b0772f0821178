// From the facets of an STL file to a scene: corners at the same place are made one vertex, facets are checked, solids become groups.
#include <bit>
#include <cmath>
#include <cstring>

#include "core/io/checked_faces.h"
#include "core/io/corner_values.h"
#include "core/io/stl.h"
#include "core/io/stl_data.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

constexpr Finding positionFinding{"nan-position", "corner has no finite position: its facet is left out",
                                  "corners have no finite position: their facets are left out"};
constexpr Finding brokenFaceFinding{"nan-face", "facet has a corner without a finite position: left out",
                                    "facets have corners without a finite position: left out"};

/// Numbers each corner's place: the first one at a place is the vertex. 0 and -0 are one place.
class Places {
public:
    explicit Places(size_t corners) : table_(std::bit_ceil(corners / 2 + 16), none) {}
    uint32_t number(const glm::vec3& p)
    {
        if (2 * positions_.size() > table_.size()) grow();
        uint32_t& entry = find(p);
        if (entry == none) {
            entry = uint32_t(positions_.size());
            positions_.push(p);
        }
        return entry;
    }
    Array<glm::vec3> take() { return positions_.take(); }

private:
    static uint64_t hash(const glm::vec3& p)
    {
        uint64_t h = 0x9e3779b97f4a7c15u;
        for (int k = 0; k < 3; ++k) {
            h = (h ^ std::bit_cast<uint32_t>(p[k] + 0.f)) * 0xff51afd7ed558ccdu;
            h ^= h >> 32;
        }
        return h;
    }
    /// What is not finite equals what has the same bits, so that a file full of it is no trap.
    static bool equal(const glm::vec3& a, const glm::vec3& b) { return a == b || std::memcmp(&a, &b, sizeof a) == 0; }
    uint32_t& find(const glm::vec3& p)
    {
        size_t i = size_t(hash(p)) & (table_.size() - 1);
        while (table_[i] != none && !equal(positions_[table_[i]], p)) i = (i + 1) & (table_.size() - 1);
        return table_[i];
    }
    void grow()
    {
        table_.assign(2 * table_.size(), none);
        for (uint32_t v = 0; v < positions_.size(); ++v) find(positions_[v]) = v;
    }

    std::vector<uint32_t> table_;
    Filling<glm::vec3> positions_;
};

class Builder {
public:
    Builder(StlData& data, const std::string& file, Progress* progress) : data_(data), file_(file), progress_(progress) {}
    Mesh mesh();

private:
    Mesh checked(Array<glm::vec3> positions, Array<uint32_t> corners);
    Array<uint32_t> starts();
    template <class T>
    Array<T> remaining(const T* values, size_t faces) const;

    StlData& data_;
    const std::string& file_;
    Progress* progress_;
    CheckedFaces kept_;
};

Array<uint32_t> Builder::starts()
{
    if (data_.faceStart.size()) return data_.faceStart.take();
    Array<uint32_t> start(data_.corners.size() / 3 + 1);
    for (size_t f = 0; f < start.size(); ++f) start[f] = uint32_t(3 * f);
    return start;
}

template <class T>
Array<T> Builder::remaining(const T* values, size_t faces) const
{
    Array<T> out(faces);
    for (size_t f = 0; f < faces; ++f) out[f] = values[kept_.all ? f : kept_.faces[f]];
    return out;
}

Mesh Builder::checked(Array<glm::vec3> positions, Array<uint32_t> corners)
{
    const std::vector<uint32_t> broken = mendPositions(positions);
    if (broken.size() == positions.size()) throw Error(file_, "none of its facets has a finite position; check the program that wrote it");
    for (uint32_t v : broken)
        data_.findings.add(
            positionFinding, [&] { return "vertex " + std::to_string(v) + " once they are merged"; }, v);
    kept_ = checkedFaces(starts(), std::move(corners), positions.size(), broken, [&](uint32_t f, uint32_t) {
        data_.findings.add(brokenFaceFinding, [&] { return "facet " + std::to_string(f) + ", counted from 0"; });
    });
    return Mesh(std::move(positions), std::move(kept_.faceStart), std::move(kept_.cornerVertex));
}

Mesh Builder::mesh()
{
    const size_t count = data_.corners.size();
    if (count == 0) throw Error(file_, "has no facets; there is nothing to show");
    Places places(count);
    Array<uint32_t> corners(count);
    for (size_t c = 0; c < count; ++c) {
        corners[c] = places.number(data_.corners[c]);
        if (progress_ && (c & 0xffff) == 0) progress_->at(0.5f + 0.5f * float(c) / float(count));
    }
    Mesh mesh = checked(places.take(), std::move(corners));
    const size_t faces = mesh.faceCount();
    if (!data_.colors.empty() && faces > 0) {
        const Array<glm::vec3> colors = remaining(data_.colors.data(), faces);
        Array<float> values(3 * faces);
        std::memcpy(values.data(), colors.data(), values.size() * sizeof(float));
        mesh = mesh.with(atCorners(floatAttribute(std::string(names::color), Domain::Face, 3, std::move(values)), mesh));
    }
    const bool named = data_.solidNames.size() > 1 || (data_.solidNames.size() == 1 && !data_.solidNames[0].empty());
    if (named && data_.solid.size()) {
        Array<int32_t> groups = remaining(&data_.solid[0], faces);
        bool outside = false;
        for (int32_t& g : groups) {
            outside = outside || g < 0;
            if (g < 0) g = int32_t(data_.solidNames.size());
        }
        if (outside) data_.solidNames.push_back("default");
        mesh = mesh.with(integerAttribute(std::string(names::group), Domain::Face, 1, std::move(groups))).withGroupNames(data_.solidNames);
    }
    return mesh;
}

bool startsLikeText(std::string_view start)
{
    const size_t first = start.find_first_not_of(" \t\r\n");
    if (first == start.npos || start.size() < first + 5) return false;
    for (size_t i = 0; i < 5; ++i)
        if ((start[first + i] | 0x20) != "solid"[i]) return false;
    return true;
}

uint64_t binarySize(std::string_view start)
{
    uint32_t n = 0;
    for (int i = 3; i >= 0; --i) n = n << 8 | uint8_t(start[80 + size_t(i)]);
    return stlHeader + stlFacet * uint64_t(n);
}

/// Binary files may begin with "solid", too: their size gives them away, or zeros, which no text has.
bool isText(std::string_view start, uint64_t size)
{
    if (start.size() >= stlHeader && binarySize(start) == size) return false;
    return startsLikeText(start) && start.substr(0, 1024).find('\0') == start.npos;
}

}  // namespace

bool isStl(std::string_view start, uint64_t size)
{
    if (start.size() >= stlHeader && size > stlHeader && binarySize(start) == size) return true;
    return startsLikeText(start) && (start.find("facet") != start.npos || start.find("FACET") != start.npos);
}

Imported readStl(const fs::path& file, Progress* progress)
{
    FileBytes bytes = readBytes(file);
    const std::string name = file.string();
    if (bytes.size() == 0) throw Error(name, "is empty; export it again");
    const bool wide = bytes.text().starts_with("\xff\xfe") || bytes.text().starts_with("\xfe\xff") || bytes.text().starts_with("\xef\xbb\xbf");
    if (wide && !isStl(bytes.text().substr(0, 1024), bytes.size())) bytes = plainText(std::move(bytes), name);
    StlData data;
    const bool text = isText(bytes.text(), bytes.size());
    if (text)
        parseStlText(bytes = plainText(std::move(bytes), name), name, data, progress);
    else
        parseStlBinary(bytes, name, data, progress);
    bytes = {};
    Imported out;
    out.scene = sceneOf(Builder(data, name, progress).mesh(), file.stem().string());
    out.warnings = data.findings.warnings();
    out.format = text ? "STL (text)" : "STL (binary)";
    out.units = "unknown";
    data.stated.tell(out);
    return out;
}

}  // namespace mw
