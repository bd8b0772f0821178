// algorithms: the catalog.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/catalog/catalog.h"

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

nlohmann::json operationJson(const Operation& op)
{
    nlohmann::json params = nlohmann::json::array();
    for (const Parameter& p : op.parameters) params.push_back(parameterJson(p));
    return {{"id", op.id},
            {"title", op.title},
            {"summary", op.summary},
            {"category", op.category},
            {"section", op.section},
            {"accepts", kindName(op.accepts)},
            {"yields", kindName(op.yields)},
            {"steps", op.steps},
            {"params", params}};
}

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

void printOperation(const Operation& op)
{
    std::cout << "\n" << op.id << " - " << op.title << '\n';
    std::cout << "    " << op.summary << "\n    " << kindName(op.accepts) << " to " << kindName(op.yields) << (op.steps ? ", can be stepped" : "")
              << (op.section.empty() ? "" : ", book " + op.section) << '\n';
    for (const Parameter& p : op.parameters)
        std::cout << "      " << p.name << "=" << valueText(p) << "  [" << rangeText(p) << "]  " << p.about.help << '\n';
}

int run(Arguments& arguments)
{
    const bool json = arguments.flag("--json");
    arguments.finish({});
    if (json) {
        nlohmann::json all = nlohmann::json::array();
        for (const Operation& op : catalog()) all.push_back(operationJson(op));
        printJson({{"algorithms", all}});
        return 0;
    }
    std::cout << counted(catalog().size(), "operation") << ", with parameters and their defaults; use one as --op ID:name=value,name=value\n";
    for (const Operation& op : catalog()) printOperation(op);
    return 0;
}

}  // namespace

const Verb algorithmsVerb{"algorithms", "the operations there are, and their parameters",
                          "algorithms [--json]\n\n"
                          "Lists the catalog: what each operation takes and gives, and its parameters.\n"
                          "  --json   one JSON object instead of text\n",
                          run};

}  // namespace mw::cli
