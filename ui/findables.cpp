#include "ui/findables.h"

#include <QDockWidget>
#include <QTimer>

#include "core/catalog/lesson.h"
#include "ui/panels/lesson_desk.h"
#include "ui/parameter_form.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/words.h"
#include "ui/workspaces.h"

namespace mw {
namespace {

QString whyNot(const QAction* a)
{
    if (a->isEnabled()) return {};
    const QString said = a->property("whyNot").toString();
    return said.isEmpty() ? QString("Select something first") : said;
}

void addCommands(std::vector<Findable>& all, const Shortcuts& shortcuts)
{
    for (const Shortcuts::Command& c : shortcuts.commands()) {
        QAction* a = c.action;
        Findable f{a->objectName(), QString(a->text()).remove('&'), c.where, a->property("tip").toString(), keysText(a), whyNot(a), {}, {}, {}};
        f.icon = a->icon().isNull() ? icon(c.where.startsWith("Steps")    ? "step"
                                           : c.where.startsWith("Window") ? "menu"
                                                                          : "chevron-right",
                                           tokens().text2)
                                    : a->icon();
        f.command = a->property("command").toString();
        f.run = [a] { a->trigger(); };
        all.push_back(std::move(f));
    }
}

void addLessons(std::vector<Findable>& all, Session& session)
{
    for (const Lesson& l : lessons()) {
        const QString title = QString::fromStdString(l.title);
        all.push_back({"lesson/" + QString::fromStdString(l.id),
                       title,
                       "Lessons, section " + QString::fromStdString(l.section),
                       "Make its scene and step through it",
                       {},
                       {},
                       {},
                       icon("book"),
                       [&session, &l] { LessonDesk::of(session).load(l); }});
    }
}

// The field of a parameter, in the panel that shows the stack: opened, and with the focus.
void goToField(Workspaces& workspaces, const QString& row, const QString& name)
{
    workspaces.show("modifiers");
    QDockWidget* dock = workspaces.dock("modifiers");
    QTimer::singleShot(50, dock, [dock, row, name] {
        for (auto* r : dock->findChildren<QWidget*>("modifierRow")) {
            if (!r->accessibleName().startsWith(row)) continue;
            if (!r->findChild<ParameterForm*>()) QMetaObject::invokeMethod(r, "opened");
        }
        QTimer::singleShot(50, dock, [dock, name] {
            for (auto* form : dock->findChildren<ParameterForm*>())
                if (QWidget* field = form->field(name)) field->setFocus(Qt::ShortcutFocusReason);
        });
    });
}

void addParameters(std::vector<Findable>& all, Session& session, Workspaces& workspaces)
{
    const MeshObject* object = session.document.scene().find(edits::activeMesh(session.document));
    if (!object) return;
    for (const Modifier& m : object->stack) {
        const Operation* op = findOperation(m.operation);
        if (!op) continue;
        const QString row = edits::titleOf(m);
        for (const Parameter& p : op->parameters)
            all.push_back({"parameter/" + QString::fromStdString(m.operation + "/" + p.name),
                           QString::fromStdString(p.about.title),
                           "Parameter of " + row,
                           QString::fromStdString(p.about.help),
                           {},
                           {},
                           {},
                           icon("menu", tokens().text2),
                           [&workspaces, row, name = QString::fromStdString(p.name)] { goToField(workspaces, row, name); }});
    }
}

void addNodes(std::vector<Findable>& all, Session& session)
{
    const Scene& scene = session.document.scene();
    for (const NodeId n : scene.nodes()) {
        const Node& node = scene.node(n);
        const char* kind = node.joint != Node::Joint::No ? "bone" : node.terrain ? "terrain" : node.mesh ? "mesh" : "tree";
        all.push_back({QString("node/%1").arg(n.value),
                       nodeName(scene, n),
                       "Node of the scene",
                       "Select it and frame it",
                       {},
                       {},
                       {},
                       icon(kind, tokens().text2),
                       [&session, n] {
                           if (!session.document.scene().find(n)) return;
                           session.document.select({{n}, {}, {}});
                           session.view.frameNodes({n});
                       }});
        if (all.size() > 5000) break;  // a scene of many nodes: the outliner's filter is for those
    }
}

}  // namespace

std::vector<Findable> findables(Session& session, const Shortcuts& shortcuts, Workspaces& workspaces)
{
    std::vector<Findable> all;
    addCommands(all, shortcuts);
    addLessons(all, session);
    addParameters(all, session, workspaces);
    addNodes(all, session);
    for (const QString& name : workspaces.all())
        if (!Workspaces::names().contains(name))
            all.push_back({"workspace/" + name,
                           name + " workspace",
                           "Your workspaces",
                           "Its own layout of panels",
                           {},
                           {},
                           {},
                           icon("menu", tokens().text2),
                           [&workspaces, name] { workspaces.change(name); }});
    return all;
}

}  // namespace mw
