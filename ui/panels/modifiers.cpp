#include "ui/panels/modifiers.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/edit_commands.h"
#include "ui/evaluation_service.h"
#include "ui/object_choices.h"
#include "ui/panels/add_modifier_popup.h"
#include "ui/panels/base_error.h"
#include "ui/panels/empty_state.h"
#include "ui/panels/modifier_row.h"
#include "ui/playback.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {
namespace {

// First and last row: base mesh and result, with the eye that says which is shown.
struct LevelRow : QFrame {
    LevelRow(const QString& title, QWidget* parent) : QFrame(parent)
    {
        setObjectName("levelRow");
        auto* line = new QHBoxLayout(this);
        line->setContentsMargins(6, 2, 8, 2);
        eye = new QToolButton(this);
        eye->setAccessibleName("Show " + title);
        eye->setToolTip("Show " + title.toLower());
        eye->setFocusPolicy(Qt::TabFocus);
        name = new QLabel(title, this);
        name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        counts = new QLabel(this);
        counts->setProperty("secondary", true);
        line->addWidget(eye);
        line->addWidget(name, 1);
        line->addWidget(counts);
    }
    void set(bool shown, const QString& title, const QString& count)
    {
        eye->setIcon(icon("eye", shown ? tokens().accentText : tokens().text3));
        name->setText(title);
        counts->setText(count);
    }
    QToolButton* eye;
    QLabel *name, *counts;
};

class ModifiersPanel : public QWidget {
public:
    ModifiersPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        makeBar();
        subscription_ = session_.document.subscribe([this](const Change&) { soon(); });
        if (session_.evaluations) connect(session_.evaluations, &EvaluationService::changed, this, [this] { soon(); });
        connect(&session_.view, &ViewState::changed, this, [this] { soon(); });
        refresh();
    }

private:
    void makeBar()
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(8, 8, 0, 0);
        outer->setSpacing(6);
        auto* bar = new QHBoxLayout;
        bar->setContentsMargins(0, 0, 8, 0);
        add_ = new QPushButton(icon("plus", Qt::white), "Add modifier", this);
        add_->setObjectName("addModifier");
        add_->setToolTip("Choose an operation for the end of the stack");
        add_->setProperty("primary", true);
        apply_ = new QPushButton("Apply stack", this);
        apply_->setToolTip("The result becomes the base mesh; undo brings the stack back");
        pause_ = new QToolButton(this);
        pause_->setIcon(icon("pause"));
        pause_->setCheckable(true);
        pause_->setToolTip("Stop evaluating until this is released");
        pause_->setAccessibleName("Pause evaluation");
        for (QWidget* w : {static_cast<QWidget*>(add_), static_cast<QWidget*>(apply_), static_cast<QWidget*>(pause_)})
            w->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(add_);
        bar->addWidget(apply_);
        bar->addStretch(1);
        bar->addWidget(pause_);
        empty_ = emptyStateLabel("Select a mesh to see its modifiers.", this);
        auto* area = area_ = new QScrollArea(this);
        inside_ = new QWidget(area);
        rowsBox_ = new QVBoxLayout(inside_);
        rowsBox_->setContentsMargins(0, 0, 8, 8);
        rowsBox_->setSpacing(6);
        base_ = new LevelRow("Base mesh", inside_);
        result_ = new LevelRow("Result", inside_);
        rowsBox_->addWidget(base_);
        rowsBox_->addWidget(result_);
        rowsBox_->addStretch(1);
        area->setWidget(inside_);
        area->setWidgetResizable(true);
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        outer->addLayout(bar);
        outer->addWidget(empty_);
        outer->addWidget(area, 1);
        outer->addWidget(makeBaseErrorRow(session_, this));
        connect(add_, &QPushButton::clicked, this, [this] {
            showAddModifierPopup(
                add_, [this](const Operation& op) { add(op); }, [this](const Operation& op) { return expectedText(op, sizeOf(shown()), {}); });
        });
        connect(apply_, &QPushButton::clicked, this, [this] { edits::applyStack(session_, mesh_, stack().size()); });
        connect(pause_, &QToolButton::toggled, this, [this](bool on) {
            if (session_.evaluations) session_.evaluations->setPaused(on);
        });
        connect(base_->eye, &QToolButton::clicked, this, [this] { showLevel(0); });
        connect(result_->eye, &QToolButton::clicked, this, [this] { showLevel(stack().size()); });
    }

    const std::vector<Modifier>& stack() const
    {
        static const std::vector<Modifier> nothing;
        const MeshObject* o = session_.document.scene().find(mesh_);
        return o ? o->stack : nothing;
    }

    Mesh shown() const { return session_.document.shownMesh(mesh_); }

    QString expectedText(const Operation& op, MeshSize input, const ParameterValues& values) const
    {
        const auto cost = session_.evaluations ? session_.evaluations->expected(op, input, values) : std::nullopt;
        return cost ? QString::fromStdString(costText(*cost)) : QString();
    }

    // What the row will take, while its result is not there. The sizes of those before it are what they are expected to leave.
    QString expectedText(size_t row) const
    {
        MeshSize size = sizeOf(session_.document.scene().find(mesh_)->base);
        for (size_t i = 0; i < row; ++i) {
            const Operation* op = findOperation(stack()[i].operation);
            if (op && stack()[i].enabled)
                if (const auto cost = expectedCost(*op, size, stack()[i].values)) size = cost->result;
        }
        const Operation* op = findOperation(stack()[row].operation);
        return op ? expectedText(*op, size, stack()[row].values) : QString();
    }

    void add(const Operation& op)
    {
        if (!session_.document.scene().find(mesh_)) return;
        const size_t clips = session_.document.scene().clips().size();
        edits::addModifier(session_.document, mesh_, op);
        if (session_.document.scene().clips().size() > clips && session_.playback)
            session_.playback->setClip(session_.document.scene().clips().back());
        openId_ = stack().back().id;
        showLevel(stack().size());
        soon();
    }

    void showLevel(size_t level)
    {
        if (level >= stack().size())
            session_.view.shownLevel.erase(mesh_);
        else
            session_.view.shownLevel[mesh_] = level;
        session_.view.touch();
    }

    void soon()
    {
        if (pending_) return;
        pending_ = true;
        QMetaObject::invokeMethod(
            this, [this] { refresh(); }, Qt::QueuedConnection);
    }

    size_t indexOf(ModifierId id) const
    {
        for (size_t i = 0; i < stack().size(); ++i)
            if (stack()[i].id == id) return i;
        return stack().size();
    }

    void connectRow(ModifierRow* row, ModifierId id)
    {
        Document& d = session_.document;
        const auto at = [this, id](auto f) {
            const size_t i = indexOf(id);
            if (i < stack().size()) f(i);
        };
        connect(row, &ModifierRow::toggled, this, [=, this, &d](bool on) { at([&](size_t i) { edits::enableModifier(d, mesh_, i, on); }); });
        connect(row, &ModifierRow::opened, this, [this, id] {
            openId_ = openId_ == id ? ModifierId{} : id;
            soon();
        });
        connect(row, &ModifierRow::edited, this,
                [=, this, &d](const ParameterValues& v) { at([&](size_t i) { edits::previewValues(d, mesh_, i, v); }); });
        connect(row, &ModifierRow::committed, this,
                [=, this, &d](const ParameterValues& v, const QString& what) { at([&](size_t i) { edits::commitValues(d, mesh_, i, v, what); }); });
        connect(row, &ModifierRow::cancelled, this, [this] { session_.evaluations->cancel(mesh_); });
        connect(row, &ModifierRow::removeRequested, this, [=, this, &d] { at([&](size_t i) { edits::removeModifier(d, mesh_, i); }); });
        connect(row, &ModifierRow::duplicateRequested, this, [=, this, &d] { at([&](size_t i) { edits::duplicateModifier(d, mesh_, i); }); });
        connect(row, &ModifierRow::moved, this, [=, this, &d](int by) { at([&](size_t i) { edits::moveModifier(d, mesh_, i, i + size_t(by)); }); });
        connect(row, &ModifierRow::droppedAt, this, [=, this, &d](int y) {
            at([&](size_t i) {
                size_t to = 0;
                for (const auto& r : rows_) to += r.row->geometry().center().y() < y && r.id != id;
                edits::moveModifier(d, mesh_, i, to);
            });
        });
        connect(row, &ModifierRow::stepRequested, this, [=, this] { at([&](size_t i) { stepThrough(i); }); });
        connect(row, &ModifierRow::applyRequested, this, [=, this] { at([&](size_t i) { edits::applyStack(session_, mesh_, i + 1); }); });
        connect(row, &ModifierRow::copyRequested, this, [=, this] { at([&](size_t i) { edits::copyModifier(session_, mesh_, i); }); });
        connect(row, &ModifierRow::showRequested, this, [=, this] { at([&](size_t i) { showLevel(i + 1); }); });
    }

    void stepThrough(size_t i)
    {
        const Operation* op = findOperation(stack()[i].operation);
        const auto e = session_.document.evaluation(mesh_);
        if (!op) return;
        const Mesh input = i == 0                       ? session_.document.scene().find(mesh_)->base
                           : e && e->levels.size() >= i ? e->at(i)
                                                        : session_.document.shownMesh(mesh_);
        session_.steps.open(*op, session_.document.selection().active(), input, checked(op->parameters, stack()[i].values));
    }

    // The rows are kept as long as the modifiers are the same, so that a form survives the changes it makes itself.
    void matchRows()
    {
        std::vector<ModifierId> wanted, have;
        for (const Modifier& m : stack()) wanted.push_back(m.id);
        for (const auto& r : rows_) have.push_back(r.id);
        if (wanted == have && mesh_ == rowsOf_) return;
        rowsOf_ = mesh_;
        for (auto& r : rows_) r.row->deleteLater();
        rows_.clear();
        int at = 1;
        for (const Modifier& m : stack()) {
            auto* row = new ModifierRow(m, inside_);
            connectRow(row, m.id);
            rowsBox_->insertWidget(at++, row);
            rows_.push_back({m.id, row});
        }
    }

    RowState stateOf(size_t i, const Evaluation* e, const EvaluationService::State& run) const
    {
        RowState s;
        const Modifier& m = stack()[i];
        s.enabled = m.enabled;
        const float n = float(std::max<size_t>(1, stack().size()));
        s.running = run.running && run.level == i && m.enabled;
        s.fraction = std::clamp(run.fraction * n - float(i), 0.f, 1.f);
        s.elapsed = run.elapsed;
        if (run.running && run.level < i) s.waits = true;
        if (!e || i >= e->levels.size()) return s;
        const Level& l = e->levels[i];
        const Mesh& before = e->at(i);
        s.time = timeText(l.seconds);
        s.error = run.running ? QString() : QString::fromStdString(l.error);
        if (!run.running) s.waits = l.waits;
        const Operation* op = findOperation(m.operation);
        if (!s.error.isEmpty() && op && wantsOther(*op, m.values)) {  // not wrong, only not yet said
            s.error.clear();
            s.counts = "choose a mesh";
            s.asks = true;
            s.time.clear();
            return s;
        }
        if (!s.error.isEmpty())
            s.counts = "not run";
        else if (before.faceCount() != l.mesh.faceCount())
            s.counts = grouped(before.faceCount()) + " → " + grouped(l.mesh.faceCount()) + " F";
        else if (before.vertexCount() != l.mesh.vertexCount())
            s.counts = grouped(before.vertexCount()) + " → " + grouped(l.mesh.vertexCount()) + " V";
        else
            s.counts = countsText(l.mesh);
        return s;
    }

    void refresh()
    {
        pending_ = false;
        mesh_ = edits::activeMesh(session_.document);
        const MeshObject* object = session_.document.scene().find(mesh_);
        empty_->setVisible(!object);
        area_->setVisible(object);
        add_->setEnabled(object);
        apply_->setEnabled(object && !object->stack.empty());
        matchRows();
        if (!object) return;
        const auto e = session_.document.evaluation(mesh_);
        const EvaluationService::State run = session_.evaluations ? session_.evaluations->state(mesh_) : EvaluationService::State{};
        const auto shown = session_.view.shownLevel.find(mesh_);
        const size_t level = shown == session_.view.shownLevel.end() ? object->stack.size() : shown->second;
        base_->set(level == 0 && !object->stack.empty(), "Base mesh " + QString::fromStdString(object->name), countsText(object->base));
        result_->set(level >= object->stack.size(), "Result", e ? countsText(e->result()) : QString());
        for (size_t i = 0; i < rows_.size(); ++i) {
            rows_[i].row->setOpen(rows_[i].id == openId_, object->stack[i]);
            if (ParameterForm* form = rows_[i].row->form()) form->setObjects(objectChoices(session_, mesh_, this));
            RowState s = stateOf(i, e.get(), run);
            if (run.cancelled && i == run.level) s.error = "Cancelled. The view shows the last result; change a parameter to run it again.";
            if (!run.failure.isEmpty() && i == run.level) s.error = run.failure;
            const bool computing = run.running && run.level <= i && s.enabled;
            if (computing) s.time = expectedText(i);
            rows_[i].row->setState(s);
        }
    }

    struct Row {
        ModifierId id;
        ModifierRow* row;
    };
    Session& session_;
    QPushButton *add_, *apply_;
    QToolButton* pause_;
    QLabel* empty_;
    QScrollArea* area_;
    QWidget* inside_;
    QVBoxLayout* rowsBox_;
    LevelRow *base_, *result_;
    std::vector<Row> rows_;
    MeshId mesh_, rowsOf_;
    ModifierId openId_;
    bool pending_ = false;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makeModifiersPanel(Session& session, QWidget* parent)
{
    return new ModifiersPanel(session, parent);
}

}  // namespace mw
