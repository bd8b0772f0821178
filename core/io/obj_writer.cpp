// OBJ, MTL and pictures out: all files are written beside their targets first, then put in place one after the other, the OBJ last.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <list>
#include <set>
#include <unordered_map>

#include "core/io/mtl.h"
#include "core/io/obj.h"
#include "core/io/placement.h"
#include "core/io/text.h"
#include "core/io/text_out.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

/// Each different value once, and its number for every corner.
struct Distinct {
    std::vector<uint32_t> first;  // element of `a` that has it
    Array<uint32_t> number;       // by corner
};

template <int K>
Distinct distinctRows(const Mesh& mesh, const Attribute& a)
{
    using Row = std::array<float, K>;
    struct Hash {
        size_t operator()(const std::array<uint32_t, K>& r) const
        {
            uint64_t h = 0x9e3779b97f4a7c15u;
            for (uint32_t v : r) h = (h ^ v) * 0xff51afd7ed558ccdu, h ^= h >> 32;
            return size_t(h);
        }
    };
    std::unordered_map<std::array<uint32_t, K>, uint32_t, Hash> seen;
    Distinct d;
    d.number.resize(mesh.cornerCount());
    const std::span<const float> values = a.floats();
    for (size_t c = 0; c < mesh.cornerCount(); ++c) {
        const size_t e = a.domain == Domain::Corner ? c : mesh.cornerVertex()[c];
        Row row;
        for (size_t k = 0; k < K; ++k) row[k] = values[e * K + k];
        const auto [i, fresh] = seen.try_emplace(std::bit_cast<std::array<uint32_t, K>>(row), uint32_t(d.first.size()));
        if (fresh) d.first.push_back(uint32_t(e));
        d.number[c] = i->second;
    }
    return d;
}

/// A name that survives: no line ends, no blanks at its ends, not empty.
std::string lineName(std::string_view name, const char* otherwise)
{
    std::string n(trimmed(name));
    std::replace_if(
        n.begin(), n.end(), [](char c) { return uint8_t(c) < ' '; }, ' ');
    return n.empty() ? otherwise : n;
}

