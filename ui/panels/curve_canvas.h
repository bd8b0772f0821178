// The plane on which a control polygon is edited by hand, with each iteration of the curve over it.
#pragma once
#include <QColor>
#include <QWidget>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace mw {

/// A click beside everything adds a point (within a segment when it is near one, else at the end), a drag moves one, Shift keeps to one axis,
/// Alt and a click removes it. Wheel: zoom to the pointer; middle button: pan; Home: fit. With the keyboard: comma and full stop choose a point,
/// the arrows move it, Insert puts one after it, Delete removes it. A point that an edit puts out of sight makes all fit again.
class CurveCanvas : public QWidget {
    Q_OBJECT

public:
    using Points = std::vector<glm::dvec2>;
    explicit CurveCanvas(QWidget* parent);
    void setPolygon(Points points, bool closed);
    const Points& points() const { return points_; }
    void setIterations(std::vector<Points> iterations);  ///< [k] after k + 1 rounds
    void setSelected(int point);
    int selected() const { return selected_; }
    void fit();
    QPointF placeOf(glm::dvec2 p) const;
    glm::dvec2 at(QPointF place) const;
    QRect legend() const;                     ///< where it is drawn: in the corner where it hides the fewest points
    static QColor colorOf(size_t iteration);  ///< 0 is the polygon; of the theme in use

signals:
    /// The polygon was changed; `what` names it when it is done ("move point 3"), empty while a drag goes on.
    void edited(const QString& what);
    void selectionChanged(int point);

protected:
    void paintEvent(QPaintEvent* e) override;
    void wheelEvent(QWheelEvent* e) override;
    void mousePressEvent(QMouseEvent* e) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void keyPressEvent(QKeyEvent* e) override;
    void resizeEvent(QResizeEvent* e) override;

private:
    int pointAt(QPointF place) const;
    size_t placeFor(QPointF place) const;
    void addPoint(size_t index, glm::dvec2 p, bool drag);
    void removePoint(int point);
    void keepInSight(int point);
    QSize legendSize() const;
    Qt::Corner freeCorner() const;
    void paintLegend(class QPainter& p);

    Points points_;
    std::vector<Points> iterations_;
    bool closed_ = false;
    bool fitted_ = false;  // nobody has zoomed or panned since all was made to fit
    int selected_ = -1, dragged_ = -1, hovered_ = -1;
    glm::dvec2 centre_{0}, dragStart_{0};
    double scale_ = 100;  // pixels a unit
    bool moved_ = false, added_ = false, panning_ = false;
    QPointF last_;
    Qt::Corner legendCorner_ = Qt::TopLeftCorner;  // stays while a point is dragged
};

}  // namespace mw
