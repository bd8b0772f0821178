#include "app/cli/value_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/table_file.h"
#include "core/io/file.h"
#include "core/io/height_picture.h"
#include "core/io/io.h"
#include "core/mesh/sample_curve.h"

namespace mw::cli {

namespace {

std::string endingOf(const std::string& file)
{
    std::string e = std::filesystem::path(file).extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

bool isTable(const std::string& file)
{
    const std::string e = endingOf(file);
    return e == ".csv" || e == ".json";
}

std::string exact(double v)
{
    if (!std::isfinite(v)) return {};
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, v).ptr};
}

std::string row(std::initializer_list<double> values)
{
    std::string line;
    for (const double v : values) line += (line.empty() ? "" : ",") + exact(v);
    return line;
}

std::string quoted(const std::string& s)
{
    if (s.find_first_of(",\"\r\n") == s.npos) return s;
    std::string out = "\"";
    for (char c : s) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

nlohmann::json json(const glm::dvec3& p)
{
    return {finite(p.x), finite(p.y), finite(p.z)};
}

nlohmann::json json(const glm::dquat& q)
{
    return {q.x, q.y, q.z, q.w};
}

nlohmann::json json(const Array<glm::dvec3>& points)
{
    nlohmann::json list = nlohmann::json::array();
    for (const glm::dvec3& p : points) list.push_back(json(p));
    return list;
}

nlohmann::json json(const Curve& c)
{
    return {{"closed", c.closed}, {"points", json(c.points)}, {"control", json(c.control)}};
}

nlohmann::json json(const Pose& p)
{
    const std::vector<glm::dvec3> places = jointPlaces(p);
    nlohmann::json joints = nlohmann::json::array(), targets = nlohmann::json::array();
    for (size_t i = 0; i < p.size(); ++i) {
        const Joint& j = p.skeleton->joints[i];
        joints.push_back({{"name", j.name},
                          {"parent", j.parent == none ? nlohmann::json() : nlohmann::json(j.parent)},
                          {"translation", json(p.locals[i].translation)},
                          {"rotation", json(p.locals[i].rotation)},
                          {"scale", json(p.locals[i].scale)},
                          {"place", json(places[i])}});
    }
    for (const PoseTarget& t : p.targets)
        targets.push_back({{"joint", t.joint}, {"at", json(t.at)}, {"distance", finite(glm::distance(places[t.joint], t.at))}});
    return {{"joints", joints}, {"targets", targets}};
}

nlohmann::json json(const Rotations& r)
{
    nlohmann::json paths = nlohmann::json::array();
    for (const Rotations::Path& p : r.paths) {
        nlohmann::json samples = nlohmann::json::array();
        for (const Rotations::Sample& s : p.samples) {
            nlohmann::json j = {{"t", s.t}, {"orientation", json(s.orientation)}};
            if (std::isfinite(s.euler.x)) j["euler"] = json(s.euler);
            samples.push_back(std::move(j));
        }
        paths.push_back({{"name", p.name}, {"samples", samples}});
    }
    return {{"from", json(r.from)}, {"to", json(r.to)}, {"paths", paths}};
}

std::string csv(const Curve& c)
{
    std::string out = "x,y,z\n";
    for (const glm::dvec3& p : c.points) out += row({p.x, p.y, p.z}) + "\n";
    return out;
}

std::string csv(const Pose& p)
{
    std::string out = "joint,name,parent,x,y,z,rotation_x,rotation_y,rotation_z,rotation_w\n";
    const std::vector<glm::dvec3> places = jointPlaces(p);
    for (size_t i = 0; i < p.size(); ++i) {
        const Joint& j = p.skeleton->joints[i];
        const glm::dquat& q = p.locals[i].rotation;
        out += std::to_string(i) + "," + quoted(j.name) + "," + (j.parent == none ? "" : std::to_string(j.parent)) + "," +
               row({places[i].x, places[i].y, places[i].z, q.x, q.y, q.z, q.w}) + "\n";
    }
    return out;
}

std::string csv(const Rotations& r)
{
    std::string out = "path,t,x,y,z,w,angle_x,angle_y,angle_z\n";
    for (const Rotations::Path& p : r.paths)
        for (const Rotations::Sample& s : p.samples) {
            const glm::dquat& q = s.orientation;
            out += std::string(p.name) + "," + row({s.t, q.x, q.y, q.z, q.w}) + "," + exact(s.euler.x) + "," + exact(s.euler.y) + "," +
                   exact(s.euler.z) + "\n";
        }
    return out;
}

template <class T>
void writeText(const std::string& file, const std::string& operation, Kind kind, const T& value)
{
    OutputFile out(file);
    if (endingOf(file) == ".csv") {
        out.write(csv(value));
    } else {
        nlohmann::json j = json(value);
        j["operation"] = operation;
        j["kind"] = kindName(kind);
        out.write(j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    }
    out.commit();
}

Scene terrainScene(const HeightMap& map, const std::string& operation)
{
    Scene scene;
    TerrainObject object;
    object.terrain.name = operation;
    object.terrain.map = map;
    Node node;
    node.name = operation;
    node.terrain = scene.add(std::move(object));
    scene.add(std::move(node));
    return scene;
}

Mesh linesOf(const Curve& c)
{
    Array<glm::vec3> places(c.points.begin(), c.points.end());
    Array<uint32_t> lines;
    const auto n = uint32_t(c.points.size());
    for (uint32_t i = 0; i + 1 < n; ++i) lines.insert(lines.end(), {i, i + 1});
    if (c.closed && n > 2) lines.insert(lines.end(), {n - 1, 0u});
    return Mesh(std::move(places), Array<uint32_t>{0u}, Array<uint32_t>{}).withLines(std::move(lines));
}

std::string poseSummary(const Pose& p)
{
    std::string text = counted(p.size(), "joint");
    const std::vector<glm::dvec3> places = jointPlaces(p);
    for (const PoseTarget& t : p.targets)
        text += ", \"" + p.skeleton->joints[t.joint].name + "\" " + shown(glm::distance(places[t.joint], t.at)) + " m from its target";
    return text;
}

}  // namespace

void checkValueFile(Kind kind, const std::string& file)
{
    const bool table = isTable(file);
    const std::string what = std::string("a ") + kindName(kind);
    switch (kind) {
        case Kind::Pose:
        case Kind::Rotations:
            if (!table) throw Error(file, what + " is written as .json or .csv; the verb ik puts a pose into a file of a character");
            return;
        case Kind::Table:
        case Kind::Selection:
            if (!table) throw Error(file, what + " is written as .csv or .json");
            return;
        case Kind::Mesh:
            if (table)
                throw Error(file,
                            "a mesh cannot be written as this; end with an operation that gives a table (as vertex-valence), or name a .glb, .obj or "
                            ".ply");
            return;
        case Kind::HeightMap:
            if (table) throw Error(file, "a height map is written as a picture (.png) or as the mesh of a terrain (.glb, .obj)");
            return;
        default:
            return;
    }
}

std::vector<Warning> writeValueFile(const std::string& file, const std::string& operation, const Value& value, Progress* progress)
{
    checkValueFile(kindOf(value), file);
    if (const auto* pose = std::get_if<Pose>(&value)) {
        writeText(file, operation, Kind::Pose, *pose);
    } else if (const auto* rotations = std::get_if<Rotations>(&value)) {
        writeText(file, operation, Kind::Rotations, *rotations);
    } else if (const auto* curve = std::get_if<Curve>(&value)) {
        if (!isTable(file)) return writeFile(sceneOf(linesOf(*curve), operation), file, {}, progress);
        writeText(file, operation, Kind::Curve, *curve);
    } else if (const auto* map = std::get_if<HeightMap>(&value)) {
        if (endingOf(file) == ".png") return writeHeightMap(*map, file, progress);
        return writeFile(terrainScene(*map, operation), file, {.project = true}, progress);
    } else if (const auto* mesh = std::get_if<Mesh>(&value)) {
        return writeFile(sceneOf(*mesh, operation), file, {}, progress);
    } else {
        writeTableFile(file, operation, {{operation, value}});
    }
    return {};
}

std::string summaryOf(const Value& value)
{
    if (const auto* m = std::get_if<Mesh>(&value)) return counted(m->vertexCount(), "vertex", "vertices") + ", " + counted(m->faceCount(), "face");
    if (const auto* p = std::get_if<Pose>(&value)) return poseSummary(*p);
    if (const auto* c = std::get_if<Curve>(&value)) return counted(c->points.size(), "point") + (c->closed ? ", closed" : ", open");
    if (const auto* h = std::get_if<HeightMap>(&value)) {
        const auto [low, high] = h->range();
        return std::to_string(h->width()) + " x " + std::to_string(h->height()) + " samples, heights " + shown(low) + " to " + shown(high);
    }
    if (const auto* r = std::get_if<Rotations>(&value)) {
        std::string text = counted(r->paths.size(), "path");
        for (const Rotations::Path& p : r->paths) text += ", " + std::string(p.name) + " of " + counted(p.samples.size(), "sample");
        return text;
    }
    return kindName(kindOf(value));
}

Curve readCurveFile(const std::string& file)
{
    constexpr uint64_t most = uint64_t(256) << 20;
    const FileBytes bytes = plainText(readBytes(file, most), file);
    std::string_view text = bytes.text();
    Curve c;
    for (size_t line = 1; !text.empty(); ++line) {
        const size_t end = text.find('\n');
        std::string words;
        for (const char ch : text.substr(0, end))
            if (!std::isspace(static_cast<unsigned char>(ch))) words += ch;
        text = end == text.npos ? std::string_view() : text.substr(end + 1);
        if (words.empty()) continue;
        try {
            for (const glm::dvec3& p : pointsIn(words)) c.points.push_back(p);
        } catch (const Error&) {
            if (line == 1 && std::isalpha(static_cast<unsigned char>(words[0]))) continue;  // titles of the columns
            throw Error(file, "line " + std::to_string(line) + " is not x,y or x,y,z with finite numbers");
        }
    }
    if (c.points.empty()) throw Error(file, "there is no point in it; write x,y or x,y,z, one point a line");
    return c;
}

}  // namespace mw::cli
