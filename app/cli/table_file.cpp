#include "app/cli/table_file.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "core/io/file.h"

namespace mw::cli {

namespace {

const char* elementName(ElementKind k)
{
    static constexpr const char* all[] = {"object", "vertex", "edge", "face", "corner", "point", "segment", "joint", "cell"};
    return all[size_t(k)];
}

// All digits that are needed to read the same number again.
std::string exact(double v)
{
    if (!std::isfinite(v)) return {};
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, v).ptr};
}

std::string quoted(const std::string& s)
{
    if (s.find_first_of(",\"\r\n") == s.npos) return s;
    std::string out = "\"";
    for (char c : s) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

size_t rowCount(const Table& t)
{
    return t.columns.empty() ? 0 : t.columns[0].values.size();
}

// A selection is a table of one row an element and no further columns.
std::string selectionRow(const ElementSet& s, size_t i)
{
    if (s.kind != ElementKind::Edge) return std::to_string(s.indices[i]);
    return std::to_string(s.indices[2 * i]) + "," + std::to_string(s.indices[2 * i + 1]);
}

std::string header(const Value& v)
{
    const auto* t = std::get_if<Table>(&v);
    const ElementKind kind = t ? t->rows : std::get<ElementSet>(v).kind;
    std::string line = kind == ElementKind::Edge ? "vertex_a,vertex_b" : kind == ElementKind::Object ? "row" : elementName(kind);
    if (t)
        for (const Column& c : t->columns) line += "," + quoted(c.unit.empty() ? c.name : c.name + " [" + c.unit + "]");
    return line;
}

void writeCsv(OutputFile& out, const std::vector<NamedResult>& results)
{
    const bool several = results.size() > 1;
    out.write((several ? "mesh," : "") + header(results.at(0).value) + "\n");
    for (const NamedResult& r : results) {
        const std::string first = several ? quoted(r.mesh) + "," : "";
        if (const auto* s = std::get_if<ElementSet>(&r.value)) {
            const size_t n = s->kind == ElementKind::Edge ? s->indices.size() / 2 : s->indices.size();
            for (size_t i = 0; i < n; ++i) out.write(first + selectionRow(*s, i) + "\n");
            continue;
        }
        const Table& t = std::get<Table>(r.value);
        for (size_t i = 0; i < rowCount(t); ++i) {
            std::string line = first;
            if (t.rows == ElementKind::Edge)
                line += std::to_string(t.edges[2 * i]) + "," + std::to_string(t.edges[2 * i + 1]);
            else
                line += std::to_string(i);
            for (const Column& c : t.columns) line += "," + exact(c.values[i]);
            out.write(line + "\n");
        }
    }
}

nlohmann::json tableJson(const Table& t)
{
    nlohmann::json columns = nlohmann::json::array(), summary = nlohmann::json::object(), lists = nlohmann::json::object();
    for (const Column& c : t.columns) columns.push_back({{"name", c.name}, {"unit", c.unit}, {"categorical", c.categorical}, {"values", c.values}});
    for (const auto& [name, value] : t.summary) summary[name] = finite(value);
    for (const auto& [name, indices] : t.lists) lists[name] = indices;
    nlohmann::json j = {{"rows", elementName(t.rows)}, {"columns", columns}, {"summary", summary}, {"lists", lists}};
    if (t.rows == ElementKind::Edge) j["edges"] = t.edges;
    return j;
}

void writeJson(OutputFile& out, const std::string& operation, const std::vector<NamedResult>& results)
{
    nlohmann::json all = nlohmann::json::array();
    for (const NamedResult& r : results) {
        nlohmann::json j;
        if (const auto* s = std::get_if<ElementSet>(&r.value))
            j = {{"rows", elementName(s->kind)}, {"indices", s->indices}};
        else
            j = tableJson(std::get<Table>(r.value));
        j["mesh"] = r.mesh;
        all.push_back(std::move(j));
    }
    const nlohmann::json whole = {{"operation", operation}, {"results", all}};
    out.write(whole.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace

void writeTableFile(const std::string& file, const std::string& operation, const std::vector<NamedResult>& results)
{
    OutputFile out(file);
    if (std::filesystem::path(file).extension() == ".csv" || std::filesystem::path(file).extension() == ".CSV")
        writeCsv(out, results);
    else
        writeJson(out, operation, results);
    out.commit();
}

}  // namespace mw::cli
