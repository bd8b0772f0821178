// STL out: triangles with their normals; in binary with one colour a facet, in text one solid for each run of faces of a group.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/io/placement.h"
#include "core/io/stl.h"
#include "core/io/stl_data.h"
#include "core/io/text_out.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

class Writer {
public:
    Writer(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
        : file_(file),
          options_(options),
          progress_(progress),
          flat_(flattened(scene, progress, options.placement, options.evaluator)),
          mesh_(flat_.mesh),
          triangles_(mesh_.triangulation()),
          out_(file),
          text_(out_)
    {}
    std::vector<Warning> run();

private:
    void chooseColor();
    void lost();
    void lost(const char* code, const std::string& text) { warnings_.push_back({code, text, {}}); }
    void writeText();
    void textTriangle(size_t t);
    void writeBinary();
    uint16_t colorBits(size_t t) const;
    glm::vec3 corner(size_t t, size_t k) const { return mesh_.positions()[triangles_.vertices[3 * t + k]]; }
    glm::vec3 normal(size_t t) const;
    size_t count() const { return triangles_.faces.size(); }
    std::string solidName(int32_t group) const;
    void report(size_t t) const
    {
        if (progress_ && (t & 0xffff) == 0) progress_->at(float(t) / float(count()));
    }

    const fs::path& file_;
    const WriteOptions& options_;
    Progress* progress_;
    Flattened flat_;
    const Mesh& mesh_;
    const Mesh::Triangulation& triangles_;
    OutputFile out_;
    TextOut text_;
    const Attribute* color_ = nullptr;
    std::vector<Warning> warnings_;
};

glm::vec3 Writer::normal(size_t t) const
{
    const glm::dvec3 a(corner(t, 0)), n = glm::cross(glm::dvec3(corner(t, 1)) - a, glm::dvec3(corner(t, 2)) - a);
    const double length = std::sqrt(glm::dot(n, n));
    return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0);
}

void Writer::chooseColor()
{
    for (const Domain d : {Domain::Corner, Domain::Vertex})
        if (const Attribute* a = mesh_.find(names::color, d); a && !a->floats().empty() && a->components >= 3 && !color_) color_ = a;
}

/// Five bits a channel, as VisCAM and SolidView have them; the mean of the corners.
uint16_t Writer::colorBits(size_t t) const
{
    if (!color_) return 0;
    uint32_t bits = 0x8000;
    for (int k = 0; k < 3; ++k) {
        double sum = 0;
        for (size_t c = 0; c < 3; ++c)
            sum += color_->at(color_->domain == Domain::Corner ? triangles_.corners[3 * t + c] : triangles_.vertices[3 * t + c], k);
        bits |= uint32_t(std::lround(std::clamp(sum / 3, 0.0, 1.0) * 31)) << (10 - 5 * k);
    }
    return uint16_t(bits);
}

void Writer::lost()
{
    std::string list;
    for (const Attribute& a : mesh_.attributes()) {
        const bool kept = (a.name == names::color && options_.binary) || (a.name == names::group && !options_.binary) || a.name == names::material ||
                          a.name == names::normal;
        if (!kept) list += (list.empty() ? "" : ", ") + a.name;
    }
    if (!list.empty())
        lost("attribute-lost",
             std::string("STL ") + (options_.binary ? "in binary" : "as text") + " has no place for the attributes " + list + "; PLY and glTF have");
    if (color_ && options_.binary)
        lost("color-coarse",
             "STL keeps one colour a triangle in five bits a channel, a way not all programs read; PLY and glTF keep colours as they are");
    if (!mesh_.isTriangles()) lost("triangulated", "STL has triangles only: polygons are cut into them");
    if (!mesh_.lines().empty())
        lost("line-lost", "STL has no loose lines: " + std::to_string(mesh_.lines().size() / 2) + " are not written; OBJ, PLY and glTF have them");
    std::vector<bool> used(mesh_.vertexCount());
    for (uint32_t v : triangles_.vertices) used[v] = true;
    if (const auto loose = std::count(used.begin(), used.end(), false))
        lost("point-lost",
             "STL has no loose points: " + std::to_string(loose) + " vertices without a triangle are not written; OBJ, PLY and OFF have them");
    if (std::any_of(flat_.materials.begin(), flat_.materials.end(), [](MaterialId m) { return bool(m); }))
        lost("material-lost", "STL has no materials: their colours and pictures are not written; OBJ and glTF have them");
}

