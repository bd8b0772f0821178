// Large meshes for benchmarks, made or read once, and how time is taken.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <time.h>

#include "core/io/io.h"
#include "core/mesh/mesh.h"

#include "bench/scan_mesh.h"

namespace mw::bench {

/// The mesh of scan_mesh.h, made once.
inline const Mesh& scanLike()
{
    static const Mesh mesh = scanMesh();
    return mesh;
}

/// The dragon of the test data; an empty mesh without it.
inline const Mesh& dragon()
{
    static const Mesh mesh = [] {
        const char* data = std::getenv("MESHWRIGHT_DATA");
        const std::filesystem::path file = std::filesystem::path(data ? data : "") / "meshes/large/dragon_871k.ply";
        if (!data || !std::filesystem::exists(file)) return Mesh();
        const Scene scene = readFile(file).scene;
        return scene.find(scene.meshes().at(0))->base;
    }();
    return mesh;
}

/// CPU seconds of the quickest of several runs, all threads together: other programs on the machine disturb it little.
template <class F>
double quickest(int runs, const F& f)
{
    const auto now = [] {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    };
    double best = 1e30;
    for (; runs > 0; --runs) {
        const double start = now();
        f();
        best = std::min(best, now() - start);
    }
    return best;
}

}  // namespace mw::bench
