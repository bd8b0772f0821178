#include "core/catalog/catalog.h"

#include <algorithm>

namespace mw {

const char* kindName(Kind k)
{
    switch (k) {
        case Kind::Nothing:
            return "nothing";
        case Kind::Mesh:
            return "mesh";
        case Kind::Curve:
            return "curve";
        case Kind::HeightMap:
            return "height-map";
        case Kind::Patches:
            return "patches";
        case Kind::Clip:
            return "clip";
        case Kind::Pose:
            return "pose";
        case Kind::Rotations:
            return "rotations";
        case Kind::Selection:
            return "selection";
        case Kind::Table:
            return "table";
    }
    return "";
}

Kind kindOf(const Value& v)
{
    constexpr Kind kinds[] = {Kind::Nothing, Kind::Mesh, Kind::Selection, Kind::Table, Kind::HeightMap, Kind::Curve, Kind::Pose, Kind::Rotations};
    return kinds[v.index()];
}

namespace {

template <class T, class... More>
Value held(const std::any& a)
{
    if (const T* v = std::any_cast<T>(&a)) return *v;
    if constexpr (sizeof...(More) > 0)
        return held<More...>(a);
    else
        return {};
}

}  // namespace

Value valueOf(const Snapshot& s)
{
    return held<Mesh, Table, ElementSet, HeightMap, Curve, Pose, Rotations>(s.value);
}

uint64_t contentHash(const Value& v)
{
    return std::visit(
        [](const auto& held) -> uint64_t {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
                return 0;
            else
                return contentHash(held);
        },
        v);
}

const Operation* findOperation(std::string_view id)
{
    for (const Operation& op : catalog())
        if (op.id == id) return &op;
    return nullptr;
}

namespace {

// Levenshtein distance, to say what was perhaps meant.
size_t distance(std::string_view a, std::string_view b)
{
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t next = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = row[j];
            row[j] = next;
        }
    }
    return row.back();
}

void checkInput(const Operation& op, const Value& input)
{
    if (op.accepts != kindOf(input))
        throw Error(op.id + " works on " + kindName(op.accepts) + ", but was given " + kindName(kindOf(input)) +
                    (op.accepts == Kind::Nothing ? "; it is a source: use - as input" : ""));
}

}  // namespace

const Operation& operation(std::string_view id)
{
    if (const Operation* op = findOperation(id)) return *op;
    const std::string wanted(id.substr(0, 64));
    std::string near;
    for (const Operation& op : catalog())
        if (distance(wanted, op.id) <= std::max<size_t>(3, wanted.size() / 3) || (wanted.size() > 3 && op.id.find(wanted) != std::string::npos))
            near += (near.empty() ? "" : ", ") + op.id;
    throw Error("there is no operation \"" + wanted + "\"; " + (near.empty() ? "the verb algorithms lists them" : "near it: " + near));
}

Value apply(const Operation& op, const Value& input, const ParameterValues& values, Progress* progress, const Others& others)
{
    checkInput(op, input);
    const std::unique_ptr<Run> run = op.start(input, checked(op.parameters, values), others, false);
    while (run->advance())
        if (progress) progress->at(run->step().progress() >= 0 ? run->step().progress() : progress->fraction.load());
    return valueOf(run->snapshot());
}

StartRun stepping(const Operation& op, Value input, const ParameterValues& values, Others others)
{
    checkInput(op, input);
    return [&op, input = std::move(input), values = checked(op.parameters, values), others = std::move(others)](bool watched) {
        return op.start(input, values, others, watched);
    };
}

}  // namespace mw
