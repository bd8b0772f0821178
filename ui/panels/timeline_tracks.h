// Ruler, list of tracks and keys of a clip; the playhead over them (ui/UI.md, Timeline).
#pragma once
#include <QAbstractScrollArea>
#include <QPixmap>
#include <optional>
#include <vector>

#include "ui/session.h"

namespace mw {

/// All keys of one node, as the timeline shows them. The first track of a clip is the summary, of no node.
struct Track {
    struct Key {
        double time;
        Channel::Interpolation shape;
    };
    NodeId node;
    QString name, word;  ///< "lin", "sph", "step", "cubic"
    QColor chip;         ///< of its bone; not valid for other nodes
    std::vector<Key> keys;
};
/// In the order of the tree. Nodes without keys have no track.
std::vector<Track> tracksOf(const Scene& scene, const Clip& clip);

class TimelineTracks : public QAbstractScrollArea {
    Q_OBJECT

public:
    TimelineTracks(Session& session, QWidget* parent);

    static constexpr int listWidth = 236, rulerHeight = 24, rowHeight = 22;
    const std::vector<Track>& tracks() const { return tracks_; }
    double xOf(double seconds) const { return origin_ + (seconds - left_) * scale_; }
    double timeAt(double x) const { return left_ + (x - origin_) / scale_; }
    void fit();  ///< the whole clip
    void zoom(double factor, double x);

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void changeEvent(QEvent*) override;
    bool viewportEvent(QEvent*) override;
    void scrollContentsBy(int, int) override;

private:
    void take(const Change& change);
    void rebuild();
    void redraw();        // everything but the playhead
    void movePlayhead();  // that alone
    void keepInside();
    void layoutRows();
    int rowAt(double y) const;  // -1: none
    const Track::Key* keyAt(QPointF at) const;
    void select(int row);
    void scrollToSelected();
    QRect playheadRect() const;
    void paintStatic(QPainter& p);
    void paintRuler(QPainter& p);
    void paintRow(QPainter& p, int row, int y);
    void paintKeys(QPainter& p, const Track& track, int y, const QColor& color);
    void paintPlayhead(QPainter& p);
    double frameStep() const;  // between labels of the ruler, frames

    static constexpr int origin_ = listWidth + 14;  // x of the view's left time
    Session& session_;
    std::shared_ptr<void> subscription_;
    const Clip* shown_ = nullptr;
    std::vector<Track> tracks_;
    size_t keyCount_ = 0;
    double left_ = 0, scale_ = 100;  // seconds at the origin, pixels a second
    bool fitted_ = true;             // stays so when resized
    QPixmap still_;
    QRect lastPlayhead_;
    enum class Drag { None, Scrub, Pan } drag_ = Drag::None;
    double dragged_ = 0;
};

}  // namespace mw
