#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "render/animated_png.h"
#include "render/turntable.h"
#include "ui/pictures.h"

namespace mw {
namespace {

/// Pictures on their way from the window's thread, which draws, to the job, which writes.
struct Reel {
    std::mutex mutex;
    std::condition_variable some;
    std::deque<Picture> ready;
    QString trouble;    // of the drawing
    bool over = false;  // the job takes no more
};

Picture take(Reel& reel, Progress& progress, float fraction)
{
    std::unique_lock lock(reel.mutex);
    while (reel.ready.empty()) {
        progress.at(fraction);
        if (!reel.trouble.isEmpty()) throw Error(reel.trouble.toStdString());
        reel.some.wait_for(lock, std::chrono::milliseconds(50));
    }
    Picture p = std::move(reel.ready.front());
    reel.ready.pop_front();
    return p;
}

void write(Reel& reel, Progress& progress, int count, const QString& file)
{
    const struct Over {
        Reel& reel;
        ~Over()
        {
            const std::lock_guard lock(reel.mutex);
            reel.over = true;
        }
    } over{reel};
    const QFileInfo info(file);
    std::optional<AnimatedPng> animation;
    if (info.suffix().toLower() == "apng") animation.emplace(file.toStdString(), count, std::clamp(4.0 / count, 0.02, 0.2));
    for (int i = 0; i < count; ++i) {
        const float fraction = float(i) / float(count);
        progress.at(fraction);
        const Picture p = take(reel, progress, fraction);
        if (animation)
            animation->add(p);
        else
            writePng(p, QString("%1/%2-%3.png").arg(info.path(), info.completeBaseName()).arg(i, 3, 10, QChar('0')).toStdString());
    }
    if (animation) animation->finish();
}

/// Draws one picture each time the event loop comes round, at most a few ahead of the job.
class Turning : public QObject {
public:
    Turning(Viewport& viewport, Frame frame, glm::ivec2 size, int count, std::shared_ptr<Reel> reel)
        : QObject(&viewport),
          viewport_(viewport),
          frame_(std::move(frame)),
          first_(frame_.camera),
          firstTurn_(frame_.options.environmentTurn),
          size_(size),
          count_(count),
          reel_(std::move(reel))
    {
        connect(&timer_, &QTimer::timeout, this, [this] { next(); });
        timer_.start(0);
    }

private:
    void next()
    {
        {
            const std::lock_guard lock(reel_->mutex);
            if (reel_->over || at_ == count_) return finish();
            timer_.setInterval(reel_->ready.size() < 3 ? 0 : 20);
            if (reel_->ready.size() >= 3) return;
        }
        turn(frame_, first_, firstTurn_, at_++, count_);
        try {
            Picture p = viewport_.picture(frame_, size_);
            const std::lock_guard lock(reel_->mutex);
            reel_->ready.push_back(std::move(p));
        } catch (const std::exception& e) {
            const std::lock_guard lock(reel_->mutex);
            reel_->trouble = QString::fromUtf8(e.what());
            finish();
        }
        reel_->some.notify_one();
    }
    void finish()
    {
        timer_.stop();
        deleteLater();
    }

