// The status bar: hint on the left; selection in words, counts of what is shown, and the running job on the right.
#pragma once
#include <QStatusBar>

#include "ui/session.h"

class QLabel;
class QProgressBar;
class QToolButton;
class QTimer;

namespace mw {

class StatusStrip : public QStatusBar {
    Q_OBJECT

public:
    StatusStrip(Session& session, QWidget* parent);
    void setHint(const QString& hint);
    void say(const QString& message);  ///< replaces the hint for 6 s

signals:
    void jobsClicked();

private:
    void refresh();
    void refreshJob();
    QString allCounts() const;
    Session& session_;
    QLabel *hint_, *selection_, *counts_;
    QToolButton *job_, *cancel_;
    QProgressBar* bar_;
    QTimer* timer_;
    QString hintText_;
    quint64 shownJob_ = 0;
    bool pending_ = false;
    std::shared_ptr<void> subscription_;
};

}  // namespace mw
