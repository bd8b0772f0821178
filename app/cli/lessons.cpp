// lessons: what can be watched step by step, and how to begin.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/catalog/lesson.h"

namespace mw::cli {

namespace {

nlohmann::json lessonJson(const Lesson& l)
{
    nlohmann::json phases = nlohmann::json::array();
    for (const LessonPhase& p : l.phases) {
        nlohmann::json numbers = nlohmann::json::array();
        for (const LessonNumber& n : p.numbers) numbers.push_back({{"name", n.name}, {"title", n.title}});
        phases.push_back({{"id", p.id}, {"title", p.title}, {"sentence", p.sentence}, {"formula", p.formula}, {"numbers", numbers}});
    }
    return {{"id", l.id},           {"title", l.title},
            {"section", l.section}, {"intro", l.intro},
            {"try", l.tries},       {"scene", {{"source", l.scene.source}, {"operations", l.scene.operations}, {"parameters", l.scene.parameters}}},
            {"phases", phases}};
}

void printLesson(const Lesson& l)
{
    std::cout << "\n" << l.id << " - " << l.title << (l.section.empty() ? "" : " (book " + l.section + ")") << "\n    phases: ";
    for (size_t i = 0; i < l.phases.size(); ++i) std::cout << (i ? ", " : "") << l.phases[i].title;
    const std::string call = l.id + (l.scene.parameters.empty() ? "" : ":" + l.scene.parameters);
    if (l.scene.source.empty()) {  // it makes something from nothing
        std::cout << "\n    meshwright step - --op " << call << '\n';
        return;
    }
    std::cout << "\n    meshwright process - --op " << l.scene.source;
    for (const std::string& op : l.scene.operations) std::cout << " --op " << op;
    std::cout << " -o lesson.glb\n    meshwright step lesson.glb --op " << call << '\n';
}

int run(Arguments& arguments)
{
    const bool json = arguments.flag("--json");
    arguments.finish({});
    if (json) {
        nlohmann::json all = nlohmann::json::array();
        for (const Lesson& l : lessons()) all.push_back(lessonJson(l));
        printJson({{"lessons", all}});
        return 0;
    }
    std::cout << counted(lessons().size(), "lesson") << ": watch one in the window (Learn), or step through it here\n";
    for (const Lesson& l : lessons()) printLesson(l);
    return 0;
}

}  // namespace

const Verb lessonsVerb{"lessons", "what can be watched step by step, and how to begin",
                       "lessons [--json]\n\n"
                       "Lists the lessons: phases, and the commands that set up the scene and step through it.\n"
                       "  --json   one JSON object instead of text, with all words and formulas\n",
                       run};

}  // namespace mw::cli
