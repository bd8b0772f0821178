#include "ui/panels/fold.h"

#include <QHash>
#include <algorithm>

#include "ui/theme.h"

namespace mw {

namespace {
QHash<QString, bool>& remembered()
{
    static QHash<QString, bool> all;
    return all;
}
}  // namespace

Fold::Fold(const QString& title, const QString& key, bool open, QWidget* parent) : QWidget(parent), key_(key)
{
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(4);
    head_ = new QToolButton(this);
    head_->setCheckable(true);
    head_->setFixedHeight(std::max(24, fontMetrics().height() + 8));
    head_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a long name gives way to a narrow dock
    head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    head_->setFocusPolicy(Qt::TabFocus);
    head_->setStyleSheet(QString("QToolButton { text-align: left; background: %1; color: %2; font-weight: 700; padding: 2px 4px; }"
                                 "QToolButton:hover { background: %3; } QToolButton:focus { border: 1px solid %4; }")
                             .arg(tokens().raised.name(), tokens().text.name(), tokens().hover.name(), tokens().accentText.name()));
    body_ = new QWidget(this);
    inside_ = new QVBoxLayout(body_);
    inside_->setContentsMargins(0, 2, 0, 6);
    inside_->setSpacing(4);
    box->addWidget(head_);
    box->addWidget(body_);
    setTitle(title);
    connect(head_, &QToolButton::toggled, this, [this](bool on) {
        remembered()[key_] = on;
        show(on);
        emit opened(on);
    });
    const bool start = remembered().value(key_, open);
    head_->blockSignals(true);
    head_->setChecked(start);
    head_->blockSignals(false);
    show(start);
}

void Fold::setTitle(const QString& title)
{
    head_->setText(title);
    head_->setAccessibleName(title);
    head_->setToolTip("Show or hide " + title);
}

void Fold::show(bool open)
{
    head_->setIcon(icon(open ? "chevron" : "chevron-right", tokens().text2));
    body_->setVisible(open);
}

}  // namespace mw
