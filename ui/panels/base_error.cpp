// See base_error.h. Measured by a job, some time after the last change.
#include "ui/panels/base_error.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include "core/mesh/same_mesh.h"
#include "ui/stack_edits.h"

namespace mw {
namespace {

constexpr size_t largeFaces = 2'000'000;  // from here on measuring is asked for
constexpr int64_t points = 100'000;       // on each surface
constexpr const char* query = "distance";

QString percent(double v)
{
    if (v < 1e-7) v = 0;  // places are floats
    return QString::number(v, 'g', 2) + " %";
}

class BaseErrorRow : public QWidget {
public:
    BaseErrorRow(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        setObjectName("baseError");
        auto* line = new QHBoxLayout(this);
        line->setContentsMargins(0, 0, 8, 6);
        line->addWidget(text_ = new QLabel(this), 1);
        text_->setObjectName("baseErrorText");
        text_->setWordWrap(true);
        text_->setProperty("secondary", true);
        text_->setToolTip(
            "As shares of the diagonal of the base mesh's box. The greatest distance is sought among the vertices and 100,000 points "
            "on each surface, both ways; the mean is over these points.");
        line->addWidget(measure_ = new QPushButton("Measure", this));
        measure_->setToolTip("Measure this large mesh now; it takes some seconds");
        line->addWidget(show_ = new QPushButton("Show", this));
        show_->setObjectName("showBaseError");
        show_->setCheckable(true);
        show_->setToolTip("Colour the view by the distance to the base mesh; again: by material");
        for (QPushButton* b : {measure_, show_}) b->setFocusPolicy(Qt::TabFocus);
        connect(measure_, &QPushButton::clicked, this, [this] { start(); });
        connect(show_, &QPushButton::clicked, this, [this](bool on) {
            session_.view.colourBy = on ? QString(query) : QString();
            session_.view.touch();
        });
        wait_.setSingleShot(true);
        wait_.setInterval(400);
        connect(&wait_, &QTimer::timeout, this, [this] { start(); });
        subscription_ = session_.document.subscribe([this](const Change&) { refresh(); });
        connect(&session_.view, &ViewState::changed, this, [this] { show_->setChecked(session_.view.colourBy == query); });
        refresh();
    }

private:
    /// What is compared; the arrays say whether it has changed.
    struct Subject {
        Mesh base, result;
        bool same(const Subject& s) const { return sameMesh(base, s.base) && sameMesh(result, s.result); }
    };

    std::optional<Subject> subject() const
    {
        const MeshId id = edits::activeMesh(session_.document);
        const MeshObject* object = session_.document.scene().find(id);
        const auto evaluation = session_.document.evaluation(id);
        if (!object || object->stack.empty() || !evaluation) return std::nullopt;
        Subject s{object->base, evaluation->result()};
        if (s.base.faceCount() == 0 || s.result.faceCount() == 0 || s.base.positions().id() == s.result.positions().id()) return std::nullopt;
        return s;
    }

    void refresh()
    {
        const auto now = subject();
        setVisible(now.has_value());
        if (now && subject_ && now->same(*subject_)) return;
        if (job_) session_.jobs.cancel(std::exchange(job_, 0));
        wait_.stop();
        subject_ = now;
        if (!now) return;
        const bool large = std::max(now->base.faceCount(), now->result.faceCount()) > largeFaces;
        measure_->setVisible(large);
        say(large ? "not measured" : "...");
        if (!large) wait_.start();
    }

    void say(const QString& what) { text_->setText("Error against the base: " + what); }

    void start()
    {
        if (!subject_) return;
        measure_->hide();
        say("...");
        job_ = session_.jobs.start(
            "Error against the base",
            [this, s = *subject_](Progress& progress) -> std::function<void()> {
                const Value v = apply(operation(query), s.result, {{"samples", points}}, &progress, {{"other", s.base}});
                std::map<std::string, double> found;
                for (const auto& [name, value] : std::get<Table>(v).summary) found[name] = value;
                return [this, s, hausdorff = found["hausdorff %"], rms = found["rms %"]] {
                    if (subject_ && subject_->same(s)) say(QString("Hausdorff %1, RMS %2").arg(percent(hausdorff), percent(rms)));
                };
            },
            [this](const QString& text) { say(text); });
    }

    Session& session_;
    QLabel* text_ = nullptr;
    QPushButton *show_ = nullptr, *measure_ = nullptr;
    QTimer wait_;
    quint64 job_ = 0;
    std::optional<Subject> subject_;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makeBaseErrorRow(Session& session, QWidget* parent)
{
    return new BaseErrorRow(session, parent);
}

}  // namespace mw
