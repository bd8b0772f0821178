// The one place where OpenMesh's decimater is instantiated. It knows no pauses: it runs on a thread of its own, which is told to stop when the
// coroutine goes away.
#include "core/simplify/decimate_openmesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/error.h"
#include "core/mesh/topology.h"

namespace mw {

namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;
namespace decimater = OpenMesh::Decimater;

/// What both threads know of the work.
struct Signal {
    std::atomic<bool> stop{false};
    std::atomic<size_t> collapses{0};
};

/// Finds every collapse legal, counts them, and ends the work when it should stop.
template <class M>
class ModSignal : public decimater::ModBaseT<M> {
public:
    DECIMATING_MODULE(ModSignal, M, Signal);
    explicit ModSignal(M& mesh) : Base(mesh, true) {}
    float collapse_priority(const CollapseInfo&) override
    {
        if (signal->stop.load(std::memory_order_relaxed)) throw Cancelled{};
        return Base::LEGAL_COLLAPSE;
    }
    void postprocess_collapse(const CollapseInfo&) override { signal->collapses.fetch_add(1, std::memory_order_relaxed); }

    Signal* signal = nullptr;
};

void requireManifold(const Mesh& mesh)
{
    const TopologyReport& report = mesh.topology();
    const size_t odd = report.nonmanifoldEdges.size() + report.nonmanifoldVertices.size() + report.inconsistentEdges.size();
    if (odd == 0 && report.degenerateFaces.empty()) return;
    throw Error("OpenMesh's decimater needs a manifold, and this mesh has " + std::to_string(odd) + " edges and vertices where it is none and " +
                std::to_string(report.degenerateFaces.size()) + " degenerate faces; put Repair and Orient before it, or use Simplify by quadrics");
}

Surface surfaceOf(const Mesh& mesh)
{
    Surface s;
    const Shared<uint32_t> corners = mesh.isTriangles() ? mesh.cornerVertex() : mesh.triangulation().vertices;
    s.reserve(mesh.vertexCount(), corners.size() / 2, corners.size() / 3);
    for (const glm::vec3& p : mesh.positions()) s.add_vertex({p.x, p.y, p.z});
    for (size_t c = 0; c + 2 < corners.size(); c += 3)
        s.add_face(s.vertex_handle(corners[c]), s.vertex_handle(corners[c + 1]), s.vertex_handle(corners[c + 2]));
    return s;
}

Mesh payloadOf(const Surface& s, const Mesh& input)
{
    std::vector<uint32_t> number(s.n_vertices(), none);
    Array<glm::vec3> positions;
    Array<uint32_t> corners;
    for (const auto v : s.all_vertices()) {
        if (s.status(v).deleted()) continue;
        number[size_t(v.idx())] = uint32_t(positions.size());
        positions.push_back(input.positions()[size_t(v.idx())]);
    }
    for (const auto f : s.all_faces()) {
        if (s.status(f).deleted()) continue;
        for (const auto v : s.fv_range(f)) corners.push_back(number[size_t(v.idx())]);
    }
    return Mesh::triangles(std::move(positions), std::move(corners));
}

/// Runs the decimater beside the coroutine.
class Work {
public:
    Work(const Mesh& input, const DecimateOpenMesh& p) : surface_(surfaceOf(input)), faces_(surface_.n_faces()), parameters_(p)
    {
        const double wanted = p.stop == DecimateOpenMesh::Stop::Faces ? double(p.faces) : std::round(p.ratio * double(faces_));
        target_ = std::min(faces_, size_t(wanted));
        thread_ = std::thread([this] { run(); });
    }
    ~Work()
    {
        signal_.stop = true;
        thread_.join();
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    /// True when it has ended within that time; rethrows what it threw.
    bool endedWithin(std::chrono::milliseconds time)
    {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_for(lock, time, [&] { return ended_; })) return false;
        if (failure_) std::rethrow_exception(failure_);
        return true;
    }
    double progress() const { return target_ < faces_ ? std::min(1.0, 2.0 * double(signal_.collapses) / double(faces_ - target_)) : 1; }
    const Surface& surface() const { return surface_; }

private:
    void run()
    {
        try {
            decimate();
        } catch (...) {
            failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }
    void decimate()
    {
        surface_.update_face_normals();
        decimater::DecimaterT<Surface> d(surface_);
        ModSignal<Surface>::Handle signal;
        decimater::ModQuadricT<Surface>::Handle quadric;
        decimater::ModNormalFlippingT<Surface>::Handle flipping;
        d.add(signal);
        d.module(signal).signal = &signal_;
        if (parameters_.turn < 180) {
            d.add(flipping);
            d.module(flipping).set_max_normal_deviation(parameters_.turn);
        }
        d.add(quadric);
        d.initialize();
        d.decimate_to_faces(0, target_);
    }

    Surface surface_;
    size_t faces_, target_ = 0;
    DecimateOpenMesh parameters_;
    Signal signal_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool ended_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace

Generator decimateOpenMesh(Mesh input, DecimateOpenMesh parameters, Stage<Mesh>& stage)
{
    co_yield Step("build").progress(0);
    requireManifold(input);
    Work work(input, parameters);
    while (!work.endedWithin(std::chrono::milliseconds(30))) co_yield Step("decimate").progress(work.progress());
    stage.finish(payloadOf(work.surface(), input));
}

}  // namespace mw
