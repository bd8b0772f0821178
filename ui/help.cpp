#include "ui/help.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/panel.h"
#include "ui/sheet.h"
#include "ui/theme.h"

namespace mw {
namespace {

// What a widget is called and what it says of itself; from the one inside outwards.
QString nameOf(const QWidget* w)
{
    if (!w->accessibleName().isEmpty()) return w->accessibleName();
    if (const auto* b = qobject_cast<const QAbstractButton*>(w)) return QString(b->text()).remove('&').remove("...");
    return {};
}

QString panelHelp(const QWidget* w, QString* panel)
{
    for (; w; w = w->parentWidget()) {
        const auto* dock = qobject_cast<const QDockWidget*>(w);
        if (!dock) continue;
        *panel = dock->windowTitle();
        for (const PanelEntry& p : panels())
            if (p.title == dock->windowTitle()) return p.tip;
    }
    return {};
}

class Reference : public Sheet {
public:
    Reference(const QString& html, QWidget* over) : Sheet("Keyboard and mouse", over, {620, 640})
    {
        auto* text = new QTextBrowser(this);
        text->setHtml(html);
        text->setAccessibleName("Keyboard and mouse");
        body()->addWidget(text);
    }
};

}  // namespace

QWidget* showHelp(QWidget* window, const QString& title, const QString& html, QPoint at)
{
    auto* card = new QFrame(window, Qt::Popup);
    card->setObjectName("popup");
    card->setAttribute(Qt::WA_DeleteOnClose);
    card->setAccessibleName("Help: " + title);
    auto* box = new QVBoxLayout(card);
    box->setContentsMargins(14, 10, 14, 12);
    box->setSpacing(6);
    auto* head = new QLabel("<b>" + title.toHtmlEscaped() + "</b>", card);
    auto* text = new QLabel(html, card);
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setMinimumWidth(320);
    text->setMaximumWidth(360);
    box->addWidget(head);
    box->addWidget(text);
    card->adjustSize();
    const QRect screen = window->screen()->availableGeometry();
    at.setX(std::clamp(at.x(), screen.left() + 4, std::max(screen.left() + 4, screen.right() - card->width() - 4)));
    at.setY(std::clamp(at.y(), screen.top() + 4, std::max(screen.top() + 4, screen.bottom() - card->height() - 4)));
    card->move(at);
    card->show();
    return card;
}

QWidget* showHelpOnWidget(QWidget* window)
{
    QPoint at = QCursor::pos();
    QWidget* w = QApplication::widgetAt(at);
    if (!w || w->window() != window) {
        w = QApplication::focusWidget() && QApplication::focusWidget()->window() == window ? QApplication::focusWidget() : window;
        at = w->mapToGlobal(QPoint(12, std::min(w->height(), 40)));
    }
    QString name, tip, panel;
    for (const QWidget* i = w; i && i != window && (name.isEmpty() || tip.isEmpty()); i = i->parentWidget()) {
        if (qobject_cast<const QDockWidget*>(i)) break;
        if (name.isEmpty()) name = nameOf(i);
        if (tip.isEmpty()) tip = i->toolTip().isEmpty() ? i->accessibleDescription() : i->toolTip();
    }
    const QString about = panelHelp(w, &panel);
    if (name.isEmpty()) name = panel.isEmpty() ? "Meshwright" : panel;
    QString html = tip.toHtmlEscaped();
    if (!panel.isEmpty() && panel != name) html += QString("<p style='color:%1'>%2: %3.</p>").arg(tokens().text2.name(), panel, about);
    if (html.isEmpty()) html = about.isEmpty() ? "Click picks, drag looks. Ctrl+K finds every command by its words." : about + ".";
    return showHelp(window, name, html, at + QPoint(8, 12));
}

void showKeyboardReference(const Shortcuts& shortcuts, QWidget* over)
{
    const QString muted = tokens().text2.name();
    QString html = "<p><b>In the view</b></p><table cellspacing='0' cellpadding='3'>";
    const std::pair<const char*, const char*> mouse[] = {{"Click", "pick; Shift adds, Ctrl toggles, again: what is behind"},
                                                         {"Drag, middle drag, Alt+drag", "orbit about the point under the cursor"},
                                                         {"Right drag, Shift+middle drag", "pan"},
                                                         {"Wheel, Alt+right drag", "zoom to the cursor"},
                                                         {"Shift+drag", "box over what is to be selected"},
                                                         {"Right click", "what can be done with what is there"},
                                                         {"F6, Shift+F6", "next panel, last panel"},
                                                         {"Tab, arrows, Space, Enter", "go through a panel, press what has the focus"}};
    for (const auto& [what, does] : mouse)
        html += QString("<tr><td width='210'><b>%1</b></td><td style='color:%3'>%2</td></tr>").arg(what, does, muted);
    QString menu;
    for (const Shortcuts::Command& c : shortcuts.commands()) {
        const QString keys = keysText(c.action);
        if (keys.isEmpty()) continue;
        const QString top = c.where.section(" > ", 0, 0);
        if (top != menu) html += QString("</table><p><b>%1</b></p><table cellspacing='0' cellpadding='3'>").arg(menu = top);
        html += QString("<tr><td width='210'><b>%1</b></td><td>%2</td></tr>").arg(keys.toHtmlEscaped(), c.title.toHtmlEscaped());
    }
    (new Reference(html + "</table><p>All of these can be changed: Edit &gt; Shortcuts.</p>", over))->open();
}

}  // namespace mw
