// algorithms: the catalog.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/parameter_words.h"
#include "app/cli/verb.h"
#include "core/catalog/catalog.h"

namespace mw::cli {

namespace {

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

void printOperation(const Operation& op)
{
    std::cout << "\n" << op.id << " - " << op.title << '\n';
    std::cout << "    " << op.summary << "\n    " << kindName(op.accepts) << " to " << kindName(op.yields) << (op.steps ? ", can be stepped" : "")
              << (op.section.empty() ? "" : ", book " + op.section) << '\n';
    printParameters(op.parameters);
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
