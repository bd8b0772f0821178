// edits: the list of edits.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/parameter_words.h"
#include "app/cli/verb.h"
#include "core/scene/edit.h"

namespace mw::cli {

namespace {

nlohmann::json editJson(const Edit& e)
{
    nlohmann::json params = nlohmann::json::array();
    for (const Parameter& p : e.parameters) params.push_back(parameterJson(p));
    return {{"id", e.id}, {"title", e.title}, {"summary", e.summary}, {"params", params}};
}

int run(Arguments& arguments)
{
    const bool json = arguments.flag("--json");
    arguments.finish({});
    if (json) {
        nlohmann::json all = nlohmann::json::array();
        for (const Edit& e : editList()) all.push_back(editJson(e));
        printJson({{"edits", all}});
        return 0;
    }
    std::cout << counted(editList().size(), "edit")
              << ", with parameters and their defaults; use one as process IN --do 'ID:name=value,name=value'\n";
    for (const Edit& e : editList()) {
        std::cout << "\n" << e.id << " - " << e.title << "\n    " << e.summary << '\n';
        printParameters(e.parameters);
    }
    return 0;
}

}  // namespace

const Verb editsVerb{
    "edits", "what changes a scene: every action of the window, for process --do",
    "edits [--json]\n\n"
    "Lists the edits: what each one does, and its parameters. Nodes are named by their names, joined by +, or as #12 by number when a\n"
    "name is there twice; the window writes them so (History: Copy as command). A value with commas stands between double quotes:\n"
    "  meshwright process bunny.obj --do 'modify:node=bunny,op=smooth,with=\"iterations=20,lambda=0.3\"' -o out.glb\n\n"
    "  --json   one JSON object instead of text\n",
    run};

}  // namespace mw::cli
