#include "ui/panels/uv_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <map>

#include "render/colors.h"

namespace mw {
namespace {

QColor inTheme(Theme theme, const char* dark, const char* light)
{
    return QColor(theme == Theme::Dark ? dark : light);
}

struct Painter {
    const UvSubject& subject;
    const UvView& view;
    const UvOptions& options;
    QSize size;
    const std::atomic<bool>* stop;

    QPointF at(glm::dvec2 t) const
    {
        return {size.width() / 2.0 + (t.x - view.centre.x) * view.perUnit, size.height() / 2.0 - (t.y - view.centre.y) * view.perUnit};
    }
    QPointF corner(size_t c) const { return at(subject.layout.corners[c]); }
    bool stopped() const { return stop && stop->load(std::memory_order_relaxed); }
    bool outside(QPointF a, QPointF b) const
    {
        return std::max(a.x(), b.x()) < 0 || std::min(a.x(), b.x()) > size.width() || std::max(a.y(), b.y()) < 0 ||
               std::min(a.y(), b.y()) > size.height();
    }
    /// Corners of a face on the picture; empty when it lies beside it.
    QPolygonF face(size_t f) const
    {
        QPolygonF p;
        const uint32_t start = subject.mesh.faceStart()[f];
        for (size_t k = 0; k < subject.mesh.face(f).size(); ++k) p << corner(start + k);
        const QRectF box = p.boundingRect();
        return outside(box.topLeft(), box.bottomRight()) ? QPolygonF() : p;
    }

    void squares(QPainter& p, const QRectF& tile) const
    {
        p.fillRect(tile, inTheme(options.theme, "#2B2F34", "#FFFFFF"));
        const double step = tile.width() / 8;
        for (int y = 0; y < 8; ++y)
            for (int x = (y & 1); x < 8; x += 2)
                p.fillRect(QRectF(tile.left() + x * step, tile.top() + y * step, step, step), inTheme(options.theme, "#363B41", "#E3E7EB"));
    }

    void tiles(QPainter& p) const
    {
        const QRectF tile(at({0, 1}), at({1, 0}));
        if (options.picture) {
            if (options.backdrop.isNull())
                squares(p, tile);
            else {
                p.setRenderHint(QPainter::SmoothPixmapTransform, tile.width() < 4 * options.backdrop.width());
                p.drawImage(tile, options.backdrop);
                p.setOpacity(options.theme == Theme::Dark ? 0.5 : 0.25);  // so that lines stay readable on bright pictures
                p.fillRect(tile, inTheme(options.theme, "#17191C", "#FFFFFF"));
                p.setOpacity(1);
            }
        }
        // A line a tile, while there is room for them.
        p.setPen(QPen(inTheme(options.theme, "#3D434A", "#C3C9D0"), 1));
        if (view.perUnit >= 12) {
            const glm::dvec2 half = glm::dvec2(size.width(), size.height()) / (2 * view.perUnit);
            for (double u = std::floor(view.centre.x - half.x); u <= view.centre.x + half.x + 1; ++u)
                p.drawLine(QPointF(at({u, 0}).x(), 0), QPointF(at({u, 0}).x(), size.height()));
            for (double v = std::floor(view.centre.y - half.y); v <= view.centre.y + half.y + 1; ++v)
                p.drawLine(QPointF(0, at({0, v}).y()), QPointF(size.width(), at({0, v}).y()));
        }
        p.setPen(QPen(inTheme(options.theme, "#7B838D", "#7D8690"), 1.4));
        p.setBrush(Qt::NoBrush);
        p.drawRect(tile);
    }

    void colours(QPainter& p) const
    {
        const Array<double>& values = subject.distortion.columns[options.colour == UvColour::Angle ? 0 : 1].values;
        const UvRange range = uvRangeOf(subject, options.colour);
        p.setPen(Qt::NoPen);
        for (size_t f = 0; f < values.size(); ++f) {
            if ((f & 1023) == 0 && stopped()) return;
            const QPolygonF shape = face(f);
            if (shape.isEmpty()) continue;
            p.setBrush(uvColourOf(options.colour, values[f], range));
            p.drawPolygon(shape);
        }
    }

    /// Lines a pixel apart would hide the colours under them: they fade with the room between them, as if the faces filled a unit square.
    double lineShare() const
    {
        const double apart = view.perUnit / std::sqrt(double(std::max<size_t>(1, subject.mesh.faceCount())));
        return std::clamp(apart / 6, 0.1, 1.0);
    }

