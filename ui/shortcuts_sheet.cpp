#include "ui/shortcuts_sheet.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/theme.h"

namespace mw {
namespace {

enum Columns { CommandColumn, WhereColumn, KeysColumn };

QPushButton* button(const QString& verb, const QString& tip, QWidget* parent)
{
    auto* b = new QPushButton(verb, parent);
    b->setToolTip(tip);
    b->setFocusPolicy(Qt::TabFocus);
    return b;
}

}  // namespace

ShortcutsSheet::ShortcutsSheet(Shortcuts& shortcuts, QWidget* over)
    : Sheet("Shortcuts", over, {660, 600}), shortcuts_(shortcuts), model_(new QStandardItemModel(0, 3, this)), proxy_(new QSortFilterProxyModel(this))
{
    setObjectName("shortcutsSheet");
    proxy_->setSourceModel(model_);
    proxy_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    proxy_->setFilterKeyColumn(-1);
    list_ = new QTreeView(this);
    list_->setModel(proxy_);
    list_->setRootIsDecorated(false);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setAccessibleName("Commands and their keys");
    model_->setHorizontalHeaderLabels({"Command", "Where", "Keys"});
    list_->header()->setSectionResizeMode(CommandColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(WhereColumn, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(KeysColumn, QHeaderView::ResizeToContents);
    body()->addWidget(top());
    body()->addWidget(list_, 1);
    body()->addWidget(editor());
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] { showCurrent(); });
    connect(list_, &QTreeView::activated, this, [this] { keys_->setFocus(); });
    connect(&shortcuts_, &Shortcuts::edited, this, &ShortcutsSheet::fill);
    fill();
    list_->setCurrentIndex(proxy_->index(0, 0));
}

QWidget* ShortcutsSheet::top()
{
    auto* w = new QWidget(this);
    auto* line = new QHBoxLayout(w);
    line->setContentsMargins(0, 0, 0, 0);
    filter_ = new QLineEdit(w);
    filter_->setObjectName("shortcutsFilter");
    filter_->setPlaceholderText("Filter by command, menu or key");
    filter_->setAccessibleName("Filter commands");
    filter_->setToolTip("Words of the command, its menu, or a key such as Ctrl+D");
    filter_->setClearButtonEnabled(true);
    filter_->installEventFilter(this);
    connect(filter_, &QLineEdit::textChanged, this, [this](const QString& t) {
        proxy_->setFilterFixedString(t);
        list_->setCurrentIndex(proxy_->index(0, 0));
    });
    auto* preset = new QComboBox(w);
    preset->setObjectName("shortcutsPreset");
    preset->addItems(Shortcuts::presets());
    preset->setCurrentText(shortcuts_.preset());
    preset->setAccessibleName("Preset");
    preset->setToolTip("Keys to begin with: our own, or those Blender has. What you have set by hand stays");
    preset->setFocusPolicy(Qt::TabFocus);
    connect(preset, &QComboBox::textActivated, this, [this](const QString& name) { shortcuts_.usePreset(name); });
    auto* all = button("Reset all", "Every command back to the keys of the preset", w);
    connect(all, &QPushButton::clicked, this, [this] { shortcuts_.resetAll(); });
    line->addWidget(filter_, 1);
    line->addWidget(new QLabel("Preset", w));
    line->addWidget(preset);
    line->addWidget(all);
    return w;
}

QWidget* ShortcutsSheet::editor()
{
    auto* w = new QWidget(this);
    auto* box = new QVBoxLayout(w);
    box->setContentsMargins(0, 0, 0, 0);
    auto* line = new QHBoxLayout;
    name_ = new QLabel(w);
    name_->setMinimumWidth(180);
    keys_ = new QLineEdit(w);
    keys_->setObjectName("shortcutsKeys");
    keys_->setReadOnly(true);
    keys_->setAccessibleName("Keys of the command");
    keys_->setToolTip("Press the key that is to run the command. Tab goes on, Esc leaves it as it was");
    keys_->installEventFilter(this);
    none_ = button("No key", "Take the keys away", w);
    reset_ = button("Reset", "The keys of the preset", w);
    connect(none_, &QPushButton::clicked, this, [this] {
        if (const auto* c = current()) shortcuts_.set(*c, {});
    });
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (const auto* c = current()) shortcuts_.reset(*c);
    });
    for (QWidget* part : {static_cast<QWidget*>(name_), static_cast<QWidget*>(keys_), static_cast<QWidget*>(none_), static_cast<QWidget*>(reset_)})
        line->addWidget(part, part == keys_ ? 1 : 0);
    auto* second = new QHBoxLayout;
    conflict_ = new QLabel(w);
    conflict_->setObjectName("shortcutsConflict");
    conflict_->setWordWrap(true);
    take_ = button("Take it", "Give the key to this command; the other one loses it", w);
    keep_ = button("Keep", "Leave the key where it is", w);
    take_->setObjectName("shortcutsTake");
    keep_->setObjectName("shortcutsKeep");
    connect(take_, &QPushButton::clicked, this, [this] { take(wanted_); });
    connect(keep_, &QPushButton::clicked, this, [this] { showCurrent(); });
    second->addWidget(conflict_, 1);
    second->addWidget(take_);
    second->addWidget(keep_);
    box->addLayout(line);
    box->addLayout(second);
    return w;
}

