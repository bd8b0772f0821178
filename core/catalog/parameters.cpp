#include "core/catalog/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace mw {

namespace {

std::string shortest(double v)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, v).ptr;
    return {text, end};
}

std::string listed(const std::vector<std::string>& words)
{
    std::string all;
    for (const std::string& w : words) all += (all.empty() ? "" : ", ") + w;
    return all;
}

[[noreturn]] void refuse(const Parameter& p, const std::string& given, const std::string& wanted)
{
    throw Error("parameter " + p.name + "=" + given + ": " + wanted);
}

std::string rangeText(const Parameter& p)
{
    const std::string unit = p.about.unit.empty() ? "" : " " + p.about.unit;
    const bool low = std::isfinite(p.about.min), high = std::isfinite(p.about.max);
    if (low && high) return "must be " + shortest(p.about.min) + " to " + shortest(p.about.max) + unit;
    if (low) return "must be at least " + shortest(p.about.min) + unit;
    if (high) return "must be at most " + shortest(p.about.max) + unit;
    return "must be a finite number";
}

void checkRange(const Parameter& p, double v)
{
    if (!std::isfinite(v) || v < p.about.min || v > p.about.max) refuse(p, shortest(v), rangeText(p));
}

// A value of the parameter's own type, or null when `given` is of quite another one.
std::optional<ParameterValue> converted(ParameterType type, const ParameterValue& given)
{
    const bool whole = std::holds_alternative<double>(given) && std::abs(std::get<double>(given)) < 9e15 &&
                       std::floor(std::get<double>(given)) == std::get<double>(given);
    switch (type) {
        case ParameterType::Flag:
            return std::holds_alternative<bool>(given) ? std::optional(given) : std::nullopt;
        case ParameterType::Integer:
            if (std::holds_alternative<int64_t>(given)) return given;
            return whole ? std::optional<ParameterValue>(int64_t(std::get<double>(given))) : std::nullopt;
        case ParameterType::Number:
            if (std::holds_alternative<double>(given)) return given;
            return std::holds_alternative<int64_t>(given) ? std::optional<ParameterValue>(double(std::get<int64_t>(given))) : std::nullopt;
        case ParameterType::Point:
            return std::holds_alternative<glm::dvec3>(given) ? std::optional(given) : std::nullopt;
        default:
            return std::holds_alternative<std::string>(given) ? std::optional(given) : std::nullopt;
    }
}

const char* typeText(ParameterType t)
{
    switch (t) {
        case ParameterType::Flag:
            return "must be true or false";
        case ParameterType::Integer:
            return "must be a whole number";
        case ParameterType::Number:
            return "must be a number";
        case ParameterType::Point:
            return "must be three numbers x/y/z";
        default:
            return "must be text";
    }
}

std::string plain(const ParameterValue& v)
{
    struct Print {
        std::string operator()(bool b) const { return b ? "true" : "false"; }
        std::string operator()(int64_t i) const { return std::to_string(i); }
        std::string operator()(double d) const { return shortest(d); }
        std::string operator()(const std::string& s) const { return s; }
        std::string operator()(const glm::dvec3& p) const { return shortest(p.x) + "/" + shortest(p.y) + "/" + shortest(p.z); }
    };
    return std::visit(Print{}, v);
}

const Parameter& named(const std::vector<Parameter>& parameters, std::string_view name)
{
    std::vector<std::string> known;
    for (const Parameter& p : parameters) {
        if (p.name == name) return p;
        known.push_back(p.name);
    }
    if (known.empty()) throw Error("there is no parameter \"" + std::string(name) + "\": this operation has none");
    throw Error("there is no parameter \"" + std::string(name) + "\"; there are: " + listed(known));
}

double readNumber(const Parameter& p, std::string_view text)
{
    double v = 0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), v);
    if (error != std::errc() || end != text.data() + text.size()) refuse(p, std::string(text), typeText(p.type));
    return v;
}

ParameterValue readPoint(const Parameter& p, std::string_view text)
{
    glm::dvec3 v{0};
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const size_t slash = rest.find('/');
        if ((slash == std::string_view::npos) != (i == 2)) refuse(p, std::string(text), typeText(p.type));
        v[i] = readNumber(p, rest.substr(0, slash));
        rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
    }
    return v;
}

ParameterValue readValue(const Parameter& p, std::string_view text)
{
    switch (p.type) {
        case ParameterType::Flag:
            if (text == "true" || text == "yes" || text == "1") return true;
            if (text == "false" || text == "no" || text == "0") return false;
            refuse(p, std::string(text), typeText(p.type));
        case ParameterType::Integer: {
            // As a number first, so that "1e6" may be said.
            const std::optional<ParameterValue> whole = converted(ParameterType::Integer, readNumber(p, text));
            if (!whole) refuse(p, std::string(text), typeText(p.type));
            return *whole;
        }
        case ParameterType::Number:
            return readNumber(p, text);
        case ParameterType::Point:
            return readPoint(p, text);
        default:
            return std::string(text);
    }
}

}  // namespace

