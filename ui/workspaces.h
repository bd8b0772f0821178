// Docks from the list of panels, and saved layouts of them over one window (ui/UI.md 1).
#pragma once
#include <QMainWindow>
#include <QMap>

#include "ui/session.h"

class QDockWidget;
class QMenu;

namespace mw {

class Workspaces : public QObject {
    Q_OBJECT

public:
    Workspaces(Session& session, QMainWindow* window);
    static QStringList names() { return {"Mesh", "Learn", "Terrain", "Character"}; }
    const QString& current() const { return current_; }
    void change(const QString& name);
    void reset();      ///< as the table has it
    void store();      ///< the present layout, on leaving
    void toggleAll();  ///< all docks away, and back
    QDockWidget* dock(const QString& id) const { return docks_.value(id); }
    void show(const QString& id);  ///< brings a dock to the front
    void fillMenu(QMenu* menu) const;

signals:
    void changed();

private:
    void makeDock(Session& session, const struct PanelEntry& entry);
    void retitle();  // a dock in tabs has its title there
    void build(const QString& name);
    QMainWindow* window_;
    QMap<QString, QDockWidget*> docks_;
    QString current_;
    QByteArray beforeHiding_;
};

}  // namespace mw
