// A histogram of vertex valences, or of face sizes; a bar is a link to the elements it counts.
#pragma once
#include <QWidget>
#include <map>
#include <vector>

namespace mw {

class ValenceHistogram : public QWidget {
    Q_OBJECT

public:
    explicit ValenceHistogram(QWidget* parent = nullptr);
    void setValences(const std::map<size_t, size_t>& valences);
    void setFaces();  ///< it counts faces by their number of vertices; call it first
    struct Bar {
        size_t valence, count;
        bool orMore;
    };
    const std::vector<Bar>& bars() const { return bars_; }
    QRect barCell(int i) const;  ///< where a click hits bar i
    QSize sizeHint() const override { return {200, 76}; }

signals:
    void barClicked(size_t valence, bool orMore);

protected:
    void paintEvent(QPaintEvent*) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void keyPressEvent(QKeyEvent* e) override;
    void leaveEvent(QEvent*) override;

private:
    int barAt(QPoint p) const;
    QString textOf(int i) const;
    std::vector<Bar> bars_;
    bool faces_ = false;
    int hovered_ = -1, current_ = 0;
};

}  // namespace mw
