// What the elements and properties of a PLY file mean, and the mesh they make. Rows are read by ply_rows.cpp.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/io/checked_faces.h"
#include "core/io/corner_values.h"
#include "core/io/ply.h"
#include "core/io/ply_rows.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

constexpr Finding elementFinding{"unknown-element", "kind of element has no place in a mesh: left out",
                                 "kinds of elements have no place in a mesh: left out"};
constexpr Finding propertyFinding{"unknown-property", "list property has no place in a mesh: left out",
                                  "list properties have no place in a mesh: left out"};
constexpr Finding edgePropertyFinding{"edge-property", "property of the edges: left out", "properties of the edges: left out"};
constexpr Finding lineFinding{"line-index", "edge uses a vertex that is not there or not finite: left out",
                              "edges use vertices that are not there or not finite: left out"};
constexpr Finding precisionFinding{"double-position",
                                   "file has positions in double precision: they are kept in single, some move by more than a millionth of the size",
                                   "files have positions in double precision"};
constexpr Finding stripFinding{"strips", "list of strips beside faces: left out", "lists of strips beside faces: left out"};

/// An attribute while its values come in.
struct Incoming {
    std::string name;
    Domain domain = Domain::Vertex;
    int components = 1;
    Scalar stored = Scalar::Float32;
    std::variant<Array<float>, Array<double>, Array<int32_t>> values;

    Attribute take()
    {
        Attribute a;
        a.name = std::move(name);
        a.domain = domain;
        a.components = components;
        a.stored = stored;
        std::visit([&](auto& v) { a.values = Shared(std::move(v)); }, values);
        return a;
    }
};

