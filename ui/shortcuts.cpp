#include "ui/shortcuts.h"

#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QShortcut>
#include <algorithm>

namespace mw {
namespace {

QString plain(const QString& text)
{
    return QString(text).remove("...").remove('&');
}

QString slug(QString text)
{
    return plain(text).toLower().replace(QRegularExpression("[^a-z0-9>]+"), "-").replace("->-", "/");
}

// As Blender has them; commands that are not here keep their own, unless one of these takes it.
const QMap<QString, QString>& blender()
{
    static const QMap<QString, QString> keys{{"Move", "G"},
                                             {"Rotate", "R"},
                                             {"Scale", "S"},
                                             {"Select", "W; Esc"},
                                             {"Box select", "B"},
                                             {"Front view", "Num+1; 1"},
                                             {"Right view", "Num+3; 3"},
                                             {"Top view", "Num+7; 7"},
                                             {"Perspective", "Num+5; 5"},
                                             {"Frame selection", "Num+.; F"},
                                             {"Frame all", "Home"},
                                             {"Next kind to pick", "Ctrl+Tab"},
                                             {"None", "Alt+A"},
                                             {"Show all", "Alt+H"},
                                             {"X-ray", "Alt+Z"},
                                             {"Wire overlay", "Shift+Alt+Z"},
                                             {"Grid", "Shift+G"},
                                             {"Delete", "X; Del"},
                                             {"Duplicate", "Shift+D"},
                                             {"Join", "Ctrl+J"},
                                             {"Separate", "P"},
                                             {"Search commands and settings", "F3; Ctrl+K"}};
    return keys;
}

QString settingOf(const Shortcuts::Command& c)
{
    return "shortcuts/keys/" + QString(c.action->objectName()).replace('/', '.');
}

}  // namespace

void setTip(QAction* action, const QString& tip)
{
    action->setProperty("tip", tip);
    const QString keys = keysText(action);
    action->setToolTip(keys.isEmpty() ? tip : tip + " · " + keys);
}

QString keysText(const QAction* action)
{
    QStringList keys;
    for (const QKeySequence& k : action->shortcuts()) keys << k.toString(QKeySequence::NativeText);
    return keys.join(", ");
}

Shortcuts::Shortcuts(QMenuBar* bar, QObject* parent) : QObject(parent)
{
    for (QAction* a : bar->actions())
        if (a->menu()) collect(a->menu(), plain(a->text()));
    apply();
}

void Shortcuts::collect(QMenu* menu, const QString& where)
{
    for (QAction* a : menu->actions()) {
        if (a->isSeparator() || a->property("passing").toBool()) continue;
        const QString title = plain(a->text());
        if (a->menu()) {
            collect(a->menu(), where + " > " + title);
            continue;
        }
        if (std::any_of(commands_.begin(), commands_.end(), [a](const Command& c) { return c.action == a; })) continue;
        a->setObjectName(slug(where + " > " + title));
        commands_ << Command{a, where, title, a->shortcuts()};
    }
}

const Shortcuts::Command* Shortcuts::command(const QString& id) const
{
    for (const Command& c : commands_)
        if (c.action->objectName() == id) return &c;
    return nullptr;
}

QString Shortcuts::preset() const
{
    return QSettings().value("shortcuts/preset", "Default").toString();
}

void Shortcuts::usePreset(const QString& name)
{
    QSettings().setValue("shortcuts/preset", name);
    apply();
}

QList<QKeySequence> Shortcuts::presetKeys(const Command& c) const
{
    if (preset() != "Blender") return c.initial;
    if (blender().contains(c.title)) return QKeySequence::listFromString(blender().value(c.title));
    QList<QKeySequence> keys = c.initial;
    for (const Command& other : commands_)
        if (blender().contains(other.title))
            for (const QKeySequence& k : QKeySequence::listFromString(blender().value(other.title))) keys.removeAll(k);
    return keys;
}

bool Shortcuts::changed(const Command& c) const
{
    return QSettings().contains(settingOf(c));
}

void Shortcuts::set(const Command& c, const QList<QKeySequence>& keys)
{
    if (keys == presetKeys(c))
        QSettings().remove(settingOf(c));
    else
        QSettings().setValue(settingOf(c), QKeySequence::listToString(keys));
    apply();
}

void Shortcuts::reset(const Command& c)
{
    QSettings().remove(settingOf(c));
    apply();
}

void Shortcuts::resetAll()
{
    QSettings().remove("shortcuts/keys");
    apply();
}

const Shortcuts::Command* Shortcuts::holder(const QKeySequence& key, const Command& but, QString* fixed) const
{
    for (const Command& c : commands_)
        if (c.action != but.action && c.action->shortcuts().contains(key)) return &c;
    for (const QShortcut* s : parent()->findChildren<QShortcut*>())
        if (s->key() == key && fixed) *fixed = "playing and stepping";
    return nullptr;
}

void Shortcuts::apply()
{
    QSettings settings;
    for (const Command& c : commands_) {
        const QString kept = settingOf(c);
        c.action->setShortcuts(settings.contains(kept) ? QKeySequence::listFromString(settings.value(kept).toString()) : presetKeys(c));
        const QString tip = c.action->property("tip").toString();
        setTip(c.action, tip.isEmpty() ? c.action->toolTip() : tip);
    }
    emit edited();
}

}  // namespace mw
