#include "core/io/mtl.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/io/file.h"
#include "core/io/text.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

constexpr uint64_t largestLibraries = uint64_t(16) << 20;  ///< of one file, together
constexpr uint64_t largestPictures = uint64_t(160) << 20;  ///< of one file, together
constexpr size_t mostMaterials = 4096, mostKept = 64, longestKept = 1000;
constexpr size_t mostLookups = 10000;  ///< of files by name: each costs system calls

constexpr Finding libraryFinding{"missing-material-library", "material library cannot be read; materials are grey",
                                 "material libraries cannot be read; materials are grey"};
constexpr Finding outsideFinding{"outside-folder", "file named outside the model's folder: not read; put it beside the model",
                                 "files named outside the model's folder: not read; put them beside the model"};
constexpr Finding pictureFinding{"missing-texture", "picture cannot be read", "pictures cannot be read"};
constexpr Finding kindFinding{"texture-format", "picture is neither PNG nor JPEG: left out; convert it",
                              "pictures are neither PNG nor JPEG: left out; convert them"};
constexpr Finding sizeFinding{"texture-size", "picture is left out: all together would exceed 160 MB",
                              "pictures are left out: all together would exceed 160 MB"};
constexpr Finding manyFinding{"many-materials", "material beyond the first 4096: left out", "materials beyond the first 4096: left out"};

/// Up to `most` numbers of a text; the rest stays as it was.
int numbersOf(std::string_view text, double* to, int most)
{
    std::string buffer(text.substr(0, 256));  // a line may be long
    buffer.append(textPadding, '\0');         // as text.h wants it
    const char* p = buffer.c_str();
    int n = 0;
    while (n < most) {
        while (*p && endsToken(*p)) ++p;
        double v = 0;
        if (!parseNumber(p, v) || !std::isfinite(v)) break;
        to[n++] = v;
    }
    return n;
}

/// The name behind the options of a texture line ("-s 1 1 1 -bm 0.5 name with blanks.png"). `options` is told each.
template <class Option>
std::string_view textureName(std::string_view rest, Option&& option)
{
    while (rest.starts_with('-')) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
        std::string_view after = trimmed(rest.substr(word.size()));
        const std::string_view values = after;
        const bool one = word == "-blendu" || word == "-blendv" || word == "-boost" || word == "-texres" || word == "-clamp" || word == "-bm" ||
                         word == "-imfchan" || word == "-type" || word == "-cc";
        const bool range = word == "-mm";
        const bool upToThree = word == "-o" || word == "-s" || word == "-t";
        if (!one && !range && !upToThree) break;
        for (int i = 0; i < (one ? 1 : range ? 2 : 3); ++i) {
            const std::string_view value = after.substr(0, after.find_first_of(" \t"));
            double number = 0;
            if (!one && numbersOf(value, &number, 1) == 0) break;
            after = trimmed(after.substr(value.size()));
        }
        option(word, values);
        rest = after;
    }
    return rest;
}

std::string lower(std::string_view s)
{
    std::string l(s);
    std::transform(l.begin(), l.end(), l.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return l;
}

std::string_view pictureKind(std::string_view start)
{
    if (start.starts_with("\x89PNG")) return "image/png";
    if (start.starts_with("\xff\xd8\xff")) return "image/jpeg";
    return {};
}

}  // namespace

void MtlReader::readLibraries(const std::string& names)
{
    if (names.empty() || readLibrary(names)) return;
    bool any = false;
    if (names.find_first_of(" \t") != names.npos)
        for (std::string_view left = names; !left.empty() && left.size() < 4096;) {
            const std::string_view name = left.substr(0, left.find_first_of(" \t"));
            any = readLibrary(std::string(name)) || any;
            left = trimmed(left.substr(name.size()));
        }
    if (!any) findings_.add(insideFolder(folder_, names).empty() ? outsideFinding : libraryFinding, [&] { return inQuotes(names); });
}

/// The file of that name in the folder, or empty. After ten thousand of them nothing is found any more.
fs::path MtlReader::lookUp(const std::string& name)
{
    if (++lookups_ > mostLookups) return {};
    const fs::path path = insideFolder(folder_, name);
    std::error_code e;
    return fs::is_regular_file(path, e) ? path : fs::path();
}

