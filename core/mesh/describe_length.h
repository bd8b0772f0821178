// Parameters that are lengths, all within the same range.
#pragma once

namespace mw {

/// A length above 0 for a describe(): a millionth of a metre to 1000 km, sliders from 0.1 to 10 m.
template <class V>
void describeLength(V& v, const char* name, double& length, const char* title, const char* help, const char* when = "")
{
    v.number(name, length,
             {.title = title, .help = help, .unit = "m", .min = 1e-6, .max = 1e6, .softMin = 0.1, .softMax = 10, .logarithmic = true, .when = when});
}

}  // namespace mw
