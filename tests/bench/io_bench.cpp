// Reading and writing against the floor (the bytes alone: read into plain memory, and line ends found) and against Assimp. Counter "floors" is the
// middle one of the ratios of processor time, the floor taken in turn with each: all of these use one thread, and time spent waiting for others does
// not count. Before each turn the memory of the last one is given back, so that all pay for fresh pages, as a program that opens a file does.
#include <algorithm>
#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

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

double processorSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Of one call, with fresh memory.
template <class Work>
double secondsOf(const Work& work)
{
    malloc_trim(0);
    const double begin = processorSeconds();
    work();
    return processorSeconds() - begin;
}

/// Runs the floor and the work in turn for each iteration.
template <class Floor, class Work>
void measure(benchmark::State& state, const std::string& name, const Floor& floor, const Work& work)
{
    if (!Files::get().has(name)) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    double best = 1e9, bestFloor = 1e9;
    std::vector<double> ratios;
    for (auto _ : state) {
        const double bare = secondsOf(floor), all = secondsOf(work);
        best = std::min(best, all);
        bestFloor = std::min(bestFloor, bare);
        ratios.push_back(all / bare);
    }
    std::nth_element(ratios.begin(), ratios.begin() + ptrdiff_t(ratios.size() / 2), ratios.end());
    state.counters["best_ms"] = best * 1e3;
    state.counters["floor_ms"] = bestFloor * 1e3;
    state.counters["floors"] = ratios[ratios.size() / 2];
}

/// Straight from the system: what malloc gives depends on what was freed before, and may lie on large pages for that.
class PlainMemory {
public:
    explicit PlainMemory(size_t size) : size_(size), bytes_(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))
    {
        if (bytes_ == MAP_FAILED) throw std::bad_alloc();
    }
    ~PlainMemory() { ::munmap(bytes_, size_); }
    PlainMemory(const PlainMemory&) = delete;
    PlainMemory& operator=(const PlainMemory&) = delete;
    char* begin() const { return static_cast<char*>(bytes_); }
    char* end() const { return begin() + size_; }

private:
    size_t size_;
    void* bytes_;
};

void bareRead(const std::string& name)
{
    const PlainMemory bytes(fs::file_size(Files::get().of(name)));
    std::ifstream(Files::get().of(name), std::ios::binary).read(bytes.begin(), bytes.end() - bytes.begin());
    size_t lines = 0;
    if (!name.ends_with(".ply"))
        for (const char* p = bytes.begin(); (p = static_cast<const char*>(std::memchr(p, '\n', size_t(bytes.end() - p)))); ++p) ++lines;
    benchmark::DoNotOptimize(lines);
}
template <class Work>
void againstReading(benchmark::State& state, const std::string& name, const Work& work)
{
    measure(
        state, name, [&] { bareRead(name); }, work);
}

void toArrays(benchmark::State& state, const std::string& name)
{
    againstReading(state, name, [&] { benchmark::DoNotOptimize(readFile(Files::get().of(name)).scene.meshes().size()); });
}
void toHalfedges(benchmark::State& state, const std::string& name)
{
    againstReading(state, name, [&] {
        const Imported in = readFile(Files::get().of(name));
        benchmark::DoNotOptimize(in.scene.find(in.scene.meshes()[0])->base.halfedges().boundaryEdges);
    });
}
void assimp(benchmark::State& state, const std::string& name)
{
    againstReading(state, name, [&] {
        const aiScene* scene = aiImportFile(Files::get().of(name).c_str(), 0);
        benchmark::DoNotOptimize(scene->mNumMeshes);
        aiReleaseImport(scene);
    });
}
void write(benchmark::State& state, const std::string& name)
{
    if (!Files::get().has(name)) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    const Imported in = readFile(Files::get().of(name));
    const FileBytes bytes = readBytes(Files::get().of(name));
    const auto bareWrite = [&] {
        OutputFile out(Files::get().of("copy"));
        out.write(bytes.data(), bytes.size());
        out.commit();
    };
    measure(state, name, bareWrite,
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
            add("arrays", toArrays, file, 15);
            add("halfedges", toHalfedges, file, 8);
            add("assimp", assimp, file, 3);
            add("write", write, file, 8);
        }
    }
    return 0;
}();

}  // namespace
}  // namespace mw::bench
