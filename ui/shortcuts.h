// The keys of commands: what they are at first, in a preset, and as the user wants them. Menus and tooltips follow.
#pragma once
#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>

class QMenuBar;

namespace mw {

class Shortcuts : public QObject {
    Q_OBJECT

public:
    /// Gives every command of the menus its id ("edit/undo": menus and first text) as object name, and the keys that are kept for it.
    Shortcuts(QMenuBar* bar, QObject* parent);

    struct Command {
        QAction* action;
        QString where, title;  ///< "View > Overlays", "Grid"
        QList<QKeySequence> initial;
    };
    const QList<Command>& commands() const { return commands_; }
    const Command* command(const QString& id) const;

    static QStringList presets() { return {"Default", "Blender"}; }
    QString preset() const;
    void usePreset(const QString& name);  ///< what the user has set by hand stays

    bool changed(const Command& c) const;  ///< by hand
    void set(const Command& c, const QList<QKeySequence>& keys);
    void reset(const Command& c);
    void resetAll();
    /// Who else has this key; null when nobody has. `fixed` is told a name when it is a key that cannot be taken away (of the transport).
    const Command* holder(const QKeySequence& key, const Command& but, QString* fixed = nullptr) const;

signals:
    void edited();

private:
    void collect(QMenu* menu, const QString& where);
    QList<QKeySequence> presetKeys(const Command& c) const;
    void apply();
    QList<Command> commands_;
};

/// A tooltip that goes on with the keys of the command, now and after they have changed.
void setTip(QAction* action, const QString& tip);
QString keysText(const QAction* action);  ///< "Q, Esc"

}  // namespace mw
