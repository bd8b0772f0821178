// PLY out, in text and both binary encodings. An attribute is written in the plainest form that holds it: values of corners that agree all
// round a vertex become properties of the vertex (nx ny nz, s t, red green blue), colours that agree on a face properties of the face, and
// only the others lists on the faces.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

#include "core/io/corner_values.h"
#include "core/io/placement.h"
#include "core/io/ply.h"
#include "core/io/ply_rows.h"
#include "core/io/text_out.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

/// One property: component of an attribute, `times` 255 where a fraction is written as a byte.
struct Column {
    std::string name;
    Scalar type;
    const Attribute* a;
    int component;
    double times = 1;
    bool list = false;  // all components of all corners of the face

    double value(size_t element, int k) const { return times == 1 ? a->at(element, k) : std::round(std::clamp(a->at(element, k), 0.0, 1.0) * times); }
};

/// The stored type if it can hold every value, else that of the values.
Scalar typeFor(const Attribute& a)
{
    const Scalar natural = std::holds_alternative<Shared<float>>(a.values) ? Scalar::Float32 : a.integral() ? Scalar::Int32 : Scalar::Float64;
    if (!isInteger(a.stored)) return natural == Scalar::Float32 ? a.stored : natural;
    const bool isSigned = a.stored == Scalar::Int8 || a.stored == Scalar::Int16 || a.stored == Scalar::Int32;
    const double range = std::ldexp(1.0, int(8 * byteSize(a.stored)) - isSigned), low = isSigned ? -range : 0, high = range - 1;
    for (size_t e = 0; e < a.size(); ++e)
        for (int k = 0; k < a.components; ++k)
            if (const double v = a.at(e, k); !(v >= low && v <= high && v == std::floor(v))) return natural;
    return a.stored;
}

double largestOf(Scalar type)
{
    return type == Scalar::UInt8 ? 255 : type == Scalar::UInt16 ? 65535 : 1;
}

