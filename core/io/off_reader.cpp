// From the numbers of an OFF file to a scene: faces are checked, colours brought to fractions, values of vertices spread to corners.
#include <algorithm>
#include <cmath>

#include "core/io/checked_faces.h"
#include "core/io/corner_values.h"
#include "core/io/off.h"
#include "core/io/off_data.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

constexpr Finding mapFinding{"color-map", "face names a colour of a map that is not in the file: its number is kept as the attribute color_index",
                             "faces name colours of a map that is not in the file: their numbers are kept as the attribute color_index"};

using Color = OffData::Color;

class Builder {
public:
    Builder(OffData& data, const std::string& file) : data_(data), file_(file) {}
    Mesh mesh();

private:
    Mesh checked();
    Attribute values(std::string_view name, Domain domain, int components, const float* from, size_t stride, size_t count, bool whole);
    void vertexValues(Mesh& mesh);
    void faceColors(Mesh& mesh);
    void colorIndices(Mesh& mesh);

    OffData& data_;
    const std::string& file_;
    CheckedFaces kept_;
};

Mesh Builder::checked()
{
    Array<glm::vec3> positions = data_.positions.take();
    const std::vector<uint32_t> broken = mendPositions(positions, CountsFrom::Zero, file_, data_.findings);
    kept_ = checkedFaces(data_.faceStart.take(), data_.cornerVertex.take(), positions.size(), broken, data_.findings,
                         [](uint32_t f, uint32_t) { return facePlace(f, CountsFrom::Zero); });
    return Mesh(std::move(positions), std::move(kept_.faceStart), std::move(kept_.cornerVertex));
}

/// Were these fractions bytes once?
bool areBytes(const Array<float>& values)
{
    return std::all_of(values.begin(), values.end(), [](float v) { return v >= 0 && v <= 1 && float(std::round(double(v) * 255) / 255) == v; });
}

/// `components` floats of each element; whole numbers up to 255 become fractions.
Attribute Builder::values(std::string_view name, Domain domain, int components, const float* from, size_t stride, size_t count, bool whole)
{
    Array<float> out(count * size_t(components));
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < size_t(components); ++k) {
            const float v = from[i * stride + k];
            if (!std::isfinite(v)) data_.findings.add(found::value);
            out[i * size_t(components) + k] = !std::isfinite(v) ? 0 : whole ? float(double(v) / 255) : v;
        }
    const bool bytes = whole || (name == names::color && areBytes(out));
    Attribute a = floatAttribute(std::string(name), domain, components, std::move(out));
    if (bytes) a.stored = Scalar::UInt8;
    return a;
}

void Builder::vertexValues(Mesh& mesh)
{
    const size_t n = mesh.vertexCount();
    if (data_.normals.size()) mesh = mesh.with(values(names::normal, Domain::Vertex, 3, &data_.normals[0].x, 3, n, false));
    if (data_.colors.size()) {
        // Above 1 they can only be bytes.
        float most = 0;
        for (size_t i = 0; i < n; ++i)
            for (int k = 0; k < data_.colorSize; ++k) most = std::max(most, data_.colors[i][k]);
        mesh = mesh.with(values(names::color, Domain::Vertex, data_.colorSize, &data_.colors[0].x, 4, n, most > 1));
    }
    if (data_.texcoords.size() && mesh.cornerCount() > 0)
        mesh = mesh.with(atCorners(values(names::texcoord, Domain::Vertex, 2, &data_.texcoords[0].x, 2, n, false), mesh));
}

