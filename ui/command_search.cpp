#include "ui/command_search.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSettings>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/theme.h"

namespace mw {
namespace {

QString plain(const QAction* a)
{
    return a->text().remove('&');
}

class Search : public QFrame {
public:
    Search(QWidget* parent, QList<QAction*> actions) : QFrame(parent, Qt::Popup), actions_(std::move(actions))
    {
        setObjectName("popup");
        setAttribute(Qt::WA_DeleteOnClose);
        auto* box = new QVBoxLayout(this);
        box->setContentsMargins(8, 8, 8, 8);
        field_ = new QLineEdit(this);
        field_->setPlaceholderText("Search commands");
        list_ = new QTreeWidget(this);
        list_->setColumnCount(2);
        list_->setHeaderHidden(true);
        list_->setRootIsDecorated(false);
        list_->setUniformRowHeights(true);
        list_->setFocusPolicy(Qt::NoFocus);
        list_->header()->setStretchLastSection(false);
        list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
        list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
        box->addWidget(field_);
        box->addWidget(list_);
        resize(560, 380);
        field_->installEventFilter(this);
        connect(field_, &QLineEdit::textChanged, this, [this] { fill(); });
        connect(list_, &QTreeWidget::itemClicked, this, [this] { run(); });
        fill();
        field_->setFocus();
    }

private:
    void fill()
    {
        list_->clear();
        shown_.clear();
        const QStringList words = field_->text().split(' ', Qt::SkipEmptyParts);
        const QStringList latest = QSettings().value("search/latest").toStringList();
        QList<QAction*> found;
        for (QAction* a : actions_) {
            const QString all = plain(a) + " " + a->toolTip();
            const bool hit = std::all_of(words.begin(), words.end(), [&](const QString& w) { return all.contains(w, Qt::CaseInsensitive); });
            if (hit && (!words.isEmpty() || latest.isEmpty() || latest.contains(plain(a)))) found << a;
        }
        const auto rank = [&](QAction* a) {
            const bool starts = !words.isEmpty() && plain(a).startsWith(words[0], Qt::CaseInsensitive);
            const bool inTitle = !words.isEmpty() && plain(a).contains(words[0], Qt::CaseInsensitive);
            return (a->isEnabled() ? 0 : 100) + (starts ? 0 : inTitle ? 1 : 2);
        };
        std::stable_sort(found.begin(), found.end(), [&](QAction* a, QAction* b) { return rank(a) < rank(b); });
        for (QAction* a : found) {
            auto* item = new QTreeWidgetItem({plain(a), a->shortcut().toString(QKeySequence::NativeText)});
            item->setIcon(0, a->icon());
            item->setToolTip(0, a->toolTip());
            item->setForeground(1, tokens().text2);
            item->setDisabled(!a->isEnabled());
            list_->addTopLevelItem(item);
            shown_ << a;
        }
        if (shown_.isEmpty()) {
            auto* none = new QTreeWidgetItem({"No command has these words", ""});
            none->setDisabled(true);
            list_->addTopLevelItem(none);
        }
        list_->setCurrentItem(list_->topLevelItem(0));
    }

    void run()
    {
        const int row = list_->indexOfTopLevelItem(list_->currentItem());
        QAction* a = shown_.value(row);
        if (!a || !a->isEnabled()) return;
        QStringList latest = QSettings().value("search/latest").toStringList();
        latest.removeAll(plain(a));
        latest.prepend(plain(a));
        QSettings().setValue("search/latest", QStringList(latest.mid(0, 8)));
        close();
        a->trigger();
    }

    bool eventFilter(QObject* o, QEvent* e) override
    {
        if (e->type() != QEvent::KeyPress) return QFrame::eventFilter(o, e);
        const int key = static_cast<QKeyEvent*>(e)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            run();
            return true;
        }
        if (key != Qt::Key_Down && key != Qt::Key_Up) return false;
        const int row = list_->indexOfTopLevelItem(list_->currentItem()) + (key == Qt::Key_Down ? 1 : -1);
        if (row >= 0 && row < list_->topLevelItemCount()) list_->setCurrentItem(list_->topLevelItem(row));
        return true;
    }

    QList<QAction*> actions_, shown_;
    QLineEdit* field_;
    QTreeWidget* list_;
};

}  // namespace

QFrame* showCommandSearch(QWidget* anchor, const QList<QAction*>& actions)
{
    auto* popup = new Search(anchor->window(), actions);
    popup->move(anchor->mapToGlobal(QPoint(anchor->width() - 560, anchor->height() + 2)));
    popup->show();
    return popup;
}

}  // namespace mw
