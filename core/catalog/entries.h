// How an algorithm becomes an entry of the catalog: its parameter struct is described, its coroutine wrapped in a Run.
#pragma once
#include <type_traits>

#include "core/catalog/catalog.h"

namespace mw {

template <class T>
inline constexpr Kind kindOfType = Kind::Nothing;
template <>
inline constexpr Kind kindOfType<Mesh> = Kind::Mesh;
template <>
inline constexpr Kind kindOfType<Table> = Kind::Table;
template <>
inline constexpr Kind kindOfType<ElementSet> = Kind::Selection;
template <>
inline constexpr Kind kindOfType<HeightMap> = Kind::HeightMap;
template <>
inline constexpr Kind kindOfType<Curve> = Kind::Curve;
template <>
inline constexpr Kind kindOfType<Pose> = Kind::Pose;
template <>
inline constexpr Kind kindOfType<Rotations> = Kind::Rotations;

template <class P>
std::vector<Parameter> described()
{
    Describer d;
    P p;
    p.describe(d);
    return std::move(d.parameters);
}

template <class P>
P filled(const ParameterValues& values, const Others& others = {})
{
    P p;
    Filler f(values, &others);
    p.describe(f);
    return p;
}

/// An algorithm that takes a value: `Generator f(In, P, Stage<Out>&)`. `about` has everything but kinds, parameters and start.
template <class In, class P, class Out>
Operation entry(Operation about, Generator (*algorithm)(In, P, Stage<Out>&))
{
    about.accepts = kindOfType<In>;
    about.yields = kindOfType<Out>;
    about.parameters = described<P>();
    about.start = [algorithm](const Value& value, const ParameterValues& values, const Others& others, bool watched) -> std::unique_ptr<Run> {
        const In& input = std::get<In>(value);
        Out initial;
        if constexpr (std::is_same_v<In, Out>) initial = input;
        return std::make_unique<RunOf<Out>>(
            watched, [&](Stage<Out>& stage) { return algorithm(input, filled<P>(values, others), stage); }, std::move(initial));
    };
    return about;
}

/// A source: `Generator f(P, Stage<Out>&)`.
template <class P, class Out>
Operation entry(Operation about, Generator (*algorithm)(P, Stage<Out>&))
{
    about.accepts = Kind::Nothing;
    about.yields = kindOfType<Out>;
    about.parameters = described<P>();
    about.start = [algorithm](const Value&, const ParameterValues& values, const Others& others, bool watched) -> std::unique_ptr<Run> {
        return std::make_unique<RunOf<Out>>(watched, [&](Stage<Out>& stage) { return algorithm(filled<P>(values, others), stage); });
    };
    return about;
}

}  // namespace mw
