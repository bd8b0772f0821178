#include "ui/panels/jobs.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/panels/empty_state.h"
#include "ui/words.h"

namespace mw {
namespace {

struct JobRow {
    QWidget* widget;
    QLabel *name, *time;
    QProgressBar* bar;
    QPushButton* cancel;
    QLabel* error;
};

class JobsPanel : public QWidget {
public:
    JobsPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        auto* area = new QScrollArea(this);
        auto* inside = new QWidget(area);
        list_ = new QVBoxLayout(inside);
        list_->setContentsMargins(8, 8, 8, 8);
        list_->setSpacing(6);
        list_->setDirection(QBoxLayout::TopToBottom);
        empty_ = emptyStateLabel("No jobs. Long work shows here while it runs.", inside);
        list_->addWidget(empty_);
        list_->addStretch(1);
        area->setWidget(inside);
        area->setWidgetResizable(true);
        outer->addWidget(area);
        connect(&session_.jobs, &Jobs::changed, this, [this] { refresh(); });
        refresh();
    }

private:
    JobRow makeRow(const Job& j)
    {
        JobRow r{};
        r.widget = new QWidget(this);
        auto* box = new QVBoxLayout(r.widget);
        box->setContentsMargins(0, 0, 0, 0);
        box->setSpacing(2);
        auto* line = new QHBoxLayout;
        r.name = new QLabel(j.name, r.widget);
        r.time = new QLabel(r.widget);
        r.time->setProperty("secondary", true);
        r.cancel = new QPushButton("Cancel", r.widget);
        r.cancel->setFocusPolicy(Qt::TabFocus);
        line->addWidget(r.name, 1);
        line->addWidget(r.time);
        line->addWidget(r.cancel);
        r.bar = new QProgressBar(r.widget);
        r.bar->setTextVisible(false);
        r.bar->setRange(0, 1000);
        r.error = new QLabel(r.widget);
        r.error->setProperty("bad", true);
        r.error->setWordWrap(true);
        box->addLayout(line);
        box->addWidget(r.bar);
        box->addWidget(r.error);
        connect(r.cancel, &QPushButton::clicked, this, [this, id = j.id] { session_.jobs.cancel(id); });
        return r;
    }

    void refresh()
    {
        // Short work does not flicker through the list: a row comes after half a second, or when something failed.
        std::map<quint64, JobRow> kept;
        for (const Job& j : session_.jobs.jobs()) {
            const qint64 ms = j.state == Job::State::Running ? j.clock.elapsed() : j.milliseconds;
            if (ms < 500 && j.state != Job::State::Failed) continue;
            auto known = rows_.find(j.id);
            JobRow r = known != rows_.end() ? known->second : makeRow(j);
            if (known == rows_.end()) list_->insertWidget(0, r.widget);
            const bool running = j.state == Job::State::Running;
            const QString state = j.state == Job::State::Cancelled ? "cancelled, " : j.state == Job::State::Failed ? "stopped, " : "";
            r.time->setText(state + timeText(double(ms) / 1000));
            r.bar->setVisible(running);
            r.bar->setValue(int(1000 * j.progress->fraction));
            r.cancel->setVisible(running);
            r.error->setText(j.error);
            r.error->setVisible(!j.error.isEmpty());
            kept[j.id] = r;
        }
        for (auto& [id, r] : rows_)
            if (!kept.count(id)) r.widget->deleteLater();
        rows_ = std::move(kept);
        empty_->setVisible(rows_.empty());
    }

    Session& session_;
    QVBoxLayout* list_;
    QLabel* empty_;
    std::map<quint64, JobRow> rows_;
};

}  // namespace

QWidget* makeJobsPanel(Session& session, QWidget* parent)
{
    return new JobsPanel(session, parent);
}

}  // namespace mw
