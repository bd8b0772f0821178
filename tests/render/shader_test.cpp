// Every program of the table compiles and links in every variant that is used, and a broken one is told by file and line.
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/offscreen.h"
#include "render/shaders.h"

namespace mw {
namespace {

TEST(Shaders, EveryRowInEveryVariant)
{
    Offscreen context(true);
    Programs programs;
    for (const ProgramRow& row : programTable()) {
        const unsigned all = 1u << row.variants.size();
        for (unsigned v = 0; v < all; ++v) {
            if (row.id == ProgramId::Surface) {  // one way of colouring at a time
                const unsigned heat = v & (variant::heat | variant::heatCategory | variant::heatFace);
                if (v & variant::dense && (heat || v & (variant::flat | variant::material))) continue;
                if ((heat & (heat - 1)) != 0 || (heat && v & (variant::color | variant::material))) continue;
            }
            // Facets and lighting by pixel go together.
            if (row.id == ProgramId::Terrain && v & variant::flat && v & variant::denseGround) continue;
            EXPECT_NO_THROW(EXPECT_NE(programs.get(row.id, v), 0u)) << row.name << " variant " << v;
        }
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
