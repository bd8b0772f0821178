#include "core/io/gltf_container.h"

#include <string>

namespace mw {

namespace {

constexpr uint32_t glbMagic = 0x46546C67, jsonChunk = 0x4E4F534A, binChunk = 0x004E4942;
constexpr size_t headerSize = 12, chunkHeaderSize = 8, deepest = 200;
constexpr const char* cut = "; the file is cut or damaged, get it again from its source";

uint32_t word(std::span<const uint8_t> b, size_t at)
{
    return uint32_t(b[at]) | uint32_t(b[at + 1]) << 8 | uint32_t(b[at + 2]) << 16 | uint32_t(b[at + 3]) << 24;
}

// Before the parser allocates anything: nesting, and how many values there are.
size_t jsonCost(std::span<const uint8_t> text)
{
    size_t depth = 0, values = 1;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const uint8_t c = text[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
            continue;
        }
        switch (c) {
            case '"':
                inString = true;
                break;
            case '[':
            case '{':
                ++values;
                if (++depth > deepest)
                    throw Error("JSON, byte " + std::to_string(i) + ": nested more than " + std::to_string(deepest) + " deep" + cut);
                break;
            case ']':
            case '}':
                depth -= depth > 0;
                break;
            case ',':
                ++values;
                break;
            default:
                break;
        }
    }
    return 64 * values + text.size();
}

void parseJson(GltfContainer& out, std::span<const uint8_t> text, size_t fileSize)
{
    out.jsonCost = jsonCost(text);
    if (out.jsonCost > gltfBudget(fileSize)) throw Error("the JSON holds more values than a glTF of this size can mean" + std::string(cut));
    try {
        out.root = nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::parse_error& e) {
        throw Error("JSON, byte " + std::to_string(e.byte) + ": it cannot be read here" + cut);
    } catch (const nlohmann::json::exception&) {
        throw Error("JSON: a number in it is too large" + std::string(cut));
    }
    if (!out.root.is_object()) throw Error("the JSON is no object, so this is no glTF; choose another file");
}

void readGlb(GltfContainer& out, std::span<const uint8_t> content)
{
    if (content.size() < headerSize + chunkHeaderSize) throw Error("the GLB header is incomplete" + std::string(cut));
    if (const uint32_t version = word(content, 4); version != 2)
        throw Error("GLB version " + std::to_string(version) + "; only version 2 can be read, export it again as glTF 2.0");
    const size_t length = word(content, 8);
    if (length > content.size())
        throw Error("the GLB header says " + std::to_string(length) + " bytes, there are " + std::to_string(content.size()) + cut);
    if (length < content.size())
        out.warnings.push_back({"trailing-bytes", std::to_string(content.size() - length) + " bytes after the end of the GLB were ignored", {}});
    bool hasJson = false;
    for (size_t at = headerSize; at + chunkHeaderSize <= length;) {
        const size_t size = word(content, at), type = word(content, at + 4);
        at += chunkHeaderSize;
        if (size > length - at)
            throw Error("byte " + std::to_string(at) + ": a GLB chunk of " + std::to_string(size) + " bytes, but only " +
                        std::to_string(length - at) + " follow" + cut);
        const auto chunk = content.subspan(at, size);
        if (!hasJson && type != jsonChunk) throw Error("the first GLB chunk is not JSON" + std::string(cut));
        if (!hasJson) {
            parseJson(out, chunk, content.size());
            hasJson = true;
        } else if (type == binChunk && !out.hasBin) {
            out.bin = chunk;
            out.hasBin = true;
        }
        at += size;
    }
    if (!hasJson) throw Error("the GLB has no JSON chunk" + std::string(cut));
}

void append(std::vector<uint8_t>& out, uint32_t x)
{
    for (int i = 0; i < 4; ++i) out.push_back(uint8_t(x >> (8 * i)));
}

}  // namespace

GltfContainer gltfContainer(std::span<const uint8_t> content)
{
    GltfContainer out;
    if (content.empty()) throw Error("the file is empty; choose another one");
    if (content.size() >= 4 && word(content, 0) == glbMagic) {
        out.binary = true;
        readGlb(out, content);
    } else {
        parseJson(out, content, content.size());
    }
    return out;
}

std::vector<uint8_t> glbContent(const std::string& json, std::span<const uint8_t> bin)
{
    const size_t jsonSize = (json.size() + 3) & ~size_t(3), binSize = (bin.size() + 3) & ~size_t(3);
    const size_t total = headerSize + chunkHeaderSize + jsonSize + (bin.empty() ? 0 : chunkHeaderSize + binSize);
    if (total > 0xFFFFFFFFu) throw Error("the content takes more than the 4 GiB a GLB can hold; simplify it or write .gltf");
    std::vector<uint8_t> out;
    out.reserve(total);
    for (uint32_t x : {glbMagic, 2u, uint32_t(total), uint32_t(jsonSize), jsonChunk}) append(out, x);
    out.insert(out.end(), json.begin(), json.end());
    out.resize(headerSize + chunkHeaderSize + jsonSize, ' ');
    if (!bin.empty()) {
        append(out, uint32_t(binSize));
        append(out, binChunk);
        out.insert(out.end(), bin.begin(), bin.end());
        out.resize(total, 0);
    }
    return out;
}

}  // namespace mw
