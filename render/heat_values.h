// Heat maps on the graphics card: their values, and how a value becomes a place in the colour table.
#pragma once
#include "render/colors.h"
#include "render/gpu_cache.h"

namespace mw {

/// Values of the column for each drawn vertex (`vertexOf` empty: for each row), as floats; undefined ones below -1e25.
GLuint heatBuffer(GpuCache& cache, const HeatMap& h, const Shared<uint32_t>& vertexOf, GpuKey& key);
/// Scale, offset, number of categories, row of the table.
glm::vec4 heatUniform(const HeatMap& h);

/// The colour table, as every program that shows values reads it.
void makeHeatTable(gl::Texture& texture);

}  // namespace mw
