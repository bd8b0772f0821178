#include "ui/panels/timeline.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/edit_commands.h"
#include "ui/elided.h"
#include "ui/look.h"
#include "ui/panels/empty_state.h"
#include "ui/panels/timeline_tracks.h"
#include "ui/playback.h"

namespace mw {
namespace {

constexpr double speeds[] = {0.1, 0.25, 0.5, 1, 2, 4};

QToolButton* button(QWidget* parent, const char* iconName, const QString& name, const QString& tip, int size = 28)
{
    auto* b = new QToolButton(parent);
    b->setObjectName("timeline-" + name.toLower().replace(' ', '-'));
    b->setIcon(look::icon(iconName));
    b->setIconSize({16, 16});
    b->setFixedSize(size, 26);
    b->setStyleSheet("QToolButton { padding: 0; }");
    b->setFocusPolicy(Qt::TabFocus);
    b->setAccessibleName(name);
    b->setToolTip(tip);
    return b;
}

QDoubleSpinBox* field(QWidget* parent, const QString& name, int decimals, int width)
{
    auto* f = new QDoubleSpinBox(parent);
    f->setObjectName(name);
    f->setDecimals(decimals);
    f->setButtonSymbols(QAbstractSpinBox::NoButtons);
    f->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    f->setFixedWidth(std::max(width, f->fontMetrics().horizontalAdvance("000000") + 14));
    f->setKeyboardTracking(false);
    f->setFocusPolicy(Qt::StrongFocus);
    return f;
}

class Timeline : public QWidget {
public:
    Timeline(Session& session, QWidget* parent) : QWidget(parent), session_(session), play_(*session.playback)
    {
        setObjectName("timeline");
        auto* page = new QWidget(this);
        auto* box = new QVBoxLayout(page);
        box->setContentsMargins(0, 0, 0, 0);
        box->setSpacing(0);
        box->addWidget(makeBar(page));
        tracks_ = new TimelineTracks(session_, page);
        box->addWidget(tracks_, 1);
        pages_ = new QStackedLayout(this);
        auto* nothing = new QWidget(this);
        auto* sentence = new QVBoxLayout(nothing);
        sentence->setContentsMargins(24, 24, 24, 24);
        sentence->addWidget(emptyStateLabel("Nothing moves yet. Open a file with clips (glTF, FBX, BVH), or drop one on the view.", nothing));
        sentence->addStretch(1);
        pages_->addWidget(nothing);
        pages_->addWidget(page);
        installPlaybackShortcuts(session_, this);
        for (QDoubleSpinBox* f : {frame_, from_, to_})
            connect(f->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, [this] { tracks_->setFocus(); });
        connect(&play_, &Playback::changed, this, &Timeline::refresh);
        connect(&session_.view, &ViewState::timeChanged, this, &Timeline::showTime);
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Clip | Aspect::File | Aspect::History)) refresh();
        });
        refresh();
    }

