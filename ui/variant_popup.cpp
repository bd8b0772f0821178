#include "ui/variant_popup.h"

#include <QComboBox>
#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>

#include "ui/parameter_form.h"
#include "ui/stack_edits.h"
#include "ui/variants.h"
#include "ui/viewport/viewport.h"

namespace mw {
namespace {

class VariantPopup : public QFrame {
public:
    VariantPopup(Session& session, Viewport& view, MeshId mesh, const Modifier& last)
        : QFrame(&view, Qt::Popup), session_(session), view_(view), mesh_(mesh), last_(last)
    {
        setObjectName("variant-popup");
        setAttribute(Qt::WA_DeleteOnClose);
        setFrameShape(QFrame::StyledPanel);
        setAccessibleName("Variant");
        column_ = new QVBoxLayout(this);
        column_->setContentsMargins(12, 8, 12, 10);
        column_->addWidget(new QLabel("<b>In place of " + edits::titleOf(last).toHtmlEscaped() + "</b>", this));
        operations_ = new QComboBox(this);
        operations_->setObjectName("variantOperation");
        operations_->setAccessibleName("Operation");
        operations_->setToolTip("What this view runs on the input of the last modifier; the stack stays as it is");
        for (const Operation* op : alternatives(last)) {
            operations_->addItem(QString::fromStdString(op->title), QString::fromStdString(op->id));
            operations_->setItemData(operations_->count() - 1, QString::fromStdString(op->summary), Qt::ToolTipRole);
        }
        column_->addWidget(operations_);
        connect(operations_, &QComboBox::activated, this, [this] { take(withOperation(last_, operation(chosen()))); });
        const std::vector<Modifier> others = variantsOf(last);
        const bool known = view_.look().variant.count(mesh_);
        take(known ? view_.look().variant.at(mesh_) : others.empty() ? last : others.front());
        setMinimumWidth(390);  // the longest label of a parameter and its field
        move(view.mapToGlobal(QPoint(12, 44)));
        show();
    }

protected:
    void keyPressEvent(QKeyEvent* e) override
    {
        if (e->key() == Qt::Key_Escape || e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter)
            close();
        else
            QFrame::keyPressEvent(e);
    }

private:
    std::string chosen() const { return operations_->currentData().toString().toStdString(); }

    void take(const Modifier& m)
    {
        operations_->setCurrentIndex(std::max(0, operations_->findData(QString::fromStdString(m.operation))));
        delete form_;
        form_ = new ParameterForm(operation(m.operation).parameters, m.values, this);
        column_->addWidget(form_);
        const auto set = [this](const ParameterValues& values) {
            Modifier next = last_;
            next.operation = chosen();
            next.values = values;
            showIt(next);
        };
        // Live, like a modifier's own: what is computed for a value that is gone is cancelled with its job.
        connect(form_, &ParameterForm::edited, this, set);
        connect(form_, &ParameterForm::committed, this, [set](const ParameterValues& values, const QString&) { set(values); });
        adjustSize();
        showIt(m);
    }

    void showIt(const Modifier& m)
    {
        view_.look().variant[mesh_] = m;
        view_.look().shownLevel[mesh_] = variantLevel;
        session_.view.touch();
    }

    Session& session_;
    Viewport& view_;
    MeshId mesh_;
    Modifier last_;
    QVBoxLayout* column_;
    QComboBox* operations_;
    QPointer<ParameterForm> form_;
};

}  // namespace

QFrame* showVariantPopup(Session& session, Viewport& view, MeshId mesh)
{
    const MeshObject* object = session.document.scene().find(mesh);
    const std::optional<size_t> last = object ? lastModifier(*object) : std::nullopt;
    return last ? new VariantPopup(session, view, mesh, object->stack[*last]) : nullptr;
}

}  // namespace mw