    /// All these faces as one shape, so that hatching runs through.
    void fill(QPainter& p, const std::vector<uint32_t>& faces, const QBrush& wash, const QBrush& hatch) const
    {
        p.setPen(Qt::NoPen);
        if (hatch.style() != Qt::NoBrush && faces.size() <= 20'000) {
            // As one shape: where faces lie on each other the wash is not laid twice.
            QPainterPath path;
            path.setFillRule(Qt::WindingFill);
            for (const uint32_t f : faces)
                if (f < subject.mesh.faceCount()) path.addPolygon(face(f)), path.closeSubpath();
            p.fillPath(path, wash);
            p.fillPath(path, hatch);
            return;
        }
        for (size_t i = 0; i < faces.size(); ++i) {
            if ((i & 1023) == 0 && stopped()) return;
            if (faces[i] >= subject.mesh.faceCount()) continue;
            const QPolygonF shape = face(faces[i]);
            if (shape.isEmpty()) continue;
            for (const QBrush& b : {wash, hatch}) {
                if (b.style() == Qt::NoBrush) continue;
                p.setBrush(b);
                p.drawPolygon(shape);
            }
        }
    }

    /// Faces too small for their hatching to be seen get a ring, one for those that lie together.
    void ring(QPainter& p, const std::vector<uint32_t>& faces, const QColor& colour) const
    {
        constexpr double radius = 7;
        std::map<std::pair<int, int>, QRectF> cells;  // what lies in squares of that side
        for (const uint32_t f : faces) {
            const QRectF box = f < subject.mesh.faceCount() ? face(f).boundingRect().adjusted(-0.5, -0.5, 0.5, 0.5) : QRectF();
            if (box.width() > 1) cells[{int(box.center().x() / radius), int(box.center().y() / radius)}] |= box;
        }
        p.setBrush(Qt::NoBrush);
        while (!cells.empty()) {
            const QRectF group = takeGroup(cells, cells.begin()->first);
            if (std::max(group.width(), group.height()) > 2 * radius) continue;
            for (const auto& [line, width] : {std::pair(QColor("#101215"), 3.4), std::pair(colour, 1.8)}) {
                p.setPen(QPen(line, width));
                p.drawEllipse(group.center(), radius, radius);
            }
        }
    }

    /// The cell and those that touch it, and those that touch these.
    static QRectF takeGroup(std::map<std::pair<int, int>, QRectF>& cells, std::pair<int, int> first)
    {
        QRectF all;
        std::vector<std::pair<int, int>> open{first};
        while (!open.empty()) {
            const auto [x, y] = open.back();
            open.pop_back();
            const auto cell = cells.find({x, y});
            if (cell == cells.end()) continue;
            all |= cell->second;
            cells.erase(cell);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) open.emplace_back(x + dx, y + dy);
        }
        return all;
    }

    /// Those of at least so many pixels.
    void lines(QPainter& p, UvLayout::Kind kind, const QPen& pen, double least = 0) const
    {
        std::vector<QLineF> some;
        p.setPen(pen);
        const UvLayout& l = subject.layout;
        for (size_t e = 0; e < l.kinds.size(); ++e) {
            if (l.kinds[e] != kind) continue;
            const QPointF a = corner(l.edges[2 * e]), b = corner(l.edges[2 * e + 1]);
            if (outside(a, b) || std::hypot(b.x() - a.x(), b.y() - a.y()) < least) continue;
            some.emplace_back(a, b);
            if (some.size() < 4096) continue;
            if (stopped()) return;
            p.drawLines(some.data(), int(some.size()));
            some.clear();
        }
        p.drawLines(some.data(), int(some.size()));
    }

