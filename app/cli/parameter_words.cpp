#include "app/cli/parameter_words.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"

namespace mw::cli {

namespace {

const char* typeName(ParameterType t)
{
    static constexpr const char* all[] = {"flag", "integer", "number", "choice", "text", "point", "object", "file"};
    return all[size_t(t)];
}

nlohmann::json valueJson(const ParameterValue& v)
{
    return toJson({{"value", v}}).at("value");
}

}  // namespace

nlohmann::json parameterJson(const Parameter& p)
{
    nlohmann::json j = {{"name", p.name},
                        {"title", p.about.title},
                        {"unit", p.about.unit},
                        {"type", typeName(p.type)},
                        {"min", finite(p.about.min)},
                        {"max", finite(p.about.max)},
                        {"default", valueJson(p.initial)},
                        {"help", p.about.help}};
    if (p.type == ParameterType::Choice) j["choices"] = p.choices;
    return j;
}

namespace {

std::string valueText(const Parameter& p)
{
    const nlohmann::json v = valueJson(p.initial);
    if (v.is_array()) return shown(v[0]) + "/" + shown(v[1]) + "/" + shown(v[2]);
    if (v.is_number_float()) return shown(v);
    return v.is_string() ? v.get<std::string>() : v.dump();
}

std::string rangeText(const Parameter& p)
{
    if (p.type == ParameterType::Choice) {
        std::string all;
        for (const std::string& c : p.choices) all += (all.empty() ? "" : "|") + c;
        return all;
    }
    const bool low = std::isfinite(p.about.min), high = std::isfinite(p.about.max);
    std::string text = typeName(p.type);
    if (low && high)
        text = shown(p.about.min) + ".." + shown(p.about.max);
    else if (low)
        text = "from " + shown(p.about.min);
    else if (high)
        text = "to " + shown(p.about.max);
    return text + (p.about.unit.empty() ? "" : " " + p.about.unit);
}

}  // namespace

void printParameters(const std::vector<Parameter>& parameters)
{
    for (const Parameter& p : parameters)
        std::cout << "      " << p.name << "=" << valueText(p) << "  [" << rangeText(p) << "]  " << p.about.help << '\n';
}

}  // namespace mw::cli