/// Colours of faces become colours of their corners; faces without are white.
void Builder::faceColors(Mesh& mesh)
{
    const size_t all = data_.faceColorKind.size();
    if (all == 0 || mesh.cornerCount() == 0) return;
    bool any = false, alpha = false, fractions = false;
    float most = 0;
    for (size_t f = 0; f < all; ++f) {
        const Color kind = data_.faceColorKind[f];
        if (kind == Color::None || kind == Color::Index) continue;
        any = true;
        alpha = alpha || kind == Color::Whole4 || kind == Color::Fraction4;
        fractions = fractions || kind == Color::Fraction3 || kind == Color::Fraction4;
        for (int k = 0; k < 3; ++k) most = std::max(most, data_.faceColor[f][k]);
    }
    if (!any) return;
    const bool bytes = most > 1;  // whole numbers of which none is above 1 are fractions, too
    for (size_t f = 0; f < all; ++f) {
        const Color kind = data_.faceColorKind[f];
        glm::vec4& c = data_.faceColor[f];
        const bool whole = kind == Color::Whole3 || kind == Color::Whole4;
        if (kind == Color::None || kind == Color::Index) c = glm::vec4(bytes && !fractions ? 255.f : 1.f);
        // `values` divides all alike: where both ways are mixed it is done here.
        if (bytes && fractions && whole) c = glm::vec4(glm::dvec4(c) / 255.0);
        if (kind == Color::Whole3 || kind == Color::Fraction3) c.a = bytes && !fractions ? 255.f : 1.f;
    }
    Array<glm::vec4> ofFaces(mesh.faceCount());
    for (size_t i = 0; i < ofFaces.size(); ++i) ofFaces[i] = data_.faceColor[kept_.all ? i : kept_.faces[i]];
    mesh = mesh.with(atCorners(values(names::color, Domain::Face, alpha ? 4 : 3, &ofFaces[0].x, 4, ofFaces.size(), bytes && !fractions), mesh));
}

void Builder::colorIndices(Mesh& mesh)
{
    const auto isIndex = [&](size_t f) { return f < data_.faceColorKind.size() && data_.faceColorKind[f] == Color::Index; };
    Array<int32_t> numbers(mesh.faceCount(), -1);
    bool any = false;
    for (size_t i = 0; i < numbers.size(); ++i) {
        const size_t f = kept_.all ? i : kept_.faces[i];
        if (!isIndex(f)) continue;
        any = true;
        data_.findings.add(mapFinding);
        numbers[i] = int32_t(std::clamp(data_.faceColor[f][0], -1.f, 1e6f));
    }
    if (any) mesh = mesh.with(integerAttribute("color_index", Domain::Face, 1, std::move(numbers)));
}

Mesh Builder::mesh()
{
    Mesh mesh = checked();
    vertexValues(mesh);
    faceColors(mesh);
    colorIndices(mesh);
    return mesh;
}

}  // namespace

bool isOff(std::string_view start)
{
    OffHeader header;
    return readOffHeader(start, header);
}

Imported readOff(const fs::path& file, Progress* progress)
{
    FileBytes bytes = readBytes(file);
    const std::string name = file.string();
    if (bytes.size() == 0) throw Error(name, "is empty; export it again");
    OffHeader header;
    if (!readOffHeader(bytes.text(), header)) {
        bytes = plainText(std::move(bytes), name);  // perhaps it is UTF-16
        // Geomview lets the first word away.
        const size_t first = bytes.text().find_first_not_of(" \t\r\n");
        if (!readOffHeader(bytes.text(), header) && (first == std::string_view::npos || !isDigit(bytes.data()[first])))
            throw Error(name, "an OFF file begins with \"OFF\", \"COFF\", \"NOFF\" or the like, this one with " +
                                  inQuotes(tokenAt(bytes.begin() + (first == std::string_view::npos ? 0 : first))) +
                                  "; check that it is an OFF file");
    }
    OffData data;
    bool big = false;
    if (header.binary) {
        big = parseBinaryOff(bytes, header, name, data, progress);
    } else {
        bytes = plainText(std::move(bytes), name);
        parseOff(bytes, header, name, data, progress);
    }
    bytes = {};
    Imported out;
    out.scene = sceneOf(Builder(data, name).mesh(), file.stem().string());
    out.warnings = data.findings.warnings();
    const std::string word =
        std::string(header.texcoord ? "ST" : "") + (header.color ? "C" : "") + (header.normal ? "N" : "") + (header.homogeneous ? "4" : "") + "OFF";
    out.format = word + (!header.binary ? " (text)" : big ? " (binary, big-endian)" : " (binary, little-endian)");
    out.units = "unknown";
    data.stated.tell(out);
    return out;
}

}  // namespace mw
