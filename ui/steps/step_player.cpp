// See step_player.h.
#include "ui/steps/step_player.h"

#include <QComboBox>
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedLayout>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/elided.h"
#include "ui/look.h"
#include "ui/object_choices.h"
#include "ui/parameter_form.h"
#include "ui/steps/step_history.h"
#include "ui/steps/step_lists.h"
#include "ui/steps/step_subject.h"
#include "ui/steps/step_words.h"

namespace mw {

namespace {

/// Rich text on a card, as high as it needs.
class FormulaCard : public QTextBrowser {
public:
    explicit FormulaCard(QWidget* parent) : QTextBrowser(parent)
    {
        setObjectName("formula");
        setAccessibleName(tr("Formula"));
        setOpenLinks(false);
        setFocusPolicy(Qt::NoFocus);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        document()->setDocumentMargin(12);
        setFrameShape(NoFrame);
    }
    void setFormula(const QString& html)
    {
        setVisible(!html.isEmpty());
        if (html == shown_) return;
        shown_ = html;
        document()->setDefaultFont(formulaFont());
        // Lines of fractions and matrices are black unless told otherwise.
        setHtml(QString(html).replace("1px solid", "1px solid " + look::tone().text.name()));
        fit();
    }

protected:
    void resizeEvent(QResizeEvent* e) override
    {
        QTextBrowser::resizeEvent(e);
        fit();
    }

private:
    QFont formulaFont() const
    {
        static const bool stix = QFontDatabase::hasFamily("STIX");
        QFont f(stix ? "STIX" : "serif");
        f.setStyleHint(QFont::Serif);
        f.setPointSizeF(font().pointSizeF() * 1.45);
        return f;
    }
    void fit()
    {
        document()->setTextWidth(viewport()->width());
        const bool wide = document()->idealWidth() > viewport()->width() + 1;
        setHorizontalScrollBarPolicy(wide ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
        setFixedHeight(int(document()->size().height()) + 2 + (wide ? 14 : 0));
    }
    QString shown_;
};

class StepPlayer : public QWidget {
public:
    StepPlayer(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* e) override;

private:
    void makeTop(QVBoxLayout* column);
    void makeEmpty();
    void makeBody();
    void refresh();
    void refreshAlgorithms();
    void refreshEmpty();
    void refreshWords();
    const Operation* chosen() const;
    void refreshForm();
    void start();

    Session& session_;
    StepSession& steps_;
    std::shared_ptr<void> subscription_;
    QComboBox* algorithm_ = nullptr;
    QStackedLayout* pages_ = nullptr;
    QLabel *emptyText_ = nullptr, *error_ = nullptr, *sentence_ = nullptr;
    QPushButton *startButton_ = nullptr, *parameters_ = nullptr;
    QVBoxLayout* formBox_ = nullptr;
    ParameterForm* form_ = nullptr;
    const Operation* formOf_ = nullptr;
    PhaseList* phases_ = nullptr;
    FormulaCard* formula_ = nullptr;
    NumberTable* numbers_ = nullptr;
    RoleLegend* legend_ = nullptr;
};

StepPlayer::StepPlayer(Session& session, QWidget* parent) : QWidget(parent), session_(session), steps_(session.steps)
{
    setObjectName("step-player");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    makeTop(column);
    pages_ = new QStackedLayout;
    column->addLayout(pages_, 1);
    makeEmpty();
    makeBody();
    connect(&steps_, &StepSession::opened, this, [this] {
        refreshForm();
        refreshAlgorithms();
    });
    connect(&steps_, &StepSession::closed, this, [this] { refreshAlgorithms(); });
    connect(&steps_, &StepSession::changed, this, &StepPlayer::refresh);
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (c.aspects & (Aspect::Selection | Aspect::Tree | Aspect::Mesh)) refreshAlgorithms();
    });
    refreshAlgorithms();
}

void StepPlayer::makeTop(QVBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 0, 8, 0);
    row->addWidget(algorithm_ = new ElidedComboBox(this), 1);
    algorithm_->setObjectName("step-algorithm");
    algorithm_->setFocusPolicy(Qt::TabFocus);
    algorithm_->setAccessibleName(tr("Algorithm"));
    algorithm_->setToolTip(tr("The algorithm to step through."));
    connect(algorithm_, &QComboBox::activated, this, [this] {
        if (steps_.isOpen())
            start();
        else
            refreshEmpty();
    });
    row->addWidget(parameters_ = new QPushButton(tr("Parameters"), this));
    parameters_->setObjectName("step-parameters");
    parameters_->setCheckable(true);
    parameters_->setFocusPolicy(Qt::TabFocus);
    connect(parameters_, &QPushButton::toggled, this, &StepPlayer::refreshForm);
    column->addLayout(row);
    column->addWidget(error_ = new QLabel(this));
    error_->setObjectName("step-error");
    error_->setWordWrap(true);
    error_->setProperty("bad", true);
    error_->setContentsMargins(8, 0, 8, 0);
    error_->setVisible(false);
}

void StepPlayer::makeEmpty()
{
    pages_->addWidget(look::emptyState(this, &emptyText_, &startButton_));
    startButton_->setObjectName("step-start");
    connect(startButton_, &QPushButton::clicked, this, &StepPlayer::start);
}

