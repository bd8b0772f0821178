// From the lines of an OBJ file to a scene: faces are checked, values of corners spread out, materials looked up.
#include <algorithm>
#include <cmath>

#include "core/io/checked_faces.h"
#include "core/io/mtl.h"
#include "core/io/obj.h"
#include "core/io/obj_data.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

constexpr Finding lineFinding{"line-index", "line segment uses a vertex that is not there or not finite: left out",
                              "line segments use vertices that are not there or not finite: left out"};
constexpr Finding texcoordFinding{"texcoord-index", "corner names a texture coordinate that is not there: set to 0 0",
                                  "corners name texture coordinates that are not there: set to 0 0"};
constexpr Finding normalFinding{"normal-index", "corner names a normal that is not there: the face's own is taken",
                                "corners name normals that are not there: the face's own is taken"};
constexpr Finding noTexcoordFinding{"texcoord-missing", "corner has no texture coordinate: set to 0 0",
                                    "corners have no texture coordinate: set to 0 0"};
constexpr Finding noNormalFinding{"normal-missing", "corner has no normal: the face's own is taken",
                                  "corners have no normal: the face's own is taken"};
constexpr Finding materialFinding{"missing-material", "material is not in any library: it is grey",
                                  "materials are not in any library: they are grey"};

class Builder {
public:
    Builder(ObjData& data, const std::string& file) : data_(data), file_(file), findings_(data.findings) {}
    Mesh mesh();
    /// The slot of each face, or empty when there is at most one material.
    void materials(Mesh& mesh, Scene& scene, const fs::path& folder, std::vector<MaterialId>& slots);

private:
    void checkUsable() const;
    void faces();
    Array<uint32_t> lines();
    template <class V>
    V finite(V v);
    Mesh withTexcoords(Mesh mesh);
    Mesh withNormals(Mesh mesh);
    Mesh withColors(Mesh mesh);
    Array<int32_t> ofRuns(const std::vector<ObjRun>& runs, int32_t before) const;
    uint64_t lineOf(uint32_t face, int64_t& index) const;

    ObjData& data_;
    const std::string& file_;
    Findings& findings_;
    Array<glm::vec3> positions_;
    std::vector<uint32_t> broken_;
    CheckedFaces faces_;
    size_t faceCount_ = 0;
};

void Builder::checkUsable() const
{
    if (data_.positions.size() == 0 && data_.firstFaceLine)
        throw Error(file_,
                    "line " + std::to_string(data_.firstFaceLine) + ": a face, but the file has no vertices; export it again with its vertices");
    if (data_.positions.size() == 0) throw Error(file_, "no line with a vertex (\"v x y z\") was found; check that it is an OBJ file");
}

/// Where a face that names a missing vertex stands: 0 beyond the first thousand.
uint64_t Builder::lineOf(uint32_t face, int64_t& index) const
{
    const auto e = std::lower_bound(data_.early.begin(), data_.early.end(), face, [](const ObjData::Early& a, uint32_t f) { return a.face < f; });
    if (e == data_.early.end() || e->face != face) return 0;
    index = e->index;
    return e->line;
}

void Builder::faces()
{
    positions_ = data_.positions.take();
    const size_t count = positions_.size();
    broken_ = mendPositions(positions_, CountsFrom::One, file_, findings_);
    faces_ = checkedFaces(data_.faceStart.take(), data_.cornerVertex.take(), count, broken_, findings_, [&](uint32_t f, uint32_t v) {
        int64_t index = int64_t(v) + 1;
        const uint64_t line = v == none ? 0 : lineOf(f, index);
        const std::string face = line ? "line " + std::to_string(line) : facePlace(f, CountsFrom::One);
        return v == none ? face : face + ": " + vertexPlace(index, count, CountsFrom::One);
    });
    faceCount_ = faces_.faceStart.size() - 1;
}

Array<uint32_t> Builder::lines()
{
    return checkedLines(data_.lines.take(), positions_.size(), broken_, [&](size_t) { findings_.add(lineFinding); });
}

template <class V>
V Builder::finite(V v)
{
    for (int k = 0; k < v.length(); ++k)
        if (!std::isfinite(v[k])) {
            findings_.add(found::value);
            return V(0);
        }
    return v;
}

Mesh Builder::withTexcoords(Mesh mesh)
{
    const Array<uint32_t> index = faces_.take(data_.cornerTexcoord.take());
    if (index.empty()) return mesh;
    Array<float> values(2 * index.size());
    for (size_t c = 0; c < index.size(); ++c) {
        const bool there = index[c] < data_.texcoords.size();
        if (!there) findings_.add(index[c] == none ? noTexcoordFinding : texcoordFinding);
        const glm::vec2 t = there ? finite(data_.texcoords[index[c]]) : glm::vec2(0);
        values[2 * c] = t.x;
        values[2 * c + 1] = t.y;
    }
    return mesh.with(floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(values)));
}