class Writer {
public:
    Writer(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
        : scene_(scene),
          file_(file),
          options_(options),
          progress_(progress),
          flat_(flattened(scene, progress, options.placement, options.evaluator)),
          mesh_(flat_.mesh)
    {}
    std::vector<Warning> run();

private:
    void chooseAttributes();
    void nameMaterials();
    void writePictures();
    std::string pictureName(const Image& image);
    void writeLibrary();
    void writeObjFile();
    void vertices(TextOut& out);
    void rows(TextOut& out, const char* keyword, const Attribute& a, const Distinct& d);
    void faces(OutputFile& file, TextOut& out);
    void points(TextOut& out);
    const Attribute* usable(std::string_view name, int components) const;
    const Attribute* vertexColors();
    void lost();

    const Scene& scene_;
    const fs::path& file_;
    const WriteOptions& options_;
    Progress* progress_;
    Flattened flat_;
    const Mesh& mesh_;
    const Attribute *texcoord_ = nullptr, *normal_ = nullptr;
    Attribute spreadColor_;
    const Attribute* color_ = nullptr;
    std::vector<const Material*> materials_;
    std::vector<std::string> materialNames_;
    std::map<ImageId, std::string> pictures_;
    std::set<std::string> pictureNames_;
    std::list<OutputFile> files_;
    std::vector<Warning> warnings_;
};

const Attribute* Writer::usable(std::string_view name, int components) const
{
    for (Domain d : {Domain::Corner, Domain::Vertex})
        if (const Attribute* a = mesh_.find(name, d); a && a->components == components && !a->floats().empty()) return a;
    return nullptr;
}

/// Colours of the vertices; those of corners when all corners of a vertex agree.
const Attribute* Writer::vertexColors()
{
    for (const Attribute& a : mesh_.attributes())
        if (a.name == names::color && a.domain == Domain::Vertex && (a.components == 3 || a.components == 4) && !a.floats().empty()) return &a;
    const Attribute* a = mesh_.find(names::color, Domain::Corner);
    if (!a || (a->components != 3 && a->components != 4) || a->floats().empty()) return nullptr;
    const size_t k = size_t(a->components);
    Array<float> values(k * mesh_.vertexCount(), 1.f);
    std::vector<bool> set(mesh_.vertexCount());
    for (size_t c = 0; c < mesh_.cornerCount(); ++c) {
        const uint32_t v = mesh_.cornerVertex()[c];
        const float* from = a->floats().data() + c * k;
        if (set[v] && std::memcmp(&values[v * k], from, k * sizeof(float)) != 0) return nullptr;
        std::copy_n(from, k, &values[v * k]);
        set[v] = true;
    }
    spreadColor_ = floatAttribute(std::string(names::color), Domain::Vertex, a->components, std::move(values));
    return &spreadColor_;
}

void Writer::chooseAttributes()
{
    texcoord_ = usable(names::texcoord, 2);
    normal_ = usable(names::normal, 3);
    color_ = vertexColors();
}

void Writer::lost()
{
    std::string list;
    for (const Attribute& a : mesh_.attributes()) {
        const bool kept = &a == texcoord_ || &a == normal_ || &a == color_ || (a.name == names::color && color_) ||
                          (a.domain == Domain::Face && (a.name == names::material || a.name == names::group));
        if (!kept) list += (list.empty() ? "" : ", ") + a.name;
    }
    if (!list.empty()) warnings_.push_back({"attribute-lost", "OBJ has no place for the attributes " + list + "; PLY and glTF have", {}});
}

void Writer::nameMaterials()
{
    std::set<std::string> used;
    for (MaterialId id : flat_.materials) {
        static const Material grey = [] {
            Material m;
            m.name = "default";
            return m;
        }();
        const Material* m = scene_.find(id);
        materials_.push_back(m ? m : &grey);
        const std::string base = lineName(materials_.back()->name, "material");
        std::string name = base;
        for (int i = 2; !used.insert(name).second; ++i) name = base + "_" + std::to_string(i);
        materialNames_.push_back(std::move(name));
    }
}

/// A file name in the target's folder that is free, or holds this very picture.
std::string Writer::pictureName(const Image& image)
{
    const std::string ending = image.mimeType == "image/jpeg" ? ".jpg" : ".png";
    std::string stem = fs::path(lineName(image.name, "picture")).filename().stem().string();
    for (char& c : stem)
        if (uint8_t(c) <= ' ' || std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos) c = '_';
    if (stem.empty() || stem[0] == '.' || stem[0] == '-') stem = "picture" + stem;
    const auto same = [&](const fs::path& path) {
        std::error_code e;
        if (!fs::exists(path, e)) return true;
        if (!fs::is_regular_file(path, e) || fs::file_size(path, e) != image.bytes->size()) return false;
        const FileBytes bytes = readBytes(path);
        return std::memcmp(bytes.data(), image.bytes->data(), bytes.size()) == 0;
    };
    for (int i = 1;; ++i) {
        const std::string name = (i == 1 ? stem : stem + "_" + std::to_string(i)) + ending;
        if (!pictureNames_.contains(name) && same(file_.parent_path() / name)) return name;
    }
}

void Writer::writePictures()
{
    for (const Material* m : materials_)
        for (const Material::Texture* t : {&m->baseColorTexture, &m->emissiveTexture, &m->normalTexture}) {
            const Image* image = scene_.find(t->image);
            if (!image || !image->bytes || pictures_.contains(t->image)) continue;
            const std::string name = pictureName(*image);
            pictureNames_.insert(name);
            pictures_[t->image] = name;
            files_.emplace_back(file_.parent_path() / name).write(image->bytes->data(), image->bytes->size());
        }
}

void Writer::writeLibrary()
{
    files_.emplace_back(fs::path(file_).replace_extension(".mtl")).write(mtlText(materials_, materialNames_, pictures_, warnings_));
}

void Writer::vertices(TextOut& out)
{
    const size_t k = color_ ? size_t(color_->components) : 0;
    for (size_t v = 0; v < mesh_.vertexCount(); ++v) {
        const glm::vec3& p = mesh_.positions()[v];
        out.begin(7);
        out.put('v');
        for (int i = 0; i < 3; ++i) {
            out.put(' ');
            out.number(p[i]);
        }
        for (size_t i = 0; i < k; ++i) {
            out.put(' ');
            out.number(color_->floats()[v * k + i]);
        }
        out.end();
        if (progress_ && (v & 0xffff) == 0) progress_->at(0.4f * float(v) / float(mesh_.vertexCount()));
    }
}

void Writer::rows(TextOut& out, const char* keyword, const Attribute& a, const Distinct& d)
{
    for (uint32_t e : d.first) {
        out.begin(3);
        out.word(keyword);
        for (int k = 0; k < a.components; ++k) {
            out.put(' ');
            out.number(a.floats()[e * size_t(a.components) + size_t(k)]);
        }
        out.end();
    }
}

void Writer::faces(OutputFile& file, TextOut& out)
{
    const Distinct t = texcoord_ ? distinctRows<2>(mesh_, *texcoord_) : Distinct();
    const Distinct n = normal_ ? distinctRows<3>(mesh_, *normal_) : Distinct();
    if (texcoord_) rows(out, "vt", *texcoord_, t);
    if (normal_) rows(out, "vn", *normal_, n);
    const Attribute *group = mesh_.find(names::group, Domain::Face), *material = mesh_.find(names::material, Domain::Face);
    const std::span<const int32_t> groups = group ? group->integers() : std::span<const int32_t>();
    const std::span<const int32_t> slots = material ? material->integers() : std::span<const int32_t>();
    int64_t lastGroup = -1, lastSlot = -1;
    for (size_t f = 0; f < mesh_.faceCount(); ++f) {
        if (!groups.empty() && groups[f] != lastGroup) {
            lastGroup = groups[f];
            const bool named = lastGroup >= 0 && size_t(lastGroup) < mesh_.groupNames().size();
            file.write("g " + lineName(named ? mesh_.groupNames()[size_t(lastGroup)] : "", "default") + "\n");
        }
        const int64_t slot = slots.empty() ? 0 : slots[f];
        if (!materials_.empty() && slot != lastSlot) {
            lastSlot = slot;
            file.write("usemtl " + materialNames_[slot >= 0 && size_t(slot) < materialNames_.size() ? size_t(slot) : 0] + "\n");
        }
        out.begin(1);
        out.put('f');
        for (uint32_t c = mesh_.faceStart()[f]; c < mesh_.faceStart()[f + 1]; ++c) {
            if ((c - mesh_.faceStart()[f]) % 1024 == 0) out.more(3 * 1024);
            out.put(' ');
            out.number(mesh_.cornerVertex()[c] + 1);
            if (texcoord_ || normal_) out.put('/');
            if (texcoord_) out.number(t.number[c] + 1);
            if (normal_) {
                out.put('/');
                out.number(n.number[c] + 1);
            }
        }
        out.end();
        if (progress_ && (f & 0xffff) == 0) progress_->at(0.4f + 0.6f * float(f) / float(mesh_.faceCount()));
    }
}

void Writer::writeObjFile()
{
    OutputFile& file = files_.emplace_back(file_);
    TextOut out(file);
    file.write("# Meshwright\n# " + statement(options_.placement) + "\n");
    if (!materials_.empty()) file.write("mtllib " + fs::path(file_).replace_extension(".mtl").filename().string() + "\n");
    vertices(out);
    faces(file, out);
    for (size_t i = 0; i + 1 < mesh_.lines().size(); i += 2) {
        out.begin(2);
        out.word("l ");
        out.number(mesh_.lines()[i] + 1);
        out.put(' ');
        out.number(mesh_.lines()[i + 1] + 1);
        out.end();
    }
    points(out);
}

/// Vertices that no face and no line uses: without a word of their own many programs drop them.
void Writer::points(TextOut& out)
{
    std::vector<bool> used(mesh_.vertexCount());
    for (uint32_t v : mesh_.cornerVertex()) used[v] = true;
    for (uint32_t v : mesh_.lines()) used[v] = true;
    for (uint32_t v = 0; v < used.size(); ++v) {
        if (used[v]) continue;
        out.begin(1);
        out.word("p ");
        out.number(v + 1);
        out.end();
    }
}

std::vector<Warning> Writer::run()
{
    if (mesh_.vertexCount() == 0) throw Error(file_.string(), "there is no visible mesh to write");
    chooseAttributes();
    lost();
    nameMaterials();
    writePictures();
    if (!materials_.empty()) writeLibrary();
    writeObjFile();
    for (OutputFile& f : files_) f.close();
    for (OutputFile& f : files_) f.commit();
    return std::move(warnings_);
}

}  // namespace

std::vector<Warning> writeObj(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
{
    return Writer(scene, file, options, progress).run();
}

}  // namespace mw
