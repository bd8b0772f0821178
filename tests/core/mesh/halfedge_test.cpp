// The half-edge view: always a manifold that shows the payload, and equal to OpenMesh's own add_face where that takes every face.
#include "core/mesh/halfedge.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

using HH = OpenMesh::HalfedgeHandle;
using VH = OpenMesh::VertexHandle;
using FH = OpenMesh::FaceHandle;

void expectLinked(const HalfedgeView& view)
{
    const auto& k = view.kernel;
    size_t boundary = 0;
    for (size_t i = 0; i < k.n_halfedges(); ++i) {
        const HH h{int(i)}, next = k.next_halfedge_handle(h);
        ASSERT_TRUE(next.is_valid());
        ASSERT_EQ(k.prev_halfedge_handle(next), h);
        ASSERT_EQ(k.to_vertex_handle(h), k.from_vertex_handle(next));
        ASSERT_EQ(k.face_handle(next), k.face_handle(h));
        ASSERT_NE(k.to_vertex_handle(h), k.from_vertex_handle(h));
        boundary += k.is_boundary(h);
    }
    ASSERT_EQ(boundary, view.boundaryEdges);
}

/// One fan a vertex, at most one boundary half-edge out of it, and that one first.
void expectOneFanEach(const HalfedgeView& view)
{
    const auto& k = view.kernel;
    std::vector<uint32_t> outgoing(k.n_vertices());
    for (size_t i = 0; i < k.n_halfedges(); ++i) ++outgoing[size_t(k.from_vertex_handle(HH(int(i))).idx())];
    for (size_t i = 0; i < k.n_vertices(); ++i) {
        const VH v{int(i)};
        uint32_t count = 0, boundary = 0;
        for (const auto h : k.voh_range(v)) {
            boundary += k.is_boundary(HH(h));
            ASSERT_EQ(k.from_vertex_handle(HH(h)), v);
            ASSERT_LE(++count, outgoing[i]);
        }
        ASSERT_EQ(count, outgoing[i]);
        ASSERT_LE(boundary, 1u);
        ASSERT_TRUE(boundary == 0 || k.is_boundary(k.halfedge_handle(v)));
    }
}

/// Every face as in the payload, from its first corner.
void expectPayload(const Mesh& mesh, const HalfedgeView& view)
{
    const auto& k = view.kernel;
    size_t corners = 0;
    for (size_t i = 0; i < k.n_faces(); ++i) {
        const FH f{int(i)};
        const auto face = mesh.face(view.faceOf(uint32_t(i)));
        size_t c = 0;
        for (const auto v : k.fv_range(f)) {
            ASSERT_LT(c, face.size());
            ASSERT_EQ(view.vertexOf(uint32_t(v.idx())), face[c++]);
        }
        ASSERT_EQ(c, face.size());
        for (c = 0; c < face.size(); ++c, ++corners) {
            const HH h{int(view.cornerHalfedge[mesh.faceStart()[view.faceOf(uint32_t(i))] + c])};
            ASSERT_EQ(k.face_handle(h), f);
            ASSERT_EQ(view.vertexOf(uint32_t(k.from_vertex_handle(h).idx())), face[c]);
        }
    }
    ASSERT_EQ(k.n_faces() + view.degenerateFaces, mesh.faceCount());
    ASSERT_EQ(corners + view.boundaryEdges, k.n_halfedges());
}

/// Handle by handle, then the rings.
void expectEqual(const OpenMesh::PolyConnectivity& a, const OpenMesh::PolyConnectivity& b)
{
    ASSERT_EQ(a.n_vertices(), b.n_vertices());
    ASSERT_EQ(a.n_edges(), b.n_edges());
    ASSERT_EQ(a.n_faces(), b.n_faces());
    for (size_t i = 0; i < a.n_halfedges(); ++i) {
        const HH h{int(i)};
        ASSERT_EQ(a.to_vertex_handle(h), b.to_vertex_handle(h));
        ASSERT_EQ(a.next_halfedge_handle(h), b.next_halfedge_handle(h));
        ASSERT_EQ(a.face_handle(h), b.face_handle(h));
    }
    for (size_t i = 0; i < a.n_faces(); ++i) ASSERT_EQ(a.halfedge_handle(FH(int(i))), b.halfedge_handle(FH(int(i))));
    for (size_t i = 0; i < a.n_vertices(); ++i) {
        const VH v{int(i)};
        ASSERT_EQ(a.is_boundary(v), b.is_boundary(v));
        std::vector<int> ringA, ringB;
        for (const auto x : a.vv_range(v)) ringA.push_back(x.idx());
        for (const auto x : b.vv_range(v)) ringB.push_back(x.idx());
        if (!ringA.empty() && !a.is_boundary(v)) std::rotate(ringB.begin(), std::find(ringB.begin(), ringB.end(), ringA[0]), ringB.end());
        ASSERT_EQ(ringA, ringB);
    }
}

/// What OpenMesh makes of the mesh; false when it refused a face.
bool addFaces(const Mesh& mesh, OpenMesh::PolyConnectivity& k)
{
    for (size_t v = 0; v < mesh.vertexCount(); ++v) k.add_vertex();
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<VH> face;
        for (const uint32_t v : mesh.face(f)) face.emplace_back(int(v));
        if (!k.add_face(face).is_valid()) return false;
    }
    return true;
}

/// What a view did with its mesh; `comparable` when add_face took every face.
struct Outcome {
    size_t copies, degenerate, boundary;
    bool comparable;
    bool operator==(const Outcome&) const = default;
};

