// See transport_strip.h.
#include "ui/steps/transport_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QStackedLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/look.h"
#include "ui/playback.h"
#include "ui/steps/step_history.h"

namespace mw {

namespace {

constexpr int knob = 14, track = 4;

struct Speed {
    const char* text;
    double perSecond;
};
constexpr Speed speeds[] = {{"1/4 /s", 0.25}, {"1/2 /s", 0.5}, {"1 /s", 1},   {"2 /s", 2},   {"4 /s", 4},
                            {"8 /s", 8},      {"16 /s", 16},   {"32 /s", 32}, {"64 /s", 64}, {"Max", 0}};

QToolButton* button(QWidget* parent, const char* iconName, const QString& name, int size)
{
    auto* b = new QToolButton(parent);
    b->setIcon(look::icon(iconName));
    b->setIconSize({16, 16});
    b->setFixedSize(size, size);
    b->setAutoRaise(true);
    b->setStyleSheet("QToolButton { padding: 0; }");
    b->setFocusPolicy(Qt::TabFocus);
    b->setAccessibleName(name);
    return b;
}

class Strip : public QWidget {
public:
    Strip(Session& session, QWidget* parent);

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* e) override;

private:
    QWidget* makeControls();
    void makeButtons(QHBoxLayout* row);
    void makeScrubber(QHBoxLayout* row);
    void makeChoices(QHBoxLayout* row);
    QWidget* makeQuestion();
    void refresh();
    void refreshButtons();
    void refreshText();
    void refreshUnits();
    void keepAsClip();
    std::vector<StepScrubber::Tick> ticks() const;

