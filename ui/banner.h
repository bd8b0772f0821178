// A line above the view: what was read, what could not be done. Never a dialog.
#pragma once
#include <QWidget>
#include <vector>

#include "core/error.h"

class QLabel;
class QPushButton;
class QTimer;

namespace mw {

class Banner : public QWidget {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent);
    void notice(const QString& text, const std::vector<Warning>& warnings);  ///< goes by itself unless there are warnings
    void trouble(const QString& text);
    QString text() const;

private:
    void show(const QString& text, const char* iconName, const QColor& color);
    QLabel *icon_, *text_, *list_;
    QPushButton* more_;
    QTimer* timer_;
};

}  // namespace mw
