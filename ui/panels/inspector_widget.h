// The inspector's widget: a report of the mesh as a worklist. inspector.cpp has its page and its report, inspector_list.cpp its rows and what
// they do.
#pragma once
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "ui/panels/inspection.h"
#include "ui/session.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedLayout;
class QTreeWidget;
class QTreeWidgetItem;

namespace mw {

class Inspector : public QWidget {
public:
    Inspector(Session& session, QWidget* parent);

protected:
    void showEvent(QShowEvent*) override { update(false); }
    void leaveEvent(QEvent*) override { flash(nullptr); }
    bool eventFilter(QObject* o, QEvent* e) override;
    void changeEvent(QEvent* e) override;
    void resizeEvent(QResizeEvent* e) override;

private:
    void makePage();
    void makeTree();
    QWidget* makeCounts(QWidget* parent);
    NodeId wantedNode() const;
    void update(bool measureLarge);
    void refreshLevels(const MeshObject& object);
    Mesh inspected(MeshId id) const;
    void measure(const Mesh& mesh, bool everything);
    void cancelMeasuring();
    void show(std::shared_ptr<const Inspection> i);
    void fill();
    QTreeWidgetItem* section(const QString& title, const QString& figure);
    void addFinding(QTreeWidgetItem* under, size_t index);
    void addSentence(QTreeWidgetItem* row, const QString& sentence);
    void addButton(QTreeWidgetItem* row, const Finding& f, const QString& text, const QString& tip, std::function<void()> run);
    void addRepairAll(QTreeWidgetItem* section);
    void strike(QTreeWidgetItem* row);
    void addValence();
    void addFaceSizes();
    void addHistogram(QTreeWidgetItem* section, ElementKind kind);
    void showMessage(const QString& text, const QString& button);

    const ElementSet* elementsOf(const QTreeWidgetItem* row) const;
    void select(const ElementSet& elements);
    void selectCounted(ElementKind kind, size_t number, bool orMore);
    void frame(const QTreeWidgetItem* row);
    void flash(const QTreeWidgetItem* row);
    void repair(const std::vector<Mending>& mendings, const std::set<QString>& findings);
    void unstrike();
    void selectionChanged();

    Session& session_;
    std::shared_ptr<void> subscription_;
    QStackedLayout* pages_;
    QLabel *message_ = nullptr, *values_[6] = {};
    QPushButton* messageButton_ = nullptr;
    QComboBox* level_ = nullptr;
    QWidget* busy_ = nullptr;
    QLabel* busyText_ = nullptr;
    QTreeWidget* tree_ = nullptr;
    NodeId node_;
    std::shared_ptr<const Inspection> shown_;
    Mesh measuring_;
    quint64 job_ = 0, ticket_ = 0;
    bool selecting_ = false, dimmed_ = false;
    std::set<QString> struck_;  // findings with a modifier on its way
    size_t struckAt_ = 0;       // the place in the history of that modifier
};

}  // namespace mw