    void selected(QPainter& p) const
    {
        const ElementSet& s = options.selection;
        const QColor orange("#FF9A3C"), halo("#101215");
        if (s.kind == ElementKind::Face) {
            fill(p, s.indices, QColor(255, 154, 60, 90), Qt::NoBrush);
            for (const auto& [colour, width] : {std::pair(halo, 3.4), std::pair(orange, 1.6)}) {
                p.setPen(QPen(colour, width));
                p.setBrush(Qt::NoBrush);
                for (const uint32_t f : s.indices)
                    if (f < subject.mesh.faceCount()) p.drawPolygon(face(f));
            }
            return;
        }
        // Vertices and edges by marking what is selected and passing over the corners once.
        const auto& corners = subject.mesh.cornerVertex();
        if (s.kind == ElementKind::Vertex) {
            for (size_t c = 0; c < corners.size(); ++c) {
                if (!std::binary_search(s.indices.begin(), s.indices.end(), corners[c])) continue;
                p.setPen(QPen(halo, 1.4));
                p.setBrush(orange);
                p.drawEllipse(corner(c), 4, 4);
            }
            return;
        }
        std::vector<std::pair<uint32_t, uint32_t>> wanted;
        for (size_t i = 0; i + 1 < s.indices.size(); i += 2) wanted.emplace_back(std::minmax(s.indices[i], s.indices[i + 1]));
        std::sort(wanted.begin(), wanted.end());
        for (const auto& [colour, width] : {std::pair(halo, 5.0), std::pair(orange, 2.4)}) {
            p.setPen(QPen(colour, width));
            for (size_t e = 0; e < subject.layout.kinds.size(); ++e) {
                const uint32_t a = subject.layout.edges[2 * e], b = subject.layout.edges[2 * e + 1];
                const std::pair<uint32_t, uint32_t> ends = std::minmax(corners[a], corners[b]);
                if (std::binary_search(wanted.begin(), wanted.end(), ends)) p.drawLine(corner(a), corner(b));
            }
        }
    }
};

}  // namespace

UvRange uvRangeOf(const UvSubject& subject, UvColour colour)
{
    if (colour == UvColour::None) return {};
    Column c = subject.distortion.columns[colour == UvColour::Angle ? 0 : 1];
    if (colour == UvColour::Area)
        for (double& v : c.values) v = v > 0 ? std::max(v, 1 / v) : v;
    const auto [low, high] = heatRange(c);
    if (colour == UvColour::Angle) return {low, high};
    const double most = std::clamp(high, 1.1, 1e6);
    return {1 / most, most};
}

QColor uvColourOf(UvColour colour, double value, const UvRange& range)
{
    static const std::vector<uint8_t> table = heatTablePixels();
    if (!std::isfinite(value)) return QColor("#8A8F96");
    const double t = colour == UvColour::Angle ? (value - range.low) / std::max(range.high - range.low, 1e-30)
                                               : 0.5 + 0.5 * std::log(std::max(value, 1e-12)) / std::log(range.high);
    const size_t row = colour == UvColour::Angle ? viridisRow : divergingRow;
    const size_t i = 4 * (row * size_t(heatEntries) + size_t(std::lround(std::clamp(t, 0.0, 1.0) * (heatEntries - 1))));
    return QColor(table[i], table[i + 1], table[i + 2]);
}

double uvValueAt(UvColour colour, double share, const UvRange& range)
{
    return colour == UvColour::Angle ? range.low + share * (range.high - range.low) : std::pow(range.high, 2 * share - 1);
}

QImage uvPicture(const UvSubject& subject, const UvView& view, const UvOptions& options, QSize size, const std::atomic<bool>* stop)
{
    QImage image(size * options.pixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(options.pixelRatio);
    image.fill(inTheme(options.theme, "#1F2226", "#EDEFF2"));
    QPainter p(&image);
    const Painter all{subject, view, options, size, stop};
    all.tiles(p);
    // Not smoothed: what is behind would shine through between two faces, and all over where they are smaller than a pixel.
    if (options.colour != UvColour::None) all.colours(p);
    // Smooth lines are worth their time while there are not too many.
    p.setRenderHint(QPainter::Antialiasing, subject.layout.kinds.size() < 60'000);
    QColor inner = inTheme(options.theme, "#C8CED6", "#3A424B");
    inner.setAlpha(int((options.colour == UvColour::None ? 150 : 90) * all.lineShare()));
    // Where it is dense, lines would grey the colours, however faint they are.
    const double least = options.colour == UvColour::None ? 0 : 5;
    all.lines(p, UvLayout::Inside, QPen(inner, subject.layout.kinds.size() < 20'000 ? 1 : 0), least);
    if (all.stopped()) return {};
    QColor red("#FF6B5E"), wash = red;
    wash.setAlpha(95);
    QBrush hatch(red, Qt::BDiagPattern);
    all.fill(p, subject.layout.folded, wash, hatch);
    if (all.stopped()) return {};
    all.lines(p, UvLayout::Border, QPen(inTheme(options.theme, "#E6E8EB", "#1C2126"), 1.6));
    all.lines(p, UvLayout::Seam, QPen(QColor("#101215"), 2.8));  // halo
    all.lines(p, UvLayout::Seam, QPen(QColor("#FF9A3C"), 1.5));
    p.setRenderHint(QPainter::Antialiasing);
    all.ring(p, subject.layout.folded, red);
    all.selected(p);
    p.end();
    return all.stopped() ? QImage() : image;
}

}  // namespace mw