void StepPlayer::makeBody()
{
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto* body = new QWidget(area);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(8);
    formBox_ = new QVBoxLayout;
    formBox_->setContentsMargins(8, 0, 8, 0);
    column->addLayout(formBox_);
    column->addWidget(phases_ = new PhaseList(steps_, body));
    column->addWidget(sentence_ = new QLabel(body));
    sentence_->setObjectName("step-sentence");
    sentence_->setWordWrap(true);
    sentence_->setTextFormat(Qt::RichText);
    sentence_->setContentsMargins(8, 2, 8, 0);
    auto* card = new QHBoxLayout;
    card->setContentsMargins(8, 0, 8, 0);
    card->addWidget(formula_ = new FormulaCard(body));
    column->addLayout(card);
    column->addWidget(numbers_ = new NumberTable(steps_, body));
    auto* signs = new QHBoxLayout;
    signs->setContentsMargins(8, 0, 8, 0);
    signs->addWidget(legend_ = new RoleLegend(body));
    column->addLayout(signs);
    column->addStretch(1);
    area->setWidget(body);
    pages_->addWidget(area);
}

void StepPlayer::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if (e->type() == QEvent::PaletteChange && legend_) refresh();
}

const Operation* StepPlayer::chosen() const
{
    return findOperation(algorithm_->currentData().toString().toStdString());
}

void StepPlayer::start()
{
    if (const Operation* op = chosen()) stepThrough(session_, *op);
}

void StepPlayer::refreshAlgorithms()
{
    const QString before = algorithm_->currentData().toString();
    QString wanted = steps_.isOpen() ? QString::fromStdString(steps_.operation()->id) : before;
    algorithm_->clear();
    for (const Operation* op : steppable()) algorithm_->addItem(QString::fromStdString(op->title), QString::fromStdString(op->id));
    if (steps_.isOpen() && algorithm_->findData(wanted) < 0) algorithm_->addItem(QString::fromStdString(steps_.operation()->title), wanted);
    algorithm_->setCurrentIndex(std::max(0, algorithm_->findData(wanted)));
    algorithm_->setEnabled(algorithm_->count() > 0);
    refresh();
}

void StepPlayer::refreshEmpty()
{
    const Operation* op = chosen();
    const QString whyNot = op ? whyNotSteppable(session_, *op) : tr("Choose an algorithm.");
    startButton_->setText(op ? tr("Step through %1").arg(QString::fromStdString(op->title)) : tr("Step through"));
    startButton_->setEnabled(whyNot.isEmpty());
    startButton_->setToolTip(whyNot.isEmpty() ? tr("Run it one step at a time, with formula, numbers and source") : whyNot);
    if (!whyNot.isEmpty()) return emptyText_->setText(tr("%1 Then it runs one step at a time.").arg(whyNot));
    const NodeId node = subjectNode(session_, *op);
    if (node)
        emptyText_->setText(tr("Run an algorithm on %1 one step at a time.").arg(QString::fromStdString(session_.document.scene().node(node).name)));
    else
        emptyText_->setText(tr("Run it one step at a time on the example of its lesson."));
}

void StepPlayer::refresh()
{
    pages_->setCurrentIndex(steps_.isOpen() ? 1 : 0);
    error_->setVisible(steps_.isOpen() && !steps_.error().isEmpty());
    error_->setText(steps_.error());
    const bool adjustable = steps_.isOpen() && !steps_.operation()->parameters.empty();
    parameters_->setEnabled(adjustable);
    parameters_->setToolTip(adjustable        ? tr("Show its parameters. A change starts it again.")
                            : steps_.isOpen() ? tr("This algorithm has no parameters.")
                                              : tr("Nothing is stepped."));
    if (!steps_.isOpen()) return refreshEmpty();
    phases_->refresh();
    refreshWords();
    numbers_->refresh();
}

void StepPlayer::refreshForm()
{
    if (!steps_.isOpen() || !parameters_->isChecked()) {
        if (form_) form_->setVisible(false);
        return;
    }
    if (formOf_ != steps_.operation()) {
        delete form_;
        formOf_ = steps_.operation();
        formBox_->addWidget(form_ = new ParameterForm(formOf_->parameters, steps_.values(), this));
        const Node* shown = session_.document.scene().find(session_.document.selection().active());
        form_->setObjects(objectChoices(session_, shown ? shown->mesh : MeshId{}, this));
        connect(form_, &ParameterForm::committed, &steps_, [this](const ParameterValues& values) { steps_.setValues(values); });
    }
    form_->setValues(steps_.values());
    form_->setVisible(true);
}

void StepPlayer::refreshWords()
{
    const StepRecord& step = steps_.step();
    if (step.phase.empty()) {
        sentence_->setText(tr("This is how it begins. Step forward with <b>Right</b>, play with <b>Space</b>."));
        return formula_->setFormula({});
    }
    if (step.phase == "end") {
        sentence_->setText(tr("The algorithm has ended; this is its result."));
        return formula_->setFormula({});
    }
    const PhaseWords w = phaseOf(*steps_.operation(), QString::fromStdString(step.phase));
    sentence_->setText(filled(*steps_.operation(), w.sentence, step));
    formula_->setFormula(filled(*steps_.operation(), w.formula, step));
}

}  // namespace

std::vector<const Operation*> steppable()
{
    std::vector<const Operation*> found;
    for (const Operation& op : catalog())
        if (op.steps) found.push_back(&op);
    return found;
}

bool stepThrough(Session& session, const Operation& op, ParameterValues values)
{
    StepSubject subject = stepSubject(session, op, std::move(values));
    if (!subject.whyNot.isEmpty()) return false;
    session.steps.open(op, subject.node, subject.value, std::move(subject.values));
    return true;
}

QWidget* makeStepPlayerPanel(Session& session, QWidget* parent)
{
    return new StepPlayer(session, parent);
}

}  // namespace mw
