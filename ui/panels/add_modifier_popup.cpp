#include "ui/panels/add_modifier_popup.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScreen>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "ui/theme.h"

namespace mw {
namespace {

constexpr int idRole = Qt::UserRole + 1, summaryRole = Qt::UserRole + 2, noteRole = Qt::UserRole + 3;

// Title in bold, the summary below it; a category as a heading.
class TwoLines : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& i) const override { return {100, i.data(idRole).isNull() ? 24 : 42}; }
    void paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const override
    {
        const Tokens& t = tokens();
        const bool on = o.state & QStyle::State_Selected;
        const QRect r = o.rect.adjusted(8, 3, -8, -3);
        if (on) p->fillRect(o.rect, t.selection);
        QFont font = o.font;
        if (i.data(idRole).isNull()) {
            p->setPen(t.text2);
            p->drawText(r, Qt::AlignLeft | Qt::AlignVCenter, i.data().toString());
            return;
        }
        font.setBold(true);
        p->setFont(font);
        p->setPen(on ? t.selectionText : t.text);
        p->drawText(r, Qt::AlignLeft | Qt::AlignTop, i.data().toString());
        p->setFont(o.font);
        p->setPen(on ? t.selectionText : t.text2);
        p->drawText(r, Qt::AlignRight | Qt::AlignTop, i.data(noteRole).toString());
        p->drawText(r, Qt::AlignLeft | Qt::AlignBottom, o.fontMetrics.elidedText(i.data(summaryRole).toString(), Qt::ElideRight, r.width()));
    }
};

class Popup : public QFrame {
public:
    Popup(QWidget* parent, std::function<void(const Operation&)> chosen, std::function<QString(const Operation&)> note)
        : QFrame(parent, Qt::Popup), chosen_(std::move(chosen)), note_(std::move(note))
    {
        setObjectName("popup");
        setAttribute(Qt::WA_DeleteOnClose);
        auto* box = new QVBoxLayout(this);
        box->setContentsMargins(8, 8, 8, 8);
        field_ = new QLineEdit(this);
        field_->setPlaceholderText("Search modifiers");
        list_ = new QListWidget(this);
        list_->setObjectName("modifierChoices");
        list_->setItemDelegate(new TwoLines(list_));
        list_->setFocusPolicy(Qt::NoFocus);
        box->addWidget(field_);
        box->addWidget(list_);
        resize(440, 360);
        connect(field_, &QLineEdit::textChanged, this, [this] { fill(); });
        connect(list_, &QListWidget::itemClicked, this, [this](QListWidgetItem* i) { take(i); });
        field_->installEventFilter(this);
        fill();
        field_->setFocus();
    }

private:
    void fill()
    {
        list_->clear();
        const QStringList words = field_->text().split(' ', Qt::SkipEmptyParts);
        std::vector<std::string> categories;
        for (const Operation& op : catalog())
            if (std::find(categories.begin(), categories.end(), op.category) == categories.end()) categories.push_back(op.category);
        for (const std::string& category : categories) {
            bool headed = false;
            for (const Operation& op : catalog()) {
                if (op.accepts != Kind::Mesh || op.yields != Kind::Mesh || op.category != category) continue;
                const QString all = QString::fromStdString(op.title + " " + op.id + " " + op.summary + " " + op.category);
                if (!std::all_of(words.begin(), words.end(), [&](const QString& w) { return all.contains(w, Qt::CaseInsensitive); })) continue;
                if (!headed) (new QListWidgetItem(QString::fromStdString(category), list_))->setFlags(Qt::NoItemFlags);
                headed = true;
                auto* item = new QListWidgetItem(QString::fromStdString(op.title), list_);
                item->setData(idRole, QString::fromStdString(op.id));
                if (note_) item->setData(noteRole, note_(op));
                item->setData(summaryRole, QString::fromStdString(op.summary));
                item->setToolTip(QString::fromStdString(op.summary));
            }
        }
        if (list_->count() == 0)
            (new QListWidgetItem("No modifier has these words. Try \"simplify\" or \"subdivide\".", list_))->setFlags(Qt::NoItemFlags);
        if (list_->count() > 1) list_->setCurrentRow(1);
    }

    void take(QListWidgetItem* i)
    {
        const Operation* op = i ? findOperation(i->data(idRole).toString().toStdString()) : nullptr;
        if (!op) return;
        const auto chosen = chosen_;
        close();
        chosen(*op);
    }

    bool eventFilter(QObject* o, QEvent* e) override
    {
        if (e->type() != QEvent::KeyPress) return QFrame::eventFilter(o, e);
        const int key = static_cast<QKeyEvent*>(e)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            take(list_->currentItem());
            return true;
        }
        if (key != Qt::Key_Down && key != Qt::Key_Up) return false;
        const int step = key == Qt::Key_Down ? 1 : -1;
        for (int r = list_->currentRow() + step; r >= 0 && r < list_->count(); r += step)
            if (!list_->item(r)->data(idRole).isNull()) {
                list_->setCurrentRow(r);
                break;
            }
        return true;
    }

    std::function<void(const Operation&)> chosen_;
    std::function<QString(const Operation&)> note_;
    QLineEdit* field_;
    QListWidget* list_;
};

}  // namespace

QFrame* showAddModifierPopup(QWidget* anchor, std::function<void(const Operation&)> chosen, std::function<QString(const Operation&)> note)
{
    auto* popup = new Popup(anchor->window(), std::move(chosen), std::move(note));
    // Below the button, but never over the edge of the screen.
    QPoint at = anchor->mapToGlobal(QPoint(0, anchor->height() + 2));
    at.setX(std::max(0, std::min(at.x(), anchor->screen()->availableGeometry().right() + 1 - popup->width())));
    popup->move(at);
    popup->show();
    return popup;
}

}  // namespace mw
