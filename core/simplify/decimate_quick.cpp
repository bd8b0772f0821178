// The phases of the quick qualities, and what they show.
#include "core/simplify/decimate_quick.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>

#include "core/simplify/quick_fit.h"
#include "core/simplify/quick_worker.h"
#include "core/simplify/ranges.h"

namespace mw {

namespace {

using namespace quick;

constexpr size_t slice = 1 << 16;    // entries of the queue between two looks at whether to stop
constexpr size_t atOnce = 16;        // regions that are begun between two looks
constexpr int blockFaces = 1 << 14;  // half a megabyte of faces and as much of vertices
constexpr size_t cached = 1 << 17;   // faces of so small a mesh and their vertices, 8 MB, are near enough as they are
constexpr double growth = 3;         // octaves of cost while the faces become half as many

/// One region, and how far it is.
struct Piece {
    std::unique_ptr<Worker> worker;
    int nextFace, lastFace;
    size_t most;  // faces it may take away at this stage
    bool blockOpen = false, done = false;
};

class QuickDecimation {
public:
    QuickDecimation(Mesh input, const DecimateQuadric& p, bool watched);

    bool usesPieces() const { return usesPieces_; }
    /// Works on some pieces for a while; false when all are done.
    bool runPieces();
    bool raise();
    /// From here on one worker has everything.
    void joinPieces();
    bool runAll() { return whole_->run(Worker::last, slice, mostOfWhole()); }
    bool wantsMore() const { return faces() > target_; }

    /// The same one by one: the next edge that is due, whoever works on it; null when all is done.
    Worker* next(Candidate& c);

    size_t faces() const;
    size_t waiting() const;
    double progress() const { return first_ > target_ ? double(first_ - faces()) / double(first_ - target_) : 1; }

    Tables tables;

private:
    size_t mostOfWhole() const { return first_ - target_ - gone_; }
    uint32_t firstCap() const;
    bool openBlock(Piece& p);
    bool runPiece(Piece& p);
    Worker* nextOfPieces(Candidate& c);

