// See source_panel.h.
#include "ui/steps/source_panel.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStackedLayout>
#include <QTextBlock>
#include <QVBoxLayout>

#include "core/catalog/resources.h"
#include "ui/look.h"
#include "ui/steps/cpp_highlighter.h"

namespace mw {

namespace {

class Gutter : public QWidget {
public:
    explicit Gutter(SourceView* view) : QWidget(view), view_(view) {}
    QSize sizeHint() const override { return {view_->gutterWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* e) override { view_->paintGutter(e); }

private:
    SourceView* view_;
};

class SourcePanel : public QWidget {
public:
    SourcePanel(Session& session, QWidget* parent);

private:
    void refresh();
    StepSession& steps_;
    QStackedLayout* pages_;
    SourceView* view_;
    QLabel *where_, *sentence_ = nullptr;
    QString shown_;
};

SourcePanel::SourcePanel(Session& session, QWidget* parent) : QWidget(parent), steps_(session.steps)
{
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &sentence_));
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(where_ = new QLabel(page));
    where_->setObjectName("source-where");
    where_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    where_->setFixedHeight(22);
    where_->setContentsMargins(8, 0, 8, 0);
    where_->setProperty("secondary", true);
    column->addWidget(view_ = new SourceView(page), 1);
    pages_->addWidget(page);
    connect(view_, &SourceView::yieldClicked, &steps_, &StepSession::toLines);
    connect(&steps_, &StepSession::changed, this, &SourcePanel::refresh);
    refresh();
}

/// The file a step came from, as the project has it; before the first step the algorithm's own.
const Resource* sourceOf(const StepRecord& step, const Operation& op)
{
    const std::string_view asked = step.line ? std::string_view(step.file) : std::string_view(op.source);
    const std::string_view text = resourceText(asked);
    for (const Resource& r : resources())
        if (!text.empty() && r.text.data() == text.data()) return &r;
    return nullptr;
}

void SourcePanel::refresh()
{
    if (!steps_.isOpen()) {
        sentence_->setText(tr("Here runs the source of the algorithm that is stepped. Steps > Step through begins one."));
        pages_->setCurrentIndex(0);
        shown_.clear();
        return;
    }
    const StepRecord& step = steps_.step();
    const Resource* source = sourceOf(step, *steps_.operation());
    const QString file =
        source ? QString::fromUtf8(source->path.data(), qsizetype(source->path.size())) : QString::fromStdString(steps_.operation()->source);
    if (file != shown_) {
        shown_ = file;
        view_->setSource(source ? QString::fromUtf8(source->text.data(), qsizetype(source->text.size())) : QString());
        if (!source) sentence_->setText(tr("The source of %1 is not part of this build.").arg(file));
        pages_->setCurrentIndex(source ? 1 : 0);
    }
    view_->setRunning(step.line);
    where_->setText(step.line ? file + " : " + QString::number(view_->runningFirstLine()) : file);
}

}  // namespace

std::vector<YieldLines> yieldsIn(const QString& source)
{
    std::vector<YieldLines> found;
    const QStringList lines = source.split('\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString code = lines[i].section("//", 0, 0);
        if (!code.contains("co_yield ")) continue;
        qsizetype end = i;
        while (end + 1 < lines.size() && !lines[end].section("//", 0, 0).trimmed().endsWith(';')) ++end;
        found.push_back({unsigned(i + 1), unsigned(end + 1)});
        i = end;
    }
    return found;
}

SourceView::SourceView(QWidget* parent) : QPlainTextEdit(parent), gutter_(new Gutter(this))
{
    setObjectName("source-text");
    setReadOnly(true);
    setAccessibleName(tr("Source of the algorithm"));
    setLineWrapMode(NoWrap);
    setFrameShape(NoFrame);
    setStyleSheet("QPlainTextEdit { border: 0; border-radius: 0; }");
    document()->setDocumentMargin(0);
    setFont(look::monospace());
    setFocusPolicy(Qt::TabFocus);
    viewport()->setMouseTracking(true);
    viewport()->setCursor(Qt::ArrowCursor);
    setTabStopDistance(fontMetrics().horizontalAdvance(' ') * 4);
    new CppHighlighter(document());
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& r, int dy) {
        if (dy)
            gutter_->scroll(0, dy);
        else
            gutter_->update(0, r.y(), gutter_->width(), r.height());
    });
}

void SourceView::setSource(const QString& text)
{
    setPlainText(text);
    yields_ = yieldsIn(text);
    setViewportMargins(gutterWidth(), 0, 0, 0);
    running_ = 0;
}