bool MtlReader::readLibrary(const std::string& name)
{
    const fs::path path = lookUp(name);
    if (path.empty()) return false;
    if (!libraries_.insert(path).second) return true;
    try {
        const FileBytes bytes = readBytes(path, largestLibraries - libraryBytes_);
        libraryBytes_ += bytes.size();
        readLines(bytes.text());
    } catch (const Error&) {
        return false;
    }
    return true;
}

void MtlReader::readLines(std::string_view all)
{
    current_ = nullptr;
    while (!all.empty()) {
        const size_t end = all.find('\n');
        const std::string_view text = trimmed(all.substr(0, end));
        all.remove_prefix(end == all.npos ? all.size() : end + 1);
        if (text.empty() || text[0] == '#') continue;
        const std::string_view keyword = text.substr(0, text.find_first_of(" \t"));
        const std::string_view rest = trimmed(text.substr(keyword.size()));
        if (keyword != "newmtl") {
            if (current_) line(*current_, keyword, rest);
            continue;
        }
        finish();
        if (materials_.size() == mostMaterials) {
            findings_.add(manyFinding);
            return;
        }
        current_ = &materials_[std::string(rest)];
        *current_ = Material{};
        current_->name = rest;
        roughnessGiven_ = false;
    }
    finish();
}

/// The present material is whole.
void MtlReader::finish()
{
    if (current_ && !kept_.empty()) current_->extras = nlohmann::json{{"mtl", kept_}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    kept_.clear();
    current_ = nullptr;
}

void MtlReader::line(Material& m, std::string_view keyword, std::string_view rest)
{
    double v[3] = {0, 0, 0};
    const int n = numbersOf(rest, v, 3);
    const auto one = [&] { return n > 0 ? std::clamp(v[0], 0.0, 1.0) : 1.0; };
    const auto rgb = [&] { return n == 1 ? glm::dvec3(v[0]) : glm::dvec3(v[0], v[1], v[2]); };
    if (keyword == "Kd" && n > 0) {
        m.baseColor = glm::dvec4(glm::clamp(rgb(), 0.0, 1.0), m.baseColor.a);
    } else if (keyword == "d" || keyword == "Tr") {
        m.baseColor.a = keyword == "d" ? one() : 1 - one();
        if (m.baseColor.a < 1) m.alpha = Material::Alpha::Blend;
    } else if (keyword == "Ke" && n > 0) {
        m.emissive = glm::max(rgb(), 0.0);
    } else if (keyword == "Pr" && n > 0) {
        m.roughness = one();
        roughnessGiven_ = true;
    } else if (keyword == "Pm" && n > 0) {
        m.metallic = one();
    } else if (!texture(m, keyword, rest)) {
        if (keyword == "Ns" && n > 0 && !roughnessGiven_) m.roughness = std::clamp(std::sqrt(2 / (std::max(v[0], 0.0) + 2)), 0.0, 1.0);
        if (kept_.size() < mostKept && rest.size() < longestKept) kept_.push_back(std::string(keyword) + " " + std::string(rest));
    }
}

/// True when it is a texture line that has a place in Material.
bool MtlReader::texture(Material& m, std::string_view keyword, std::string_view rest)
{
    const std::string k = lower(keyword);
    Material::Texture* to = k == "map_kd"                                     ? &m.baseColorTexture
                            : k == "map_ke"                                   ? &m.emissiveTexture
                            : k == "norm" || k == "map_bump" || k == "map_kn" ? &m.normalTexture
                                                                              : nullptr;
    if (k == "bump") to = &m.normalTexture;
    if (!to || (to == &m.normalTexture && to->image)) return false;
    if (to == &m.normalTexture && k != "norm" && k != "map_kn") {
        // Only a normal map can be shown; a height map would light wrongly.
        const std::string name = lower(rest);
        if (name.find("normal") == name.npos && name.find("nrm") == name.npos && name.find("_n.") == name.npos) return false;
    }
    Material::Texture t;
    const std::string_view name = textureName(rest, [&](std::string_view option, std::string_view value) {
        double scale = 1;
        if (option == "-clamp") t.repeat = !value.starts_with("on");
        if (option == "-bm" && numbersOf(value, &scale, 1)) m.normalScale = scale;
    });
    t.image = image(std::string(name));
    if (!t.image) return false;
    *to = t;
    if (to == &m.baseColorTexture && m.baseColor == glm::dvec4(0, 0, 0, m.baseColor.a)) m.baseColor = glm::dvec4(1, 1, 1, m.baseColor.a);
    return true;
}

ImageId MtlReader::image(const std::string& name)
{
    fs::path path = lookUp(name);
    if (path.empty()) {
        // Paths of the machine it was made on: the picture often lies beside the model.
        const size_t slash = name.find_last_of("/\\");
        if (slash != name.npos) path = lookUp(name.substr(slash + 1));
        if (path.empty()) {
            findings_.add(lookups_ <= mostLookups && insideFolder(folder_, name).empty() ? outsideFinding : pictureFinding,
                          [&] { return inQuotes(name); });
            return {};
        }
    }
    if (auto known = images_.find(path); known != images_.end()) return known->second;
    ImageId& id = images_[path];
    try {
        const std::string_view kind = pictureKind(readStart(path, 16));
        std::error_code e;
        const uint64_t size = fs::file_size(path, e);
        if (kind.empty()) {
            findings_.add(kindFinding, [&] { return inQuotes(name); });
        } else if (e || imageBytes_ + size > largestPictures) {
            findings_.add(sizeFinding, [&] { return inQuotes(name); });
        } else {
            const FileBytes bytes = readBytes(path, largestPictures);
            imageBytes_ += bytes.size();
            id = scene_.add(
                Image{path.filename().string(), std::string(kind), std::make_shared<const std::vector<uint8_t>>(bytes.begin(), bytes.end())});
        }
    } catch (const Error& error) {
        findings_.add(pictureFinding, [&] { return std::string(error.what()); });
    }
    return id;
}

namespace {

std::string numberText(double v)
{
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, v);
    return {buffer, end};
}

std::string line(const char* keyword, std::initializer_list<double> values)
{
    std::string text = keyword;
    for (double v : values) text += " " + numberText(v);
    return text + "\n";
}

/// The lines an MTL file gave that a Material has no place for.
std::vector<std::string> keptLines(const Material& m)
{
    const nlohmann::json extras = nlohmann::json::parse(m.extras, nullptr, false);
    std::vector<std::string> lines;
    if (extras.is_object() && extras.contains("mtl") && extras["mtl"].is_array())
        for (const auto& l : extras["mtl"])
            if (l.is_string() && l.get_ref<const std::string&>().find_first_of("\r\n") == std::string::npos) lines.push_back(l);
    return lines;
}

}  // namespace