const Shortcuts::Command* ShortcutsSheet::current() const
{
    const QModelIndex i = list_->currentIndex();
    return i.isValid() ? shortcuts_.command(i.siblingAtColumn(CommandColumn).data(Qt::UserRole).toString()) : nullptr;
}

void ShortcutsSheet::fill()
{
    const QString before = current() ? current()->action->objectName() : QString();
    if (model_->rowCount() != shortcuts_.commands().size()) model_->setRowCount(int(shortcuts_.commands().size()));
    int row = 0;
    for (const Shortcuts::Command& c : shortcuts_.commands()) {
        auto* title = new QStandardItem(c.title);
        title->setData(c.action->objectName(), Qt::UserRole);
        title->setToolTip(c.action->toolTip());
        auto* where = new QStandardItem(c.where);
        where->setForeground(tokens().text2);
        auto* keys = new QStandardItem(keysText(c.action));
        QFont font = list_->font();
        font.setBold(shortcuts_.changed(c));
        keys->setFont(font);
        model_->setItem(row, CommandColumn, title);
        model_->setItem(row, WhereColumn, where);
        model_->setItem(row, KeysColumn, keys);
        if (c.action->objectName() == before) list_->setCurrentIndex(proxy_->mapFromSource(model_->index(row, 0)));
        ++row;
    }
    showCurrent();
}

void ShortcutsSheet::showCurrent()
{
    const Shortcuts::Command* c = current();
    name_->setText(c ? "<b>" + c->title.toHtmlEscaped() + "</b>" : QString());
    keys_->setText(c ? keysText(c->action) : QString());
    keys_->setPlaceholderText("Press a key");
    for (QWidget* w : {static_cast<QWidget*>(keys_), static_cast<QWidget*>(none_)}) w->setEnabled(c);
    reset_->setEnabled(c && shortcuts_.changed(*c));
    conflict_->setText(c ? "Click the field, or Enter in the list, and press a key." : "No command has these words.");
    take_->hide();
    keep_->hide();
}

// The first of its keys becomes this one; further ones stay.
void ShortcutsSheet::take(const QKeySequence& key)
{
    const Shortcuts::Command* c = current();
    if (!c) return;
    if (const Shortcuts::Command* other = shortcuts_.holder(key, *c)) {
        QList<QKeySequence> left = other->action->shortcuts();
        left.removeAll(key);
        shortcuts_.set(*other, left);
    }
    QList<QKeySequence> keys = c->action->shortcuts();
    keys.removeAll(key);
    if (!keys.isEmpty()) keys.removeFirst();
    keys.prepend(key);
    shortcuts_.set(*c, keys);
}

void ShortcutsSheet::offer(const QKeySequence& key)
{
    const Shortcuts::Command* c = current();
    if (!c) return;
    QString fixed;
    const Shortcuts::Command* other = shortcuts_.holder(key, *c, &fixed);
    const QString text = key.toString(QKeySequence::NativeText);
    wanted_ = key;
    keys_->setText(text);
    if (!other && fixed.isEmpty()) return take(key);
    take_->setVisible(other);
    keep_->setVisible(other);
    conflict_->setText(other ? QString("%1 runs %2 (%3) now.").arg(text, other->title, other->where)
                             : QString("%1 belongs to %2. Press another key.").arg(text, fixed));
    if (other) take_->setFocus();
}

bool ShortcutsSheet::eventFilter(QObject* o, QEvent* e)
{
    if (o == filter_ && e->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Down) {
        list_->setFocus();
        return true;
    }
    if (o != keys_) return Sheet::eventFilter(o, e);
    if (e->type() == QEvent::ShortcutOverride) {
        e->accept();  // the key is for us, whatever it does elsewhere
        return true;
    }
    if (e->type() == QEvent::FocusIn) conflict_->setText("Press the key. Esc leaves it as it was.");
    if (e->type() != QEvent::KeyPress) return Sheet::eventFilter(o, e);
    auto* press = static_cast<QKeyEvent*>(e);
    const int key = press->key();
    if (key == Qt::Key_Tab || key == Qt::Key_Backtab) return false;
    if (key == Qt::Key_Escape) {
        showCurrent();
        list_->setFocus();
        return true;
    }
    if (key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta || key == 0 || key == Qt::Key_unknown)
        return true;
    offer(QKeySequence(press->keyCombination()));
    return true;
}

}  // namespace mw