class Writer {
public:
    Writer(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
        : file_(file),
          options_(options),
          progress_(progress),
          flat_(flattened(scene, progress, options.placement, options.evaluator)),
          mesh_(flat_.mesh),
          out_(file),
          text_(out_),
          swap_(options.bigEndian)
    {}
    std::vector<Warning> run();

private:
    void place(const Attribute& a);
    void add(std::vector<Column>& to, const Attribute& a, std::vector<std::string> names, Scalar type, double times = 1);
    std::string fresh(std::set<std::string>& used, std::string_view name) const;
    void header();
    void vertices();
    void faces();
    void edges();
    template <class T>
    void put(T v);
    void put(const Column& c, size_t element, int k);
    void putCount(size_t n, bool wide);

    const fs::path& file_;
    const WriteOptions& options_;
    Progress* progress_;
    Flattened flat_;
    const Mesh& mesh_;
    OutputFile out_;
    TextOut text_;
    bool swap_;
    bool firstInLine_ = true, wideFaces_ = false, wideLists_ = false;
    std::vector<Column> vertexColumns_, faceColumns_;
    std::vector<std::unique_ptr<Attribute>> made_;
    std::set<std::string> vertexNames_{"x", "y", "z"}, faceNames_{"vertex_indices", "vertex_index"};
    std::vector<Warning> warnings_;
};

/// A property name has no blanks and is there once.
std::string Writer::fresh(std::set<std::string>& used, std::string_view name) const
{
    std::string n(name);
    for (char& c : n)
        if (uint8_t(c) <= ' ') c = '_';
    if (n.empty()) n = "property";
    while (!used.insert(n).second) n += "_";
    return n;
}

void Writer::add(std::vector<Column>& to, const Attribute& a, std::vector<std::string> names, Scalar type, double times)
{
    std::set<std::string>& used = &to == &vertexColumns_ ? vertexNames_ : faceNames_;
    for (int k = 0; k < a.components; ++k) to.push_back({fresh(used, names[size_t(k)]), type, &a, k, times, false});
}

std::vector<std::string> numbered(const Attribute& a)
{
    std::vector<std::string> all;
    for (int k = 0; k < a.components; ++k) all.push_back(a.components == 1 ? a.name : a.name + "_" + std::to_string(k));
    return all;
}

/// The names other programs know, or none.
std::vector<std::string> knownNames(const Attribute& a)
{
    const bool floats = !a.floats().empty();
    if (floats && a.name == names::normal && a.components == 3) return {"nx", "ny", "nz"};
    if (floats && a.name == names::texcoord && a.components == 2) return {"s", "t"};
    if (floats && a.name == names::color && a.components == 3) return {"red", "green", "blue"};
    if (floats && a.name == names::color && a.components == 4) return {"red", "green", "blue", "alpha"};
    return {};
}

void Writer::place(const Attribute& a)
{
    if (a.components < 1 || a.size() != mesh_.count(a.domain)) return;
    const std::vector<std::string> known = knownNames(a);
    const bool color = !known.empty() && a.name == names::color;
    const double times = color ? largestOf(a.stored) : 1;
    const Scalar type = times > 1 ? a.stored : color ? Scalar::Float32 : typeFor(a);
    if (a.domain == Domain::Vertex) return add(vertexColumns_, a, known.empty() ? numbered(a) : known, type, times);
    if (a.domain == Domain::Face) return add(faceColumns_, a, numbered(a), type);
    if (color)
        if (auto byFace = gatheredIfEqual(a, mesh_, Domain::Face)) {
            made_.push_back(std::make_unique<Attribute>(std::move(*byFace)));
            return add(faceColumns_, *made_.back(), known, type, times);
        }
    if (!known.empty() && !mesh_.find(a.name, Domain::Vertex))
        if (auto byVertex = gatheredIfEqual(a, mesh_, Domain::Vertex)) {
            made_.push_back(std::make_unique<Attribute>(std::move(*byVertex)));
            return add(vertexColumns_, *made_.back(), known, type, times);
        }
    const bool plain = a.name == names::texcoord && a.components == 2;
    faceColumns_.push_back({fresh(faceNames_, plain ? a.name : "corner_" + a.name), type, &a, 0, times, true});
}

void Writer::header()
{
    const auto property = [](const Column& c, bool wide) {
        return "property " + std::string(c.list ? wide ? "list uint " : "list uchar " : "") + plyName(c.type) + " " + c.name + "\n";
    };
    std::string h = std::string("ply\nformat ") +
                    (!options_.binary ? "ascii"
                     : swap_          ? "binary_big_endian"
                                      : "binary_little_endian") +
                    " 1.0\ncomment Meshwright\ncomment " + statement(options_.placement) + "\n";
    for (const std::string& name : mesh_.groupNames()) {
        std::string line = name;
        std::replace_if(
            line.begin(), line.end(), [](char c) { return uint8_t(c) < ' '; }, ' ');
        h += "comment group " + line + "\n";
    }
    h += "element vertex " + std::to_string(mesh_.vertexCount()) + "\nproperty float x\nproperty float y\nproperty float z\n";
    for (const Column& c : vertexColumns_) h += property(c, false);
    if (mesh_.faceCount() > 0) {
        h += "element face " + std::to_string(mesh_.faceCount()) + "\nproperty list " + (wideFaces_ ? "uint" : "uchar") +
             (mesh_.vertexCount() > 0x7fffffff ? " uint" : " int") + " vertex_indices\n";
        for (const Column& c : faceColumns_) h += property(c, wideLists_);
    }
    if (!mesh_.lines().empty()) h += "element edge " + std::to_string(mesh_.lines().size() / 2) + "\nproperty int vertex1\nproperty int vertex2\n";
    out_.write(h + "end_header\n");
}

template <class T>
void Writer::put(T v)
{
    if (!options_.binary) {
        if (!firstInLine_) text_.put(' ');
        firstInLine_ = false;
        if constexpr (sizeof(T) == 1)
            text_.number(int(v));
        else
            text_.number(v);
        return;
    }
    char bytes[sizeof(T)];
    std::memcpy(bytes, &v, sizeof(T));
    if (swap_) std::reverse(bytes, bytes + sizeof(T));
    char* to = out_.room(sizeof(T));
    std::memcpy(to, bytes, sizeof(T));
    out_.advance(to + sizeof(T));
}

void Writer::put(const Column& c, size_t element, int k)
{
    const double v = c.value(element, k);
    switch (c.type) {
        case Scalar::Float32:
            return put(float(v));
        case Scalar::Float64:
            return put(v);
        case Scalar::Int8:
            return put(int8_t(v));
        case Scalar::UInt8:
            return put(uint8_t(v));
        case Scalar::Int16:
            return put(int16_t(v));
        case Scalar::UInt16:
            return put(uint16_t(v));
        case Scalar::Int32:
            return put(int32_t(v));
        case Scalar::UInt32:
            return put(uint32_t(v));
    }
}

void Writer::putCount(size_t n, bool wide)
{
    if (wide)
        put(uint32_t(n));
    else
        put(uint8_t(n));
}

void Writer::vertices()
{
    if (options_.binary && !swap_ && vertexColumns_.empty()) return out_.write(mesh_.positions().data(), mesh_.positions().bytes());
    for (size_t v = 0; v < mesh_.vertexCount(); ++v) {
        firstInLine_ = true;
        if (!options_.binary) text_.begin(3 + vertexColumns_.size());
        for (int k = 0; k < 3; ++k) put(mesh_.positions()[v][k]);
        for (const Column& c : vertexColumns_) put(c, v, c.component);
        if (!options_.binary) text_.end();
        if (progress_ && (v & 0xffff) == 0) progress_->at(0.4f * float(v) / float(mesh_.vertexCount()));
    }
}

void Writer::faces()
{
    const bool plain = options_.binary && !swap_ && !wideFaces_ && faceColumns_.empty();
    for (size_t f = 0; f < mesh_.faceCount(); ++f) {
        if (progress_ && (f & 0xffff) == 0) progress_->at(0.4f + 0.6f * float(f) / float(mesh_.faceCount()));
        const std::span<const uint32_t> corners = mesh_.face(f);
        if (plain) {
            char* to = out_.room(1 + 4 * corners.size());
            *to++ = char(corners.size());
            if (!corners.empty()) std::memcpy(to, corners.data(), corners.size_bytes());
            out_.advance(to + corners.size_bytes());
            continue;
        }
        firstInLine_ = true;
        size_t values = 1 + corners.size();
        for (const Column& c : faceColumns_) values += c.list ? 1 + corners.size() * size_t(c.a->components) : 1;
        if (!options_.binary) text_.begin(values);
        putCount(corners.size(), wideFaces_);
        for (uint32_t v : corners) put(v);
        for (const Column& c : faceColumns_) {
            if (!c.list) {
                put(c, f, c.component);
                continue;
            }
            putCount(corners.size() * size_t(c.a->components), wideLists_);
            for (uint32_t i = mesh_.faceStart()[f]; i < mesh_.faceStart()[f + 1]; ++i)
                for (int k = 0; k < c.a->components; ++k) put(c, i, k);
        }
        if (!options_.binary) text_.end();
    }
}

void Writer::edges()
{
    for (size_t i = 0; i + 1 < mesh_.lines().size(); i += 2) {
        firstInLine_ = true;
        if (!options_.binary) text_.begin(2);
        put(mesh_.lines()[i]);
        put(mesh_.lines()[i + 1]);
        if (!options_.binary) text_.end();
    }
}

std::vector<Warning> Writer::run()
{
    if (mesh_.vertexCount() == 0) throw Error(file_.string(), "there is no visible mesh to write");
    // Those with names of their own first: a property that happens to be called "s" gives way.
    for (const bool known : {true, false})
        for (const Attribute& a : mesh_.attributes())
            if (knownNames(a).empty() != known) place(a);
    size_t largestFace = 0, components = 1;
    for (size_t f = 0; f < mesh_.faceCount(); ++f) largestFace = std::max(largestFace, mesh_.face(f).size());
    for (const Column& c : faceColumns_)
        if (c.list) components = std::max(components, size_t(c.a->components));
    wideFaces_ = largestFace > 255;
    wideLists_ = largestFace * components > 255;
    header();
    vertices();
    faces();
    edges();
    out_.commit();
    if (std::any_of(flat_.materials.begin(), flat_.materials.end(), [](MaterialId m) { return bool(m); }))
        warnings_.push_back(
            {"material-lost", "PLY has no materials: their colours and pictures are not written (the slot numbers of faces are)", {}});
    return std::move(warnings_);
}

}  // namespace

std::vector<Warning> writePly(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
{
    return Writer(scene, file, options, progress).run();
}

}  // namespace mw
