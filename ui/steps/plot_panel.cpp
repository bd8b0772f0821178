// See plot_panel.h.
#include "ui/steps/plot_panel.h"

#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QSaveFile>
#include <QStackedLayout>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <map>
#include <qcustomplot.h>

#include "ui/look.h"
#include "ui/steps/step_history.h"
#include "ui/steps/step_words.h"

namespace mw {

namespace {

constexpr int maxCurves = 6;
constexpr int grabWidth = 8;

QColor curveColor(int i)
{
    static const QColor onDark[] = {"#6CB2FF", "#F2B84B", "#4CC38A", "#D98CF2", "#FF7B72", "#18DEF0"};
    static const QColor onLight[] = {"#1A5CAA", "#7D5200", "#17693A", "#8A21AE", "#B3261E", "#0B6A78"};
    return look::dark() ? onDark[i % maxCurves] : onLight[i % maxCurves];
}

class PlotPanel : public QWidget {
public:
    PlotPanel(Session& session, QWidget* parent);

protected:
    bool eventFilter(QObject* o, QEvent* e) override;
    void changeEvent(QEvent* e) override;

private:
    void makePlot();
    void connectPlot();
    void applyTheme();
    void begin();
    void refresh();
    void choose();
    void rebuild();
    void append();
    void moveCursor();
    void fit();
    void showMenu(const QPoint& at);
    void addNumbersTo(QMenu& menu);
    void saveCsv();
    void savePicture();
    void toggle(const QString& number);
    QString over() const;
    double xOf(size_t step) const;
    size_t stepAt(double x) const;
    double cursorX() const { return xOf(steps_.position()); }

    StepSession& steps_;
    QStackedLayout* pages_;
    QLabel* sentence_ = nullptr;
    QCustomPlot* plot_ = nullptr;
    QCPItemStraightLine* cursor_ = nullptr;
    QCPItemTracer* dot_ = nullptr;
    QStringList shown_;
    QString over_;                     // the number on the x axis; empty: the step
    std::map<QString, size_t> taken_;  // points of each series that are in its graph
    size_t seen_ = 0;
    bool fitted_ = true, dragging_ = false, logarithmic_ = false;
};

PlotPanel::PlotPanel(Session& session, QWidget* parent) : QWidget(parent), steps_(session.steps)
{
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &sentence_));
    makePlot();
    pages_->addWidget(plot_);
    connectPlot();
    connect(&steps_, &StepSession::opened, this, &PlotPanel::begin);
    connect(&steps_, &StepSession::changed, this, &PlotPanel::refresh);
    begin();
    refresh();
}

void PlotPanel::makePlot()
{
    plot_ = new QCustomPlot(this);
    plot_->setObjectName("plot");
    plot_->setAccessibleName(tr("Plot of the numbers of the steps"));
    plot_->setContextMenuPolicy(Qt::CustomContextMenu);
    plot_->setInteractions(QCP::Interactions(QCP::iRangeZoom) | QCP::iRangeDrag);
    plot_->axisRect()->setRangeZoom(Qt::Horizontal);
    plot_->axisRect()->setRangeDrag(Qt::Horizontal);
    plot_->axisRect()->setMinimumMargins(QMargins(8, 8, 14, 4));
    plot_->legend->setVisible(true);
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignLeft | Qt::AlignTop);
    cursor_ = new QCPItemStraightLine(plot_);
    dot_ = new QCPItemTracer(plot_);
    dot_->setStyle(QCPItemTracer::tsCircle);
    dot_->setSize(8);
    dot_->setInterpolating(false);
    plot_->installEventFilter(this);
    auto* menu = new QToolButton(plot_);
    menu->setText(QString(QChar(0x22EF)));
    menu->setAutoRaise(true);
    menu->setFocusPolicy(Qt::TabFocus);
    menu->setAccessibleName(tr("Plot menu"));
    menu->setToolTip(tr("Numbers shown, scale, saving."));
    menu->setObjectName("plot-menu");
    menu->setProperty("small", true);
    menu->setFixedSize(24, 20);
    connect(menu, &QToolButton::clicked, this, [this, menu] { showMenu(menu->mapToGlobal(QPoint(0, menu->height()))); });
    applyTheme();
}

