// step IN --op ID: an algorithm one step at a time, as the step player shows it.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/other_mesh.h"
#include "app/cli/output.h"
#include "app/cli/placement_options.h"
#include "app/cli/subject.h"
#include "app/cli/value_file.h"
#include "app/cli/verb.h"
#include "core/catalog/lesson.h"
#include "core/steps/stepper.h"

namespace mw::cli {

namespace {

const char* elementName(ElementKind k)
{
    static constexpr const char* all[] = {"object", "vertex", "edge", "face", "corner", "point", "segment", "joint", "cell"};
    return all[size_t(k)];
}

const char* roleName(Role r)
{
    static constexpr const char* all[] = {"current", "neighbour", "new", "removed", "rejected"};
    return all[size_t(r)];
}

// The compiler may have seen the file by a longer path than the project's own.
std::string sourceFile(const Operation& op, const char* file)
{
    const std::string_view all = file;
    const size_t core = all.rfind("core/");
    return core == all.npos ? op.source : std::string(all.substr(core));
}

nlohmann::json place(const glm::vec3& p)
{
    return {finite(p.x), finite(p.y), finite(p.z)};
}

nlohmann::json focusJson(const Focus& f)
{
    nlohmann::json j = {{"kind", elementName(f.kind)}, {"index", f.index}, {"role", roleName(f.role)}};
    if (f.kind == ElementKind::Edge) j["other"] = f.other;
    if (f.kind == ElementKind::Point || f.kind == ElementKind::Segment) j["at"] = place(f.at);
    if (f.kind == ElementKind::Segment) j["to"] = place(f.to);
    if (f.label) j["label"] = f.label;
    return j;
}

void printStepJson(const Operation& op, const StepRecord& r)
{
    nlohmann::json focus = nlohmann::json::array(), numbers = nlohmann::json::object();
    for (const Focus& f : r.focus) focus.push_back(focusJson(f));
    for (const Number& n : r.numbers) numbers[n.name] = finite(n.value);
    printJson({{"step", r.index},
               {"phase", r.phase},
               {"focus", focus},
               {"numbers", numbers},
               {"progress", finite(r.progress)},
               {"file", sourceFile(op, r.file)},
               {"line", r.line}});
}

// Elements of one role and kind together: "current edge 3-7; neighbour vertices 1 2 9".
void printFocus(const std::vector<Focus>& focus)
{
    constexpr size_t most = 12;
    for (size_t i = 0; i < focus.size();) {
        size_t j = i;
        while (j < focus.size() && focus[j].kind == focus[i].kind && focus[j].role == focus[i].role) ++j;
        std::cout << "  " << roleName(focus[i].role) << ' ' << elementName(focus[i].kind);
        for (size_t k = i; k < std::min(j, i + most); ++k) {
            const Focus& f = focus[k];
            std::cout << ' ';
            if (f.kind == ElementKind::Point || f.kind == ElementKind::Segment)
                std::cout << '(' << shown(f.at.x) << ", " << shown(f.at.y) << ", " << shown(f.at.z) << ')';
            else
                std::cout << f.index;
            if (f.kind == ElementKind::Edge) std::cout << '-' << f.other;
        }
        if (j - i > most) std::cout << " and " << j - i - most << " more";
        i = j;
    }
}

void printStepText(const Operation& op, const StepRecord& r)
{
    std::cout << r.index << "  " << r.phase;
    for (const Number& n : r.numbers) std::cout << "  " << n.name << '=' << shown(n.value);
    printFocus(r.focus);
    std::cout << "  [" << sourceFile(op, r.file) << ':' << r.line << "]\n";
}

void printEnd(const Run& run, size_t steps)
{
    std::cout << "end after " << counted(steps, "step") << ": " << summaryOf(valueOf(run.snapshot())) << '\n';
}

// The lesson's own parameters where its subject is taken; those given come first.
ParameterValues valuesFor(const OperationCall& call, const std::string& in)
{
    const Lesson* lesson = in == "-" ? findLesson(call.operation->id) : nullptr;
    ParameterValues values = call.values;
    if (lesson) values.merge(parsed(call.operation->parameters, lesson->scene.parameters));
    return values;
}

Value read(const std::string& in, const OperationCall& call, const std::optional<std::string>& object, const ImportOptions& options)
{
    Working working("reading " + in);
    return subjectOf(in, call, object, working.progress(), options);
}

int run(Arguments& arguments)
{
    const bool json = arguments.flag("--json");
    const std::optional<std::string> op = arguments.value("--op"), object = arguments.value("--object");
    const std::optional<long> until = arguments.number("--until", 0, 2000000000);
    const ImportOptions options = takeImportOptions(arguments);
    const std::string in = arguments.finish({"IN"})[0];
    if (!op) throw UsageError("--op ID is missing");
    const OperationCall call = parseCall(*op);
    if (in != "-" && call.operation->accepts == Kind::Nothing)
        throw Error(in, call.operation->id + " makes something from nothing and takes no file; give - as input");
    const Value value = read(in, call, object, options);
    const ParameterValues values = valuesFor(call, in);
    const Scene nothing;
    const Others others = othersOf(*call.operation, values, meshesOf(nothing, nullptr));
    const std::unique_ptr<Run> steps = stepping(*call.operation, value, values, others)(true);
    size_t n = 0;
    while (!until || n < size_t(*until)) {
        if (!steps->advance()) {
            if (!json) printEnd(*steps, n);
            break;
        }
        const StepRecord record = recordOf(*steps, ++n);
        if (json)
            printStepJson(*call.operation, record);
        else
            printStepText(*call.operation, record);
        if (!std::cout.good()) break;  // nobody reads any more
    }
    return 0;
}

}  // namespace

const Verb stepVerb{
    "step", "an operation one step at a time",
    "step IN --op ID[:k=v,...] [--until N] [--object NAME] [--unit UNIT] [--up y|z|x] [--json]\n\n"
    "One line a step: phase, numbers, elements in focus, and the line of source that runs. IN is what the operation works on: a mesh,\n"
    "a character (its skeleton at rest), a curve (.csv of x,y or x,y,z), a height map (.png). It may be - for a source, or for what\n"
    "the operation's lesson is tried on.\n"
    "  --until N       stop after N steps\n"
    "  --object NAME   which mesh, or which skeleton by its topmost joint, when the file has several\n"
    "  --json          one JSON object a line: step, phase, focus, numbers, progress, file, line\n",
    run};

}  // namespace mw::cli
