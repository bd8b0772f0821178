// The widget of the Records panel. records.cpp has where it stands and how it moves, records_table.cpp what it shows.
#pragma once
#include <QPushButton>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/panels/record_tables.h"
#include "ui/session.h"

class QComboBox;
class QLabel;
class QStackedLayout;
class QTableWidget;
class QTableWidgetItem;
class QToolButton;

namespace mw {

class Records : public QWidget {
public:
    Records(Session& session, QWidget* parent);

protected:
    void showEvent(QShowEvent*) override { update(); }
    void hideEvent(QHideEvent*) override;
    void leaveEvent(QEvent*) override { flash(nullptr); }
    void changeEvent(QEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void makePage();
    QWidget* makeBar(QWidget* parent);
    void makeTable(QWidget* parent);
    QWidget* makeQueries(QWidget* parent);

    NodeId wantedNode() const;
    void update();
    void prepare(const Mesh& mesh);
    void take(std::shared_ptr<const RecordMesh> m);
    void followSelection();
    void showMessage(const QString& text, const QString& button);
    void messageClicked();

    void go(RecordLink link);
    void travel(int by);
    void stand(RecordLink link);
    void selectHere();
    void select(const ElementSet& elements);

    void fill();
    void addTable(const RecordTable& table);
    void addCell(int row, int column, const RecordCell& cell);
    void fillAnswer();
    void draw();
    void flash(const QTableWidgetItem* cell);
    void follow(const QTableWidgetItem* cell);
    std::optional<RecordLink> linkOf(const QTableWidgetItem* cell) const;

    Session& session_;
    std::shared_ptr<void> subscription_;
    QStackedLayout* pages_;
    QLabel *message_ = nullptr, *title_ = nullptr, *answer_ = nullptr;
    QPushButton *messageButton_ = nullptr, *selectAnswer_ = nullptr;
    QToolButton *back_ = nullptr, *forward_ = nullptr;
    QComboBox* drawing_ = nullptr;
    QTableWidget* table_ = nullptr;
    QPushButton* queries_[9] = {};

    NodeId node_;
    Mesh wanted_;  // the mesh shown, perhaps still being prepared
    std::shared_ptr<const RecordMesh> mesh_;
    quint64 job_ = 0, ticket_ = 0;
    RecordLink here_;
    RecordPlace place_;
    std::vector<RecordLink> path_;  // what was gone to, for back and forward
    size_t pathAt_ = 0;
    int query_ = -1;
    ElementSet found_;
    bool selecting_ = false, drawn_ = false;
};

}  // namespace mw
