// How much is kept: the parameters that decimate-quadric and its reference share.
#pragma once
#include <cstdint>

namespace mw {

/// Of a struct with a choice `stop` of, among others, ratio and faces.
template <class V>
void describeKept(V& v, double& ratio, int64_t& faces)
{
    v.number("ratio", ratio,
             {.title = "Ratio",
              .help = "Share of the triangles to keep.",
              .min = 0,
              .max = 1,
              .softMin = 0.01,
              .softMax = 1,
              .logarithmic = true,
              .when = "stop=ratio"});
    v.integer("faces", faces,
              {.title = "Faces",
               .help = "Number of triangles to keep.",
               .min = 0,
               .max = 1e9,
               .softMin = 100,
               .softMax = 1e6,
               .logarithmic = true,
               .when = "stop=faces"});
}

}  // namespace mw
