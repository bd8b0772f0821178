#include "ui/panels/curve_lab.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/catalog/catalog.h"
#include "core/error.h"
#include "core/scene/command_line.h"
#include "core/subdivide/subdivide_curve.h"
#include "ui/look.h"
#include "ui/panels/curve_canvas.h"
#include "ui/parameter_form.h"

namespace mw {
namespace {

using Points = CurveCanvas::Points;

constexpr int64_t mostLevels = 10;  // beyond that nothing more is to be seen

struct State {
    Points points;
    bool closed = false;
    QString what = {};
};

/// The parameters of the operation that this page has fields for: whether the curve is closed is the polygon's.
std::vector<Parameter> shownParameters()
{
    std::vector<Parameter> out;
    for (Parameter p : operation("subdivide-curve").parameters) {
        if (p.name == "ends") continue;
        if (p.name == "levels") p.about.max = mostLevels;
        out.push_back(std::move(p));
    }
    return out;
}

Curve curveOf(const State& s)
{
    Curve c;
    c.closed = s.closed;
    for (const glm::dvec2& p : s.points) c.points.emplace_back(p, 0);
    return c;
}

std::string pointsText(const Points& points)
{
    std::string text;
    for (const glm::dvec2& p : points) {
        char one[80];
        std::snprintf(one, sizeof one, "%s%.9g,%.9g", text.empty() ? "" : " ", p.x, p.y);
        text += one;
    }
    return text;
}

class CurveLab : public QWidget {
public:
    CurveLab(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(8, 8, 8, 8);
        outer->setSpacing(6);
        makeBar(outer);
        auto* split = new QSplitter(Qt::Vertical, this);
        split->setChildrenCollapsible(false);
        outer->addWidget(split, 1);
        canvas_ = new CurveCanvas(split);
        split->addWidget(canvas_);
        makeFields(split);
        split->setStretchFactor(0, 3);
        split->setStretchFactor(1, 2);
        trouble_ = new QLabel(this);
        trouble_->setObjectName("curveTrouble");
        trouble_->setWordWrap(true);
        trouble_->setProperty("error", true);
        outer->addWidget(trouble_);
        makeButtons(outer);
        connect(canvas_, &CurveCanvas::edited, this, [this](const QString& what) { changed({canvas_->points(), now().closed, what}); });
        connect(canvas_, &CurveCanvas::selectionChanged, this, [this](int point) { table_->setCurrentCell(point, 0); });
        take("square");
    }

protected:
    // Ctrl+Z is the document's unless the page has the focus.
    bool event(QEvent* e) override
    {
        if (e->type() == QEvent::ShortcutOverride) {
            auto* key = static_cast<QKeyEvent*>(e);
            if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) e->accept();
        }
        return QWidget::event(e);
    }
    void keyPressEvent(QKeyEvent* e) override
    {
        if (e->matches(QKeySequence::Undo))
            go(-1);
        else if (e->matches(QKeySequence::Redo))
            go(1);
        else
            QWidget::keyPressEvent(e);
    }

private:
    QPushButton* button(QBoxLayout* line, const QString& text, const char* name, const QString& tip, std::function<void()> act)
    {
        auto* b = new QPushButton(text, this);
        b->setObjectName(name);
        b->setToolTip(tip);
        b->setFocusPolicy(Qt::TabFocus);
        line->addWidget(b);
        connect(b, &QPushButton::clicked, this, [act = std::move(act)] { act(); });
        return b;
    }
    void makeBar(QBoxLayout* outer)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        sample_ = new QComboBox(this);
        sample_->setObjectName("curveSample");
        sample_->setAccessibleName("Sample polygon");
        sample_->setToolTip("Begin with a polygon");
        sample_->addItems({"square", "zigzag", "wave", "polygon", "star", "spiral", "letter"});
        closed_ = new QCheckBox("Closed", this);
        closed_->setObjectName("curveClosed");
        closed_->setToolTip("The last point is joined to the first");
        line->addWidget(sample_, 1);
        line->addWidget(closed_);
        undo_ = button(line, "Undo", "curveUndo", "Take the last edit of the polygon back (Ctrl+Z here)", [this] { go(-1); });
        redo_ = button(line, "Redo", "curveRedo", "Do it again (Ctrl+Shift+Z here)", [this] { go(1); });
        outer->addLayout(line);
        connect(sample_, &QComboBox::activated, this, [this] { take(sample_->currentText()); });
        connect(closed_, &QCheckBox::clicked, this, [this](bool on) { changed({now().points, on, on ? "close" : "open"}); });
    }
    void makeFields(QSplitter* split)
    {
        auto* area = new QScrollArea(split);
        area->setWidgetResizable(true);
        auto* inside = new QWidget(area);
        auto* box = new QVBoxLayout(inside);
        box->setContentsMargins(0, 4, 8, 4);
        const std::vector<Parameter> parameters = shownParameters();
        form_ = new ParameterForm(parameters, checked(parameters, {}), inside);
        form_->setObjectName("curveForm");
        box->addWidget(form_);
        table_ = new QTableWidget(0, 2, inside);
        table_->setObjectName("curvePoints");
        table_->setAccessibleName("Points of the polygon");
        table_->setHorizontalHeaderLabels({"x", "y"});
        table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
        table_->horizontalHeader()->setAccessibleName("Coordinates");
        table_->verticalHeader()->setAccessibleName("Numbers of the points");
        table_->verticalHeader()->setDefaultSectionSize(22);
        table_->setCornerButtonEnabled(false);
        for (QAbstractButton* corner : table_->findChildren<QAbstractButton*>()) corner->setAccessibleName("Corner of the table");
        table_->setMinimumHeight(110);
        table_->setToolTip("The same points by number; Insert on the drawing adds one, Delete removes it");
        box->addWidget(table_, 1);
        area->setWidget(inside);
        look::keepWide(area);
        split->addWidget(area);
        const auto redo = [this] { compute(); };
        connect(form_, &ParameterForm::edited, this, redo);
        connect(form_, &ParameterForm::committed, this, redo);
        connect(table_, &QTableWidget::cellChanged, this, [this](int row, int column) { typed(row, column); });
        connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
            if (!filling_) canvas_->setSelected(row);
        });
    }
    void makeButtons(QBoxLayout* outer)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        step_ = button(line, "Step through", "curveStep", "Watch the scheme on this polygon, a point at a time", [this] { stepThrough(); });
        button(line, "Copy as command", "curveCopy", "The command line that gives this curve", [this] {
            QGuiApplication::clipboard()->setText(QString::fromStdString(command()));
            if (session_.notice) session_.notice("Copied the command line of the curve");
        });
        button(line, "Reset", "curveReset", "The sample as it was", [this] { take(sample_->currentText()); });
        outer->addLayout(line);
    }

    const State& now() const { return history_[at_]; }

    void take(const QString& shape)
    {
        State s{{}, true, shape};
        if (shape == "square") {
            s.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        } else {
            const Operation& op = operation("sample-curve");
            const Curve c = std::get<Curve>(apply(op, {}, parsed(op.parameters, "shape=" + shape.toStdString())));
            for (const glm::dvec3& p : c.points) s.points.emplace_back(p);
            s.closed = c.closed;
        }
        changed(s);
        canvas_->fit();
    }

    /// Another polygon; an entry of the page's history when it has a name. Until then the last entry stays what undo goes back to.
    void changed(State s)
    {
        canvas_->setPolygon(s.points, s.closed);
        shown_ = s;
        if (!s.what.isEmpty()) {
            if (!history_.empty()) history_.resize(at_ + 1);
            history_.push_back(std::move(s));
            at_ = history_.size() - 1;
            fillTable();
        }
        compute();
    }
    void go(int by)
    {
        if (by < 0 ? at_ == 0 : at_ + 1 >= history_.size()) return;
        at_ = by < 0 ? at_ - 1 : at_ + 1;
        shown_ = now();
        canvas_->setPolygon(shown_.points, shown_.closed);
        fillTable();
        compute();
    }
    void fillTable()
    {
        filling_ = true;
        table_->setRowCount(int(shown_.points.size()));
        for (int i = 0; i < table_->rowCount(); ++i)
            for (int k = 0; k < 2; ++k) table_->setItem(i, k, new QTableWidgetItem(QString::number(shown_.points[size_t(i)][k], 'g', 6)));
        table_->setCurrentCell(canvas_->selected(), 0);
        filling_ = false;
    }
    void typed(int row, int column)
    {
        if (filling_ || row < 0 || size_t(row) >= shown_.points.size()) return;
        bool ok = false;
        const double v = table_->item(row, column)->text().replace(QChar(0x2212), '-').toDouble(&ok);
        if (!ok || !std::isfinite(v)) return fillTable();
        State s = shown_;
        s.points[size_t(row)][column] = v;
        s.what = QString("move point %1").arg(row + 1);
        changed(std::move(s));
    }

    ParameterValues values() const { return checked(operation("subdivide-curve").parameters, form_->values()); }

    void compute()
    {
        closed_->setChecked(shown_.closed);
        undo_->setEnabled(at_ > 0);
        redo_->setEnabled(at_ + 1 < history_.size());
        std::vector<Points> iterations;
        QString wrong;
        try {
            ParameterValues one = values();
            const auto given = one.find("levels");  // values that are as described are not there
            const int64_t levels = given == one.end() ? SubdivideCurve().levels : std::get<int64_t>(given->second);
            one["levels"] = int64_t(1);
            Curve c = curveOf(shown_);
            for (int64_t level = 0; level < levels; ++level) {
                c = std::get<Curve>(apply(operation("subdivide-curve"), c, one));
                iterations.emplace_back(c.points.begin(), c.points.end());
            }
        } catch (const Error& e) {
            iterations.clear();
            wrong = QString::fromUtf8(e.what());
            if (!wrong.isEmpty()) wrong[0] = wrong[0].toUpper();
        }
        trouble_->setText(wrong);
        trouble_->setVisible(!wrong.isEmpty());
        step_->setEnabled(wrong.isEmpty());
        canvas_->setIterations(std::move(iterations));
    }

    void stepThrough() { session_.steps.open(operation("subdivide-curve"), NodeId{}, Value(curveOf(shown_)), values()); }

    std::string command() const
    {
        const std::string source = "sample-curve:given=" + pointsText(shown_.points) + (shown_.closed ? ",closed=true" : "");
        const Operation& op = operation("subdivide-curve");
        const std::string parameters = printed(op.parameters, values());
        return "meshwright process - --op " + shellQuoted(source) + " --op " + shellQuoted(op.id + (parameters.empty() ? "" : ":" + parameters)) +
               " -o curve.csv";
    }

    Session& session_;
    QComboBox* sample_ = nullptr;
    QCheckBox* closed_ = nullptr;
    QPushButton *undo_ = nullptr, *redo_ = nullptr, *step_ = nullptr;
    CurveCanvas* canvas_ = nullptr;
    ParameterForm* form_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel* trouble_ = nullptr;
    State shown_;
    std::vector<State> history_;
    size_t at_ = 0;
    bool filling_ = false;
};

}  // namespace

QWidget* makeCurveLabPanel(Session& session, QWidget* parent)
{
    return new CurveLab(session, parent);
}

}  // namespace mw
