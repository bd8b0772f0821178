// The lists of the step player: phases, numbers, roles.
#pragma once
#include <QListWidget>
#include <QTreeWidget>
#include <set>

#include "ui/steps/step_session.h"

namespace mw {

/// Phases with a tick when passed and an arrow at the present one; a click runs to the next step of that phase.
class PhaseList : public QListWidget {
    Q_OBJECT

public:
    explicit PhaseList(StepSession& steps, QWidget* parent);
    void refresh();

private:
    StepSession& steps_;
    QStringList shown_;
};

/// Elements in focus, and each number now and before; bold when it has changed. A click plots a number.
class NumberTable : public QTreeWidget {
    Q_OBJECT

public:
    explicit NumberTable(StepSession& steps, QWidget* parent);
    void refresh();

private:
    void addFocus();
    void addNumbers();
    std::vector<std::string> shownNumbers() const;
    void fitHeight();
    StepSession& steps_;
};

/// The signs of the roles with their names.
class RoleLegend : public QWidget {
    Q_OBJECT

public:
    explicit RoleLegend(QWidget* parent);
    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int w) const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    int columns(int w) const;
};

}  // namespace mw
