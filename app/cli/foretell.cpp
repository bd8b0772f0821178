#include "app/cli/foretell.h"

#include <algorithm>
#include <iostream>
#include <unistd.h>

#include "app/cli/output.h"

namespace mw::cli {

namespace {

void say(const std::string& what, const Mesh& input, const Cost& cost)
{
    if (!cost.heavy()) return;
    const char* overBar = isatty(STDERR_FILENO) ? "\r\033[K" : "";
    std::cerr << overBar << "meshwright: " << what << " on " << counted(input.faceCount(), "face") << ": " << costText(cost)
              << " expected; Ctrl+C ends it\n";
}

}  // namespace

void foretell(const Operation& op, const Mesh& input, const ParameterValues& values)
{
    if (const auto cost = expectedCost(op, sizeOf(input), values)) say(op.id, input, *cost);
}

void foretell(const MeshObject& object)
{
    Cost all;
    all.result = sizeOf(object.base);
    for (const Modifier& m : object.stack) {
        const Operation* op = m.enabled ? findOperation(m.operation) : nullptr;
        const auto cost = op ? expectedCost(*op, all.result, m.values) : std::nullopt;
        if (!cost) continue;
        all.seconds += cost->seconds;
        all.bytes = std::max(all.bytes, cost->bytes);
        all.result = cost->result;
    }
    say("the modifiers of \"" + object.name + "\"", object.base, all);
}

}  // namespace mw::cli
