// The qualities of decimate-quadric against CGAL's Lindstrom-Turk: RMS distance to the mesh they came from, measured by CGAL's tree for all alike.
#include <gtest/gtest.h>

#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

#include "bench/simplify_peers.h"

namespace mw::test {
namespace {

double rms(const Mesh& mesh, const std::string& quality, double ratio)
{
    const Mesh out = applied("decimate-quadric", mesh, ("quality=" + quality + ",ratio=" + std::to_string(ratio)).c_str());
    return bench::rmsDistance(mesh, out, 40'000);
}

// The order of edges of equal cost, of which a machine part has many, moves the distance by 3 %.
TEST(DecimateCgal, AsCloseAsLindstromAndTurk)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"closed_genus0/fandisk.off", "closed_genus0/max_planck_5k.obj"}) {
        const Mesh mesh = meshOf(data / "meshes" / name);
        double seconds = 0;
        const double theirs = bench::rmsDistance(mesh, bench::cgalLindstromTurk(mesh, 0.1, seconds), 40'000);
        EXPECT_LE(rms(mesh, "fast", 0.1), 1.1 * theirs) << name;
        EXPECT_LE(rms(mesh, "balanced", 0.1), 1.1 * theirs) << name;
        EXPECT_LE(rms(mesh, "best", 0.1), 1.0 * theirs) << name;
        EXPECT_LE(rms(mesh, "textbook", 0.1), 1.4 * theirs) << name;
    }
}

// OpenMesh's decimater keeps vertices where they are, as `optimal=false` does.
TEST(DecimateCgal, CloserThanTheReference)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh mesh = meshOf(data / "meshes/closed_higher_genus/rocker-arm.obj");
    const double theirs = bench::rmsDistance(mesh, applied("decimate-openmesh", mesh, "ratio=0.1"), 40'000);
    EXPECT_LT(rms(mesh, "balanced", 0.1), theirs);
    EXPECT_LT(theirs, 5 * rms(mesh, "balanced", 0.1)) << "a reference, not nonsense";
}

}  // namespace
}  // namespace mw::test
