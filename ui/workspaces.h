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
    static QStringList names() { return {"Mesh", "Learn", "Terrain", "Character"}; }  ///< those that are always there
    QStringList all() const;                                                          ///< with those the user has made
    const QString& current() const { return current_; }
    /// Which of names() the present one is, or was made from: what header and default tool go by.
    QString kind() const;
    void change(const QString& name);
    void reset();  ///< as the table has it
    /// The present layout under a name of its own, which becomes the present one. False, with a reason, when the name is taken or empty.
    bool saveAs(const QString& name, QString* whyNot);
    void remove(const QString& name);  ///< of those the user has made
    void remakePanels();               ///< anew, with the colours of the theme
    bool floats() const { return floats_; }
    void store();      ///< the present layout, on leaving
    void toggleAll();  ///< all docks away, and back
    QDockWidget* dock(const QString& id) const { return docks_.value(id); }
    void show(const QString& id);  ///< brings a dock to the front
    void fillMenu(QMenu* menu) const;

signals:
    void changed();
    void listChanged();

protected:
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void makeDock(const struct PanelEntry& entry);
    void retitle();  // a dock in tabs has its title there
    void build(const QString& name);
    void restore();
    QString key() const;  // of the settings; wide and narrow windows have layouts of their own
    void fillDock(QDockWidget* dock);
    Session& session_;
    QMainWindow* window_;
    QMap<QString, QDockWidget*> docks_;
    QString current_;
    QByteArray beforeHiding_;
    bool narrow_ = false, floats_ = true;
};

}  // namespace mw