    Session session_;
    StepSession& steps_;
    QStackedLayout* pages_ = nullptr;
    QToolButton *first_ = nullptr, *back_ = nullptr, *play_ = nullptr, *next_ = nullptr, *last_ = nullptr;
    QLabel *where_ = nullptr, *state_ = nullptr;
    StepScrubber* scrubber_ = nullptr;
    QPushButton* keep_ = nullptr;
    QComboBox *unit_ = nullptr, *speed_ = nullptr;
    size_t ticksAt_ = 0;
};

Strip::Strip(Session& session, QWidget* parent) : QWidget(parent), session_(session), steps_(session.steps)
{
    setObjectName("transport-strip");
    setAccessibleName(tr("Stepping"));
    setFixedHeight(52);
    pages_ = new QStackedLayout(this);
    pages_->setContentsMargins(0, 0, 0, 0);
    pages_->addWidget(makeControls());
    pages_->addWidget(makeQuestion());
    installTransportShortcuts(steps_, this);
    connect(&steps_, &StepSession::opened, this, [this] {
        ticksAt_ = 0;
        refreshUnits();
        setVisible(true);
    });
    connect(&steps_, &StepSession::closed, this, [this] { setVisible(false); });
    connect(&steps_, &StepSession::changed, this, &Strip::refresh);
    refreshUnits();
    refresh();
    setVisible(steps_.isOpen());
}

QWidget* Strip::makeControls()
{
    auto* page = new QWidget(this);
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(6);
    makeButtons(row);
    row->addSpacing(10);
    makeScrubber(row);
    row->addSpacing(10);
    makeChoices(row);
    return page;
}

void Strip::makeButtons(QHBoxLayout* row)
{
    row->addWidget(first_ = button(this, "first", tr("First step"), 28));
    row->addWidget(back_ = button(this, "back", tr("Step back"), 28));
    row->addWidget(play_ = button(this, "play", tr("Play"), 32));
    row->addWidget(next_ = button(this, "next", tr("Step forward"), 28));
    row->addWidget(last_ = button(this, "last", tr("Last step"), 28));
    play_->setAutoRaise(false);
    for (QToolButton* b : {first_, back_, next_, last_, play_}) b->setObjectName("transport-" + b->accessibleName().toLower().replace(' ', '-'));
    connect(first_, &QToolButton::clicked, &steps_, &StepSession::first);
    connect(back_, &QToolButton::clicked, &steps_, &StepSession::back);
    connect(play_, &QToolButton::clicked, &steps_, [this] { steps_.playing() ? steps_.pause() : steps_.play(); });
    connect(next_, &QToolButton::clicked, &steps_, &StepSession::forward);
    connect(last_, &QToolButton::clicked, &steps_, &StepSession::last);
}

void Strip::makeScrubber(QHBoxLayout* row)
{
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    auto* texts = new QHBoxLayout;
    texts->addWidget(where_ = new QLabel(this), 1);
    texts->addWidget(state_ = new QLabel(this));
    where_->setObjectName("transport-where");
    where_->setTextFormat(Qt::RichText);
    where_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addLayout(texts);
    column->addWidget(scrubber_ = new StepScrubber(this));
    row->addLayout(column, 1);
    connect(scrubber_, &StepScrubber::sliderMoved, &steps_, [this](int p) { steps_.scrub(size_t(p)); });
    connect(scrubber_, &StepScrubber::sliderReleased, &steps_, [this] { steps_.seek(size_t(scrubber_->sliderPosition())); });
    connect(scrubber_, &StepScrubber::actionTriggered, &steps_, [this](int action) {
        if (action != QAbstractSlider::SliderMove) steps_.scrub(size_t(scrubber_->sliderPosition()));
    });
}

void Strip::makeChoices(QHBoxLayout* row)
{
    row->addWidget(unit_ = new QComboBox(this));
    unit_->setObjectName("transport-unit");
    unit_->setFocusPolicy(Qt::TabFocus);
    unit_->setAccessibleName(tr("Where to stop"));
    unit_->setToolTip(tr("Where playing and stepping stop."));
    unit_->setMinimumWidth(118);
    connect(unit_, &QComboBox::activated, this, [this](int i) {
        if (i < 2) return steps_.setUnit(i == 0 ? StepSession::Unit::Step : StepSession::Unit::Phase);
        steps_.setUnit(StepSession::Unit::Named, unit_->itemData(i).toString());
    });
    row->addWidget(speed_ = new QComboBox(this));
    speed_->setObjectName("transport-speed");
    speed_->setFocusPolicy(Qt::TabFocus);
    speed_->setAccessibleName(tr("Speed"));
    speed_->setToolTip(tr("Stops a second while it plays. Max: as fast as it goes."));
    for (const Speed& s : speeds) speed_->addItem(tr(s.text), s.perSecond);
    speed_->setCurrentIndex(4);
    connect(speed_, &QComboBox::activated, this, [this](int i) { steps_.setSpeed(speed_->itemData(i).toDouble()); });
    row->addWidget(keep_ = new QPushButton(tr("Keep as clip"), this));
    keep_->setObjectName("transport-keep");
    keep_->setFocusPolicy(Qt::TabFocus);
    keep_->setToolTip(tr("Ends stepping; a new clip leads from the pose at the start to the one shown, within 1 s. Can be undone."));
    connect(keep_, &QPushButton::clicked, this, &Strip::keepAsClip);
    QToolButton* x = button(this, "x", tr("End stepping"), 28);
    x->setObjectName("transport-close");
    x->setToolTip(tr("End stepping and show the scene again."));
    connect(x, &QToolButton::clicked, &steps_, &StepSession::close);
    row->addWidget(x);
}

QWidget* Strip::makeQuestion()
{
    auto* page = new QWidget(this);
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(16, 4, 8, 4);
    auto* text = new QLabel(tr("The mesh was changed since stepping began."), page);
    text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(text, 1);
    auto* keep = new QPushButton(tr("Keep this state as the base"), page);
    keep->setToolTip(tr("The state shown becomes the mesh, without modifiers. Can be undone."));
    auto* leave = new QPushButton(tr("Leave as it was"), page);
    leave->setToolTip(tr("Ends stepping; the mesh stays as it is now."));
    connect(keep, &QPushButton::clicked, &steps_, &StepSession::keepAsBase);
    connect(leave, &QPushButton::clicked, &steps_, &StepSession::close);
    row->addWidget(keep);
    row->addWidget(leave);
    return page;
}

// Two units and one for each phase that was seen.
void Strip::refreshUnits()
{
    const std::vector<std::string> phases = steps_.history().phases();
    if (unit_->count() == int(phases.size()) + 2 && ticksAt_ != 0) return;
    unit_->clear();
    unit_->addItem(tr("Every step"));
    unit_->addItem(tr("Each phase"));
    for (const std::string& p : phases) unit_->addItem(tr("Each %1").arg(QString::fromStdString(p)), QString::fromStdString(p));
    int chosen = int(steps_.unit());
    if (steps_.unit() == StepSession::Unit::Named) chosen = std::max(0, unit_->findData(steps_.unitPhase()));
    unit_->setCurrentIndex(chosen);
}

std::vector<StepScrubber::Tick> Strip::ticks() const
{
    std::vector<StepScrubber::Tick> found;
    const StepHistory& h = steps_.history();
    for (const std::string& p : h.phases()) found.push_back({int(h.nextOf(p, 0)), false});
    for (uint32_t r : h.rejected()) found.push_back({int(r), true});
    return found;
}

// The view then stands at the clip's end: what was kept is what is seen.
void Strip::keepAsClip()
{
    const ClipId clip = steps_.keepAsClip();
    if (!clip) return;
    if (session_.playback) {
        session_.playback->setClip(clip);
        session_.playback->setTime(1);
    } else {
        session_.view.clip = clip;
        session_.view.setTime(1);
    }
    session_.view.touch();
}

void Strip::refresh()
{
    if (!steps_.isOpen()) return;
    keep_->setVisible(steps_.isOfCharacter());
    pages_->setCurrentIndex(steps_.edited() ? 1 : 0);
    const size_t total = steps_.estimatedLength();
    const size_t end = std::max({total, steps_.history().end(), size_t(2)});
    if (!scrubber_->isSliderDown()) {
        QSignalBlocker quiet(scrubber_);
        scrubber_->setRange(0, int(std::min<size_t>(end - 1, 1'000'000'000)));
        scrubber_->setValue(int(steps_.position()));
    }
    if (ticksAt_ != steps_.history().end()) {
        scrubber_->setTicks(ticks());
        refreshUnits();
        ticksAt_ = steps_.history().end();
    }
    refreshButtons();
    refreshText();
}

void Strip::refreshButtons()
{
    const bool start = steps_.position() == 0, end = steps_.atEnd(), playing = steps_.playing();
    auto set = [](QToolButton* b, bool enabled, const QString& does, const QString& whyNot) {
        b->setEnabled(enabled);
        b->setToolTip(enabled ? does : whyNot);
    };
    set(first_, !start, tr("To the start · Home"), tr("It stands at the start."));
    set(back_, !start, tr("One stop back · Left"), tr("It stands at the start."));
    set(next_, !end, tr("To the next stop · Right"), tr("It stands at the end."));
    set(last_, !end, tr("Run to the end · End"), tr("It stands at the end."));
    const QString primary =
        QString("QToolButton { padding: 0; border: 0; border-radius: 4px; background: %1; } QToolButton:focus { border: 2px solid %2; }")
            .arg(look::tone().accent.name(), look::tone().text.name());
    if (play_->styleSheet() != primary) play_->setStyleSheet(primary);
    play_->setIcon(look::icon(playing ? "pause" : "play", Qt::white));
    play_->setAccessibleName(playing ? tr("Pause") : tr("Play"));
    play_->setToolTip(playing ? tr("Pause · Space") : end ? tr("Play from the start · Space") : tr("Play · Space"));
}

void Strip::refreshText()
{
    const QLocale l;
    auto number = [&](size_t n) { return l.toString(qulonglong(n)); };
    QString text = tr("Step <b>%1</b>").arg(number(steps_.position()));
    if (steps_.length() > 0)
        text += tr(" of %1").arg(number(steps_.length() - 1));
    else if (size_t about = steps_.estimatedLength()) {
        const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(double(about))) - 2));
        text += tr(" of about %1").arg(number(size_t(std::round(double(about) / unit) * unit)));
    }
    where_->setText(text);
    QString state = steps_.seeking() && !steps_.playing() ? tr("Running...") : steps_.atEnd() ? tr("At the end") : QString();
    if (!steps_.error().isEmpty()) state = tr("It stopped: see Step player");
    state_->setText(state);
    QPalette p = state_->palette();
    p.setColor(QPalette::WindowText, steps_.error().isEmpty() ? look::tone().text2 : look::tone().error);
    state_->setPalette(p);
}

void Strip::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.fillRect(rect(), look::tone().panel);
    p.fillRect(0, 0, width(), 1, look::tone().border);
}