Mesh Builder::withNormals(Mesh mesh)
{
    const Array<uint32_t> index = faces_.take(data_.cornerNormal.take());
    if (index.empty()) return mesh;
    Array<float> values(3 * index.size());
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (size_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
            const bool there = index[c] < data_.normals.size();
            if (!there) findings_.add(index[c] == none ? noNormalFinding : normalFinding);
            const glm::vec3 n = there ? finite(data_.normals[index[c]]) : mesh.faceNormals()[f];
            for (int k = 0; k < 3; ++k) values[3 * c + size_t(k)] = n[k];
        }
    return mesh.with(floatAttribute(std::string(names::normal), Domain::Corner, 3, std::move(values)));
}

Mesh Builder::withColors(Mesh mesh)
{
    if (data_.colors.size() == 0) return mesh;
    const size_t k = data_.alpha ? 4 : 3;
    Array<float> values(k * mesh.vertexCount());
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        const glm::vec4 color = finite(data_.colors[v]);
        for (size_t i = 0; i < k; ++i) values[k * v + i] = color[int(i)];
    }
    return mesh.with(floatAttribute(std::string(names::color), Domain::Vertex, int(k), std::move(values)));
}

/// The name's number for each face that remained.
Array<int32_t> Builder::ofRuns(const std::vector<ObjRun>& runs, int32_t before) const
{
    Array<int32_t> values(faceCount_);
    size_t run = 0;
    for (size_t i = 0; i < faceCount_; ++i) {
        const uint32_t face = faces_.all ? uint32_t(i) : faces_.faces[i];
        while (run < runs.size() && runs[run].face <= face) ++run;
        values[i] = run == 0 ? before : int32_t(runs[run - 1].name);
    }
    return values;
}

Mesh Builder::mesh()
{
    checkUsable();
    faces();
    Array<uint32_t> lineVertices = lines();
    Array<int32_t> groups;
    if (!data_.groupRuns.empty()) {
        const bool before = data_.groupRuns.front().face > 0;
        if (before) data_.groupNames.push_back("default");
        groups = ofRuns(data_.groupRuns, int32_t(data_.groupNames.size()) - 1);
    }
    Mesh mesh(std::move(positions_), std::move(faces_.faceStart), std::move(faces_.cornerVertex));
    if (!lineVertices.empty()) mesh = mesh.withLines(std::move(lineVertices));
    mesh = withColors(withNormals(withTexcoords(std::move(mesh))));
    if (!groups.empty())
        mesh = mesh.with(integerAttribute(std::string(names::group), Domain::Face, 1, std::move(groups))).withGroupNames(std::move(data_.groupNames));
    return mesh;
}

void Builder::materials(Mesh& mesh, Scene& scene, const fs::path& folder, std::vector<MaterialId>& slots)
{
    if (data_.materialRuns.empty()) return;
    MtlReader reader(folder, scene, findings_);
    for (const std::string& l : data_.libraries) reader.readLibraries(l);
    if (data_.materialRuns.front().face > 0) data_.materialNames.push_back("default");
    for (const std::string& name : data_.materialNames) {
        const auto m = reader.materials().find(name);
        Material grey;
        grey.name = name;
        if (m == reader.materials().end() && name != "default") findings_.add(materialFinding, [&] { return inQuotes(name); });
        slots.push_back(scene.add(m == reader.materials().end() ? grey : m->second));
    }
    if (slots.size() > 1)
        mesh = mesh.with(integerAttribute(std::string(names::material), Domain::Face, 1, ofRuns(data_.materialRuns, int32_t(slots.size()) - 1)));
}

}  // namespace

Imported readObj(const fs::path& file, Progress* progress)
{
    FileBytes bytes = readBytes(file);
    const std::string name = file.string();
    if (bytes.size() == 0) throw Error(name, "is empty; export it again");
    ObjData data;
    bytes = plainText(std::move(bytes), name);
    parseObj(bytes, name, data, progress);
    bytes = {};
    Builder builder(data, name);
    Mesh mesh = builder.mesh();
    Imported out;
    MeshObject object;
    builder.materials(mesh, out.scene, file.parent_path(), object.materials);
    object.name = file.stem().string();
    object.base = std::move(mesh);
    Node node;
    node.name = object.name;
    node.mesh = out.scene.add(std::move(object));
    out.scene.add(std::move(node));
    out.warnings = data.findings.warnings();
    out.format = "OBJ";
    out.units = "unknown";
    data.stated.tell(out);
    return out;
}

}  // namespace mw
