#include "ui/panels/history.h"

#include <QDateTime>
#include <QHeaderView>
#include <QMenu>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/edit_commands.h"
#include "ui/theme.h"

namespace mw {
namespace {

class History : public QWidget {
public:
    History(Session& session, QWidget* parent) : QWidget(parent), session_(session), list_(new QTreeWidget(this))
    {
        auto* box = new QVBoxLayout(this);
        box->setContentsMargins(0, 4, 6, 0);
        box->addWidget(list_);
        list_->setColumnCount(2);
        list_->setHeaderHidden(true);
        list_->setRootIsDecorated(false);
        list_->setUniformRowHeights(true);
        list_->setAccessibleName("History");
        list_->header()->setStretchLastSection(false);
        list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
        list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
        connect(list_, &QTreeWidget::itemClicked, this,
                [this](QTreeWidgetItem* i) { session_.document.goTo(size_t(list_->indexOfTopLevelItem(i))); });
        connect(list_, &QTreeWidget::itemActivated, this,
                [this](QTreeWidgetItem* i) { session_.document.goTo(size_t(list_->indexOfTopLevelItem(i))); });
        list_->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(list_, &QTreeWidget::customContextMenuRequested, this, [this](const QPoint& p) { menu(p); });
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::History | Aspect::File))
                QMetaObject::invokeMethod(
                    this, [this] { rebuild(); }, Qt::QueuedConnection);
        });
        rebuild();
    }

private:
    void menu(const QPoint& at)
    {
        auto* row = list_->itemAt(at);
        if (!row) return;
        const auto i = size_t(list_->indexOfTopLevelItem(row));
        auto* m = new QMenu(this);
        m->setAttribute(Qt::WA_DeleteOnClose);
        m->setToolTipsVisible(true);
        m->addAction(icon("here"), "Go here", this, [this, i] { session_.document.goTo(i); });
        m->addSeparator();
        auto* one = m->addAction(icon("copy"), "Copy as command", this, [this, i] { edits::copyCommand(session_, i, edits::Copied::Entry); });
        one->setEnabled(!session_.document.history()[i].calls.empty());
        one->setToolTip(one->isEnabled() ? "What a shell has to say to do this again" : "A command line cannot do this again");
        auto* all = m->addAction("Copy all up to here as command", this, [this, i] { edits::copyCommand(session_, i, edits::Copied::AllUpTo); });
        all->setToolTip("What a shell has to say to get this state");
        m->popup(list_->viewport()->mapToGlobal(at));
    }

    void rebuild()
    {
        const auto& entries = session_.document.history();
        const size_t here = session_.document.historyPosition();
        list_->clear();
        for (size_t i = 0; i < entries.size(); ++i) {
            const auto at = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(entries[i].at));
            auto* row = new QTreeWidgetItem({QString::fromStdString(entries[i].name), i > here ? "undone" : at.toString("HH:mm")});
            row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
            row->setIcon(0, i == here ? icon("here") : i < here ? icon("ok", tokens().text2) : QIcon(iconPixmap("dots", QColor(0, 0, 0, 0), 16, 1)));
            row->setToolTip(0, i == here ? "The present state" : i < here ? "Go back to here" : "Redo up to here");
            if (i > here)
                for (int c : {0, 1}) row->setForeground(c, tokens().text3);
            list_->addTopLevelItem(row);
        }
        if (auto* row = list_->topLevelItem(int(here))) {
            list_->setCurrentItem(row);
            list_->scrollToItem(row);
        }
    }

    Session& session_;
    QTreeWidget* list_;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makeHistoryPanel(Session& session, QWidget* parent)
{
    return new History(session, parent);
}

}  // namespace mw
