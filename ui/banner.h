// A line above the view: what was read, what could not be done. Never a dialog.
#pragma once
#include <QColor>
#include <QElapsedTimer>
#include <QWidget>
#include <functional>
#include <vector>

#include "core/error.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTimer;

namespace mw {

class IconLabel;
struct Tokens;

class Banner : public QWidget {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent);
    void notice(const QString& text, const std::vector<Warning>& warnings);  ///< goes by itself unless there are warnings
    void trouble(const QString& text);                                       ///< several within a second and a half are shown together
    void ask(const QString& text);                                           ///< stays until something is chosen of what is offered
    /// One more thing to do about what it says, until it says something else.
    void offer(const QString& verb, const QString& tip, std::function<void()> run);
    QString text() const;

private:
    void show(const QString& text, const char* iconName, QColor Tokens::*color);
    IconLabel* icon_;
    QLabel *text_, *list_;
    QHBoxLayout* line_;
    QList<QPushButton*> offers_;
    QPushButton* more_;
    QTimer* timer_;
    QElapsedTimer sinceTrouble_;
};

}  // namespace mw