std::string mtlText(const std::vector<const Material*>& materials, const std::vector<std::string>& names,
                    const std::map<ImageId, std::string>& pictureName, std::vector<Warning>& warnings)
{
    std::string text = "# Meshwright\n";
    size_t lost = 0;
    for (size_t i = 0; i < materials.size(); ++i) {
        const Material& m = *materials[i];
        text += "\nnewmtl " + names[i] + "\n";
        text += line("Kd", {m.baseColor.r, m.baseColor.g, m.baseColor.b}) + line("d", {m.baseColor.a});
        if (m.emissive != glm::dvec3(0)) text += line("Ke", {m.emissive.r, m.emissive.g, m.emissive.b});
        bool exponent = false;
        for (const std::string& kept : keptLines(m)) {
            text += kept + "\n";
            exponent = exponent || kept.starts_with("Ns ");
        }
        // A roughness of 0.6 and an exponent that was read say the same to a reader as the file did.
        if (!exponent) text += line("Ns", {std::clamp(2 / std::max(m.roughness * m.roughness, 1e-6) - 2, 0.0, 1000.0)});
        text += line("Pr", {m.roughness}) + line("Pm", {m.metallic});
        const auto map = [&](const char* keyword, const Material::Texture& t) {
            const auto name = pictureName.find(t.image);
            if (t.image && name != pictureName.end()) text += std::string(keyword) + (t.repeat ? " " : " -clamp on ") + name->second + "\n";
            lost += t.image && t.set != 0;
        };
        map("map_Kd", m.baseColorTexture);
        map("map_Ke", m.emissiveTexture);
        map("norm", m.normalTexture);
        lost += bool(m.metallicRoughnessTexture.image) + bool(m.occlusionTexture.image) + (m.alpha == Material::Alpha::Mask) + m.doubleSided;
    }
    if (lost)
        warnings.push_back({"material-reduced",
                            std::to_string(lost) +
                                " material properties that MTL cannot hold (packed textures, further coordinate sets, cut-out alpha, two-sidedness)",
                            {}});
    return text;
}

}  // namespace mw
