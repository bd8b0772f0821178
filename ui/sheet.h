// A sheet: what would be a dialog elsewhere, as a card over the view. Nothing waits for it; Esc closes it.
#pragma once
#include <QFrame>

class QVBoxLayout;

namespace mw {

class Sheet : public QFrame {
    Q_OBJECT

public:
    /// Takes the place of a sheet that is open already. `wanted` is cut to what the parent has room for.
    Sheet(const QString& title, QWidget* over, QSize wanted);
    void open();

protected:
    QVBoxLayout* body() { return body_; }
    void keyPressEvent(QKeyEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void place();
    QVBoxLayout* body_;
    QSize wanted_;
};

}  // namespace mw