    const DecimateQuadric parameters_;
    size_t first_, target_, gone_ = 0;
    double slack_;  // how many times the target blocks leave, regions half of that: few cheap collapses must be chosen from more
    std::vector<Piece> pieces_;
    std::unique_ptr<Worker> whole_;
    uint32_t cap_ = 0;
    int block_;
    bool usesPieces_ = false;
};

Rules rulesOf(const DecimateQuadric& p, const Mesh& input)
{
    const Bounds box = input.bounds();
    const glm::dvec3 size = box.size();
    const double side = std::max({size.x, size.y, size.z});
    Rules r;
    r.turn = float(std::cos(glm::radians(p.turn)));
    r.wall = float(p.border);
    r.bend = p.feature < 180 ? float(std::cos(glm::radians(p.feature))) : -1;
    r.endsOnly = !p.optimal;
    if (p.stop == DecimateQuadric::Stop::Error) r.deviation = side > 0 ? float(p.error * box.diagonal() / side) : 0;
    return r;
}

size_t targetOf(const DecimateQuadric& p, size_t faces)
{
    if (p.stop == DecimateQuadric::Stop::Error) return 0;
    const double wanted = p.stop == DecimateQuadric::Stop::Faces ? double(p.faces) : std::round(p.ratio * double(faces));
    return std::min(faces, size_t(wanted));
}

QuickDecimation::QuickDecimation(Mesh input, const DecimateQuadric& p, bool watched)
    : tables(input, rulesOf(p, input), watched), parameters_(p), first_(tables.faces.size()), target_(targetOf(p, first_))
{
    const bool blocks = p.quality == DecimateQuadric::Quality::Fast;
    const double share = double(target_) / double(std::max<size_t>(first_, 1));
    slack_ = share < 0.05 ? 4 : share < 0.2 ? 3 : 2;
    block_ = blocks ? blockFaces : int(first_);
    const bool pieces = blocks ? first_ > size_t(blockFaces) : tables.regions.size() > 1;
    usesPieces_ = p.stop != DecimateQuadric::Stop::Error && pieces && double(first_) > 1.5 * slack_ * double(target_);
    cap_ = firstCap();
    for (const Region& r : tables.regions) {
        if (!usesPieces_) break;
        const size_t inside = size_t(r.lastFace - r.firstFace), keeps = size_t(double(target_) * double(inside) / double(first_)) + 2;
        pieces_.push_back({std::make_unique<Worker>(tables, r.vertices, !blocks), r.firstFace, r.lastFace, inside > keeps ? inside - keeps : 0});
        pieces_.back().worker->reserve(blocks ? inside / 2 : inside * 3 / 2);
    }
    if (usesPieces_) return;
    whole_ = std::make_unique<Worker>(tables, Range{0, int(tables.vertices.size())}, first_ > cached);
    whole_->reserve(first_ * 3 / 2);
    whole_->rank(0, int(first_));
}

// The cost up to which a first pass goes: the middle one of some edges, and what it grows by until about twice the faces are left.
uint32_t QuickDecimation::firstCap() const
{
    std::vector<uint32_t> sample;
    for (size_t f = 0; f < first_; f += std::max<size_t>(1, first_ / 4096)) sample.push_back(BucketQueue::bucketOf(tables.target(int(4 * f)).cost));
    if (sample.empty()) return Worker::last;
    std::nth_element(sample.begin(), sample.begin() + std::ptrdiff_t(sample.size() / 2), sample.end());
    const double halvings = std::log2(double(first_) / (slack_ * std::max(1.0, double(target_))));
    const double octaves = 0.7 * growth * std::max(0.0, halvings);
    return std::min(sample[sample.size() / 2] + uint32_t(octaves * BucketQueue::perOctave), Worker::last);
}

size_t QuickDecimation::faces() const
{
    size_t left = first_ - gone_;
    for (const Piece& p : pieces_) left -= p.worker->removed();
    return whole_ ? left - whole_->removed() : left;
}

size_t QuickDecimation::waiting() const
{
    size_t n = whole_ ? whole_->waiting() : 0;
    for (const Piece& p : pieces_) n += p.worker->waiting();
    return n;
}

bool QuickDecimation::openBlock(Piece& p)
{
    if (p.nextFace == p.lastFace) return false;
    const int end = p.lastFace - p.nextFace > block_ ? p.nextFace + block_ : p.lastFace;
    p.worker->rank(p.nextFace, end);
    p.worker->rewind();
    p.nextFace = end;
    p.blockOpen = true;
    return true;
}

bool QuickDecimation::runPiece(Piece& p)
{
    if (!p.blockOpen && !openBlock(p)) return false;
    p.blockOpen = p.worker->run(cap_, slice, p.most);
    return p.worker->removed() < p.most;
}

bool QuickDecimation::runPieces()
{
    std::vector<Piece*> some;
    for (Piece& p : pieces_)
        if (!p.done && some.size() < atOnce) some.push_back(&p);
    tbb::parallel_for(
        size_t(0), some.size(), size_t(1), [&](size_t i) { some[i]->done = !runPiece(*some[i]); }, tbb::simple_partitioner());
    return !some.empty();
}

// Another octave when that leaves enough, then bucket by bucket, as one queue would. What waits between the regions does not count: there faces are
// still small.
bool QuickDecimation::raise()
{
    size_t edges = 0;
    for (const Piece& p : pieces_) edges += p.worker->deferred();
    const double inside = double(faces()) - 2.0 / 3 * double(edges);
    const bool far = inside >= slack_ * std::pow(2, 1 / growth) * double(target_);
    const uint32_t more = far ? BucketQueue::perOctave : 1;
    if (inside < slack_ / 2 * double(target_) || cap_ + more > Worker::last) return false;
    cap_ += more;
    for (Piece& p : pieces_) {
        p.done = p.worker->removed() >= p.most;
        p.blockOpen = true;
        p.worker->rewind();
    }
    return true;
}

void QuickDecimation::joinPieces()
{
    whole_ = std::make_unique<Worker>(tables, Range{0, int(tables.vertices.size())}, first_ > cached);
    for (Piece& p : pieces_) {
        gone_ += p.worker->removed();
        whole_->takeOver(*p.worker);
    }
    pieces_.clear();
}

Worker* QuickDecimation::nextOfPieces(Candidate& c)
{
    for (Piece& p : pieces_) {
        while (!p.done) {
            if (!p.blockOpen && !openBlock(p)) p.done = true;
            if (p.done) break;
            if (p.worker->removed() >= p.most)
                p.done = true;
            else if (p.worker->findNext(cap_, c) == Worker::Found::Edge)
                return p.worker.get();
            else
                p.blockOpen = false;
        }
    }
    return nullptr;
}

Worker* QuickDecimation::next(Candidate& c)
{
    while (!pieces_.empty()) {
        if (Worker* w = nextOfPieces(c)) return w;
        if (!raise()) joinPieces();
    }
    return wantsMore() && whole_->findNext(Worker::last, c) == Worker::Found::Edge ? whole_.get() : nullptr;
}

/// The lists of faces a step shows, numbered as the payload is.
struct Shown {
    std::vector<uint32_t> ring, removed;

