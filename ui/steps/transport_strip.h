// The strip below the view while an algorithm is stepped: first, back, play, next, last, scrubber, unit, speed, close.
#pragma once
#include <QAbstractSlider>
#include <QWidget>
#include <vector>

#include "ui/session.h"

namespace mw {

/// 52 high; hides itself while nothing is stepped.
QWidget* makeTransportStrip(Session& session, QWidget* parent);

/// Space, arrows, Home and End on a widget and its children, active while something is stepped.
void installTransportShortcuts(StepSession& steps, QWidget* on);

/// The scrubber: a slider that marks where phases began and what was refused.
class StepScrubber : public QAbstractSlider {
    Q_OBJECT

public:
    explicit StepScrubber(QWidget* parent = nullptr);
    struct Tick {
        int position;
        bool rejected;
    };
    void setTicks(std::vector<Tick> ticks);
    int knobX() const;  ///< middle of the knob
    QSize sizeHint() const override { return {280, 22}; }
    QSize minimumSizeHint() const override { return {80, 22}; }

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* e) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void wheelEvent(QWheelEvent* e) override;

private:
    int xOf(double position) const;
    int positionAt(double x) const;
    std::vector<Tick> ticks_;
};

}  // namespace mw