ParameterValues checked(const std::vector<Parameter>& parameters, const ParameterValues& given)
{
    ParameterValues out;
    for (const auto& [name, value] : given) {
        const Parameter& p = named(parameters, name);
        const std::optional<ParameterValue> v = converted(p.type, value);
        if (!v) refuse(p, plain(value), typeText(p.type));
        if (p.type == ParameterType::Number) checkRange(p, std::get<double>(*v));
        if (p.type == ParameterType::Integer) checkRange(p, double(std::get<int64_t>(*v)));
        if (p.type == ParameterType::Point)
            for (int i = 0; i < 3; ++i) checkRange(p, std::get<glm::dvec3>(*v)[i]);
        if (p.type == ParameterType::Choice && std::find(p.choices.begin(), p.choices.end(), std::get<std::string>(*v)) == p.choices.end())
            refuse(p, plain(*v), "must be one of " + listed(p.choices));
        out.emplace(name, *v);
    }
    return out;
}

namespace {

// The text between double quotes at the front of `text`, which loses it and what follows up to the next comma.
std::string takeQuoted(std::string_view& text)
{
    std::string out;
    size_t i = 1;
    for (; i < text.size() && text[i] != '"'; ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        out += text[i];
    }
    if (i >= text.size()) throw Error("a value begins with \" and does not end with it");
    if (i + 1 < text.size() && text[i + 1] != ',') throw Error("a comma is wanted after the value \"" + out.substr(0, 64) + "\"");
    text.remove_prefix(std::min(text.size(), i + 2));
    return out;
}

std::string_view takePlain(std::string_view& text)
{
    const size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    return item;
}

// As parsed() reads it back: between quotes where it must be.
std::string quoted(const std::string& text)
{
    if (text.find(',') == std::string::npos && !text.starts_with('"')) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return out + '"';
}

}  // namespace

ParameterValues parsed(const std::vector<Parameter>& parameters, std::string_view text)
{
    ParameterValues out;
    std::string* words = nullptr;  // the text that came last: a text may have commas of its own
    while (!text.empty()) {
        const size_t equals = text.find('='), comma = text.find(',');
        if (equals < comma && text.substr(equals + 1).starts_with('"')) {
            const Parameter& p = named(parameters, text.substr(0, equals));
            text.remove_prefix(equals + 1);
            if (!out.emplace(p.name, readValue(p, takeQuoted(text))).second) throw Error("parameter " + p.name + " is given twice");
            words = nullptr;
            continue;
        }
        const std::string_view item = takePlain(text);
        if (item.empty()) continue;
        if (equals >= comma && words) {
            *words += "," + std::string(item);
            continue;
        }
        if (item.find('=') == std::string_view::npos) throw Error("parameter \"" + std::string(item) + "\" has no value: write name=value");
        const Parameter& p = named(parameters, item.substr(0, equals));
        const auto [value, first] = out.emplace(p.name, readValue(p, item.substr(equals + 1)));
        if (!first) throw Error("parameter " + p.name + " is given twice");
        words = p.type == ParameterType::Text ? &std::get<std::string>(value->second) : nullptr;
    }
    return checked(parameters, out);
}

std::string printed(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    std::string out;
    for (const Parameter& p : parameters) {
        const ParameterValue v = valueOf(p, values);
        if (v == p.initial) continue;
        out += (out.empty() ? "" : ",") + p.name + "=" + quoted(plain(v));
    }
    return out;
}

std::string printedAll(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    std::string out;
    for (const Parameter& p : parameters)
        if (const auto v = values.find(p.name); v != values.end()) out += (out.empty() ? "" : ",") + p.name + "=" + quoted(plain(v->second));
    return out;
}

ParameterValues unlikeDefaults(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    ParameterValues out;
    for (const auto& [name, value] : checked(parameters, values))
        if (value != named(parameters, name).initial) out.emplace(name, value);
    return out;
}

nlohmann::json toJson(const ParameterValues& values)
{
    nlohmann::json out = nlohmann::json::object();
    for (const auto& [name, value] : values) {
        if (const auto* point = std::get_if<glm::dvec3>(&value))
            out[name] = {point->x, point->y, point->z};
        else
            std::visit(
                [&, key = name](const auto& v) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(v)>, glm::dvec3>) out[key] = v;
                },
                value);
    }
    return out;
}

ParameterValues parametersFromJson(const std::vector<Parameter>& parameters, const nlohmann::json& json)
{
    if (!json.is_object()) throw Error("parameters must be a JSON object");
    ParameterValues out;
    for (const auto& [name, v] : json.items()) {
        const Parameter& p = named(parameters, name);
        if (v.is_boolean())
            out[name] = v.get<bool>();
        else if (v.is_number_integer())
            out[name] = v.get<int64_t>();
        else if (v.is_number())
            out[name] = v.get<double>();
        else if (v.is_string())
            out[name] = v.get<std::string>();
        else if (v.is_array() && v.size() == 3 && v[0].is_number() && v[1].is_number() && v[2].is_number())
            out[name] = glm::dvec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
        else
            refuse(p, v.dump(), typeText(p.type));
    }
    return checked(parameters, out);
}

ParameterValue valueOf(const Parameter& p, const ParameterValues& values)
{
    const auto i = values.find(p.name);
    return i == values.end() ? p.initial : i->second;
}

}  // namespace mw
