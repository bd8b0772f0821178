// One collapse of the quick decimation: may the edge go, and doing it.
#pragma once
#include "core/simplify/quick_mesh.h"
#include "core/simplify/refusal.h"

namespace mw::quick {

struct Vectors;

/// What came of an attempt.
struct Attempt {
    Refusal refusal = Refusal::None;
    bool outside = false;         ///< it would touch what lies outside of the range: nothing was done
    int common = 0, allowed = 0;  ///< neighbours shared by the two rings, where that was counted
};

/// Tests and collapses; keeps the lists of the star it works on. One for each thread.
class Collapser {
public:
    explicit Collapser(Tables& tables, Range range) : t_(tables), range_(range) {}

    /// To `to` from the first end, corrected so that the volume stays.
    Attempt attempt(int h, const Target& to);
    /// Twins of the sides of the faces that went, in pairs that are twins now; below 0: none.
    const int (&joined() const)[4] { return joined_; }
    /// The faces that stay around the edge, for who watches; to be called before the attempt.
    const std::vector<int>& star(int h);

private:
    static constexpr int mostRing = 64, mostFan = 1024;
    static constexpr float unsafe = 1.5f;  // distances to planes fall short of those to triangles where these are long
    struct Fan {
        std::vector<int> out;   ///< half-edges out of the vertex
        std::vector<int> ring;  ///< their other ends, and for an open one the last neighbour
        bool open = false, tooMany = false;
    };
    struct Ring;
    enum class Walk { Closed, Open, Pinched, Odd, Outside };

    // The usual case: two vertices that are free and have closed rings.
    MW_INLINE Walk walk(int h, Ring& r) const;
    MW_INLINE Walk walkFan(int half, int tip, int& last, Ring& r) const;
    MW_INLINE Vectors armsOf(const int* v, Float4 origin) const;
    MW_INLINE void measure(Ring& r) const;
    MW_INLINE Refusal shape(Ring& r) const;
    MW_INLINE Attempt foldedOutside(const Ring& r) const;
    float moved(const Ring& r) const;
    MW_INLINE Attempt inner(int h, const Target& to, Ring& r);
    MW_INLINE void commit(int h, Ring& r);
    MW_INLINE void closeInner(int h, int g);

    // Any case, plainly.
    void fanOf(int h, Fan& fan) const;
    Attempt open(int h, const Target& to);
    Attempt linkOpen(int h);
    bool gatherStar(int h);
    Attempt shapeOpen(Float4 to);
    float movedOpen(Float4 to) const;
    float offLine(int h, Float4 p) const;
    bool foldedBefore(int h, size_t i, size_t j, int rim) const;
    void commitOpen(int h, Float4 to);
    void close(int h);

    Tables& t_;
    Range range_;
    int joined_[4] = {-1, -1, -1, -1};
    Fan fanA_, fanB_;
    std::vector<int> star_;
    std::vector<Float4> old_, new_;
};

}  // namespace mw::quick
