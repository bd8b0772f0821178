#include "ui/drop_target.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QPainter>

#include "ui/banner.h"
#include "ui/file_commands.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {
namespace {

QStringList localFiles(const QMimeData* data)
{
    QStringList names;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile()) names << url.toLocalFile();
    return names;
}

bool isPicture(const QString& file)
{
    static const QStringList endings{"png", "jpg", "jpeg", "tga", "pgm", "bmp", "tif", "tiff", "webp", "hdr", "exr"};
    return endings.contains(QFileInfo(file).suffix().toLower());
}

bool isHeightMap(const QString& file)
{
    return QStringList{"png", "tga", "pgm"}.contains(QFileInfo(file).suffix().toLower());
}

}  // namespace

DropFrame::DropFrame(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void DropFrame::showOn(const QRect& target, const QString& verb)
{
    verb_ = verb;
    setGeometry(target);
    // Cut to what is painted: over the view nothing may be translucent.
    const QSize label(fontMetrics().horizontalAdvance(verb) + 28, std::min(target.height() - 8, fontMetrics().height() + 14));
    const QRect pill(QPoint((width() - label.width()) / 2, (height() - label.height()) / 2), label);
    setMask((QRegion(rect()) - QRegion(rect().adjusted(2, 2, -2, -2))) + QRegion(pill));
    show();
    raise();
    update();
}

void DropFrame::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.fillRect(rect(), tokens().accent);
    p.setPen(Qt::white);
    p.drawText(rect(), Qt::AlignCenter, verb_);
}

DropTarget::DropTarget(FileCommands& files, Banner& banner, QWidget* window, QWidget* opens, QWidget* adds)
    : QObject(window), files_(files), banner_(banner), window_(window), opens_(opens), adds_(adds), frame_(new DropFrame(window))
{
    window_->setAcceptDrops(true);
    window_->installEventFilter(this);
}

bool DropTarget::onBar(QPoint at) const
{
    return at.y() < opens_->mapTo(window_, QPoint(0, opens_->height())).y();
}

bool DropTarget::eventFilter(QObject* o, QEvent* e)
{
    switch (e->type()) {
        case QEvent::DragEnter:
        case QEvent::DragMove: {
            auto* drag = static_cast<QDragMoveEvent*>(e);
            const QStringList names = localFiles(drag->mimeData());
            if (names.isEmpty()) return false;
            const bool bar = onBar(drag->position().toPoint());
            const QWidget* on = bar ? opens_ : adds_;
            const QString what = names.size() == 1 ? QFileInfo(names.front()).fileName() : counted(size_t(names.size()), "file", "files");
            frame_->showOn(QRect(on->mapTo(window_, QPoint(0, 0)), on->size()), (bar || files_.showsWelcomeScene() ? "Open " : "Add ") + what);
            drag->acceptProposedAction();
            return true;
        }
        case QEvent::DragLeave:
            frame_->hide();
            return true;
        case QEvent::Drop: {
            auto* drop = static_cast<QDropEvent*>(e);
            frame_->hide();
            const QStringList names = localFiles(drop->mimeData());
            if (names.isEmpty()) return false;
            drop->acceptProposedAction();
            take(names, onBar(drop->position().toPoint()));
            return true;
        }
        default:
            return QObject::eventFilter(o, e);
    }
}

void DropTarget::take(const QStringList& dropped, bool open)
{
    emit this->dropped();
    QStringList names = dropped;
    if (open) {
        files_.whenSaved([this, names] { files_.openAll(names); });
        return;
    }
    QStringList models;
    for (const QString& file : names)
        if (isPicture(file))
            askAboutPicture(file);
        else
            models << file;
    if (files_.showsWelcomeScene())
        files_.openAll(models);
    else
        files_.import(models);
}

void DropTarget::askAboutPicture(const QString& file)
{
    const QString name = QFileInfo(file).fileName();
    if (!isHeightMap(file)) return banner_.trouble(name + " is a picture. Assign it to a material in Properties; height maps are PNG, TGA or PGM.");
    banner_.ask(name + " is a picture. Make it the heights of a terrain here, or assign it to a material in Properties.");
    banner_.offer("New terrain from it", "Grey is height: a terrain beside what is there", [this, file] { emit heightMapWanted(file); });
}

}  // namespace mw
