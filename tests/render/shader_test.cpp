// Every program of the table compiles and links in every variant that is used, and a broken one is told by file and line.
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/offscreen.h"
#include "render/shaders.h"

namespace mw {
namespace {

/// What the surface is drawn with: one way of colouring at a time, and what lights and pictures add to it.
std::vector<unsigned> surfaceVariants()
{
    namespace v = variant;
    constexpr unsigned maps = v::mapBase | v::mapRoughness | v::mapNormal | v::mapOcclusion | v::mapEmissive;
    std::vector<unsigned> out;
    for (unsigned low = 0; low < 256; ++low) {
        const unsigned heat = low & (v::heat | v::heatCategory | v::heatFace);
        if (low & v::dense && (heat || low & (v::flat | v::material))) continue;
        if ((heat & (heat - 1)) != 0 || (heat && low & (v::color | v::material))) continue;
        out.push_back(low);
        out.push_back(low | v::environment);
        if (low & v::dense) continue;
        for (const unsigned light : {0u, v::environment}) {
            out.push_back(low | light | v::shadow);
            if (heat || low & v::color) continue;
            out.push_back(low | light | v::checker);
        }
        if (!(low & (v::color | v::material | v::flat)) && !heat) out.push_back(low | v::matcap);
    }
    for (unsigned map = v::mapBase; map <= v::mapEmissive; map <<= 1) out.push_back(v::material | map);
    for (const unsigned light : {0u, v::environment, v::shadow, v::environment | v::shadow})
        for (const unsigned low : {0u, v::color, v::flat, v::dimmed, v::tangent}) out.push_back(v::material | maps | light | low);
    return out;
}

TEST(Shaders, EveryRowInEveryVariant)
{
    Offscreen context(true);
    Programs programs;
    for (const ProgramRow& row : programTable()) {
        std::vector<unsigned> variants;
        for (unsigned v = 0; v < 1u << row.variants.size() && row.id != ProgramId::Surface; ++v) {
            // Facets and lighting by pixel go together.
            if (row.id == ProgramId::Terrain && v & variant::flat && v & variant::denseGround) continue;
            variants.push_back(v);
        }
        if (row.id == ProgramId::Surface) variants = surfaceVariants();
        for (const unsigned v : variants) EXPECT_NO_THROW(EXPECT_NE(programs.get(row.id, v), 0u)) << row.name << " variant " << v;
    }
    EXPECT_EQ(context.messages(), std::vector<std::string>{});
}

TEST(Shaders, AllFilesAreUsed)
{
    for (const ProgramRow& row : programTable()) {
        for (const char* file : {row.vertex, row.control, row.evaluation, row.geometry, row.fragment}) {
            if (!file) continue;
            EXPECT_FALSE(shaderFile(file).empty()) << file;
        }
        for (const char* chunk : row.chunks) EXPECT_FALSE(shaderFile(chunk).empty());
    }
    EXPECT_THROW(shaderFile("absent.frag"), Error);
}

}  // namespace
}  // namespace mw