private:
    QWidget* makeBar(QWidget* parent)
    {
        auto* bar = new QWidget(parent);
        bar->setFixedHeight(std::max(36, bar->fontMetrics().height() + 10));
        auto* row = new QHBoxLayout(bar);
        row->setContentsMargins(8, 0, 8, 0);
        row->setSpacing(4);
        makeClips(bar, row);
        row->addSpacing(6);
        makeTransport(bar, row);
        row->addSpacing(10);
        makeFields(bar, row);
        row->addStretch(1);
        return bar;
    }

    void makeClips(QWidget* bar, QHBoxLayout* row)
    {
        row->addWidget(clips_ = new ElidedComboBox(bar));
        clips_->setObjectName("timeline-clips");
        clips_->setAccessibleName("Clip");
        clips_->setToolTip("Which clip moves the scene. Rest: none does.");
        clips_->setFixedWidth(190);
        clips_->setFocusPolicy(Qt::TabFocus);
        connect(clips_, &QComboBox::activated, this, [this](int i) { play_.setClip({clips_->itemData(i).toUInt()}); });
        QToolButton* more = button(bar, "dots", "Clip menu", "Rename, duplicate or delete this clip");
        more->setIcon(icon("dots", tokens().text2));
        connect(more, &QToolButton::clicked, this, [this, more] { menu(more->mapToGlobal(QPoint(0, more->height()))); });
        row->addWidget(more);
    }

    void makeTransport(QWidget* bar, QHBoxLayout* row)
    {
        QToolButton* first = button(bar, "first", "First frame", "To the start of the range · Home");
        QToolButton* back = button(bar, "back", "Frame back", "One frame back · Left; to the key before · Shift+Left");
        playing_ = button(bar, "play", "Play", "Play · Space", 36);
        QToolButton* next = button(bar, "next", "Frame forward", "One frame on · Right; to the next key · Shift+Right");
        QToolButton* last = button(bar, "last", "Last frame", "To the end of the range · End");
        loop_ = button(bar, "loop", "Loop", "From the end back to the start of the range");
        loop_->setCheckable(true);
        for (QToolButton* b : {first, back, playing_, next, last, loop_}) row->addWidget(b);
        connect(first, &QToolButton::clicked, &play_, [this] { play_.toFirst(); });
        connect(back, &QToolButton::clicked, &play_, [this] { play_.stepFrames(-1); });
        connect(playing_, &QToolButton::clicked, &play_, [this] { play_.toggle(); });
        connect(next, &QToolButton::clicked, &play_, [this] { play_.stepFrames(1); });
        connect(last, &QToolButton::clicked, &play_, [this] { play_.toLast(); });
        connect(loop_, &QToolButton::clicked, &play_, [this](bool on) { play_.setLoop(on); });
        row->addWidget(speed_ = new QComboBox(bar));
        speed_->setObjectName("timeline-speed");
        speed_->setAccessibleName("Speed");
        speed_->setToolTip("How fast it plays. × 1: as it was made.");
        speed_->setFocusPolicy(Qt::TabFocus);
        for (const double s : speeds) speed_->addItem(QString("× %1").arg(s), s);
        speed_->setFixedWidth(std::max(76, speed_->sizeHint().width()));
        connect(speed_, &QComboBox::activated, this, [this](int i) { play_.setSpeed(speed_->itemData(i).toDouble()); });
    }

    void makeFields(QWidget* bar, QHBoxLayout* row)
    {
        row->addWidget(new QLabel("Frame", bar));
        row->addWidget(frame_ = field(bar, "timeline-frame", 1, 62));
        frame_->setAccessibleName("Frame");
        row->addSpacing(6);
        row->addWidget(new QLabel("Range", bar));
        row->addWidget(from_ = field(bar, "timeline-from", 0, 54));
        row->addWidget(to_ = field(bar, "timeline-to", 0, 54));
        from_->setAccessibleName("First frame of the range");
        to_->setAccessibleName("Last frame of the range");
        from_->setToolTip("Playing begins at this frame.");
        to_->setToolTip("Playing ends at this frame.");
        row->addSpacing(6);
        row->addWidget(seconds_ = new ElidedLabel(bar));
        seconds_->setObjectName("timeline-seconds");
        seconds_->setProperty("secondary", true);
        connect(frame_, &QDoubleSpinBox::valueChanged, this, [this](double f) {
            play_.pause();
            play_.setTime(f / play_.frameRate());
        });
        for (QDoubleSpinBox* f : {from_, to_})
            connect(f, &QDoubleSpinBox::valueChanged, this, [this] { play_.setRange(from_->value() / play_.frameRate(), rangeEnd()); });
    }

    // The last frame may lie a little before the clip's end: then the end is meant.
    double rangeEnd() const
    {
        const double seconds = to_->value() / play_.frameRate();
        return std::abs(to_->value() - to_->maximum()) < 0.5 ? play_.end() : seconds;
    }

    void refresh()
    {
        const Scene& scene = session_.document.scene();
        const std::vector<ClipId> clips = scene.clips();
        pages_->setCurrentIndex(clips.empty() ? 0 : 1);
        const QSignalBlocker quiet(clips_);
        clips_->clear();
        for (const ClipId id : clips) {
            const std::string& name = scene.find(id)->name;
            clips_->addItem(name.empty() ? QString("Clip %1").arg(clips_->count() + 1) : QString::fromStdString(name), id.value);
        }
        clips_->addItem("Rest", 0u);
        clips_->setCurrentIndex(std::max(0, clips_->findData(session_.view.clip.value)));
        const QString primary =
            QString("QToolButton { padding: 0; border: 0; border-radius: 4px; background: %1; } QToolButton:focus { border: 2px solid %2; }")
                .arg(tokens().accent.name(), tokens().text.name());
        if (playing_->styleSheet() != primary) playing_->setStyleSheet(primary);
        playing_->setIcon(look::icon(play_.playing() ? "pause" : "play", Qt::white));
        playing_->setAccessibleName(play_.playing() ? "Pause" : "Play");
        playing_->setToolTip(play_.playing() ? "Pause · Space" : "Play · Space");
        loop_->setChecked(play_.loop());
        loop_->setIcon(icon("loop", play_.loop() ? tokens().selectionText : tokens().text));
        speed_->setCurrentIndex(std::max(0, speed_->findData(play_.speed())));
        const double frames = std::round(play_.end() * play_.frameRate());
        for (auto [f, value] : {std::pair{from_, play_.rangeFrom()}, {to_, play_.rangeTo()}}) {
            const QSignalBlocker still(f);
            f->setRange(0, frames);
            f->setValue(value * play_.frameRate());
        }
        const QSignalBlocker still(frame_);
        frame_->setRange(0, play_.end() * play_.frameRate());
        frame_->setToolTip(QString("Where the playhead stands, in frames. 0 to %1.").arg(frames));
        showTime();
    }

    void showTime()
    {
        if (!isVisible() && !seconds_->text().isEmpty() && play_.playing()) return;
        const QSignalBlocker still(frame_);
        if (!frame_->hasFocus()) frame_->setValue(play_.frame());
        const double rate = play_.frameRate();
        const QString fps = std::abs(rate - std::round(rate)) < 0.01 ? QString::number(std::lround(rate)) : QString::number(rate, 'f', 2);
        seconds_->setText(QString("%1 fps, %2 s of %3 s").arg(fps).arg(play_.time(), 0, 'f', 3).arg(play_.end(), 0, 'f', 3));
    }

    void menu(const QPoint& at)
    {
        const ClipId id = session_.view.clip;
        if (!session_.document.scene().find(id)) return;
        auto* m = new QMenu(this);
        m->setObjectName("clipMenu");
        m->setAttribute(Qt::WA_DeleteOnClose);
        m->addAction("Rename...", this, [this, id] {
            const Clip& clip = *session_.document.scene().find(id);
            bool ok = false;
            const QString name = QInputDialog::getText(this, "Rename clip", "Name", QLineEdit::Normal, QString::fromStdString(clip.name), &ok);
            if (ok && !name.isEmpty()) rename(id, name);
        });
        m->addAction("Duplicate", this, [this, id] { duplicate(id); });
        m->addSeparator();
        m->addAction("Delete", this, [this, id] { remove(id); });
        m->popup(at);
    }

    std::string named(ClipId id) const { return "#" + std::to_string(id.value); }

    void rename(ClipId id, const QString& name) { edits::run(session_, {"rename-clip", {{"clip", named(id)}, {"name", name.toStdString()}}}); }

    void duplicate(ClipId id)
    {
        edits::run(session_, {"duplicate-clip", {{"clip", named(id)}}}, [this](const EditRun& run) { play_.setClip(run.clips.front()); });
    }

    void remove(ClipId id) { edits::run(session_, {"delete-clip", {{"clip", named(id)}}}); }

    Session& session_;
    Playback& play_;
    QStackedLayout* pages_;
    TimelineTracks* tracks_;
    QComboBox *clips_ = nullptr, *speed_ = nullptr;
    QToolButton *playing_ = nullptr, *loop_ = nullptr;
    QDoubleSpinBox *frame_ = nullptr, *from_ = nullptr, *to_ = nullptr;
    QLabel* seconds_ = nullptr;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makeTimelinePanel(Session& session, QWidget* parent)
{
    return new Timeline(session, parent);
}