    void around(const Tables& t, Worker& worker, int edge)
    {
        ring.clear(), removed.clear();
        for (const int c : worker.collapser().star(edge)) ring.push_back(t.faceIndex(c >> 2));
        removed.push_back(t.faceIndex(edge >> 2));
        if (t.twin(edge) >= 0) removed.push_back(t.faceIndex(t.twin(edge) >> 2));
    }
};

Generator fit(Tables& tables)
{
    constexpr size_t piece = 1 << 16;
    Fit f(tables);
    for (int round = 0; round < Fit::rounds; ++round) {
        for (size_t s = 0; s < f.samples(); s += piece) {
            const size_t count = std::min(piece, f.samples() - s);
            inPieces(
                count, [&](size_t begin, size_t end) { f.findNearest(s + begin, s + end); }, 4096);
            if (!tables.watched()) co_yield Step("fit").progress(1);
        }
        f.group();
        for (int i = 0; i < Fit::steps; ++i) {
            const double distance = f.move();
            if (tables.watched()) f.show();
            co_yield Step("fit").number("round", round + 1).number("distance", distance).progress(1);
        }
    }
    f.finish();
}

}  // namespace

Generator decimateQuick(Mesh input, DecimateQuadric parameters, Stage<Mesh>& stage)
{
    co_yield Step("order").progress(0);
    QuickDecimation d(std::move(input), parameters, stage.watched());
    Tables& tables = d.tables;
    stage.show([&tables] { return tables.payload(); });
    co_yield Step("sort").number("edges", double(d.waiting())).number("faces", double(d.faces())).progress(0);

    if (stage.watched()) {
        Candidate c;
        Shown shown;
        while (Worker* worker = d.next(c)) {
            const int v = tables.from(c.edge), w = tables.to(c.edge);
            const Float4 p = tables.vertices[size_t(v)].place + Float4{c.to.x, c.to.y, c.to.z, 0};
            const uint32_t vertex = tables.vertexIndex(v), other = tables.vertexIndex(w);
            const double before = double(d.faces());
            shown.around(tables, *worker, c.edge);
            co_yield Step("due")
                .edge(vertex, other, Role::Current)
                .vertex(vertex, Role::Current, "v")
                .vertex(other, Role::Current, "w")
                .point(tables.position(p), Role::New, "p")
                .ring(ElementKind::Face, Role::Removed, shown.removed)
                .ring(ElementKind::Face, Role::Neighbour, shown.ring)
                .number("cost", c.to.cost)
                .number("bucket", double(c.bucket))
                .number("least", BucketQueue::leastCost(c.bucket))
                .number("edges", double(d.waiting()))
                .number("faces", before)
                .progress(d.progress());
            const Attempt a = worker->tryNext(c);
            if (a.refusal != Refusal::None) {
                co_yield Step("put off")
                    .edge(vertex, other, Role::Rejected)
                    .vertex(vertex, Role::Rejected, "v")
                    .vertex(other, Role::Rejected, "w")
                    .number("reason", double(a.refusal))
                    .number("bucket", double(c.bucket))
                    .number("bucket again", double(c.bucket + Worker::retry))
                    .progress(d.progress());
            } else {
                co_yield Step("collapsed")
                    .vertex(tables.vertexIndex(v), Role::New, "p")
                    .number("cost", c.to.cost)
                    .number("bucket", double(c.bucket))
                    .number("faces", before)
                    .number("faces after", double(d.faces()))
                    .progress(d.progress());
            }
        }
    } else {
        while (d.usesPieces()) {
            while (d.runPieces()) co_yield Step("collapsed").number("faces", double(d.faces())).progress(d.progress());
            if (!d.raise()) break;
        }
        if (d.usesPieces()) d.joinPieces();
        while (d.wantsMore() && d.runAll()) co_yield Step("collapsed").number("faces", double(d.faces())).progress(d.progress());
    }
    if (parameters.quality == DecimateQuadric::Quality::Best && parameters.optimal && parameters.stop != DecimateQuadric::Stop::Error) {
        Generator fitting = fit(tables);
        while (fitting.next()) co_yield fitting.step();
    }
    stage.finish(tables.payload());
}

}  // namespace mw
