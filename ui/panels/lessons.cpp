// See lessons.h: the list. A click shows a lesson's text, Enter or a double click opens it.
#include "ui/panels/lessons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "ui/look.h"
#include "ui/panels/lesson_desk.h"

namespace mw {

namespace {

QString chapterName(int chapter)
{
    switch (chapter) {
        case 2:
            return QObject::tr("2 Mesh basics");
        case 3:
            return QObject::tr("3 Mesh algorithms");
        case 4:
            return QObject::tr("4 Geometry shaders");
        case 5:
            return QObject::tr("5 Tessellation");
        case 6:
            return QObject::tr("6 Rotations");
        case 7:
            return QObject::tr("7 Character animation");
        case 8:
            return QObject::tr("8 Kinematics");
        default:
            return QObject::tr("Further");
    }
}

class LessonsPanel : public QWidget {
public:
    LessonsPanel(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* e) override;

private:
    void makeTree();
    void fill();
    void refresh();
    void filter(const QString& text);
    const Lesson* lessonOf(const QTreeWidgetItem* row) const;

    LessonDesk& desk_;
    QLineEdit* filter_;
    QTreeWidget* tree_;
    QWidget* backBar_;
};

LessonsPanel::LessonsPanel(Session& session, QWidget* parent) : QWidget(parent), desk_(LessonDesk::of(session))
{
    setObjectName("lessons");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 0, 8, 0);
    top->addWidget(filter_ = new QLineEdit(this));
    filter_->setPlaceholderText(tr("Filter lessons"));
    filter_->setClearButtonEnabled(true);
    filter_->setAccessibleName(tr("Filter lessons"));
    filter_->setToolTip(tr("Only lessons whose title has these words"));
    connect(filter_, &QLineEdit::textChanged, this, &LessonsPanel::filter);
    column->addLayout(top);
    makeTree();
    column->addWidget(tree_, 1);
    backBar_ = new QWidget(this);
    auto* row = new QHBoxLayout(backBar_);
    row->setContentsMargins(8, 4, 8, 8);
    auto* text = new QLabel(tr("Your scene is kept."), backBar_);
    text->setProperty("secondary", true);
    row->addWidget(text, 1);
    auto* back = new QPushButton(tr("Back to my scene"), backBar_);
    back->setObjectName("lesson-back");
    connect(back, &QPushButton::clicked, &desk_, &LessonDesk::backToMyScene);
    row->addWidget(back);
    column->addWidget(backBar_);
    connect(&desk_, &LessonDesk::changed, this, &LessonsPanel::refresh);
    fill();
    refresh();
}

void LessonsPanel::makeTree()
{
    tree_ = new QTreeWidget(this);
    tree_->setObjectName("lesson-list");
    tree_->setAccessibleName(tr("Lessons"));
    tree_->setHeaderHidden(true);
    tree_->setColumnCount(2);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setIndentation(16);
    tree_->setExpandsOnDoubleClick(false);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
        if (const Lesson* l = lessonOf(row)) desk_.show(l);
    });
    connect(tree_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        if (const Lesson* l = lessonOf(row))
            desk_.load(*l);
        else
            row->setExpanded(!row->isExpanded());
    });
}

const Lesson* LessonsPanel::lessonOf(const QTreeWidgetItem* row) const
{
    return row ? findLesson(row->data(0, Qt::UserRole).toString().toStdString()) : nullptr;
}

void LessonsPanel::fill()
{
    std::map<int, std::vector<const Lesson*>> chapters;
    for (const Lesson& l : lessons()) {
        const int chapter = QString::fromStdString(l.section).section('.', 0, 0).toInt();
        chapters[chapter >= 2 && chapter <= 8 ? chapter : 99].push_back(&l);
    }
    for (auto& [chapter, list] : chapters) {
        std::stable_sort(list.begin(), list.end(), [](const Lesson* a, const Lesson* b) { return a->section < b->section; });
        auto* head = new QTreeWidgetItem(tree_, {chapterName(chapter)});
        QFont bold = font();
        bold.setBold(true);
        head->setFont(0, bold);
        head->setSizeHint(0, {0, 24});
        head->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        for (const Lesson* l : list) {
            auto* row = new QTreeWidgetItem(head, {QString::fromStdString(l->title)});
            row->setData(0, Qt::UserRole, QString::fromStdString(l->id));
            row->setSizeHint(0, {0, 24});
            row->setFirstColumnSpanned(true);
            row->setToolTip(0, tr("Book %1. Enter or a double click opens it.").arg(QString::fromStdString(l->section)));
        }
        head->setExpanded(true);
    }
}

void LessonsPanel::refresh()
{
    backBar_->setVisible(desk_.canGoBack());
    for (int c = 0; c < tree_->topLevelItemCount(); ++c) {
        QTreeWidgetItem* head = tree_->topLevelItem(c);
        int done = 0;
        for (int i = 0; i < head->childCount(); ++i) {
            QTreeWidgetItem* row = head->child(i);
            const Lesson* l = lessonOf(row);
            const bool ticked = desk_.done(*l), open = desk_.loaded() == l;
            done += ticked;
            QPixmap blank(16, 16);
            blank.fill(Qt::transparent);
            row->setIcon(0, open ? look::icon("here") : ticked ? look::icon("ok", look::tone().success) : QIcon(blank));
            row->setData(0, Qt::AccessibleDescriptionRole, open ? tr("open") : ticked ? tr("done") : tr("not done"));
            if (desk_.lesson() == l && !tree_->hasFocus()) tree_->setCurrentItem(row);
        }
        head->setText(1, tr("%1 of %2").arg(done).arg(head->childCount()));
        head->setForeground(1, look::tone().text2);
    }
}

void LessonsPanel::filter(const QString& text)
{
    for (int c = 0; c < tree_->topLevelItemCount(); ++c) {
        QTreeWidgetItem* head = tree_->topLevelItem(c);
        bool any = false;
        for (int i = 0; i < head->childCount(); ++i) {
            const bool fits = head->child(i)->text(0).contains(text, Qt::CaseInsensitive);
            head->child(i)->setHidden(!fits);
            any |= fits;
        }
        head->setHidden(!any);
        if (any && !text.isEmpty()) head->setExpanded(true);
    }
}

void LessonsPanel::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if (e->type() == QEvent::PaletteChange && tree_) refresh();
}

}  // namespace

QWidget* makeLessonsPanel(Session& session, QWidget* parent)
{
    return new LessonsPanel(session, parent);
}

}  // namespace mw
