#include "render/heat_values.h"

#include <algorithm>
#include <cmath>

namespace mw {

namespace {

// Far from every value, and not so far that interpolating it between vertices overflows.
constexpr double undefinedValue = -1e32, greatestValue = 9e24;

float heatFloat(double v)
{
    return float(std::isfinite(v) ? std::clamp(v, -greatestValue, greatestValue) : undefinedValue);
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

void makeHeatTable(gl::Texture& texture)
{
    const std::vector<uint8_t> pixels = heatTablePixels();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, heatEntries, 3, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

glm::vec4 heatUniform(const HeatMap& h)
{
    const double span = h.high - h.low;
    const HeatRow row = heatRow(h);
    const double scale = span > 0 ? 1 / span : 0;
    return {float(scale), float(span > 0 ? -h.low * scale : 0.5), row == categoryRow ? float(categoryCount) : 0.f, float(row)};
}

}  // namespace mw
