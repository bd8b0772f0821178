#include "ui/panels/modifier_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/elided.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {

namespace {
constexpr int wideRow = 400;  // from here on the time has a column of its own
}

ProgressRing::ProgressRing(QWidget* parent) : QWidget(parent)
{
    setFixedSize(16, 16);
    setAccessibleName("Running");
}

void ProgressRing::setFraction(float f)
{
    fraction_ = f;
    update();
}

void ProgressRing::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const QRectF r(2, 2, 12, 12);
    p.setPen(QPen(tokens().border, 2));
    p.drawEllipse(r);
    p.setPen(QPen(tokens().accentText, 2, Qt::SolidLine, Qt::RoundCap));
    p.drawArc(r, 90 * 16, -int(360 * 16 * std::clamp(fraction_, 0.04f, 1.f)));
}

ModifierRow::ModifierRow(const Modifier& m, QWidget* parent) : QFrame(parent), op_(findOperation(m.operation))
{
    setObjectName("modifierRow");
    setFocusPolicy(Qt::StrongFocus);
    box_ = new QVBoxLayout(this);
    box_->setContentsMargins(2, 2, 2, 2);
    box_->setSpacing(4);
    makeHeader(m);
    errorBox_ = new QWidget(this);
    auto* e = new QVBoxLayout(errorBox_);
    e->setContentsMargins(26, 0, 6, 6);
    error_ = new QLabel(errorBox_);
    error_->setProperty("bad", true);
    error_->setWordWrap(true);
    e->addWidget(error_);
    auto* remedies = new QHBoxLayout;
    auto* off = new QPushButton("Switch off", errorBox_);
    auto* remove = new QPushButton("Remove", errorBox_);
    for (auto* b : {off, remove}) b->setFocusPolicy(Qt::TabFocus);
    connect(off, &QPushButton::clicked, this, [this] { emit toggled(false); });
    connect(remove, &QPushButton::clicked, this, &ModifierRow::removeRequested);
    remedies->addWidget(off);
    remedies->addWidget(remove);
    remedies->addStretch(1);
    e->addLayout(remedies);
    box_->addWidget(errorBox_);
    errorBox_->hide();
}

void ModifierRow::makeHeader(const Modifier& m)
{
    auto* line = new QHBoxLayout;
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    grip_ = new QLabel(this);
    grip_->setPixmap(iconPixmap("grip", tokens().text3, 16, devicePixelRatioF()));
    grip_->setCursor(Qt::OpenHandCursor);
    grip_->setToolTip("Drag to another place · Alt+Up, Alt+Down");
    grip_->installEventFilter(this);
    on_ = new QCheckBox(this);
    on_->setFocusPolicy(Qt::TabFocus);
    on_->setToolTip("Switch on or off · Space");
    on_->setAccessibleName("Enabled");
    connect(on_, &QCheckBox::clicked, this, &ModifierRow::toggled);
    name_ = new ElidedButton(edits::titleOf(m), this);
    name_->setProperty("quiet", true);
    name_->setStyleSheet("text-align: left; font-weight: 700;");
    name_->setFocusPolicy(Qt::NoFocus);
    name_->setToolTip(op_ ? QString::fromStdString(op_->summary) : "This version does not know the operation; it is kept and left out.");
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(name_, &QPushButton::clicked, this, &ModifierRow::opened);
    counts_ = new QLabel(this);
    counts_->setProperty("secondary", true);
    time_ = new QLabel(this);
    time_->setProperty("secondary", true);
    time_->setMinimumWidth(40);
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    ring_ = new ProgressRing(this);
    errorIcon_ = new QLabel(this);
    errorIcon_->setPixmap(iconPixmap("error", tokens().error, 16, devicePixelRatioF()));
    menu_ = new QToolButton(this);
    menu_->setIcon(icon("menu", tokens().text2));
    menu_->setAccessibleName("Menu of " + edits::titleOf(m));
    menu_->setToolTip("Step through, apply, duplicate, move, remove");
    menu_->setFocusPolicy(Qt::TabFocus);
    connect(menu_, &QToolButton::clicked, this, &ModifierRow::menu);
    for (QWidget* w : {static_cast<QWidget*>(grip_), static_cast<QWidget*>(on_)}) line->addWidget(w);
    line->addWidget(name_, 1);
    for (QWidget* w : {static_cast<QWidget*>(counts_), static_cast<QWidget*>(time_), static_cast<QWidget*>(ring_), static_cast<QWidget*>(errorIcon_),
                       static_cast<QWidget*>(menu_)})
        line->addWidget(w);
    ring_->hide();
    errorIcon_->hide();
    box_->addLayout(line);
}

