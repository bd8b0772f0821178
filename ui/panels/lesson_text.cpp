// See lessons.h: the text of the lesson that is shown. Links in it run actions: phase:ID, number:NAME, lesson:ID, end.
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look.h"
#include "ui/panels/lesson_desk.h"
#include "ui/panels/lessons.h"

namespace mw {

namespace {

class LessonText : public QWidget {
public:
    LessonText(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* e) override;

private:
    QWidget* makePage();
    void refresh();
    QString html(const Lesson& l) const;
    QString sceneLine(const Lesson& l) const;
    void follow(const QUrl& link);
    const Lesson* next() const;

    StepSession& steps_;
    Document& document_;
    LessonDesk& desk_;
    QStackedLayout* pages_;
    QLabel *sentence_ = nullptr, *error_ = nullptr;
    QPushButton *begin_ = nullptr, *open_ = nullptr, *next_ = nullptr;
    QTextBrowser* text_ = nullptr;
    QString shown_;
};

LessonText::LessonText(Session& session, QWidget* parent)
    : QWidget(parent), steps_(session.steps), document_(session.document), desk_(LessonDesk::of(session))
{
    setObjectName("lesson-text");
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &sentence_, &begin_));
    sentence_->setText(tr("A lesson opens a scene and steps through an algorithm on it. Choose one in Lessons."));
    begin_->setText(tr("Open the first lesson"));
    begin_->setToolTip(tr("Show its text here"));
    begin_->setVisible(!lessons().empty());
    connect(begin_, &QPushButton::clicked, this, [this] { desk_.load(lessons().front()); });
    pages_->addWidget(makePage());
    connect(&desk_, &LessonDesk::changed, this, &LessonText::refresh);
    refresh();
}

QWidget* LessonText::makePage()
{
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(6);
    column->addWidget(text_ = new QTextBrowser(page), 1);
    text_->setObjectName("lesson-body");
    text_->setAccessibleName(tr("Text of the lesson"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);
    text_->document()->setDocumentMargin(8);
    text_->setStyleSheet("QTextBrowser { background: transparent; border: 0; }");
    connect(text_, &QTextBrowser::anchorClicked, this, &LessonText::follow);
    column->addWidget(error_ = new QLabel(page));
    error_->setWordWrap(true);
    error_->setProperty("bad", true);
    error_->setContentsMargins(8, 0, 8, 0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 0, 8, 0);
    row->addWidget(open_ = new QPushButton(page));
    open_->setObjectName("lesson-open");
    row->addStretch(1);
    row->addWidget(next_ = new QPushButton(tr("Next lesson"), page));
    next_->setObjectName("lesson-next");
    connect(open_, &QPushButton::clicked, this, [this] {
        if (desk_.lesson()) desk_.load(*desk_.lesson());
    });
    connect(next_, &QPushButton::clicked, this, [this] {
        if (const Lesson* l = next()) desk_.load(*l);
    });
    column->addLayout(row);
    return page;
}

const Lesson* LessonText::next() const
{
    const auto& all = lessons();
    for (size_t i = 0; i + 1 < all.size(); ++i)
        if (&all[i] == desk_.lesson()) return &all[i + 1];
    return nullptr;
}

QString LessonText::sceneLine(const Lesson& l) const
{
    QString line = tr("Book %1.").arg(QString::fromStdString(l.section));
    const std::string source = l.scene.source.substr(0, l.scene.source.find(':'));
    const Operation* op = findOperation(source);
    line += ' ' + tr("Scene: %1").arg(op ? QString::fromStdString(op->title).toLower() : QString::fromStdString(source));
    if (desk_.loaded() != &l || document_.scene().roots().empty()) return line;
    const Node& n = document_.scene().node(document_.scene().roots().front());
    const MeshObject* object = n.mesh ? document_.scene().find(n.mesh) : nullptr;
    return object ? line + ", " + look::counted(object->base.faceCount(), tr("face"), tr("faces")) : line;
}

QString LessonText::html(const Lesson& l) const
{
    const look::Tones& t = look::tone();
    QString h = QString("<style>p, ol { margin: 0 0 8px 0 } a { color: %1; text-decoration: none }</style>").arg(t.accentText.name());
    h += QString("<p style='font-size:%1pt; font-weight:700'>%2</p>")
             .arg(font().pointSizeF() * 1.2)
             .arg(QString::fromStdString(l.title).toHtmlEscaped());
    h += QString("<p style='color:%1'>%2</p>").arg(t.text2.name(), sceneLine(l).toHtmlEscaped());
    h += QString::fromStdString(l.intro);
    if (l.tries.empty()) return h;
    h += "<p><b>" + tr("Try") + "</b></p><ol style='-qt-list-indent: 1; margin-left: -18px'>";
    for (const std::string& tryThis : l.tries) h += "<li>" + QString::fromStdString(tryThis) + "</li>";
    return h + "</ol>";
}

void LessonText::refresh()
{
    const Lesson* l = desk_.lesson();
    pages_->setCurrentIndex(l ? 1 : 0);
    if (!l) return;
    const QString h = html(*l);
    if (h != shown_) text_->setHtml(h);
    shown_ = h;
    open_->setText(desk_.loaded() == l ? tr("Restart lesson") : tr("Open lesson"));
    open_->setEnabled(!desk_.loading());
    open_->setToolTip(desk_.loading() ? tr("Its scene is being made.")
                                      : tr("Makes the scene of the lesson and begins stepping. Your scene is kept."));
    next_->setEnabled(next() != nullptr);
    next_->setToolTip(next() ? QString::fromStdString(next()->title) : tr("This is the last lesson."));
    error_->setVisible(!desk_.error().isEmpty());
    error_->setText(desk_.error());
}

void LessonText::follow(const QUrl& link)
{
    const QString what = link.toString().section(':', 1);
    if (link.scheme() == "phase") steps_.toPhase(what);
    if (link.scheme() == "number") steps_.setPlotted({what});
    if (link.scheme() == "end") steps_.last();
    if (link.scheme() == "lesson")
        if (const Lesson* l = findLesson(what.toStdString())) desk_.load(*l);
}

void LessonText::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if ((e->type() == QEvent::PaletteChange || e->type() == QEvent::FontChange) && text_) refresh();
}

}  // namespace

QWidget* makeLessonTextPanel(Session& session, QWidget* parent)
{
    return new LessonText(session, parent);
}

}  // namespace mw
