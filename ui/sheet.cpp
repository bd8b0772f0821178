#include "ui/sheet.h"

#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/theme.h"

namespace mw {

Sheet::Sheet(const QString& title, QWidget* over, QSize wanted) : QFrame(over), wanted_(wanted)
{
    for (Sheet* other : over->findChildren<Sheet*>(QString(), Qt::FindDirectChildrenOnly))
        if (other != this) other->deleteLater();
    setObjectName("card");
    setAccessibleName(title);
    setAttribute(Qt::WA_StyledBackground);
    setFocusPolicy(Qt::StrongFocus);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(16, 10, 12, 14);
    box->setSpacing(8);
    auto* line = new QHBoxLayout;
    line->addWidget(new QLabel("<b>" + title + "</b>", this), 1);
    auto* close = new QToolButton(this);
    close->setIcon(icon("x", tokens().text2));
    close->setAccessibleName("Close");
    close->setToolTip("Close · Esc");
    close->setFocusPolicy(Qt::TabFocus);
    connect(close, &QToolButton::clicked, this, &QObject::deleteLater);
    line->addWidget(close);
    box->addLayout(line);
    body_ = new QVBoxLayout;
    body_->setSpacing(8);
    box->addLayout(body_, 1);
    over->installEventFilter(this);
}

void Sheet::open()
{
    place();
    show();
    raise();
    for (QWidget* w = nextInFocusChain(); w && w != this; w = w->nextInFocusChain())
        if (isAncestorOf(w) && (w->focusPolicy() & Qt::TabFocus) && w->isVisible() && w->isEnabled() && !qobject_cast<QToolButton*>(w))
            return w->setFocus(Qt::TabFocusReason);
    setFocus();
}

void Sheet::place()
{
    const QSize room = parentWidget()->size() - QSize(32, 32);
    setFixedSize(wanted_.boundedTo(room));
    move((parentWidget()->width() - width()) / 2, std::max(16, (parentWidget()->height() - height()) / 3));
}

void Sheet::keyPressEvent(QKeyEvent* e)
{
    if (e->key() == Qt::Key_Escape)
        deleteLater();
    else
        QFrame::keyPressEvent(e);
}

bool Sheet::eventFilter(QObject* o, QEvent* e)
{
    if (o == parentWidget() && e->type() == QEvent::Resize) place();
    return QFrame::eventFilter(o, e);
}

}  // namespace mw
