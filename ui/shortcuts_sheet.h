// Edit > Shortcuts: every command with its keys; a key is pressed to change them, conflicts are settled in place.
#pragma once
#include "ui/sheet.h"
#include "ui/shortcuts.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QStandardItemModel;
class QTreeView;

namespace mw {

class ShortcutsSheet : public Sheet {
    Q_OBJECT

public:
    ShortcutsSheet(Shortcuts& shortcuts, QWidget* over);

protected:
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    QWidget* top();
    QWidget* editor();
    void fill();
    void showCurrent();
    void take(const QKeySequence& key);
    void offer(const QKeySequence& key);
    const Shortcuts::Command* current() const;
    Shortcuts& shortcuts_;
    QStandardItemModel* model_;
    QSortFilterProxyModel* proxy_;
    QTreeView* list_;
    QLineEdit *filter_ = nullptr, *keys_ = nullptr;
    QLabel *name_ = nullptr, *conflict_ = nullptr;
    QPushButton *take_ = nullptr, *keep_ = nullptr, *none_ = nullptr, *reset_ = nullptr;
    QKeySequence wanted_;
};

}  // namespace mw
