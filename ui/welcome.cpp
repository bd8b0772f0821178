#include "ui/welcome.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include "core/catalog/lesson.h"
#include "core/scene/samples.h"
#include "ui/panels/lesson_desk.h"
#include "ui/theme.h"
#include "ui/thumbnails.h"

namespace mw {
namespace {

QLabel* secondary(const QString& text, QWidget* parent)
{
    auto* l = new QLabel(text, parent);
    l->setProperty("secondary", true);
    l->setWordWrap(true);
    return l;
}

// A picture with a name below it. Without a picture, the icon.
QToolButton* tile(const QString& title, const QString& tip, const QString& key, const QString& iconName, QWidget* parent)
{
    auto* b = new QToolButton(parent);
    b->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    const QPixmap picture = thumbnails::kept(key);
    b->setIcon(picture.isNull() ? icon(iconName, tokens().text2) : QIcon(picture));
    b->setIconSize({thumbnails::width, thumbnails::height});
    b->setText(b->fontMetrics().elidedText(title, Qt::ElideMiddle, thumbnails::width));
    b->setToolTip(tip);
    b->setAccessibleName(title);
    b->setAccessibleDescription(tip);
    b->setFocusPolicy(Qt::TabFocus);
    b->setFixedWidth(thumbnails::width + 10);
    return b;
}

QWidget* section(const QString& title, QLayout* rows, QWidget* parent)
{
    auto* w = new QWidget(parent);
    auto* box = new QVBoxLayout(w);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(4);
    box->addWidget(new QLabel("<b>" + title + "</b>", w));
    box->addLayout(rows);
    box->addStretch(1);
    return w;
}

}  // namespace

WelcomeCard::WelcomeCard(Session& session, FileCommands& files, QWidget* parent)
    : QFrame(parent), session_(session), files_(files), pictures_(new ThumbnailMaker(session, this))
{
    setObjectName("card");
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName("Welcome");
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(20, 12, 12, 12);
    box->setSpacing(8);
    box->addWidget(head());
    refill();
    connect(pictures_, &ThumbnailMaker::made, this, &WelcomeCard::refill);
    connect(&files_, &FileCommands::recentChanged, this, &WelcomeCard::refill);
    pictures_->makeSamples();
    subscription_ = session.document.subscribe([this](const Change& c) {
        if (c.aspects & (Aspect::History | Aspect::File)) hide();
    });
    parent->installEventFilter(this);
    place();
}

QWidget* WelcomeCard::head()
{
    auto* w = new QWidget(this);
    auto* line = new QHBoxLayout(w);
    line->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel("<span style='font-size: 130%'><b>Meshwright</b></span>", w);
    auto* open = new QPushButton(icon("open", Qt::white), "Open...", w);
    open->setProperty("primary", true);
    open->setToolTip("Open a mesh, a character, a motion or a height map · Ctrl+O");
    connect(open, &QPushButton::clicked, this, [this] { files_.openDialog(); });
    auto* terrain = new QPushButton(icon("terrain"), "New terrain", w);
    terrain->setToolTip("A landscape made by diamond-square, to paint on");
    connect(terrain, &QPushButton::clicked, this, &WelcomeCard::newTerrainWanted);
    auto* close = new QToolButton(w);
    close->setIcon(icon("x", tokens().text2));
    close->setAccessibleName("Close");
    close->setToolTip("Close · Esc. Help > Welcome brings it back");
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    for (QWidget* b : {static_cast<QWidget*>(open), static_cast<QWidget*>(terrain), static_cast<QWidget*>(close)}) b->setFocusPolicy(Qt::TabFocus);
    line->addWidget(title, 1);
    line->addWidget(open);
    line->addWidget(terrain);
    line->addSpacing(8);
    line->addWidget(close);
    return w;
}

QWidget* WelcomeCard::recentFiles()
{
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    const QStringList recent = files_.recent();
    if (recent.isEmpty()) grid->addWidget(secondary("None yet. Drop a file on the view, or open one.", this), 0, 0);
    int i = 0;
    for (const QString& file : recent) {
        const bool there = QFileInfo::exists(file);
        auto* b = tile(there ? QFileInfo(file).fileName() : "Find...",
                       there ? file : file + " is not there any more. Click to say where it is now, or to leave it out.", file, "mesh", this);
        if (there) {
            connect(b, &QToolButton::clicked, this, [this, file] { files_.whenSaved([this, file] { files_.open(file); }); });
        } else {
            b->setAccessibleName("Find " + QFileInfo(file).fileName());
            b->setIcon(b->icon().pixmap(b->iconSize(), QIcon::Disabled));
            connect(b, &QToolButton::clicked, this, [this, file] { files_.findRecent(file); });
        }
        grid->addWidget(b, i / 4, i % 4);
        ++i;
    }
    grid->setColumnStretch(4, 1);
    return section("Recent files", grid, this);
}

QWidget* WelcomeCard::sampleScenes()
{
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    const int columns = files_.recent().isEmpty() ? 4 : 2;
    int i = 0;
    for (const Sample& s : samples()) {
        auto* b = tile(s.title, s.about, QString("sample:%1").arg(s.id), "object", this);
        connect(b, &QToolButton::clicked, this, [this, &s] {
            hide();
            files_.whenSaved([this, &s] { files_.openScene(s.make(), QString("Open %1").arg(s.title), QString("sample:%1").arg(s.id)); });
        });
        grid->addWidget(b, i / columns, i % columns);
        ++i;
    }
    grid->setColumnStretch(columns, 1);
    return section("Samples", grid, this);
}

QWidget* WelcomeCard::lessons()
{
    auto* w = new QWidget(this);
    auto* line = new QHBoxLayout(w);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    line->addWidget(new QLabel("<b>Lessons</b>", w));
    int shown = 0;
    const int room = std::min(680, parentWidget()->width() - 72) - 150;
    int used = 0;
    for (const Lesson& l : mw::lessons()) {
        if (shown == 6) break;
        auto* b = new QPushButton(QString::fromStdString(l.title), w);
        b->setProperty("quiet", true);
        b->setFocusPolicy(Qt::TabFocus);
        b->setToolTip("Make its scene and step through it, line by line");
        used += b->sizeHint().width() + 4;
        if (used > room) {
            delete b;
            break;
        }
        connect(b, &QPushButton::clicked, this, [this, &l] {
            hide();
            LessonDesk::of(session_).load(l);
        });
        line->addWidget(b);
        ++shown;
    }
    auto* all = new QPushButton(QString("All %1...").arg(mw::lessons().size()), w);
    all->setAccessibleName("All lessons");
    all->setToolTip("The list of lessons, by chapter");
    all->setFocusPolicy(Qt::TabFocus);
    connect(all, &QPushButton::clicked, this, [this] {
        hide();
        emit lessonsWanted();
    });
    line->addStretch(1);
    line->addWidget(all);
    return w;
}

// After the list of files or a picture has changed.
void WelcomeCard::refill()
{
    if (content_) content_->deleteLater();
    content_ = new QWidget(this);
    auto* box = new QVBoxLayout(content_);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(8);
    auto* inner = new QWidget;
    auto* columns = new QHBoxLayout(inner);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(16);
    if (files_.recent().isEmpty()) {
        columns->addWidget(sampleScenes(), 3);
        columns->addWidget(recentFiles(), 1);
    } else {
        columns->addWidget(recentFiles(), 2);
        columns->addWidget(sampleScenes(), 1);
    }
    auto* area = new QScrollArea(content_);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(inner);
    box->addWidget(area, 1);
    box->addWidget(lessons());
    layout()->addWidget(content_);
}

// At the foot of the view, and never over more than its lower part: the model is above it.
void WelcomeCard::place()
{
    const QSize view = parentWidget()->size();
    const int height = std::clamp(int(view.height() * 0.46), 250, 340);
    setFixedSize(std::min(720, view.width() - 32), height);
    move((view.width() - width()) / 2, view.height() - height - 16);
}

void WelcomeCard::keyPressEvent(QKeyEvent* e)
{
    if (e->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(e);
}

void WelcomeCard::hideEvent(QHideEvent* e)
{
    QFrame::hideEvent(e);
    if (isHidden()) emit hidden();
}

bool WelcomeCard::eventFilter(QObject* o, QEvent* e)
{
    if (e->type() == QEvent::Resize) place();
    if (e->type() == QEvent::KeyPress && isVisible() && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Escape) hide();
    return QFrame::eventFilter(o, e);
}

}  // namespace mw