Outcome outcomeOf(const Polygons& p, bool compare = true)
{
    const Mesh mesh = p.mesh();
    const HalfedgeView view(mesh);
    expectLinked(view);
    expectOneFanEach(view);
    expectPayload(mesh, view);
    bool comparable = false;
    if (compare && view.extraVertex.empty() && view.degenerateFaces == 0) {
        OpenMesh::PolyConnectivity own;
        comparable = addFaces(mesh, own);
        if (comparable) expectEqual(view.kernel, own);
    }
    return {view.extraVertex.size(), view.degenerateFaces, view.boundaryEdges, comparable};
}

class HalfedgeView_ : public testing::Test {
protected:
    void SetUp() override
    {
        omerr().disable();
        omlog().disable();
        omout().disable();
    }
};

}  // namespace

TEST_F(HalfedgeView_, EqualsAddFaceOnManifolds)
{
    EXPECT_EQ(outcomeOf(Polygons()), (Outcome{0, 0, 0, true}));
    EXPECT_EQ(outcomeOf(Polygons::points(5)), (Outcome{0, 0, 0, true}));
    EXPECT_EQ(outcomeOf(tetrahedron()), (Outcome{0, 0, 0, true}));
    EXPECT_EQ(outcomeOf(cube()), (Outcome{0, 0, 0, true}));
    EXPECT_EQ(outcomeOf(grid(20, false, false)), (Outcome{0, 0, 80, true}));
    EXPECT_EQ(outcomeOf(grid(20, false, true)), (Outcome{0, 0, 80, true}));
    EXPECT_EQ(outcomeOf(grid(20, true, false)), (Outcome{0, 0, 0, true}));
    EXPECT_EQ(outcomeOf(Polygons::points(6).face({0, 1, 2, 3, 4})), (Outcome{0, 0, 5, true}));
    EXPECT_EQ(outcomeOf(Polygons::points(3).face({0, 1, 2}).face({2, 1, 0})), (Outcome{0, 0, 0, true}));
}

TEST_F(HalfedgeView_, SplitsWhatIsNoManifold)
{
    EXPECT_EQ(outcomeOf(Polygons::points(5).face({0, 1, 2}).face({1, 0, 3}).face({0, 1, 4})), (Outcome{2, 0, 7, false}));  // third face
    EXPECT_EQ(outcomeOf(Polygons::points(5).face({0, 1, 2}).face({0, 3, 4})), (Outcome{1, 0, 6, false}));                  // bow tie
    EXPECT_EQ(outcomeOf(Polygons::points(4).face({0, 1, 2}).face({0, 1, 3})), (Outcome{2, 0, 6, false}));                  // same direction
    outcomeOf(Polygons::points(5).face({0, 1, 2}).face({1, 0, 3}).face({0, 1, 4}).face({0, 4, 3}).face({4, 1, 3}));        // two edges 0 1
    Polygons twice = Polygons::points(4);
    for (int k = 0; k < 2; ++k) twice.face({0, 1, 2}).face({0, 2, 3}).face({0, 3, 1}).face({1, 3, 2});
    EXPECT_EQ(outcomeOf(twice), (Outcome{4, 0, 0, false}));
    Polygons hourglass = Polygons::points(7);
    for (const uint32_t o : {0u, 3u}) hourglass.face({0, o + 1, o + 2}).face({0, o + 2, o + 3}).face({0, o + 3, o + 1}).face({o + 1, o + 3, o + 2});
    EXPECT_EQ(outcomeOf(hourglass), (Outcome{1, 0, 0, false}));
    Polygons glued = grid(12, false, false);
    for (uint32_t& v : glued.corners) v = v == 90 ? 45 : v;
    EXPECT_EQ(outcomeOf(glued), (Outcome{1, 0, 48, false}));
    EXPECT_EQ(outcomeOf(moebius(20)), (Outcome{2, 0, 42, false}));
}

TEST_F(HalfedgeView_, LeavesDegenerateFacesOut)
{
    EXPECT_EQ(outcomeOf(Polygons::points(4).face({0, 1, 1}).face({0, 1}).face({}).face({0, 1, 2, 0, 3}).face({1, 2, 3})), (Outcome{0, 4, 3, false}));
    EXPECT_EQ(outcomeOf(Polygons::points(4).face({0, 1, 1})), (Outcome{0, 1, 0, false}));
    const Mesh mesh = Polygons::points(4).face({0, 1, 1}).face({1, 2, 3}).mesh();
    const HalfedgeView view(mesh);
    EXPECT_EQ(view.faceOf(0), 1u);
    EXPECT_EQ(view.cornerHalfedge[0], none);
}

TEST_F(HalfedgeView_, IsAManifoldWhateverComes)
{
    std::mt19937 random(1);
    for (int round = 0; round < 3000 && !HasFatalFailure(); ++round) {
        const uint32_t n = 3 + random() % 12;
        Polygons p = Polygons::points(n);
        for (uint32_t f = random() % 40; f--;) {
            for (uint32_t c = 2 + random() % 5; c--;) p.corners.push_back(random() % n);
            p.start.push_back(uint32_t(p.corners.size()));
        }
        outcomeOf(p, false);
    }
}

TEST_F(HalfedgeView_, ConeInRandomOrderTakesLinearTime)
{
    const uint32_t n = 300000;
    Polygons p = Polygons::points(n + 1);
    std::vector<uint32_t> order(n);
    for (uint32_t i = 0; i < n; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    for (const uint32_t i : order) p.face({0, 1 + i, 1 + (i + 1) % n});
    const Mesh mesh = p.mesh();
    const HalfedgeView& view = mesh.halfedges();  // with quadratic search it would not end
    EXPECT_EQ(view.kernel.n_edges(), 2u * n);
    EXPECT_EQ(view.boundaryEdges, n);
    EXPECT_EQ(view.splitVertices, 0u);
}
