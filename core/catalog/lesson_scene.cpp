#include "core/catalog/lesson_scene.h"

namespace mw {

namespace {

// "id:k=v,k=v", as on the command line.
Value applied(const std::string& call, const Value& input, Progress* progress)
{
    const size_t colon = call.find(':');
    const Operation& op = operation(call.substr(0, colon));
    const std::string parameters = colon == std::string::npos ? std::string() : call.substr(colon + 1);
    return apply(op, input, parsed(op.parameters, parameters), progress);
}

}  // namespace

Value lessonSubject(const Lesson& lesson, Progress* progress)
{
    if (lesson.scene.source.empty()) return {};
    Value value = applied(lesson.scene.source, Value{}, progress);
    for (const std::string& call : lesson.scene.operations) value = applied(call, value, progress);
    return value;
}

}  // namespace mw