int SourceView::gutterWidth() const
{
    const int digits = std::max<int>(3, int(QString::number(blockCount()).size()));
    return 8 + fontMetrics().horizontalAdvance('9') * digits + 20;
}

unsigned SourceView::runningFirstLine() const
{
    const YieldLines* statement = yieldAt(running_);
    return statement ? statement->first : running_;
}

const YieldLines* SourceView::yieldAt(unsigned line) const
{
    for (const YieldLines& y : yields_)
        if (line >= y.first && line <= y.last) return &y;
    return nullptr;
}

void SourceView::setRunning(unsigned line)
{
    running_ = line;
    mark();
    const YieldLines* y = yieldAt(line);
    if (line > 0) keepInMiddle(int(y ? y->first : line) - 1);
    gutter_->update();
}

void SourceView::mark()
{
    QList<QTextEdit::ExtraSelection> marks;
    const YieldLines* y = yieldAt(running_);
    const unsigned first = y ? y->first : running_, last = y ? y->last : running_;
    for (unsigned line = first; running_ > 0 && line <= last; ++line) {
        QTextEdit::ExtraSelection s;
        s.format.setBackground(look::tone().selection);
        s.format.setProperty(QTextFormat::FullWidthSelection, true);
        s.cursor = QTextCursor(document()->findBlockByNumber(int(line) - 1));
        marks.append(s);
    }
    setExtraSelections(marks);
}

// Scrolls only when the line has left the middle third, so that a short loop does not make the text jump.
void SourceView::keepInMiddle(int line)
{
    const int rows = std::max(1, viewport()->height() / std::max(1, fontMetrics().lineSpacing()));
    const int top = verticalScrollBar()->value(), at = line - top;
    if (at >= rows / 3 && at < rows - rows / 3) return;
    verticalScrollBar()->setValue(line - rows / 2);
    horizontalScrollBar()->setValue(0);
}

void SourceView::paintGutter(QPaintEvent* e)
{
    const look::Tones& t = look::tone();
    QPainter p(gutter_);
    p.fillRect(e->rect(), t.field);
    p.setFont(font());
    const YieldLines* now = yieldAt(running_);
    for (QTextBlock b = firstVisibleBlock(); b.isValid(); b = b.next()) {
        const QRectF box = blockBoundingGeometry(b).translated(contentOffset());
        if (box.top() > e->rect().bottom()) break;
        const unsigned line = unsigned(b.blockNumber()) + 1;
        const bool running = running_ > 0 && (line == running_ || (now && line >= now->first && line <= now->last));
        const QRect row(0, int(box.top()), gutter_->width(), int(box.height()));
        if (running) p.fillRect(row, t.selection);
        p.setPen(running ? t.selectionText : t.text2);
        p.drawText(row.adjusted(0, 0, -20, 0), Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
        const YieldLines* y = yieldAt(line);
        if (!y || y->first != line) continue;
        p.setRenderHint(QPainter::Antialiasing);
        p.setPen(Qt::NoPen);
        p.setBrush(running ? t.selectionText : t.accentText);
        p.drawEllipse(QPointF(gutter_->width() - 10, box.center().y()), 2.5, 2.5);
    }
}

void SourceView::resizeEvent(QResizeEvent* e)
{
    QPlainTextEdit::resizeEvent(e);
    const QRect r = contentsRect();
    gutter_->setGeometry(r.left(), r.top(), gutterWidth(), r.height());
    if (running_ > 0) setRunning(running_);
}

void SourceView::mouseMoveEvent(QMouseEvent* e)
{
    const bool stops = yieldAt(unsigned(cursorForPosition(e->pos()).blockNumber()) + 1) != nullptr;
    viewport()->setCursor(stops ? Qt::PointingHandCursor : Qt::ArrowCursor);
    viewport()->setToolTip(stops ? tr("Click: run until this line.") : QString());
    QPlainTextEdit::mouseMoveEvent(e);
}

void SourceView::mouseReleaseEvent(QMouseEvent* e)
{
    QPlainTextEdit::mouseReleaseEvent(e);
    if (e->button() != Qt::LeftButton || textCursor().hasSelection()) return;
    if (const YieldLines* y = yieldAt(unsigned(cursorForPosition(e->pos()).blockNumber()) + 1)) emit yieldClicked(y->first, y->last);
}

void SourceView::changeEvent(QEvent* e)
{
    QPlainTextEdit::changeEvent(e);
    if (e->type() != QEvent::PaletteChange) return;
    if (auto* h = document()->findChild<QSyntaxHighlighter*>()) h->rehighlight();
    mark();
}

QWidget* makeSourcePanel(Session& session, QWidget* parent)
{
    return new SourcePanel(session, parent);
}

}  // namespace mw