void PlotPanel::connectPlot()
{
    connect(plot_, &QWidget::customContextMenuRequested, this, [this](const QPoint& p) { showMenu(plot_->mapToGlobal(p)); });
    connect(plot_, &QCustomPlot::mouseWheel, this, [this] { fitted_ = false; });
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] {
        fitted_ = true;
        fit();
        plot_->replot(QCustomPlot::rpQueuedReplot);
    });
    connect(plot_, &QCustomPlot::mousePress, this, [this](QMouseEvent* e) {
        dragging_ = e->button() == Qt::LeftButton && std::abs(plot_->xAxis->coordToPixel(cursorX()) - e->position().x()) <= grabWidth;
        plot_->setInteraction(QCP::iRangeDrag, !dragging_);
    });
    connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* e) {
        const double x = plot_->xAxis->pixelToCoord(e->position().x());
        const bool near = std::abs(plot_->xAxis->coordToPixel(cursorX()) - e->position().x()) <= grabWidth;
        plot_->setCursor(dragging_ || near ? Qt::SizeHorCursor : Qt::ArrowCursor);
        if (dragging_) steps_.scrub(stepAt(x));
        if (!dragging_ && (e->buttons() & Qt::LeftButton)) fitted_ = false;
    });
    connect(plot_, &QCustomPlot::mouseRelease, this, [this](QMouseEvent* e) {
        if (dragging_) steps_.seek(stepAt(plot_->xAxis->pixelToCoord(e->position().x())));
        dragging_ = false;
        plot_->setInteraction(QCP::iRangeDrag, true);
    });
}

// The menu button stays in the corner; tooltips say what is under the mouse.
bool PlotPanel::eventFilter(QObject* o, QEvent* e)
{
    if (o == plot_ && e->type() == QEvent::Resize)
        if (auto* b = plot_->findChild<QToolButton*>("plot-menu")) b->move(plot_->width() - b->width() - 4, 2);
    return QWidget::eventFilter(o, e);
}

void PlotPanel::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if (e->type() != QEvent::PaletteChange || !plot_) return;
    applyTheme();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotPanel::applyTheme()
{
    const look::Tones& t = look::tone();
    plot_->setBackground(QBrush(t.panel));
    plot_->axisRect()->setBackground(QBrush(t.panel));
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    for (QCPAxis* a : {plot_->xAxis, plot_->yAxis}) {
        a->setBasePen(QPen(t.strong));
        a->setTickPen(QPen(t.strong));
        a->setSubTickPen(Qt::NoPen);
        a->setTickLabelColor(t.text2);
        a->setTickLabelFont(small);
        a->setLabelColor(t.text2);
        a->setLabelFont(small);
        a->grid()->setPen(QPen(t.border, 1));
        a->grid()->setSubGridVisible(false);
        a->grid()->setZeroLinePen(QPen(t.border, 1));
        a->setTickLengthIn(0);
    }
    plot_->xAxis->grid()->setVisible(false);
    plot_->legend->setBrush(Qt::NoBrush);  // a curve may begin behind it
    plot_->legend->setBorderPen(Qt::NoPen);
    plot_->legend->setTextColor(t.text);
    plot_->legend->setFont(small);
    cursor_->setPen(QPen(t.text, 1));
    dot_->setPen(QPen(QColor("#101215"), 1.4));
    dot_->setBrush(look::roleColor(Role::Current));
    for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->setPen(QPen(curveColor(i), 1.6));
}

void PlotPanel::begin()
{
    seen_ = 0;
    fitted_ = true;
    shown_ = QStringList{"\n"};  // equal to no choice
    taken_.clear();
}

// At first the number its lesson names, even before it comes, or the first that came.
void PlotPanel::choose()
{
    if (!steps_.plotted().isEmpty()) return;
    const std::vector<std::string> names = steps_.seriesNames();
    const QString named = plottedFirst(*steps_.operation());
    if (!named.isEmpty())
        steps_.setPlotted({named});
    else if (!names.empty())
        steps_.setPlotted({QString::fromStdString(names.front())});
}

/// What the run gives: a direct solver has no sweeps.
QString PlotPanel::over() const
{
    const QString wanted = plottedOver(*steps_.operation(), steps_.plotted());
    return steps_.series(wanted.toStdString()).empty() ? QString() : wanted;
}

