// Sampling a joint and skinning a vertex against the loop one writes first with GLM: nanoseconds, and the share of that loop's.
#include <benchmark/benchmark.h>
#include <ctime>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "core/character/clip.h"
#include "core/character/skin.h"

namespace mw::bench {

namespace {

/// CPU seconds of the quickest of some runs.
template <class Work>
double quickest(const Work& work)
{
    double best = 1e9;
    for (int i = 0; i < 15; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

constexpr size_t vertices = 100000;
constexpr int slots = 4, joints = 60;

Mesh character(int influences)
{
    std::mt19937 random(1);
    Array<glm::vec3> positions(vertices, glm::vec3(1, 2, 3));
    Array<int32_t> numbers(vertices * slots);
    Array<float> weights(vertices * slots, 0.f), normals(vertices * 3, 0.577f);
    for (size_t v = 0; v < vertices; ++v)
        for (size_t k = 0; k < slots; ++k) {
            numbers[v * slots + k] = int32_t((v / 500 + random() % 3) % joints);  // neighbours follow the same joints
            if (int(k) < influences) weights[v * slots + k] = 1 / float(influences);
        }
    Mesh m(std::move(positions), {}, {});
    m = m.with(integerAttribute("joints", Domain::Vertex, slots, std::move(numbers)));
    m = m.with(floatAttribute("weights", Domain::Vertex, slots, std::move(weights)));
    return m.with(floatAttribute("normal", Domain::Vertex, 3, std::move(normals)));
}

void plainSkinning(const Mesh& m, const MeshPose& pose, std::vector<glm::vec3>& places, std::vector<glm::vec3>& normals)
{
    const auto j = m.find("joints")->integers();
    const auto w = m.find("weights")->floats(), n = m.find("normal")->floats();
    for (size_t v = 0; v < m.vertexCount(); ++v) {
        glm::mat4 sum(0.f);
        for (size_t k = 0; k < slots; ++k) sum += w[v * slots + k] * pose.joints[size_t(j[v * slots + k])];
        places[v] = glm::vec3(sum * glm::vec4(m.positions()[v], 1.f));
        normals[v] = glm::normalize(glm::inverseTranspose(glm::mat3(sum)) * glm::vec3(n[3 * v], n[3 * v + 1], n[3 * v + 2]));
    }
}

void skinning(benchmark::State& state)
{
    const Mesh m = character(int(state.range(0)));
    MeshPose pose;
    for (int i = 0; i < joints; ++i) pose.joints.push_back(glm::rotate(glm::mat4(1), float(i) * 0.1f, glm::vec3(1, 0, 0)));
    std::vector<glm::vec3> places(vertices), normals(vertices);
    const double plain = quickest([&] { plainSkinning(m, pose, places, normals); });
    const double ours = quickest([&] { benchmark::DoNotOptimize(posed(m, pose)); });
    for (auto _ : state) benchmark::DoNotOptimize(posed(m, pose));
    state.counters["ns_a_vertex"] = 1e9 * ours / double(vertices);
    state.counters["of_plain"] = ours / plain;
}

/// Rotations of as many joints as there are, a key each thirtieth of a second.
std::vector<Channel> walk()
{
    Array<double> times;
    for (int i = 0; i < 120; ++i) times.push_back(i / 30.0);
    const Shared<double> shared(std::move(times));
    std::vector<Channel> all(joints);
    for (size_t j = 0; j < all.size(); ++j) {
        Array<double> values;
        for (int i = 0; i < 120; ++i) {
            const glm::dquat q = glm::angleAxis(0.05 * i + double(j), glm::dvec3(0, 1, 0));
            values.insert(values.end(), {q.x, q.y, q.z, q.w});
        }
        all[j].path = Channel::Path::Rotation;
        all[j].components = 4;
        all[j].times = shared;
        all[j].values = std::move(values);
    }
    return all;
}

glm::dquat plainSample(const Channel& c, double time)
{
    size_t k = 0;
    while (k + 2 < c.keys() && c.times[k + 1] <= time) ++k;
    const auto at = [&](size_t i) { return glm::dquat(c.values[4 * i + 3], c.values[4 * i], c.values[4 * i + 1], c.values[4 * i + 2]); };
    return glm::slerp(at(k), at(k + 1), (time - c.times[k]) / (c.times[k + 1] - c.times[k]));
}

void sampling(benchmark::State& state)
{
    const std::vector<Channel> clip = walk();
    constexpr int frames = 2000;
    const auto time = [](int f) { return 3.9 * f / frames; };
    const double plain = quickest([&] {
        for (int f = 0; f < frames; ++f)
            for (const Channel& c : clip) benchmark::DoNotOptimize(plainSample(c, time(f)));
    });
    const auto all = [&] {
        for (int f = 0; f < frames; ++f)
            for (const Channel& c : clip) {
                const Channel* const list[] = {&c};
                benchmark::DoNotOptimize(sampled({}, list, time(f)));
            }
    };
    const double ours = quickest(all);
    for (auto _ : state) all();
    state.counters["ns_a_joint"] = 1e9 * ours / (double(frames) * double(joints));
    state.counters["of_plain"] = ours / plain;
}

BENCHMARK(skinning)->Arg(2)->Arg(4)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(sampling)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