    Viewport& viewport_;
    Frame frame_;
    Camera first_;
    double firstTurn_;
    glm::ivec2 size_;
    int count_, at_ = 0;
    std::shared_ptr<Reel> reel_;
    QTimer timer_;
};

QSpinBox* number(int value, int low, int high, const QString& unit, const QString& name, const QString& tip, QFormLayout* form)
{
    auto* box = new QSpinBox;
    box->setRange(low, high);
    box->setValue(value);
    box->setSuffix(unit);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    box->setGroupSeparatorShown(true);
    form->addRow(name, box);
    return box;
}

QCheckBox* tick(const QString& text, bool on, const QString& tip, QFormLayout* form)
{
    auto* box = new QCheckBox(text);
    box->setChecked(on);
    box->setToolTip(tip);
    form->addRow(QString(), box);
    return box;
}

/// False when it was left by Cancel.
bool ask(PictureWish& wish, bool turning, const Viewport& viewport, QWidget* parent)
{
    QDialog dialog(parent);
    dialog.setObjectName("pictureDialog");
    dialog.setWindowTitle(turning ? "Save turntable" : "Save picture");
    auto* form = new QFormLayout(&dialog);
    const QSize shown = viewport.size() * viewport.devicePixelRatioF();
    if (turning) wish.width = wish.height = 640;
    auto* width = number(turning ? wish.width : shown.width(), 16, 8192, " px", "Width", "Pixels from left to right. 16 to 8,192.", form);
    auto* height = number(turning ? wish.height : shown.height(), 16, 8192, " px", "Height", "Pixels from top to bottom. 16 to 8,192.", form);
    QSpinBox* count = nullptr;
    QCheckBox* animated = nullptr;
    if (turning) {
        count = number(wish.count, 2, 720, " pictures", "Turn in", "How many pictures a whole turn has. 2 to 720.", form);
        animated = tick("One file that plays (APNG)", wish.animated, "Browsers play it. Without: numbered PNG files in a folder.", form);
    }
    auto* clear = tick("Transparent background", false, "The model alone, nothing behind it", form);
    auto* grid = tick("Grid and markers", !turning, "Ground lines, axes, orientation marker and legend as the view shows them", form);
    QObject::connect(clear, &QCheckBox::toggled, grid, &QWidget::setDisabled);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->addButton("Save...", QDialogButtonBox::AcceptRole);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return false;
    wish = {width->value(),
            height->value(),
            clear->isChecked(),
            grid->isChecked() && !clear->isChecked(),
            count ? count->value() : 0,
            animated && animated->isChecked()};
    return true;
}

}  // namespace

Frame pictureFrame(const Session& session, Viewport& viewport, const PictureWish& wish)
{
    Frame frame = viewport.frame();
    frame.camera = session.view.camera;
    for (DrawObject& o : frame.objects) o.selected = o.hovered = false;
    for (DrawTerrain& t : frame.terrains) t.selected = t.hovered = false;
    ViewOptions& o = frame.options;
    o.transparentBackground = wish.transparent;
    o.legend = viewport.look().options.legend;  // on screen one legend may serve several views; a picture stands alone
    if (!wish.grid) o.grid = o.axes = o.orientationMarker = o.legend = false;
    o.pixelRatio = std::max(1.0, double(wish.height) / std::max(viewport.height(), 1));  // lines and letters grow with the picture
    return frame;
}

void savePicture(const Session& session, Viewport& viewport, const PictureWish& wish, const QString& file)
{
    writePng(viewport.picture(pictureFrame(session, viewport, wish), {wish.width, wish.height}), file.toStdString());
}

void saveTurntable(Session& session, Viewport& viewport, const PictureWish& wish, const QString& file)
{
    Frame frame = pictureFrame(session, viewport, wish);
    frameTurntable(frame, double(wish.width) / wish.height);
    const auto reel = std::make_shared<Reel>();
    const int count = wish.count;
    const QPointer<Viewport> view = &viewport;
    session.jobs.start(
        QString("Turntable of %1 pictures").arg(count),
        [reel, count, file, view](Progress& progress) -> std::function<void()> {
            write(*reel, progress, count, file);
            return [file, view] {
                if (view) emit view->hint("Saved " + QFileInfo(file).fileName());
            };
        },
        [view](const QString& why) {
            if (view) emit view->failed(why);
        });
    new Turning(viewport, std::move(frame), {wish.width, wish.height}, count, reel);  // goes with the view, or when it is done
}

void askPicture(Session& session, Viewport& viewport, QWidget* parent)
{
    PictureWish wish;
    if (!ask(wish, false, viewport, parent)) return;
    QString file = QFileDialog::getSaveFileName(parent, "Save picture", "view.png", "PNG (*.png)");
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += ".png";
    try {
        savePicture(session, viewport, wish, file);
        emit viewport.hint("Saved " + QFileInfo(file).fileName());
    } catch (const std::exception& e) {
        emit viewport.failed(QString::fromUtf8(e.what()));
    }
}

void askTurntable(Session& session, Viewport& viewport, QWidget* parent)
{
    PictureWish wish;
    if (!ask(wish, true, viewport, parent)) return;
    const QString ending = wish.animated ? ".apng" : ".png";
    QString file = QFileDialog::getSaveFileName(parent, "Save turntable", "turn" + ending, wish.animated ? "APNG (*.apng)" : "PNG (*.png)");
    if (file.isEmpty()) return;
    const QString suffix = "." + QFileInfo(file).suffix();
    if (suffix != ending) file += ending;
    saveTurntable(session, viewport, wish, file);
}

}  // namespace mw
