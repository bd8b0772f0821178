#include "ui/welcome.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "core/scene/samples.h"
#include "ui/theme.h"

namespace mw {
namespace {

QPushButton* entry(const QString& title, const QString& about, const QString& iconName, QWidget* parent)
{
    auto* b = new QPushButton(icon(iconName), "  " + title, parent);
    b->setToolTip(about);
    b->setProperty("quiet", true);
    b->setStyleSheet("text-align: left; padding: 4px 6px;");
    b->setFocusPolicy(Qt::TabFocus);
    return b;
}

QLabel* secondary(const QString& text, QWidget* parent)
{
    auto* l = new QLabel(text, parent);
    l->setProperty("secondary", true);
    l->setWordWrap(true);
    return l;
}

}  // namespace

WelcomeCard::WelcomeCard(Session& session, FileCommands& files, QWidget* parent) : QFrame(parent)
{
    setObjectName("card");
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName("Welcome");
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(24, 18, 24, 20);
    box->setSpacing(10);
    auto* top = new QHBoxLayout;
    auto* title = new QLabel("<span style='font-size: 140%'><b>Meshwright</b></span>", this);
    auto* close = new QToolButton(this);
    close->setIcon(icon("x", tokens().text2));
    close->setAccessibleName("Close");
    close->setToolTip("Close · Esc");
    close->setFocusPolicy(Qt::TabFocus);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    top->addWidget(title, 1);
    top->addWidget(close);
    box->addLayout(top);
    box->addWidget(secondary("Open a mesh, add a modifier, or step through an algorithm line by line.", this));
    auto* columns = new QHBoxLayout;
    columns->setSpacing(28);
    auto* left = new QVBoxLayout;
    auto* right = new QVBoxLayout;
    for (auto* c : {left, right}) c->setSpacing(2);
    auto* open = new QPushButton(icon("open", Qt::white), "Open...", this);
    open->setProperty("primary", true);
    open->setFocusPolicy(Qt::TabFocus);
    connect(open, &QPushButton::clicked, this, [&files] { files.openDialog(); });
    left->addWidget(open, 0, Qt::AlignLeft);
    left->addSpacing(10);
    left->addWidget(new QLabel("<b>Recent files</b>", this));
    const QStringList recent = files.recent();
    if (recent.isEmpty()) left->addWidget(secondary("None yet. A file dropped on the view opens, too.", this));
    for (const QString& file : recent) {
        auto* b = entry(QFileInfo(file).fileName(), file, "mesh", this);
        b->setEnabled(QFileInfo::exists(file));
        connect(b, &QPushButton::clicked, this, [&files, file] { files.whenSaved([&files, file] { files.open(file); }); });
        left->addWidget(b);
    }
    left->addStretch(1);
    right->addWidget(new QLabel("<b>Samples</b>", this));
    for (const Sample& s : samples()) {
        auto* b = entry(s.title, s.about, "object", this);
        connect(b, &QPushButton::clicked, this, [this, &files, &s] {
            hide();
            files.whenSaved([&files, &s] { files.openScene(s.make(), std::string("Open ").append(s.title).c_str()); });
        });
        right->addWidget(b);
        auto* about = secondary(s.about, this);
        about->setContentsMargins(30, 0, 0, 6);
        right->addWidget(about);
    }
    right->addStretch(1);
    columns->addLayout(left, 1);
    columns->addLayout(right, 1);
    box->addLayout(columns, 1);
    subscription_ = session.document.subscribe([this](const Change& c) {
        if (c.aspects & (Aspect::History | Aspect::File)) hide();
    });
    parent->installEventFilter(this);
    place();
}

void WelcomeCard::place()
{
    const QSize size(std::min(640, parentWidget()->width() - 32), std::min(360, parentWidget()->height() - 32));
    setFixedSize(size);
    move((parentWidget()->width() - size.width()) / 2, parentWidget()->height() - size.height() - 24);
}

void WelcomeCard::keyPressEvent(QKeyEvent* e)
{
    if (e->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(e);
}

bool WelcomeCard::eventFilter(QObject* o, QEvent* e)
{
    if (e->type() == QEvent::Resize) place();
    if (e->type() == QEvent::KeyPress && isVisible() && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Escape) hide();
    return QFrame::eventFilter(o, e);
}

}  // namespace mw