/// A name that survives: no line ends, no blanks at its ends.
std::string Writer::solidName(int32_t group) const
{
    const bool named = group >= 0 && size_t(group) < mesh_.groupNames().size();
    std::string name(trimmed(named ? mesh_.groupNames()[size_t(group)] : std::string()));
    std::replace_if(
        name.begin(), name.end(), [](char c) { return uint8_t(c) < ' '; }, ' ');
    return name;
}

void Writer::textTriangle(size_t t)
{
    text_.begin(3);
    text_.word("facet normal");
    const glm::vec3 n = normal(t);
    for (int k = 0; k < 3; ++k) {
        text_.put(' ');
        text_.number(n[k] + 0.f);
    }
    text_.word("\n outer loop");
    text_.end();
    for (size_t c = 0; c < 3; ++c) {
        text_.begin(3);
        text_.word("  vertex");
        for (int k = 0; k < 3; ++k) {
            text_.put(' ');
            text_.number(corner(t, c)[k]);
        }
        text_.end();
    }
    text_.begin(0);
    text_.word(" endloop\nendfacet");
    text_.end();
}

void Writer::writeText()
{
    const Attribute* group = mesh_.find(names::group, Domain::Face);
    const std::span<const int32_t> groups = group ? group->integers() : std::span<const int32_t>();
    int32_t last = -1;
    std::string name = groups.empty() ? "" : solidName(groups[triangles_.faces[0]]);
    for (size_t t = 0; t < count(); ++t) {
        const int32_t g = groups.empty() ? -1 : groups[triangles_.faces[t]];
        if (t == 0 || g != last) {
            if (t > 0) out_.write("endsolid " + name + "\n");
            name = solidName(g);
            out_.write("solid " + name + "\n");
            last = g;
        }
        textTriangle(t);
        report(t);
    }
    out_.write("endsolid " + name + "\n");
}

void Writer::writeBinary()
{
    // Not "solid": that is how text begins.
    std::string header = "Meshwright; " + statement(options_.placement);
    header.resize(80, '\0');
    out_.write(header);
    const auto put = [](char* to, uint32_t v, int bytes) {
        for (int i = 0; i < bytes; ++i) *to++ = char(v >> 8 * i);
        return to;
    };
    out_.advance(put(out_.room(4), uint32_t(count()), 4));
    for (size_t t = 0; t < count(); ++t) {
        char* to = out_.room(stlFacet);
        for (const glm::vec3& v : {normal(t), corner(t, 0), corner(t, 1), corner(t, 2)})
            for (int k = 0; k < 3; ++k) to = put(to, std::bit_cast<uint32_t>(v[k]), 4);
        out_.advance(put(to, colorBits(t), 2));
        report(t);
    }
}

std::vector<Warning> Writer::run()
{
    if (mesh_.vertexCount() == 0) throw Error(file_.string(), "there is no visible mesh to write");
    if (count() == 0) throw Error(file_.string(), "there is no triangle to write, and STL holds nothing else; write it as OBJ, PLY or glTF");
    chooseColor();
    lost();
    if (options_.binary)
        writeBinary();
    else
        writeText();
    out_.commit();
    return std::move(warnings_);
}

}  // namespace

std::vector<Warning> writeStl(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
{
    return Writer(scene, file, options, progress).run();
}

}  // namespace mw
