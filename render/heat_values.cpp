#include "render/heat_values.h"

#include <algorithm>
#include <cmath>

namespace mw {

namespace {

constexpr double undefinedValue = -1e38;

float heatFloat(double v)
{
    return float(std::isfinite(v) ? std::clamp(v, -9e29, 9e29) : undefinedValue);
}

}  // namespace

GLuint heatBuffer(GpuCache& cache, const HeatMap& h, const Shared<uint32_t>& vertexOf, GpuKey& key)
{
    key = {{h.table.get(), vertexOf.id()}, 100 + h.column};
    return cache.made(key, {h.table, vertexOf.owner()}, [&] {
        const Array<double>& values = h.table->columns[h.column].values;
        Array<float> out(vertexOf.empty() ? values.size() : vertexOf.size());
        for (size_t i = 0; i < out.size(); ++i) out[i] = heatFloat(values[vertexOf.empty() ? i : vertexOf[i]]);
        return out;
    });
}

glm::vec4 heatUniform(const HeatMap& h)
{
    const double span = h.high - h.low;
    const HeatRow row = heatRow(h);
    const double scale = span > 0 ? 1 / span : 0;
    return {float(scale), float(span > 0 ? -h.low * scale : 0.5), row == categoryRow ? float(categoryCount) : 0.f, float(row)};
}

}  // namespace mw
