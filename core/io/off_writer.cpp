// OFF out, as Geomview has it: COFF, NOFF, STOFF as there are colours, normals and texture coordinates with one value a vertex.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/io/corner_values.h"
#include "core/io/off.h"
#include "core/io/placement.h"
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
          out_(file),
          text_(out_)
    {}
    std::vector<Warning> run();

private:
    void chooseValues();
    void choose(std::optional<Attribute>& to, std::string_view name, std::initializer_list<int> components, const char* what);
    void chooseColors();
    void lost();
    void header();
    void vertices();
    void textVertex(size_t v);
    void binaryVertex(size_t v);
    void faces();
    void textFace(size_t f);
    void binaryFace(size_t f);
    void numbers(const Attribute& a, size_t element, bool fractions);
    void word(uint32_t v);
    void word(float v) { word(std::bit_cast<uint32_t>(v)); }

    const fs::path& file_;
    const WriteOptions& options_;
    Progress* progress_;
    Flattened flat_;
    const Mesh& mesh_;
    OutputFile out_;
    TextOut text_;
    std::optional<Attribute> normal_, texcoord_, color_, faceColor_;  // of vertices, of faces
    const Attribute* colorIndex_ = nullptr;
    std::vector<Warning> warnings_;
};

bool fits(const Attribute& a, std::initializer_list<int> components)
{
    return !a.floats().empty() && std::find(components.begin(), components.end(), a.components) != components.end();
}

/// Values of vertices, or of corners when they agree round each vertex.
void Writer::choose(std::optional<Attribute>& to, std::string_view name, std::initializer_list<int> components, const char* what)
{
    if (const Attribute* a = mesh_.find(name, Domain::Vertex); a && fits(*a, components)) to = *a;
    const Attribute* a = mesh_.find(name, Domain::Corner);
    if (to || !a || !fits(*a, components)) return;
    to = gatheredIfEqual(*a, mesh_, Domain::Vertex);
    if (!to)
        warnings_.push_back({"seam-lost",
                             std::string("OFF has one value a vertex: the ") + what +
                                 " differ at corners of one vertex and are not written; OBJ, PLY and glTF keep them",
                             {}});
}

void Writer::chooseColors()
{
    if (const Attribute* a = mesh_.find(names::color, Domain::Vertex); a && fits(*a, {3, 4})) color_ = *a;
    const Attribute* a = mesh_.find(names::color, Domain::Corner);
    if (!a || !fits(*a, {3, 4})) return;
    faceColor_ = gatheredIfEqual(*a, mesh_, Domain::Face);
    if (!faceColor_ && !color_) choose(color_, names::color, {3, 4}, "colours");
}

void Writer::chooseValues()
{
    choose(normal_, names::normal, {3}, "normals");
    choose(texcoord_, names::texcoord, {2}, "texture coordinates");
    chooseColors();
    const Attribute* index = mesh_.find("color_index", Domain::Face);
    if (index && index->components == 1 && index->integral() && !faceColor_) colorIndex_ = index;
}

void Writer::lost()
{
    std::string list;
    for (const Attribute& a : mesh_.attributes()) {
        const bool known = (a.name == names::normal || a.name == names::texcoord || a.name == names::color) && a.domain != Domain::Face;
        if (!known && &a != colorIndex_ && a.name != names::material) list += (list.empty() ? "" : ", ") + a.name;
    }
    if (!list.empty()) warnings_.push_back({"attribute-lost", "OFF has no place for the attributes " + list + "; PLY and glTF have", {}});
    if (!mesh_.lines().empty())
        warnings_.push_back({"line-lost",
                             "OFF has no loose lines: " + std::to_string(mesh_.lines().size() / 2) + " are not written; OBJ, PLY and glTF have them",
                             {}});
    if (std::any_of(flat_.materials.begin(), flat_.materials.end(), [](MaterialId m) { return bool(m); }))
        warnings_.push_back({"material-lost", "OFF has no materials: their colours and pictures are not written; OBJ and glTF have them", {}});
}