void ModifierRow::resizeEvent(QResizeEvent* e)
{
    QFrame::resizeEvent(e);
    fitHeader();
}

// The name comes first: where there is no room for all, the time and the count before are only in the tooltip. What is asked for comes before it.
void ModifierRow::fitHeader()
{
    time_->setVisible(width() >= wideRow);
    QFont bold = font();
    bold.setBold(true);
    const int name = QFontMetrics(bold).horizontalAdvance(name_->text()) + 14;  // the padding of a quiet button
    int room = contentsRect().width() - box_->contentsMargins().left() - box_->contentsMargins().right() - name;
    for (const QWidget* w : std::initializer_list<const QWidget*>{grip_, on_, menu_, time_, ring_, errorIcon_})
        if (!w->isHidden()) room -= std::max(w->sizeHint().width(), w->minimumWidth()) + 4;
    const QFontMetrics metrics = counts_->fontMetrics();
    const QString after = countsText_.mid(std::max(0, int(countsText_.indexOf(QChar(0x2192)))));
    const auto fits = [&](const QString& text) { return metrics.horizontalAdvance(text) + 4 <= room; };
    counts_->setText(asks_ || fits(countsText_) ? countsText_ : fits(after) ? after : QString());
}

void ModifierRow::setState(const RowState& s)
{
    on_->setChecked(s.enabled);
    countsText_ = s.enabled ? s.waits ? (s.time.isEmpty() ? QString("waits") : "waits, " + s.time) : s.counts : QString("off");
    const QString time = s.enabled && !s.running && !s.waits && s.error.isEmpty() ? s.time : QString();
    time_->setText(time);
    asks_ = s.asks && s.enabled;
    counts_->setToolTip(time.isEmpty() ? countsText_ : countsText_ + ", in " + time);
    const QString color = s.enabled ? tokens().text.name() : tokens().text3.name();
    const QString style = "text-align: left; font-weight: 700; color: " + color + ";";
    if (name_->styleSheet() != style) name_->setStyleSheet(style);
    ring_->setVisible(s.running && s.elapsed > 150);
    ring_->setFraction(s.fraction);
    errorIcon_->setVisible(!s.error.isEmpty());
    fitHeader();
    error_->setText(s.error);
    errorBox_->setVisible(!s.error.isEmpty());
    if (progressLine_) {
        progressLine_->setVisible(s.running && s.elapsed > 150);
        bar_->setValue(int(1000 * s.fraction));
        QString text = QString("%1 %").arg(int(100 * s.fraction));
        if (s.fraction > 0.05f && s.elapsed > 400)
            text += ", about " + timeText(double(s.elapsed) / 1000 * (1 - double(s.fraction)) / double(s.fraction)) + " left";
        else if (!s.time.isEmpty())
            text += ", " + s.time;
        left_->setText(text);
    }
    setAccessibleName(name_->text() + (s.enabled ? ", enabled" : ", off") + (s.running ? ", running" : ""));
}