void Strip::changeEvent(QEvent* e)
{
    if (e->type() == QEvent::PaletteChange && play_) refresh();
    QWidget::changeEvent(e);
}

}  // namespace

StepScrubber::StepScrubber(QWidget* parent) : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::TabFocus);
    setPageStep(64);
    setObjectName("transport-scrubber");
    setAccessibleName(tr("Step"));
    setToolTip(tr("Drag to a step. Grey marks: where a phase first came. Coloured marks: what was refused."));
}

void StepScrubber::setTicks(std::vector<Tick> ticks)
{
    ticks_ = std::move(ticks);
    update();
}

int StepScrubber::xOf(double position) const
{
    const double span = std::max(1, maximum() - minimum());
    return knob / 2 + int(std::lround((position - minimum()) / span * (width() - knob)));
}

int StepScrubber::positionAt(double x) const
{
    const double share = std::clamp((x - knob / 2.0) / std::max(1, width() - knob), 0.0, 1.0);
    return minimum() + int(std::lround(share * (maximum() - minimum())));
}

int StepScrubber::knobX() const
{
    return xOf(sliderPosition());
}

void StepScrubber::paintEvent(QPaintEvent*)
{
    const look::Tones& t = look::tone();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const int y = height() / 2, x = knobX();
    p.setPen(Qt::NoPen);
    p.setBrush(t.border);
    p.drawRoundedRect(QRectF(knob / 2.0, y - track / 2.0, width() - knob, track), 2, 2);
    p.setBrush(t.accentText);
    p.drawRoundedRect(QRectF(knob / 2.0, y - track / 2.0, x - knob / 2.0, track), 2, 2);
    p.setRenderHint(QPainter::Antialiasing, false);
    std::vector<char> drawn(size_t(std::max(1, width())), 0);  // one mark a pixel, however many steps
    for (bool rejected : {true, false})
        for (const Tick& tick : ticks_) {
            const int tx = xOf(tick.position);
            if (tick.rejected != rejected || tx < 0 || tx >= width() || (rejected && drawn[size_t(tx)]++)) continue;
            p.fillRect(tx - 1, y - (rejected ? 5 : 6), 2, rejected ? 10 : 12, rejected ? look::roleColor(Role::Rejected) : t.strong);
        }
    p.setRenderHint(QPainter::Antialiasing);
    p.setBrush(t.text);
    p.drawEllipse(QPointF(x, y), knob / 2.0, knob / 2.0);
    if (hasFocus()) {
        p.setPen(QPen(t.accentText, 2));
        p.setBrush(Qt::NoBrush);
        p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
}

void StepScrubber::mousePressEvent(QMouseEvent* e)
{
    if (e->button() != Qt::LeftButton) return;
    setSliderDown(true);
    setSliderPosition(positionAt(e->position().x()));
}

void StepScrubber::mouseMoveEvent(QMouseEvent* e)
{
    if (isSliderDown()) setSliderPosition(positionAt(e->position().x()));
}

void StepScrubber::mouseReleaseEvent(QMouseEvent* e)
{
    if (e->button() == Qt::LeftButton && isSliderDown()) setSliderDown(false);
}

void StepScrubber::wheelEvent(QWheelEvent* e)
{
    e->ignore();  // the wheel scrolls, it changes no value
}

void installTransportShortcuts(StepSession& steps, QWidget* on)
{
    auto add = [&](const QKeySequence& keys, auto act) {
        auto* s = new QShortcut(keys, on);
        s->setContext(Qt::WidgetWithChildrenShortcut);
        s->setEnabled(steps.isOpen());
        QObject::connect(s, &QShortcut::activated, &steps, act);
        QObject::connect(&steps, &StepSession::opened, s, [s] { s->setEnabled(true); });
        QObject::connect(&steps, &StepSession::closed, s, [s] { s->setEnabled(false); });
    };
    StepSession* s = &steps;
    add(Qt::Key_Space, [s] { s->playing() ? s->pause() : s->play(); });
    add(Qt::Key_Right, [s] { s->forward(); });
    add(Qt::Key_Left, [s] { s->back(); });
    add(QKeyCombination(Qt::SHIFT, Qt::Key_Right), [s] { s->nextPhase(); });
    add(QKeyCombination(Qt::SHIFT, Qt::Key_Left), [s] { s->lastPhase(); });
    add(QKeyCombination(Qt::CTRL, Qt::Key_Right), [s] { s->skip(10); });
    add(QKeyCombination(Qt::CTRL, Qt::Key_Left), [s] { s->skip(-10); });
    add(Qt::Key_Home, [s] { s->first(); });
    add(Qt::Key_End, [s] { s->last(); });
}

QWidget* makeTransportStrip(Session& session, QWidget* parent)
{
    return new Strip(session, parent);
}

}  // namespace mw
