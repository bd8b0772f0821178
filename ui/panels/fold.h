// A part of a panel under a heading that opens and shuts it. What was shut stays shut, also when the panel is made anew.
#pragma once
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace mw {

class Fold : public QWidget {
    Q_OBJECT

public:
    /// `key` tells folds apart in memory; `open` is how it starts.
    Fold(const QString& title, const QString& key, bool open, QWidget* parent);
    QVBoxLayout* inside() const { return inside_; }
    QToolButton* head() const { return head_; }
    bool isOpen() const { return head_->isChecked(); }
    void setTitle(const QString& title);

signals:
    void opened(bool open);

private:
    void show(bool open);
    QToolButton* head_;
    QWidget* body_;
    QVBoxLayout* inside_;
    QString key_;
};

}  // namespace mw