/// Properties that together are one well-known attribute, under the names programs give them.
struct Known {
    std::string_view attribute;
    std::vector<std::vector<std::string_view>> spellings;
    bool fractions = false;  // whole numbers stand for fractions of their largest
};
const std::vector<Known>& knownAttributes()
{
    static const std::vector<Known> known{
        {names::normal, {{"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}}, false},
        {names::color,
         {{"red", "green", "blue", "alpha"},
          {"red", "green", "blue"},
          {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
          {"diffuse_red", "diffuse_green", "diffuse_blue"},
          {"r", "g", "b", "a"},
          {"r", "g", "b"}},
         true},
        {names::texcoord, {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}, false},
    };
    return known;
}

/// "NAME_3" is component 3 of NAME.
std::string_view baseName(std::string_view name, int component)
{
    const std::string ending = "_" + std::to_string(component);
    return name.size() > ending.size() && name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : std::string_view();
}

bool isWellKnown(std::string_view name)
{
    for (std::string_view n : {names::normal, names::texcoord, names::color, names::tangent, names::joints, names::weights, names::crease})
        if (name == n) return true;
    return false;
}

class Reader {
public:
    Reader(const FileBytes& bytes, const std::string& file, Progress* progress)
        : file_(file), header_(readPlyHeader(bytes, file)), body_(header_, bytes, file, findings_, progress)
    {}
    Mesh run();
    std::vector<Warning> warnings() const { return findings_.warnings(); }
    const PlyHeader& header() const { return header_; }

private:
    void vertices(const PlyElement& e);
    void faces(const PlyElement& e);
    void edges(const PlyElement& e);
    void strips(const PlyElement& e);
    void position(const PlyElement& e, std::vector<PlyColumn>& columns);
    void scalars(const PlyElement& e, Domain domain, size_t count, std::vector<PlyColumn>& columns);
    void known(const Known& k, const std::vector<std::string_view>& spelling, Domain domain, size_t count, std::vector<PlyColumn>& columns);
    void further(size_t first, Domain domain, size_t count, std::vector<PlyColumn>& columns);
    void cornerLists(std::vector<PlyColumn>& columns, std::vector<PlyValues>& lists);
    void checkPrecision(const Array<double>& exact);
    Mesh build();
    Mesh withAttributes(Mesh mesh, const CheckedFaces& kept);
    void mendValues(Incoming& in);
    std::vector<PlyColumn> columnsOf(const PlyElement& e) const
    {
        std::vector<PlyColumn> columns;
        for (const PlyProperty& p : e.properties) columns.push_back({p, {}, 1, 1, nullptr, nullptr});
        return columns;
    }

    const std::string& file_;
    Findings findings_;
    PlyHeader header_;
    PlyBody body_;
    Array<glm::vec3> positions_;
    std::vector<uint32_t> broken_;
    Array<uint32_t> faceStart_, cornerVertex_, lines_, strip_;
    std::vector<Incoming> attributes_;
};

bool taken(const PlyColumn& c)
{
    return c.to.index() != 0 || c.indices || c.list;
}

PlyColumn* columnNamed(std::vector<PlyColumn>& columns, std::string_view name, bool list)
{
    for (PlyColumn& c : columns)
        if (c.property.name == name && c.property.list == list && !taken(c)) return &c;
    return nullptr;
}

void Reader::position(const PlyElement& e, std::vector<PlyColumn>& columns)
{
    for (int k = 0; k < 3; ++k) {
        const char name[] = {"xyz"[k], 0};
        PlyColumn* c = columnNamed(columns, name, false);
        if (!c) throw Error(file_, "element 'vertex' has no property " + inQuotes(name) + "; a mesh needs x, y and z");
        c->to = &positions_[0][k];
        c->stride = 3;
    }
    (void)e;
}

void Reader::known(const Known& k, const std::vector<std::string_view>& spelling, Domain domain, size_t count, std::vector<PlyColumn>& columns)
{
    std::vector<PlyColumn*> found;
    for (std::string_view name : spelling)
        if (PlyColumn* c = columnNamed(columns, name, false)) found.push_back(c);
    if (found.size() != spelling.size()) return;
    const Scalar type = found[0]->property.type;
    Incoming in{std::string(k.attribute), domain, int(found.size()), k.fractions && isInteger(type) ? type : Scalar::Float32,
                Array<float>(count * found.size())};
    attributes_.push_back(std::move(in));
    float* to = std::get<Array<float>>(attributes_.back().values).data();
    for (size_t i = 0; i < found.size(); ++i) {
        found[i]->to = to + i;
        found[i]->stride = found.size();
        if (k.fractions && isInteger(found[i]->property.type)) found[i]->divisor = byteSize(found[i]->property.type) == 2 ? 65535 : 255;
    }
}

/// A property nobody here knows: an attribute of its own, with those that follow as NAME_1, NAME_2, ...
void Reader::further(size_t first, Domain domain, size_t count, std::vector<PlyColumn>& columns)
{
    const PlyProperty& p = columns[first].property;
    std::string_view base = baseName(p.name, 0);
    size_t n = 1;
    if (!base.empty())
        while (first + n < columns.size() && baseName(columns[first + n].property.name, int(n)) == base &&
               columns[first + n].property.type == p.type && !columns[first + n].property.list && !taken(columns[first + n]))
            ++n;
    Incoming in{n > 1 ? std::string(base) : p.name, domain, int(n), p.type, {}};
    if (isWellKnown(in.name) && n == 1) in.name += "_";
    if (p.type == Scalar::Float32)
        in.values = Array<float>(n * count);
    else if (p.type == Scalar::Float64 || p.type == Scalar::UInt32)
        in.values = Array<double>(n * count);
    else
        in.values = Array<int32_t>(n * count);
    attributes_.push_back(std::move(in));
    std::visit(
        [&](auto& values) {
            for (size_t i = 0; i < n; ++i) {
                columns[first + i].to = values.data() + i;
                columns[first + i].stride = n;
            }
        },
        attributes_.back().values);
}

void Reader::scalars(const PlyElement& e, Domain domain, size_t count, std::vector<PlyColumn>& columns)
{
    if (count == 0) return;
    for (const Known& k : knownAttributes())
        if (domain == Domain::Vertex || k.attribute == names::color) {
            const size_t before = attributes_.size();
            for (const auto& spelling : k.spellings)
                if (attributes_.size() == before) known(k, spelling, domain, count, columns);
        }
    for (size_t i = 0; i < columns.size(); ++i)
        if (!columns[i].property.list && !taken(columns[i])) further(i, domain, count, columns);
    (void)e;
}

void Reader::vertices(const PlyElement& e)
{
    const size_t count = body_.checkedCount(e);
    positions_.resize(count);
    std::vector<PlyColumn> columns = columnsOf(e);
    Array<double> exact;
    if (count > 0) position(e, columns);
    scalars(e, Domain::Vertex, count, columns);
    const bool doubles = std::any_of(columns.begin(), columns.end(), [](const PlyColumn& c) {
        return c.stride == 3 && c.property.name == "x" && c.property.type == Scalar::Float64;
    });
    if (doubles) {
        exact.resize(3 * count);
        for (PlyColumn& c : columns)
            for (int k = 0; k < 3; ++k)
                if (c.property.name == std::string(1, "xyz"[k]) && !c.property.list) c.to = exact.data() + k;
    }
    for (const PlyColumn& c : columns)
        if (c.property.list) findings_.add(propertyFinding, [&] { return "vertex " + inQuotes(c.property.name); });
    body_.read(e, columns);
    if (doubles) checkPrecision(exact);
    broken_ = mendPositions(positions_, CountsFrom::Zero, file_, findings_);
}

/// Positions far from the origin lose digits: say so when it can be seen.
void Reader::checkPrecision(const Array<double>& exact)
{
    Bounds bounds;
    double moved = 0;
    for (size_t i = 0; i < positions_.size(); ++i) {
        const glm::dvec3 p(exact[3 * i], exact[3 * i + 1], exact[3 * i + 2]);
        positions_[i] = glm::vec3(p);
        const glm::dvec3 d = glm::abs(glm::dvec3(positions_[i]) - p);
        if (!std::isfinite(d.x + d.y + d.z)) continue;
        bounds.add(p);
        moved = std::max({moved, d.x, d.y, d.z});
    }
    if (moved > 1e-6 * bounds.diagonal()) findings_.add(precisionFinding, [&] { return "at most by " + std::to_string(moved); });
}

void Reader::faces(const PlyElement& e)
{
    const size_t count = body_.checkedCount(e);
    std::vector<PlyColumn> columns = columnsOf(e);
    PlyColumn* index = columnNamed(columns, "vertex_indices", true);
    if (!index) index = columnNamed(columns, "vertex_index", true);
    if (!index) {
        findings_.add(elementFinding, [&] { return "'face' without a list vertex_indices"; });
        return body_.skip(e);
    }
    PlyIndices indices;
    indices.start.expect(count + 1);
    indices.start.push(0);
    const bool last = &e == &header_.elements.back();
    const size_t most = body_.mostListValues(e, index->property);
    indices.values.expect(last && byteSize(index->property.type) == 4 && columns.size() == 1 ? most : std::min(most, 3 * count));
    index->indices = &indices;
    scalars(e, Domain::Face, count, columns);
    std::vector<PlyValues> lists(columns.size());
    cornerLists(columns, lists);
    body_.read(e, columns);
    faceStart_ = indices.start.take();
    cornerVertex_ = indices.values.take();
    for (size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].list) continue;
        std::visit(
            [&](auto& list) {
                // So many values a corner in every face?
                const size_t total = list.values.size(), corners = cornerVertex_.size(), k = corners ? total / corners : 0;
                bool fits = corners > 0 && k > 0;
                for (size_t f = 0; fits && f < count; ++f) fits = list.start[f + 1] == k * faceStart_[f + 1];
                std::string name = columns[i].property.name;
                if (!fits || k > 1000) {
                    findings_.add(propertyFinding, [&] { return "face " + inQuotes(name); });
                    return;
                }
                if (name.starts_with("corner_")) name.erase(0, 7);
                attributes_.push_back({std::move(name), Domain::Corner, int(k), columns[i].property.type, list.values.take()});
            },
            lists[i]);
    }
}

/// Makes room for the lists that may hold values of corners.
void Reader::cornerLists(std::vector<PlyColumn>& columns, std::vector<PlyValues>& lists)
{
    for (size_t i = 0; i < columns.size(); ++i) {
        const PlyProperty& p = columns[i].property;
        if (!p.list || taken(columns[i])) continue;
        if (p.type == Scalar::Float32)
            lists[i].emplace<PlyLists<float>>();
        else if (p.type == Scalar::Float64 || p.type == Scalar::UInt32)
            lists[i].emplace<PlyLists<double>>();
        else
            lists[i].emplace<PlyLists<int32_t>>();
        std::visit([](auto& list) { list.start.push(0); }, lists[i]);
        columns[i].list = &lists[i];
    }
}

void Reader::edges(const PlyElement& e)
{
    const size_t count = body_.checkedCount(e);
    std::vector<PlyColumn> columns = columnsOf(e);
    PlyColumn *a = columnNamed(columns, "vertex1", false), *b = columnNamed(columns, "vertex2", false);
    if (!a || !b) {
        findings_.add(elementFinding, [&] { return "'edge' without vertex1 and vertex2"; });
        return body_.skip(e);
    }
    if (count == 0) return;
    Array<double> ends(2 * count);
    a->to = ends.data();
    b->to = ends.data() + 1;
    a->stride = b->stride = 2;
    for (const PlyColumn& c : columns)
        if (!taken(c)) findings_.add(edgePropertyFinding, [&] { return inQuotes(c.property.name); });
    body_.read(e, columns);
    lines_.resize(2 * count);
    for (size_t i = 0; i < ends.size(); ++i) lines_[i] = ends[i] >= 0 && ends[i] < double(none) ? uint32_t(ends[i]) : none;
}

/// Triangles from strips in which a negative index begins a new one.
void Reader::strips(const PlyElement& e)
{
    std::vector<PlyColumn> columns = columnsOf(e);
    PlyColumn* index = columnNamed(columns, "vertex_indices", true);
    if (!index) index = columnNamed(columns, "vertex_index", true);
    if (!index) {
        findings_.add(elementFinding, [&] { return "'tristrips' without a list vertex_indices"; });
        return body_.skip(e);
    }
    PlyIndices indices;
    indices.start.push(0);
    index->indices = &indices;
    const size_t count = body_.checkedCount(e);
    body_.read(e, columns);
    for (size_t s = 0; s < count; ++s) {
        size_t first = indices.start[s];
        for (size_t i = first; i < indices.start[s + 1]; ++i) {
            if (indices.values[i] == none) {
                first = i + 1;
                continue;
            }
            if (i < first + 2) continue;
            const bool odd = (i - first) % 2;
            const uint32_t a = indices.values[i - 2], b = indices.values[i - 1], c = indices.values[i];
            if (a == b || b == c || a == c) continue;  // joins two strips
            for (uint32_t v : {odd ? b : a, odd ? a : b, c}) strip_.push_back(v);
        }
    }
}

Mesh Reader::run()
{
    bool vertexElement = false;
    for (const PlyElement& e : header_.elements) {
        if (e.name == "vertex") {
            vertices(e);
            vertexElement = true;
        } else if (e.name == "face") {
            faces(e);
        } else if (e.name == "edge") {
            edges(e);
        } else if (e.name == "tristrips") {
            strips(e);
        } else {
            findings_.add(elementFinding, [&] { return inQuotes(e.name); });
            body_.checkedCount(e);
            body_.skip(e);
        }
    }
    if (!vertexElement || positions_.empty()) throw Error(file_, "has no vertices; export it again");
    body_.finish();
    return build();
}

Mesh Reader::build()
{
    if (!strip_.empty() && cornerVertex_.empty()) {
        cornerVertex_ = std::move(strip_);
        faceStart_.resize(cornerVertex_.size() / 3 + 1);
        for (size_t f = 0; f < faceStart_.size(); ++f) faceStart_[f] = uint32_t(3 * f);
        std::erase_if(attributes_, [](const Incoming& in) { return in.domain != Domain::Vertex; });
    } else if (!strip_.empty()) {
        findings_.add(stripFinding);
    }
    if (faceStart_.empty()) faceStart_.push_back(0);
    const size_t count = positions_.size();
    CheckedFaces kept = checkedFaces(std::move(faceStart_), std::move(cornerVertex_), count, broken_, findings_,
                                     [](uint32_t f, uint32_t) { return facePlace(f, CountsFrom::Zero); });
    Mesh mesh(std::move(positions_), std::move(kept.faceStart), std::move(kept.cornerVertex));
    Array<uint32_t> lines = checkedLines(
        lines_, count, broken_, [&](size_t i) { findings_.add(lineFinding, [&] { return "edge " + std::to_string(i) + ", counted from 0"; }); });
    if (!lines.empty()) mesh = mesh.withLines(std::move(lines));
    return withAttributes(std::move(mesh), kept);
}

void Reader::mendValues(Incoming& in)
{
    auto* values = std::get_if<Array<float>>(&in.values);
    if (!values || !(isWellKnown(in.name))) return;
    for (float& v : *values)
        if (!std::isfinite(v)) {
            findings_.add(found::value);
            v = 0;
        }
}

/// Floats, whatever the file has; whole numbers of colours are fractions.
Attribute asFloats(const Attribute& a)
{
    const double divisor = a.name != names::color || !isInteger(a.stored) ? 1 : byteSize(a.stored) == 2 ? 65535 : 255;
    Array<float> values(a.size() * size_t(a.components));
    for (size_t e = 0, i = 0; e < a.size(); ++e)
        for (int k = 0; k < a.components; ++k) {
            const double v = a.at(e, k) / divisor;
            values[i++] = std::isfinite(v) ? float(v) : 0;
        }
    Attribute f = floatAttribute(a.name, a.domain, a.components, std::move(values));
    if (a.name == names::color && isInteger(a.stored)) f.stored = a.stored;
    return f;
}

/// `base`, or a further set of it: base1, base2, ...
bool isSetOf(std::string_view name, std::string_view base)
{
    return name.starts_with(base) && std::all_of(name.begin() + long(base.size()), name.end(), isDigit);
}

/// Whoever meets a well-known name relies on its form: what a file has under such a name in another form is renamed.
Attribute inKnownForm(Attribute a)
{
    const auto among = [&](std::initializer_list<int> n) { return std::find(n.begin(), n.end(), a.components) != n.end(); };
    const bool texcoord = isSetOf(a.name, names::texcoord), color = isSetOf(a.name, names::color);
    bool fits = true;
    if (a.name == names::material || a.name == names::group) {
        const std::span<const int32_t> values = a.integers();
        const int32_t most = a.name == names::material ? 4096 : 65536;
        fits = a.domain == Domain::Face && a.components == 1 && a.integral() &&
               std::all_of(values.begin(), values.end(), [most](int32_t v) { return v >= 0 && v < most; });
    } else if (texcoord || color || a.name == names::normal || a.name == names::tangent || a.name == names::crease || a.name == names::weights) {
        fits = a.domain != Domain::Face && (texcoord                  ? among({2})
                                            : color                   ? among({3, 4})
                                            : a.name == names::normal ? among({3})
                                            : a.name == names::crease ? a.domain == Domain::Corner && among({1})
                                                                      : a.components % 4 == 0);
        if (fits && (a.floats().empty() || a.name == names::weights)) a = asFloats(a);
    } else if (a.name == names::joints) {
        fits = a.domain == Domain::Vertex && a.components % 4 == 0 && a.integral();
    } else if (a.name.starts_with(names::morph)) {
        fits = a.domain == Domain::Vertex && a.components == 3 && !a.floats().empty();
    }
    if (!fits) a.name += "_";
    return a;
}

Mesh Reader::withAttributes(Mesh mesh, const CheckedFaces& kept)
{
    for (Incoming& in : attributes_) {
        mendValues(in);
        Attribute a = in.take();
        if (!kept.all && a.domain != Domain::Vertex) a = gathered(a, a.domain == Domain::Face ? kept.faces : kept.corners);
        const bool spread = (a.name == names::texcoord && a.domain == Domain::Vertex) || (a.name == names::color && a.domain == Domain::Face);
        if (spread && mesh.cornerCount() > 0) a = atCorners(a, mesh);
        if (a.domain != Domain::Vertex && mesh.cornerCount() == 0) continue;
        a = inKnownForm(std::move(a));
        while (mesh.find(a.name, a.domain)) a.name += "_";
        mesh = mesh.with(std::move(a));
    }
    if (const Attribute* group = mesh.find(names::group, Domain::Face); group && group->integral() && group->components == 1) {
        std::vector<std::string> groupNames = header_.groupNames;
        int32_t most = -1;
        for (int32_t g : group->integers()) most = g < 0 || g > 65535 ? 65536 : std::max(most, g);
        for (int i = int(groupNames.size()); most < 65536 && i <= most; ++i) groupNames.push_back("group " + std::to_string(i));
        if (most < 65536) mesh = mesh.withGroupNames(std::move(groupNames));
    }
    return mesh;
}

/// Grey materials for the slots that the faces name, so that each slot has one.
std::vector<MaterialId> slotsFor(const Mesh& mesh, Scene& scene)
{
    std::vector<MaterialId> slots;
    const Attribute* a = mesh.find(names::material, Domain::Face);
    if (!a || !a->integral() || a->components != 1) return slots;
    int32_t most = -1;
    for (int32_t s : a->integers()) most = std::max(most, s);
    for (int32_t s = 0; s <= std::min(most, 4095); ++s) {
        Material m;
        m.name = "material " + std::to_string(s);
        slots.push_back(scene.add(std::move(m)));
    }
    return slots;
}

}  // namespace

Imported readPly(const fs::path& file, Progress* progress)
{
    const FileBytes bytes = readBytes(file);
    const std::string name = file.string();
    Reader reader(bytes, name, progress);
    MeshObject object;
    object.name = file.stem().string();
    object.base = reader.run();
    Imported out;
    object.materials = slotsFor(object.base, out.scene);
    Node node;
    node.name = object.name;
    node.mesh = out.scene.add(std::move(object));
    out.scene.add(std::move(node));
    out.warnings = reader.warnings();
    const PlyHeader::Encoding e = reader.header().encoding;
    out.format = e == PlyHeader::Encoding::Text     ? "PLY (text)"
                 : e == PlyHeader::Encoding::Little ? "PLY (binary, little-endian)"
                                                    : "PLY (binary, big-endian)";
    out.units = "unknown";
    reader.header().stated.tell(out);
    return out;
}

}  // namespace mw