void ModifierRow::setOpen(bool open, const Modifier& m)
{
    if (open && body_) {
        if (form_) form_->setValues(m.values);
        return;
    }
    if (open == isOpen()) return;
    setProperty("open", open);
    style()->unpolish(this);
    style()->polish(this);
    if (!open) {
        body_->deleteLater();
        body_ = progressLine_ = nullptr;
        form_ = nullptr;
        return;
    }
    body_ = new QWidget(this);
    auto* box = new QVBoxLayout(body_);
    box->setContentsMargins(8, 0, 8, 6);
    box->setSpacing(6);
    if (op_) {
        form_ = new ParameterForm(op_->parameters, m.values, body_);
        connect(form_, &ParameterForm::edited, this, &ModifierRow::edited);
        connect(form_, &ParameterForm::committed, this, &ModifierRow::committed);
        box->addWidget(form_);
    }
    progressLine_ = new QWidget(body_);
    auto* line = new QHBoxLayout(progressLine_);
    line->setContentsMargins(0, 0, 0, 0);
    bar_ = new QProgressBar(progressLine_);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    left_ = new QLabel(progressLine_);
    left_->setProperty("secondary", true);
    auto* cancel = new QPushButton("Cancel", progressLine_);
    cancel->setFocusPolicy(Qt::TabFocus);
    connect(cancel, &QPushButton::clicked, this, &ModifierRow::cancelled);
    line->addWidget(bar_, 1);
    line->addWidget(left_);
    line->addWidget(cancel);
    progressLine_->hide();
    box->addWidget(progressLine_);
    if (op_ && op_->steps) {
        auto* step = new QPushButton(icon("step"), "Step through", body_);
        step->setToolTip("Open this algorithm in the step player, on the mesh that comes in here");
        step->setFocusPolicy(Qt::TabFocus);
        connect(step, &QPushButton::clicked, this, &ModifierRow::stepRequested);
        auto* row = new QHBoxLayout;
        row->addWidget(step);
        row->addStretch(1);
        box->addLayout(row);
    }
    box_->insertWidget(1, body_);
}

void ModifierRow::menu()
{
    auto* m = new QMenu(this);
    m->setAttribute(Qt::WA_DeleteOnClose);
    if (op_ && op_->steps) m->addAction(icon("step"), "Step through", this, &ModifierRow::stepRequested);
    m->addAction(icon("eye"), "Show this level", this, &ModifierRow::showRequested);
    m->addAction("Apply to here", this, &ModifierRow::applyRequested);
    m->addSeparator();
    m->addAction(icon("copy"), "Duplicate\tCtrl+D", this, &ModifierRow::duplicateRequested);
    m->addAction("Move up\tAlt+Up", this, [this] { emit moved(-1); });
    m->addAction("Move down\tAlt+Down", this, [this] { emit moved(1); });
    if (op_) m->addAction(icon("copy"), "Copy as command", this, &ModifierRow::copyRequested);
    m->addAction("Remove\tDelete", this, &ModifierRow::removeRequested);
    m->popup(menu_->mapToGlobal(QPoint(0, menu_->height())));
}

void ModifierRow::keyPressEvent(QKeyEvent* e)
{
    if (e->modifiers() == Qt::AltModifier && (e->key() == Qt::Key_Up || e->key() == Qt::Key_Down))
        emit moved(e->key() == Qt::Key_Up ? -1 : 1);
    else if (e->modifiers() == Qt::ControlModifier && e->key() == Qt::Key_D)
        emit duplicateRequested();
    else if (e->key() == Qt::Key_Delete)
        emit removeRequested();
    else if (e->key() == Qt::Key_Space)
        emit toggled(!on_->isChecked());
    else if (e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter)
        emit opened();
    else
        QFrame::keyPressEvent(e);
}

bool ModifierRow::eventFilter(QObject* o, QEvent* e)
{
    if (o == grip_ && e->type() == QEvent::MouseButtonRelease)
        emit droppedAt(mapToParent(grip_->mapTo(this, static_cast<QMouseEvent*>(e)->position().toPoint())).y());
    return o == grip_ && e->type() == QEvent::MouseButtonPress ? true : QFrame::eventFilter(o, e);
}

}  // namespace mw