void installPlaybackShortcuts(Session& session, QWidget* on)
{
    Playback* p = session.playback;
    const auto add = [&](const QKeySequence& keys, auto act) {
        auto* s = new QShortcut(keys, on);
        s->setContext(Qt::WidgetWithChildrenShortcut);
        s->setEnabled(!session.steps.isOpen());
        QObject::connect(s, &QShortcut::activated, p, act);
        QObject::connect(&session.steps, &StepSession::opened, s, [s] { s->setEnabled(false); });
        QObject::connect(&session.steps, &StepSession::closed, s, [s] { s->setEnabled(true); });
    };
    add(Qt::Key_Space, [p] { p->toggle(); });
    add(Qt::Key_Right, [p] { p->stepFrames(1); });
    add(Qt::Key_Left, [p] { p->stepFrames(-1); });
    add(QKeyCombination(Qt::SHIFT, Qt::Key_Right), [p] { p->nextKey(); });
    add(QKeyCombination(Qt::SHIFT, Qt::Key_Left), [p] { p->lastKey(); });
    add(QKeyCombination(Qt::CTRL, Qt::Key_Right), [p] { p->stepFrames(10); });
    add(QKeyCombination(Qt::CTRL, Qt::Key_Left), [p] { p->stepFrames(-10); });
    add(Qt::Key_End, [p] { p->toLast(); });
    if (on->objectName() != "timeline") add(Qt::Key_Home, [p] { p->toFirst(); });  // there it shows the whole clip
}

}  // namespace mw
