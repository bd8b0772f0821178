// Text up to twice its size: nowhere in the window is a word cut off or drawn over another one without an ellipsis to say so.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QToolButton>

#include "core/scene/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/elided.h"
#include "ui/file_commands.h"
#include "ui/panel.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/workspaces.h"

using namespace mw;

class TextSizeTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    qreal points_ = 0;
    QStringList offenders_;

    static QString what(const QWidget* w)
    {
        QString place;
        for (const QWidget* p = w; p; p = p->parentWidget())
            if (auto* d = qobject_cast<const QDockWidget*>(p)) place = d->windowTitle() + ": ";
        return QString("%1%2 '%3' '%4'").arg(place, w->metaObject()->className(), w->objectName(), textOf(w));
    }
    static QString textOf(const QWidget* w)
    {
        if (auto* b = qobject_cast<const QAbstractButton*>(w)) return b->text();
        if (auto* l = qobject_cast<const QLabel*>(w)) return l->text();
        if (auto* c = qobject_cast<const QComboBox*>(w)) return c->currentText();
        if (auto* e = qobject_cast<const QLineEdit*>(w)) return e->text();
        return {};
    }
    // What scrolls sideways shows the rest when asked.
    static bool scrollsSideways(const QWidget* w)
    {
        for (; w; w = w->parentWidget())
            if (auto* area = qobject_cast<const QAbstractScrollArea*>(w); area && area->horizontalScrollBar()->isVisible()) return true;
        return false;
    }
    static bool elides(const QWidget* w)
    {
        return qobject_cast<const ElidedLabel*>(w) || qobject_cast<const ElidedComboBox*>(w) || qobject_cast<const ElidedButton*>(w);
    }
    static bool showsText(const QWidget* w)
    {
        if (auto* b = qobject_cast<const QToolButton*>(w); b && b->toolButtonStyle() == Qt::ToolButtonIconOnly && !b->icon().isNull()) return false;
        return !textOf(w).isEmpty();
    }

    void blame(const QWidget* w, const QString& why) { offenders_ << what(w) + " " + why; }

    void lookAtText(const QWidget* w)
    {
        QSize hint = w->sizeHint();
        if (qobject_cast<const QToolButton*>(w)) hint -= QSize(6, 5);  // what Fusion asks for beside text and padding
        if (auto* label = qobject_cast<const QLabel*>(w); label && label->wordWrap() && w->height() < label->heightForWidth(w->width()))
            return blame(w, QString("is %1 high, needs %2").arg(w->height()).arg(label->heightForWidth(w->width())));
        else if (label && label->wordWrap())
            return;
        if (auto* edit = qobject_cast<const QLineEdit*>(w)) {
            if (qobject_cast<const QAbstractItemView*>(w->parentWidget())) return;
            if (w->height() < w->fontMetrics().height()) blame(w, QString("is %1 high, its text %2").arg(w->height()).arg(w->fontMetrics().height()));
            if (edit->isReadOnly() || qobject_cast<const QComboBox*>(w->parentWidget()) || edit->objectName() != "qt_spinbox_lineedit") return;
            const int needed = w->fontMetrics().horizontalAdvance(edit->text());
            if (w->width() < needed) blame(w, QString("is %1 wide, its text %2").arg(w->width()).arg(needed));
            return;
        }
        if (auto* combo = qobject_cast<const ElidedComboBox*>(w); combo && w->width() >= hint.width() && combo->shownText() != combo->currentText())
            blame(w, "shows " + combo->shownText() + " where there is room");
        if (w->height() < hint.height()) blame(w, QString("is %1 high, needs %2").arg(w->height()).arg(hint.height()));
        if (!elides(w) && w->width() < hint.width()) blame(w, QString("is %1 wide, needs %2").arg(w->width()).arg(hint.width()));
    }
    // An icon is drawn smaller, and not evenly, when its button leaves it less room than it has.
    void lookAtIcon(const QToolButton* b)
    {
        const QSize hint = b->sizeHint() - QSize(6, 5);
        if (b->width() < hint.width() || b->height() < hint.height())
            blame(b, QString("is %1 by %2, its icon needs %3 by %4").arg(b->width()).arg(b->height()).arg(hint.width()).arg(hint.height()));
    }
    void lookAtPlace(const QWidget* w)
    {
        if (!qobject_cast<const QLineEdit*>(w) && !scrollsSideways(w)) {
            QRect seen(QPoint(), w->size());
            for (const QWidget* p = w; !p->isWindow() && p->parentWidget(); p = p->parentWidget()) {
                const QPoint at = w->mapTo(p->parentWidget(), QPoint());
                const QRect r = seen.translated(at);
                if (r.left() < 0 || r.right() >= p->parentWidget()->width()) {
                    blame(w, QString("reaches %1 to %2 of the %3 pixels of %4")
                                 .arg(r.left())
                                 .arg(r.right())
                                 .arg(p->parentWidget()->width())
                                 .arg(what(p->parentWidget())));
                    break;
                }
            }
        }
        for (const QObject* o : w->parentWidget()->children()) {
            auto* other = qobject_cast<const QWidget*>(o);
            if (!other || other == w || !other->isVisible() || other->isWindow() || !showsText(other)) continue;
            if (w->geometry().intersects(other->geometry())) blame(w, "lies over " + what(other));
        }
    }
    void look()
    {
        for (const QWidget* w : w_->findChildren<QWidget*>()) {
            if (!w->isVisible() || w->visibleRegion().isEmpty()) continue;
            if (auto* b = qobject_cast<const QToolButton*>(w);
                b && !b->icon().isNull() && !qobject_cast<const QLineEdit*>(b->parentWidget()) && !showsText(b))
                lookAtIcon(b);
            if (!showsText(w)) continue;
            if (qobject_cast<const QAbstractScrollArea*>(w->parentWidget())) continue;
            lookAtText(w);
            lookAtPlace(w);
        }
    }

    void lookAtPanels()
    {
        QTest::qWait(50);
        for (const PanelEntry& p : panels()) {
            QDockWidget* dock = w_->workspaces().dock(p.id);
            if (dock->isHidden()) continue;
            dock->raise();
            QTest::qWait(30);
            settle();
            look();
        }
    }

