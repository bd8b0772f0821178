// One row of the stack: grip, enabled, name, counts, time, state, menu; below it, when open, the form and the progress.
#pragma once
#include <QFrame>

#include "core/scene/scene.h"
#include "ui/parameter_form.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace mw {

/// A small ring that fills while the row's operation runs.
class ProgressRing : public QWidget {
    Q_OBJECT

public:
    explicit ProgressRing(QWidget* parent);
    void setFraction(float f);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    float fraction_ = 0;
};

/// What the panel tells a row after each change.
struct RowState {
    QString counts, time, error;
    bool enabled = true, running = false, waits = false, shown = false;
    bool asks = false;  ///< for what the counts then say: it is never left out
    float fraction = 0;
    qint64 elapsed = 0;
};

class ModifierRow : public QFrame {
    Q_OBJECT

public:
    ModifierRow(const Modifier& m, QWidget* parent);
    void setState(const RowState& s);
    void setOpen(bool open, const Modifier& m);
    bool isOpen() const { return body_ != nullptr; }
    ParameterForm* form() const { return form_; }

signals:
    void toggled(bool on);
    void opened();
    void edited(const mw::ParameterValues& values);
    void committed(const mw::ParameterValues& values, const QString& what);
    void cancelled();
    void removeRequested();
    void duplicateRequested();
    void moved(int by);
    void droppedAt(int y);  ///< the grip was dragged to this height of the parent
    void stepRequested();
    void applyRequested();
    void showRequested();
    void copyRequested();

protected:
    void keyPressEvent(QKeyEvent* e) override;
    void resizeEvent(QResizeEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void makeHeader(const Modifier& m);
    void menu();
    void fitHeader();

    const Operation* op_;
    QString countsText_;
    bool asks_ = false;
    QVBoxLayout* box_;
    QLabel *grip_, *counts_, *time_, *error_, *errorIcon_;
    QCheckBox* on_;
    QPushButton* name_;
    QToolButton* menu_;
    ProgressRing* ring_;
    QWidget *errorBox_, *body_ = nullptr, *progressLine_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QLabel* left_ = nullptr;
    ParameterForm* form_ = nullptr;
};

}  // namespace mw