void Writer::header()
{
    std::string h = std::string(texcoord_ ? "ST" : "") + (color_ ? "C" : "") + (normal_ ? "N" : "") + "OFF";
    if (options_.binary) {
        out_.write(h + " BINARY\n");
        word(uint32_t(mesh_.vertexCount()));
        word(uint32_t(mesh_.faceCount()));
        return word(uint32_t(0));
    }
    h += "\n# Meshwright\n# " + statement(options_.placement) + "\n";
    out_.write(h + std::to_string(mesh_.vertexCount()) + " " + std::to_string(mesh_.faceCount()) + " 0\n");
}

/// Geomview's binary numbers are big-endian.
void Writer::word(uint32_t v)
{
    char* to = out_.room(4);
    for (int i = 0; i < 4; ++i) to[i] = char(v >> (24 - 8 * i));
    out_.advance(to + 4);
}

/// Fractions have a point, whatever they are: others take "1" for one of 255.
void Writer::numbers(const Attribute& a, size_t element, bool fractions)
{
    for (int k = 0; k < a.components; ++k) {
        const float v = a.floats()[element * size_t(a.components) + size_t(k)];
        text_.put(' ');
        text_.number(v);
        if (fractions && v == std::floor(v) && std::abs(v) < 1e5f) text_.word(".0");
    }
}

void Writer::textVertex(size_t v)
{
    text_.begin(12);
    for (int k = 0; k < 3; ++k) {
        if (k > 0) text_.put(' ');
        text_.number(mesh_.positions()[v][k]);
    }
    if (normal_) numbers(*normal_, v, false);
    if (color_) numbers(*color_, v, true);
    if (texcoord_) numbers(*texcoord_, v, false);
    text_.end();
}

void Writer::binaryVertex(size_t v)
{
    for (int k = 0; k < 3; ++k) word(mesh_.positions()[v][k]);
    for (int k = 0; normal_ && k < 3; ++k) word(normal_->floats()[3 * v + size_t(k)]);
    for (int k = 0; color_ && k < 4; ++k) word(k < color_->components ? float(color_->at(v, k)) : 1.f);
    for (int k = 0; texcoord_ && k < 2; ++k) word(texcoord_->floats()[2 * v + size_t(k)]);
}

void Writer::vertices()
{
    for (size_t v = 0; v < mesh_.vertexCount(); ++v) {
        if (options_.binary)
            binaryVertex(v);
        else
            textVertex(v);
        if (progress_ && (v & 0xffff) == 0) progress_->at(0.4f * float(v) / float(mesh_.vertexCount()));
    }
}

void Writer::textFace(size_t f)
{
    const std::span<const uint32_t> corners = mesh_.face(f);
    text_.begin(1);
    text_.number(uint32_t(corners.size()));
    for (size_t c = 0; c < corners.size(); ++c) {
        if (c % 1024 == 0) text_.more(1024);
        text_.put(' ');
        text_.number(corners[c]);
    }
    text_.more(4);
    if (faceColor_) numbers(*faceColor_, f, true);
    if (colorIndex_ && colorIndex_->integers()[f] >= 0) {
        text_.put(' ');
        text_.number(colorIndex_->integers()[f]);
    }
    text_.end();
}

void Writer::binaryFace(size_t f)
{
    const std::span<const uint32_t> corners = mesh_.face(f);
    word(uint32_t(corners.size()));
    for (uint32_t v : corners) word(v);
    const bool index = colorIndex_ && colorIndex_->integers()[f] >= 0;
    word(uint32_t(faceColor_ ? faceColor_->components : index ? 1 : 0));
    for (int k = 0; faceColor_ && k < faceColor_->components; ++k) word(float(faceColor_->at(f, k)));
    if (index) word(uint32_t(colorIndex_->integers()[f]));
}

void Writer::faces()
{
    for (size_t f = 0; f < mesh_.faceCount(); ++f) {
        if (options_.binary)
            binaryFace(f);
        else
            textFace(f);
        if (progress_ && (f & 0xffff) == 0) progress_->at(0.4f + 0.6f * float(f) / float(mesh_.faceCount()));
    }
}

std::vector<Warning> Writer::run()
{
    if (mesh_.vertexCount() == 0) throw Error(file_.string(), "there is no visible mesh to write");
    chooseValues();
    lost();
    header();
    vertices();
    faces();
    out_.commit();
    return std::move(warnings_);
}

}  // namespace

std::vector<Warning> writeOff(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
{
    return Writer(scene, file, options, progress).run();
}

}  // namespace mw