private slots:
    void initTestCase() { points_ = qApp->font().pointSizeF(); }
    void cleanup() { w_.reset(); }

    void noWordIsCut_data()
    {
        QTest::addColumn<int>("percent");
        QTest::addColumn<QSize>("size");
        for (const int percent : {100, 150, 200})
            for (const QSize size : {QSize(1280, 800), QSize(1600, 1000)})
                QTest::addRow("%d percent, %d x %d", percent, size.width(), size.height()) << percent << size;
    }
    void noWordIsCut()
    {
        QFETCH(int, percent);
        QFETCH(QSize, size);
        QSettings().clear();
        QFont font = qApp->font();
        font.setPointSizeF(points_ * percent / 100);
        qApp->setFont(font);
        applyTheme(*qApp, currentTheme());
        offenders_.clear();
        showWindow(size.width(), size.height());
        const std::pair<const char*, const char*> both[] = {
            {"Mesh", "blossom"}, {"Learn", "blossom"}, {"Terrain", "terrain"}, {"Character", "mannequin"}, {"Character", "blossom"}};
        for (const auto& [workspace, sample] : both) {
            w_->files().openScene(drawnCoarsely(sampleScene(sample)), "Open sample");
            if (sample == QString("blossom"))
                edits::addModifier(document(), edits::activeMesh(document()), operation("decimate-quadric"), {{"ratio", 0.2}});
            w_->workspaces().change(workspace);
            lookAtPanels();
        }
        offenders_.removeDuplicates();
        for (const QString& o : offenders_) qWarning("%s", qPrintable(o));
        QCOMPARE(offenders_.size(), 0);
    }
};

int main(int argc, char** argv)
{
    return runTests<TextSizeTest>(argc, argv);
}

#include "text_size_test.moc"
