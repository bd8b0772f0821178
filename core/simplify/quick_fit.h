// The last part of quality `best`: the vertices of the simplified mesh are moved so that it lies as near as can be to the centres of the faces it
// came from. Centres and not vertices: on a convex place old vertices lie outside of the old surface's mean, and fitting to them swells the result.
#pragma once
#include "core/simplify/quick_mesh.h"

namespace mw::quick {

/// Rounds of: find the nearest face for each centre; then a few steps of least squares, point to plane. Vertices on curves and beside walls stay.
class Fit {
public:
    static constexpr int rounds = 2, steps = 3;

    explicit Fit(Tables& tables);

    size_t samples() const { return samples_.size(); }
    /// For centres [begin, end); begins where the last round ended.
    void findNearest(size_t begin, size_t end);
    /// After the last findNearest of a round.
    void group();
    /// Moves all vertices once; the root mean square of the distances before.
    double move();
    /// Puts the places into the tables.
    void show() const;
    /// Faces that turned far or folded get their old corners back; then the places go into the tables.
    void finish();

private:
    struct Nearest {
        uint32_t face;  // `none`: has no face to begin with
        float weight[3];
    };
    /// What the samples of a face ask of one of its corners.
    struct Pull {
        Symmetric matrix = zero;
        Float4 right{0, 0, 0, 0};
        float weight = 0;
    };

    void listFaces();
    void listAround();
    void takeSamples();
    uint32_t top(const Nearest& n) const;
    void pullOf(size_t face);
    void moveVertex(size_t v);
    void normals(std::vector<Float4>& out) const;
    bool undo(std::vector<uint8_t>& back) const;

    Tables& t_;
    std::vector<int> vertices_, faces_;          // of the tables, those that are left
    std::vector<uint32_t> corners_;              // three a face, as numbered here
    std::vector<uint32_t> start_, around_;       // faces around a vertex
    std::vector<uint32_t> sampleStart_, order_;  // samples of a face
    LargeBuffer<Float4> samples_;
    LargeBuffer<Nearest> nearest_;
    std::vector<uint32_t> root_;  // by vertex of the tables: number of the one it went into
    std::vector<Float4> places_, first_, normals_, firstNormals_;
    std::vector<Pull> pulls_;  // three a face
    std::vector<double> errors_;
    bool begun_ = false;
};

}  // namespace mw::quick