/// Where a step stands on the x axis: at the last value there was by then.
double PlotPanel::xOf(size_t step) const
{
    if (over_.isEmpty()) return double(step);
    const auto& points = steps_.series(over_.toStdString());
    const auto after = std::upper_bound(points.begin(), points.end(), step, [](size_t s, const auto& p) { return s < p.first; });
    return after == points.begin() ? 0 : (after - 1)->second;
}

/// Of the first curve's, the one nearest.
size_t PlotPanel::stepAt(double x) const
{
    if (over_.isEmpty()) return size_t(std::max(0.0, std::round(x)));
    const auto& points = steps_.series(shown_.front().toStdString());
    if (points.empty()) return 0;
    const auto at = std::lower_bound(points.begin(), points.end(), x - 0.5, [this](const auto& p, double v) { return xOf(p.first) < v; });
    return at == points.end() ? points.back().first : at->first;
}

void PlotPanel::refresh()
{
    if (steps_.isOpen()) choose();
    const QStringList numbers = steps_.isOpen() ? steps_.plotted() : QStringList();
    const bool any = std::any_of(numbers.begin(), numbers.end(), [this](const QString& n) { return !steps_.series(n.toStdString()).empty(); });
    pages_->setCurrentIndex(any ? 1 : 0);
    if (!any) {
        sentence_->setText(
            !steps_.isOpen() ? tr("The numbers of the algorithm that is stepped are plotted here.")
            : numbers.isEmpty()
                ? tr("The numbers of the steps passed are plotted here. Step forward to get the first.")
                : tr("%1 is plotted here. Step forward until a step gives it.").arg(numberTitle(*steps_.operation(), numbers.front())));
        return;
    }
    if (shown_ != numbers || over_ != over()) rebuild();
    if (seen_ != steps_.history().end()) append();
    moveCursor();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotPanel::rebuild()
{
    shown_ = steps_.plotted();
    over_ = over();
    taken_.clear();
    seen_ = 0;
    dot_->setGraph(nullptr);
    plot_->clearGraphs();
    logarithmic_ = !shown_.isEmpty() && isLogarithmic(*steps_.operation(), shown_.front());
    plot_->yAxis->setScaleType(logarithmic_ ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    QSharedPointer<QCPAxisTicker> ticker(logarithmic_ ? new QCPAxisTickerLog : new QCPAxisTicker);
    ticker->setTickCount(4);
    plot_->yAxis->setTicker(ticker);
    plot_->yAxis->setNumberFormat(logarithmic_ ? "eb" : "gb");
    plot_->yAxis->setNumberPrecision(logarithmic_ ? 0 : 4);
    QSharedPointer<QCPAxisTicker> steps(new QCPAxisTicker);
    steps->setTickCount(4);
    plot_->xAxis->setTicker(steps);
    plot_->xAxis->setLabel(over_.isEmpty() ? tr("step") : numberTitle(*steps_.operation(), over_).toLower());
    for (const QString& name : shown_) {
        QCPGraph* g = plot_->addGraph();
        g->setName(numberTitle(*steps_.operation(), name));
        g->setAdaptiveSampling(true);
    }
    plot_->xAxis->setNumberFormat("f");
    plot_->xAxis->setNumberPrecision(0);
    applyTheme();
}

void PlotPanel::append()
{
    seen_ = steps_.history().end();
    for (int i = 0; i < plot_->graphCount(); ++i) {
        const auto& points = steps_.series(shown_[i].toStdString());
        size_t& taken = taken_[shown_[i]];
        if (taken > points.size()) {  // it was thinned out
            plot_->graph(i)->data()->clear();
            taken = 0;
        }
        QVector<double> x, y;
        for (; taken < points.size(); ++taken) {
            if (logarithmic_ && points[taken].second <= 0) continue;  // has no place on this scale
            x.append(xOf(points[taken].first));
            y.append(points[taken].second);
        }
        plot_->graph(i)->addData(x, y, true);
    }
    if (fitted_) fit();
    // Where the curve is not: a residual falls, a count rises.
    const auto curve = plot_->graph(0)->data();
    const bool falls = !curve->isEmpty() && curve->constBegin()->value > (curve->constEnd() - 1)->value;
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, (falls ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
    // Whole powers of ten where there are several, else one digit more.
    const QCPRange y = plot_->yAxis->range();
    if (logarithmic_) plot_->yAxis->setNumberPrecision(y.lower > 0 && y.upper / y.lower > 100 ? 0 : 1);
}

void PlotPanel::fit()
{
    plot_->yAxis->rescale();
    if (logarithmic_)
        plot_->yAxis->setRange(plot_->yAxis->range().lower / 1.5, plot_->yAxis->range().upper * 1.5);
    else
        plot_->yAxis->scaleRange(1.12);
    plot_->xAxis->setRange(0, 1.02 * std::max(10.0, xOf(steps_.history().end())));
}

void PlotPanel::moveCursor()
{
    cursor_->point1->setCoords(cursorX(), plot_->yAxis->range().lower);
    cursor_->point2->setCoords(cursorX(), plot_->yAxis->range().upper);
    const bool any = plot_->graphCount() > 0 && !plot_->graph(0)->data()->isEmpty();
    dot_->setVisible(any);
    if (!any) return;
    dot_->setGraph(plot_->graph(0));
    dot_->setGraphKey(cursorX());
}

void PlotPanel::toggle(const QString& number)
{
    QStringList chosen = steps_.plotted();
    if (!chosen.removeOne(number)) chosen.append(number);
    if (!chosen.isEmpty()) steps_.setPlotted(chosen);
}

void PlotPanel::addNumbersTo(QMenu& menu)
{
    const QStringList chosen = steps_.plotted();
    for (const std::string& name : steps_.seriesNames()) {
        const QString number = QString::fromStdString(name);
        QAction* a = menu.addAction(numberTitle(*steps_.operation(), number), this, [this, number] { toggle(number); });
        a->setCheckable(true);
        a->setChecked(chosen.contains(number));
        a->setEnabled(a->isChecked() ? chosen.size() > 1 : chosen.size() < maxCurves);
    }
}

void PlotPanel::showMenu(const QPoint& at)
{
    if (!steps_.isOpen()) return;
    QMenu menu(this);
    addNumbersTo(menu);
    menu.addSeparator();
    menu.addAction(tr("Fit"), this, [this] {
        fitted_ = true;
        fit();
        plot_->replot();
    });
    menu.addAction(tr("Save CSV..."), this, &PlotPanel::saveCsv);
    menu.addAction(tr("Save picture..."), this, &PlotPanel::savePicture);
    menu.exec(at);
}

void PlotPanel::saveCsv()
{
    const QString file = QFileDialog::getSaveFileName(this, tr("Save CSV"), "steps.csv", tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    QSaveFile out(file);
    const QByteArray text = seriesAsCsv(steps_, steps_.plotted());
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size() || !out.commit())
        sentence_->setText(tr("%1: %2. Choose another folder.").arg(file, out.errorString())), pages_->setCurrentIndex(0);
}

void PlotPanel::savePicture()
{
    const QString file = QFileDialog::getSaveFileName(this, tr("Save picture"), "steps.png", tr("Pictures (*.png)"));
    if (file.isEmpty()) return;
    if (!plot_->savePng(file, 0, 0, 2))
        sentence_->setText(tr("%1 could not be written. Choose another folder.").arg(file)), pages_->setCurrentIndex(0);
}

}  // namespace

QByteArray seriesAsCsv(const StepSession& steps, const QStringList& numbers)
{
    std::map<size_t, std::vector<double>> rows;
    for (qsizetype i = 0; i < numbers.size(); ++i)
        for (const auto& [step, value] : steps.series(numbers[i].toStdString())) {
            std::vector<double>& row = rows.try_emplace(step, size_t(numbers.size()), std::nan("")).first->second;
            row[size_t(i)] = value;
        }
    QByteArray text = "step," + numbers.join(',').toUtf8() + '\n';
    for (const auto& [step, row] : rows) {
        text += QByteArray::number(qulonglong(step));
        for (double v : row) text += ',' + (std::isnan(v) ? QByteArray() : QByteArray::number(v, 'g', 17));
        text += '\n';
    }
    return text;
}

QWidget* makePlotPanel(Session& session, QWidget* parent)
{
    return new PlotPanel(session, parent);
}

}  // namespace mw
