// URIs of a glTF: data: URIs, and relative files that must lie inside the folder of the glTF.
#include "core/io/base64.h"
#include "core/io/file.h"
#include "core/io/gltf_document.h"

namespace mw {

namespace {

int hexValue(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string percentDecoded(const std::string& s)
{
    std::string out;
    for (size_t i = 0; i < s.size(); ++i) {
        if (s[i] == '%' && i + 2 < s.size() && hexValue(s[i + 1]) >= 0 && hexValue(s[i + 2]) >= 0) {
            out += char(hexValue(s[i + 1]) * 16 + hexValue(s[i + 2]));
            i += 2;
        } else {
            out += s[i];
        }
    }
    return out;
}

std::string shortened(const std::string& s)
{
    return s.size() <= 80 ? s : s.substr(0, 77) + "...";
}

// "scheme:" at the start; a single letter would be a drive.
bool hasScheme(const std::string& s)
{
    const size_t colon = s.find(':');
    return colon != std::string::npos && s.find_first_of("/?#") > colon;
}

}  // namespace

std::filesystem::path fileOfUri(const std::string& uri, const std::filesystem::path& folder)
{
    const std::string name = percentDecoded(uri);
    const auto refuse = [&](const std::string& why) { throw Error("\"" + shortened(name) + "\" " + why); };
    if (folder.empty()) refuse("names a file, but this content may name none; embed it");
    if (name.empty() || name.find('\0') != std::string::npos) refuse("is no file name; the file is damaged");
    if (hasScheme(uri) || hasScheme(name)) refuse("is an address, only files beside the glTF are read; put the file there and name it relatively");
    const auto target = insideFolder(folder, name);
    if (target.empty()) refuse("lies outside the folder of the glTF; move it there and name it relatively");
    return target;
}

std::shared_ptr<const std::vector<uint8_t>> GltfDocument::resource(const JsonPlace& place)
{
    const std::string& uri = place.text();
    if (uri.starts_with("data:")) {
        const size_t comma = uri.find(',');
        if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
            place.fail("a data: URI without base64 data; the file is damaged");
        charge(uri.size(), place.pointer());
        auto bytes = decodedBase64(std::string_view(uri).substr(comma + 1));
        if (!bytes) place.fail("a data: URI with characters that are not base64; the file is damaged");
        return std::make_shared<const std::vector<uint8_t>>(std::move(*bytes));
    }
    std::filesystem::path file;
    try {
        file = fileOfUri(uri, folder_);
        std::shared_ptr<const std::vector<uint8_t>>& known = files_[file];
        if (!known) {
            const FileBytes bytes = readBytes(file);
            inputBytes_ += bytes.size();
            known = std::make_shared<const std::vector<uint8_t>>(bytes.begin(), bytes.end());
        }
        return known;
    } catch (const Error& e) {
        place.fail(e.what());
    }
}

}  // namespace mw
