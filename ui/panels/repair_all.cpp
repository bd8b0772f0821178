#include "ui/panels/repair_all.h"

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include "core/catalog/catalog.h"
#include "ui/look.h"

namespace mw {
namespace {

/// "−1,113 vertices, +213 faces".
QString difference(const Mesh& before, const Mesh& after)
{
    QStringList parts;
    const auto add = [&](size_t a, size_t b, const QString& one, const QString& many) {
        if (a != b) parts << (b > a ? "+" : "\u2212") + look::counted(b > a ? b - a : a - b, one, many);
    };
    add(before.vertexCount(), after.vertexCount(), "vertex", "vertices");
    add(before.faceCount(), after.faceCount(), "face", "faces");
    return parts.isEmpty() ? "same counts" : parts.join(", ");
}

struct Forecast {
    std::vector<QString> changes;  // one a mending
    QString left;                  // what is still to be fixed
};

Forecast forecastOf(Mesh mesh, const std::vector<Mending>& mendings, const std::vector<bool>& ticked, Progress& progress)
{
    Forecast f;
    for (size_t i = 0; i < mendings.size(); ++i) {
        f.changes.push_back("left out");
        if (!ticked[i]) continue;
        const Mesh before = mesh;
        try {
            mesh = std::get<Mesh>(apply(operation(mendings[i].operation), mesh, mendings[i].values, &progress));
            f.changes.back() = difference(before, mesh);
        } catch (const Error& e) {
            f.changes.back() = QString::fromStdString(e.reason());
        }
    }
    QStringList left;
    for (const Finding& finding : inspect(mesh, false, &progress).findings)
        if (finding.toFix()) left << (left.isEmpty() ? finding.title : finding.title.toLower());
    f.left = left.isEmpty() ? "Then nothing is left to fix." : "Still to fix then: " + left.join(", ") + ".";
    return f;
}

class RepairAll : public QFrame {
public:
    RepairAll(Session& session, QWidget* anchor, std::shared_ptr<const Inspection> inspection,
              std::function<void(const std::vector<Mending>&)> chosen)
        : QFrame(anchor, Qt::Popup),
          session_(session),
          inspection_(std::move(inspection)),
          mendings_(inspection_->mendings()),
          chosen_(std::move(chosen))
    {
        setObjectName("repair-all");
        setAttribute(Qt::WA_DeleteOnClose);
        setFrameShape(QFrame::StyledPanel);
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(12, 8, 12, 12);
        column->addWidget(new QLabel("<b>Modifiers to add</b>", this));
        makeList();
        column->addWidget(list_);
        left_ = new QLabel(this);
        left_->setObjectName("repair-all-left");
        left_->setWordWrap(true);
        left_->setProperty("secondary", true);
        column->addWidget(left_);
        auto* buttons = new QHBoxLayout;
        buttons->addStretch(1);
        button_ = new QPushButton("Repair", this);
        button_->setObjectName("repair-all-go");
        button_->setProperty("primary", true);
        button_->setToolTip("Adds the ticked modifiers; one undo takes all of them back");
        buttons->addWidget(button_);
        column->addLayout(buttons);
        connect(button_, &QPushButton::clicked, this, [this] { finish(); });
        setFixedWidth(430);
        forecast();
        adjustSize();
        place(anchor);
        show();
        list_->setFocus();
    }
    ~RepairAll() override
    {
        if (job_ != 0) session_.jobs.cancel(job_);
    }

protected:
    void keyPressEvent(QKeyEvent* e) override
    {
        if (e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter)
            finish();
        else
            QFrame::keyPressEvent(e);
    }

private:
    void makeList()
    {
        list_ = new QListWidget(this);
        list_->setObjectName("repair-all-list");
        list_->setAccessibleName("Modifiers to add");
        list_->setFrameShape(QFrame::NoFrame);
        list_->setSpacing(2);
        for (const Mending& m : mendings_) {
            auto* item = new QListWidgetItem(list_);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(Qt::Checked);
            item->setToolTip(QString::fromStdString(operation(m.operation).summary));
        }
        connect(list_, &QListWidget::itemChanged, this, [this] {
            if (!filling_) forecast();
        });
    }
    void place(QWidget* anchor)
    {
        QPoint at = anchor->mapToGlobal(QPoint(0, anchor->height() + 4));
        const QRect screen = anchor->screen()->availableGeometry();
        at.setX(std::min(at.x(), screen.right() - width()));
        at.setY(std::min(at.y(), screen.bottom() - height()));
        move(at);
    }
    std::vector<bool> ticked() const
    {
        std::vector<bool> t;
        for (int i = 0; i < list_->count(); ++i) t.push_back(list_->item(i)->checkState() == Qt::Checked);
        return t;
    }
    void fill(const Forecast& f)
    {
        filling_ = true;
        for (size_t i = 0; i < mendings_.size(); ++i) {
            const QString title = QString::fromStdString(operation(mendings_[i].operation).title),
                          change = i < f.changes.size() ? f.changes[i] : "...";
            list_->item(int(i))->setText(title + ": " + change + "\n" + mendings_[i].findings);
            list_->item(int(i))->setData(Qt::AccessibleTextRole, title + ", for " + mendings_[i].findings + ", " + change);
        }
        filling_ = false;
        left_->setText(f.left.isEmpty() ? "Trying them out..." : f.left);
        const auto t = ticked();
        button_->setEnabled(std::find(t.begin(), t.end(), true) != t.end());
        list_->setFixedHeight(list_->sizeHintForRow(0) * list_->count() + 4 * list_->count() + 6);
    }
    void forecast()
    {
        fill({});
        if (job_ != 0) session_.jobs.cancel(job_);
        const quint64 ticket = ++ticket_;
        QPointer<RepairAll> self(this);
        job_ = session_.jobs.start(
            "Try repairs", [self, ticket, mesh = inspection_->mesh, mendings = mendings_, t = ticked()](Progress& p) -> std::function<void()> {
                auto f = std::make_shared<Forecast>(forecastOf(mesh, mendings, t, p));
                return [self, ticket, f] {
                    if (!self || self->ticket_ != ticket) return;
                    self->job_ = 0;
                    self->fill(*f);
                };
            });
    }
    void finish()
    {
        std::vector<Mending> chosen;
        const auto t = ticked();
        for (size_t i = 0; i < mendings_.size(); ++i)
            if (t[i]) chosen.push_back(mendings_[i]);
        if (chosen.empty()) return;
        const auto tell = chosen_;
        close();
        tell(chosen);
    }

    Session& session_;
    std::shared_ptr<const Inspection> inspection_;
    std::vector<Mending> mendings_;
    std::function<void(const std::vector<Mending>&)> chosen_;
    QListWidget* list_ = nullptr;
    QLabel* left_ = nullptr;
    QPushButton* button_ = nullptr;
    quint64 job_ = 0, ticket_ = 0;
    bool filling_ = false;
};

}  // namespace

QFrame* showRepairAll(Session& session, QWidget* anchor, std::shared_ptr<const Inspection> inspection,
                      std::function<void(const std::vector<Mending>&)> chosen)
{
    return new RepairAll(session, anchor, std::move(inspection), std::move(chosen));
}

}  // namespace mw
