// Reading and writing against the floor (the bytes alone: read into plain memory, and line ends found) and against Assimp. Counter "floors" is the
// least processor time divided by that of the floor in the same run: all of these use one thread, and time spent waiting for others does not count.
// Before each turn the memory of the last one is given back, so that all pay for fresh pages, as a program that opens a file does.
#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <map>
#include <unistd.h>

#include "core/io/file.h"
#include "core/io/io.h"
#include "core/mesh/halfedge.h"
#include "tests/bench/scan_mesh.h"

namespace mw::bench {
namespace {

namespace fs = std::filesystem;

/// The generated mesh and the dragon as files, made at the first call and removed at the end.
class Files {
public:
    static const Files& get()
    {
        static const Files files;
        return files;
    }
    fs::path of(const std::string& name) const { return folder_ / name; }
    bool has(const std::string& name) const { return fs::exists(of(name)); }

private:
    Files() : folder_(fs::temp_directory_path() / ("meshwright-bench-" + std::to_string(::getpid())))
    {
        fs::create_directories(folder_);
        const Scene scan = sceneOf(scanMesh(), "scan");
        writeFile(scan, of("scan.obj"));
        writeFile(scan, of("scan.off"), {.binary = false});
        writeFile(scan, of("scan.ply"));
        const char* data = std::getenv("MESHWRIGHT_DATA");
        const fs::path dragon = fs::path(data ? data : "") / "meshes/large/dragon_871k.ply";
        if (!data || !fs::exists(dragon)) return;
        const Imported in = readFile(dragon);
        writeFile(in.scene, of("dragon.ply"));
        writeFile(in.scene, of("dragon.obj"));
        writeFile(in.scene, of("dragon.off"), {.binary = false});
    }
    ~Files()
    {
        std::error_code e;
        fs::remove_all(folder_, e);
    }
    fs::path folder_;
};

std::map<std::string, double>& floors()
{
    static std::map<std::string, double> f;
    return f;
}

double processorSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Runs `work` for each iteration; `isFloor`: what others of this name are measured against.
template <class Work>
void measure(benchmark::State& state, const std::string& name, bool isFloor, Work&& work)
{
    if (!Files::get().has(name.substr(0, name.find(' ')))) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    double best = 1e9;
    for (auto _ : state) {
        malloc_trim(0);
        const double begin = processorSeconds();
        work();
        best = std::min(best, processorSeconds() - begin);
    }
    if (isFloor) floors()[name] = best;
    state.counters["best_ms"] = best * 1e3;
    if (floors().contains(name)) state.counters["floors"] = best / floors()[name];
}

void bareRead(benchmark::State& state, const std::string& name, bool lineEnds)
{
    measure(state, name, true, [&] {
        const size_t size = fs::file_size(Files::get().of(name));
        const auto bytes = std::make_unique_for_overwrite<char[]>(size);
        std::ifstream(Files::get().of(name), std::ios::binary).read(bytes.get(), std::streamsize(size));
        const char* end = bytes.get() + size;
        size_t lines = 0;
        if (lineEnds)
            for (const char* p = bytes.get(); (p = static_cast<const char*>(std::memchr(p, '\n', size_t(end - p)))); ++p) ++lines;
        benchmark::DoNotOptimize(lines);
    });
}
void toArrays(benchmark::State& state, const std::string& name)
{
    measure(state, name, false, [&] { benchmark::DoNotOptimize(readFile(Files::get().of(name)).scene.meshes().size()); });
}
void toHalfedges(benchmark::State& state, const std::string& name)
{
    measure(state, name, false, [&] {
        const Imported in = readFile(Files::get().of(name));
        benchmark::DoNotOptimize(in.scene.find(in.scene.meshes()[0])->base.halfedges().boundaryEdges);
    });
}
void assimp(benchmark::State& state, const std::string& name)
{
    measure(state, name, false, [&] {
        const aiScene* scene = aiImportFile(Files::get().of(name).c_str(), 0);
        benchmark::DoNotOptimize(scene->mNumMeshes);
        aiReleaseImport(scene);
    });
}

void bareWrite(benchmark::State& state, const std::string& name)
{
    const std::string key = name + " written";
    const FileBytes bytes = readBytes(Files::get().of(name));
    measure(state, key, true, [&] {
        OutputFile out(Files::get().of("copy"));
        out.write(bytes.data(), bytes.size());
        out.commit();
    });
}
void write(benchmark::State& state, const std::string& name)
{
    const Imported in = readFile(Files::get().of(name));
    measure(state, name + " written", false,
            [&] { writeFile(in.scene, Files::get().of("copy" + fs::path(name).extension().string()), {.binary = name.ends_with(".ply")}); });
}

void add(const std::string& title, void (*f)(benchmark::State&, const std::string&), const std::string& file, int times)
{
    benchmark::RegisterBenchmark(("io/" + title + "/" + file).c_str(), [=](benchmark::State& s) { f(s, file); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(times);
}

const int registered = [] {
    for (const char* mesh : {"scan", "dragon"}) {
        for (const std::string& file : {std::string(mesh) + ".obj", std::string(mesh) + ".off", std::string(mesh) + ".ply"}) {
            const bool text = !file.ends_with(".ply");
            add(
                "floor",
                text ? +[](benchmark::State& s, const std::string& f) { bareRead(s, f, true); }
                     : +[](benchmark::State& s, const std::string& f) { bareRead(s, f, false); },
                file, 15);
            add("arrays", toArrays, file, 15);
            add("halfedges", toHalfedges, file, 8);
            add("assimp", assimp, file, 3);
            add("floor-write", bareWrite, file, 8);
            add("write", write, file, 8);
        }
    }
    return 0;
}();

}  // namespace
}  // namespace mw::bench
