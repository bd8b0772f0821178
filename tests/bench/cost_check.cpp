// What operations take, beside what core/catalog/cost.h tells of them. Arguments: mesh files. Ends with status 1 when an operation takes three times
// as long as told, or a third, on a mesh of 50 thousand faces or more.
#include <cstdio>
#include <fstream>
#include <string>
#include <time.h>

#include "core/catalog/cost.h"
#include "core/io/io.h"

namespace mw {
namespace {

double processorSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Of this process, in bytes: "VmRSS:" now, "VmHWM:" the peak.
double memory(const char* key)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
        if (word == key) {
            double kilobytes = 0;
            status >> kilobytes;
            return 1024 * kilobytes;
        }
    return 0;
}

/// A copy with nothing derived from it yet.
Mesh fresh(const Mesh& m)
{
    const auto copy = [](const auto& a) {
        using T = std::decay_t<decltype(a[0])>;
        return Shared<T>(Array<T>(a.begin(), a.end()));
    };
    return Mesh(copy(m.positions()), copy(m.faceStart()), copy(m.cornerVertex()));
}

/// `others`: the further meshes that an operation names.
bool check(const Mesh& mesh, const char* id, const char* values, const Others& others)
{
    const Operation& op = operation(id);
    const Mesh input = fresh(mesh);
    const ParameterValues given = parsed(op.parameters, values);
    const Cost told = *expectedCost(op, sizeOf(input), given);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins anew
    const double before = memory("VmRSS:"), begin = processorSeconds();
    Value result;
    try {
        result = apply(op, input, given, nullptr, others);
    } catch (const Error& e) {
        std::printf("%-17s %-22s refused: %.100s\n", id, values, e.what());
        return true;
    }
    const double seconds = processorSeconds() - begin, bytes = memory("VmHWM:") - before;
    const double ratio = told.seconds / seconds;
    std::printf("%-17s %-22s %9zu -> %9zu F (told %9zu)  %8.3f s (told %8.3f, %4.2f)  %7.1f MB (told %7.1f)\n", id, values, input.faceCount(),
                std::get<Mesh>(result).faceCount(), told.result.faces, seconds, told.seconds, ratio, bytes / 1e6, told.bytes / 1e6);
    return input.faceCount() < 50'000 || seconds < 0.02 || (ratio < 3 && ratio > 1.0 / 3);
}

}  // namespace
}  // namespace mw

int main(int count, char** words)
{
    bool good = true;
    for (int i = 1; i < count; ++i) {
        const mw::Scene scene = mw::readFile(words[i]).scene;
        const mw::Mesh& mesh = scene.find(scene.meshes().at(0))->base;
        const char* const calls[][2] = {{"decimate-quadric", "ratio=0.5"},
                                        {"decimate-quadric", "ratio=0.1"},
                                        {"subdivide-loop", "levels=1"},
                                        {"subdivide-loop", "levels=2"},
                                        {"subdivide-catmull-clark", "levels=2"},
                                        {"subdivide-butterfly", ""},
                                        {"subdivide-sqrt3", ""},
                                        {"split-dyadic", ""},
                                        {"split-nadic", "n=3"},
                                        {"embed-planar", ""},
                                        {"embed-planar", "weights=mean-value"},
                                        {"embed-spherical", ""},
                                        {"cut", ""},
                                        {"morph", "other=half,method=spherical"},
                                        {"morph", "other=half,method=barycentric"},
                                        {"smooth", ""},
                                        {"smooth", "iterations=40"},
                                        {"smooth", "weights=cotangent"},
                                        {"weld", ""},
                                        {"repair", ""},
                                        {"orient", ""},
                                        {"fill-holes", ""}};
        const mw::Operation& simplify = mw::operation("decimate-quadric");
        const mw::Others others{{"other", std::get<mw::Mesh>(mw::apply(simplify, mesh, mw::parsed(simplify.parameters, "ratio=0.5")))}};
        for (const auto& call : calls) good = mw::check(mesh, call[0], call[1], others) && good;
    }
    return good ? 0 : 1;
}
