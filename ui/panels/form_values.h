// Forms from described structs that are no parameters of an operation: their rows, and their values as a struct.
#pragma once
#include "core/catalog/parameters.h"

namespace mw::forms {

template <class F>
std::vector<Parameter> described()
{
    Describer d;
    F f;
    f.describe(d);
    return d.parameters;
}

template <class F>
F filled(const ParameterValues& values)
{
    F f;
    Filler filler(values);
    f.describe(filler);
    return f;
}

}  // namespace mw::forms
