// Ctrl+K: one field that finds everything by its words: commands, modifiers, lessons, parameters, nodes, settings.
#pragma once
#include <QAbstractListModel>
#include <QFrame>
#include <QIcon>
#include <functional>

class QLineEdit;
class QListView;

namespace mw {

/// Something that can be found and run.
struct Findable {
    QString id;            ///< for the list of the last ones
    QString title, where;  ///< "Loop subdivision", "Mesh > Subdivide"
    QString more;          ///< further words it is found by: the tooltip
    QString keys, whyNot;  ///< its shortcut; why it cannot run now, empty when it can
    QString command;       ///< command line that does the same; empty: there is none
    QIcon icon;
    std::function<void()> run;
};

/// Where the words of a query are found in a title, as (start, length); `rank` tells how well, smaller is better. Empty ranges and rank -1:
/// not found at all. Letters in order ("lsub" in "Loop subdivision") count when words do not.
std::vector<std::pair<int, int>> matchedLetters(const QString& query, const Findable& entry, int* rank);

class FoundModel : public QAbstractListModel {
    Q_OBJECT

public:
    FoundModel(std::vector<Findable> all, QObject* parent);
    void search(const QString& query);
    int rowCount(const QModelIndex& = {}) const override { return int(rows_.size()); }
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    const Findable& at(int row) const { return all_[rows_[size_t(row)].entry]; }
    const std::vector<std::pair<int, int>>& letters(int row) const { return rows_[size_t(row)].letters; }

private:
    struct Row {
        size_t entry;
        int rank;
        std::vector<std::pair<int, int>> letters;
    };
    std::vector<Findable> all_;
    std::vector<Row> rows_;
};

class CommandSearch : public QFrame {
    Q_OBJECT

public:
    CommandSearch(std::vector<Findable> all, QWidget* window);
    void openBelow(QWidget* anchor);

signals:
    void helpWanted(const QString& title, const QString& text);
    void said(const QString& text);  ///< for the status bar

private:
    void run();
    void copyCommand();
    bool eventFilter(QObject* o, QEvent* e) override;
    FoundModel* model_;
    QLineEdit* field_;
    QListView* list_;
};

}  // namespace mw
