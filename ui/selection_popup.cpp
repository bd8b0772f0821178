#include "ui/selection_popup.h"

#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/parameter_form.h"

namespace mw::selecting {
namespace {

class Popup : public QFrame {
public:
    Popup(Session& session, QWidget* view, const QString& title, std::vector<Parameter> parameters, FindWith find)
        : QFrame(view, Qt::Popup), session_(session), before_(session.document.selection()), title_(title), find_(std::move(find))
    {
        setObjectName("selection-popup");
        setAttribute(Qt::WA_DeleteOnClose);
        setFrameShape(QFrame::StyledPanel);
        setAccessibleName(title);
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(12, 8, 12, 10);
        auto* heading = new QLabel("<b>" + title + "</b>", this);
        column->addWidget(heading);
        form_ = new ParameterForm(std::move(parameters), {}, this);
        column->addWidget(form_);
        connect(form_, &ParameterForm::edited, this, [this](const ParameterValues& v) { select(v); });
        connect(form_, &ParameterForm::committed, this, [this](const ParameterValues& v, const QString&) { select(v); });
        setMinimumWidth(340);
        adjustSize();
        move(view->mapToGlobal(QPoint((view->width() - width()) / 2, 48)));
        show();
        select({});
    }

protected:
    // Esc is a shortcut of the window, too; here it takes the selection back.
    bool event(QEvent* e) override
    {
        if (e->type() != QEvent::ShortcutOverride || static_cast<QKeyEvent*>(e)->key() != Qt::Key_Escape) return QFrame::event(e);
        e->accept();
        return true;
    }
    void keyPressEvent(QKeyEvent* e) override
    {
        if (e->key() == Qt::Key_Escape) session_.document.select(before_);
        if (e->key() == Qt::Key_Escape || e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter)
            close();
        else
            QFrame::keyPressEvent(e);
    }

private:
    void select(const ParameterValues& given)
    {
        ElementSet had = before_.elements;
        if (before_.elementsOf != session_.document.selection().active()) had.indices.clear();
        run(session_, title_, [had, given, find = find_](const Mesh& m, const ElementSet&, Progress&) { return find(m, had, given); });
    }

    Session& session_;
    Selection before_;
    QString title_;
    FindWith find_;
    ParameterForm* form_;
};

}  // namespace

QFrame* showPopup(Session& session, QWidget* view, const QString& title, std::vector<Parameter> parameters, FindWith find)
{
    return new Popup(session, view, title, std::move(parameters), std::move(find));
}

}  // namespace mw::selecting
