// Operations that work with another mesh, as a person uses them: the row that names it, the morph that plays at once.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

#include "core/catalog/others.h"
#include "core/character/skin.h"
#include "core/io/io.h"
#include "core/mesh/topology.h"
#include "tests/ui/window_fixture.h"
#include "ui/edit_commands.h"
#include "ui/elided.h"
#include "ui/file_commands.h"
#include "ui/object_choices.h"
#include "ui/parameter_form.h"
#include "ui/playback.h"
#include "ui/stack_edits.h"
#include "ui/viewport/viewport.h"

using namespace mw;

class MorphWindowTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    Playback& play() { return *w_->session().playback; }
    NodeId node(const char* name)
    {
        for (const NodeId id : document().scene().nodes())
            if (document().scene().node(id).name == name) return id;
        return {};
    }
    void open(std::initializer_list<std::pair<const char*, const char*>> meshes)
    {
        Scene scene;
        for (const auto& [name, source] : meshes) {
            MeshObject object;
            object.name = name;
            object.base = *meshOfSource(source);
            Node n;
            n.name = name;
            n.mesh = scene.add(std::move(object));
            scene.add(std::move(n));
        }
        w_->files().openScene(scene, "Open");
        document().select({{node(meshes.begin()->first)}, {}, {}});
        settle();
    }
    void add(const char* id)
    {
        w_->findChild<QPushButton*>("addModifier")->click();
        auto* list = w_->findChild<QListWidget*>("modifierChoices");
        QVERIFY(list);
        auto items = list->findItems(QString::fromStdString(operation(id).title), Qt::MatchExactly);
        items.removeIf([](const QListWidgetItem* i) { return !(i->flags() & Qt::ItemIsSelectable); });  // the heading of the category
        QCOMPARE(items.size(), 1);
        emit list->itemClicked(items.front());
        settle();
    }
    QComboBox* other()
    {
        for (auto* form : w_->findChildren<ParameterForm*>())
            if (auto* box = qobject_cast<QComboBox*>(form->field("other"))) return box;
        return nullptr;
    }
    const Modifier& modifier() { return document().scene().find(edits::activeMesh(document()))->stack.back(); }
    std::string chosen()
    {
        const auto i = modifier().values.find("other");
        return i == modifier().values.end() ? std::string() : std::get<std::string>(i->second);
    }
    bool says(const QString& text)
    {
        for (const auto* l : w_->findChildren<QLabel*>())
            if (l->isVisible() && l->text().contains(text, Qt::CaseInsensitive)) return true;
        return false;
    }
    double shownVolume(const char* name)
    {
        for (const DrawObject& o : w_->viewport().frame().objects)
            if (o.node == node(name)) return enclosedVolume(o.pose ? posed(o.mesh, *o.pose) : o.mesh);
        return -1;
    }

private slots:
    void init() { showWindow(1280, 900); }
    void cleanup() { w_.reset(); }

    void takesTheOnlyOtherMeshAndPlays()
    {
        open({{"ball", "icosphere:subdivisions=2"}, {"cube", "box:width=2,height=2,depth=2"}});
        const size_t entries = document().history().size();
        add("morph");
        QCOMPARE(chosen(), std::string("cube"));
        QVERIFY(other());
        QCOMPARE(other()->currentText(), QString("cube"));
        QCOMPARE(document().history().size(), entries + 1);
        QVERIFY(!says("choose a mesh"));
        // Its clip is the one in the timeline; the view shows the pose at the playhead.
        QVERIFY(play().clip());
        QCOMPARE(play().end(), 4.0);
        play().setTime(0);
        QTRY_VERIFY(std::abs(shownVolume("ball") - enclosedVolume(*meshOfSource("icosphere:subdivisions=2"))) < 1e-4);
        play().setTime(2);
        QTRY_VERIFY2(std::abs(shownVolume("ball") - 8) < 1e-3, qPrintable(QString::number(shownVolume("ball"))));
        document().undo();
        QVERIFY(document().scene().clips().empty());
        QVERIFY(document().scene().find(edits::activeMesh(document()))->stack.empty());
    }

    void asksWhichWhenThereAreSeveral()
    {
        open({{"ball", "icosphere:subdivisions=2"}, {"cube", "box"}, {"egg", "uv-sphere"}});
        add("morph");
        QCOMPARE(chosen(), std::string());
        QVERIFY(says("choose a mesh"));
        // However narrow the row: then the name ends in an ellipsis.
        auto* row = w_->findChild<QFrame*>("modifierRow");
        row->setFixedWidth(190);
        QTest::qWait(50);
        QVERIFY(says("choose a mesh"));
        auto* name = row->findChild<ElidedButton*>();
        QVERIFY2(name->width() > 0 && name->width() < name->sizeHint().width(), qPrintable(QString::number(name->width())));
        row->setMinimumWidth(0), row->setMaximumWidth(QWIDGETSIZE_MAX);
        QVERIFY2(!says("needs another mesh") && !says("the node, file or source"), "not yet said is no error");
        QCOMPARE(other()->lineEdit()->placeholderText(), QString("Choose the other mesh"));
        other()->showPopup();
        QStringList items;
        for (int i = 0; i < other()->count(); ++i) items << other()->itemText(i);
        other()->hidePopup();
        QVERIFY2(items.contains("cube") && items.contains("egg") && items.contains("File...") && !items.contains("ball"),
                 qPrintable(items.join(", ")));
        const int egg = other()->findText("egg");
        other()->setCurrentIndex(egg);
        emit other()->activated(egg);
        settle();
        QCOMPARE(chosen(), std::string("egg"));
        QVERIFY(!says("choose a mesh"));
        // A source is typed.
        other()->lineEdit()->setText("box:width=2");
        emit other()->lineEdit()->editingFinished();
        settle();
        QCOMPARE(chosen(), std::string("box:width=2"));
        QVERIFY(document().shownMesh(edits::activeMesh(document())).find("morph:box"));
        // What is named and is not there is an error.
        other()->lineEdit()->setText("nobody");
        emit other()->lineEdit()->editingFinished();
        settle();
        QVERIFY(says("nobody"));
    }

    void aFileComesInHidden()
    {
        open({{"ball", "icosphere:subdivisions=2"}});
        const NodeId active = document().selection().active();
        QTemporaryDir folder;
        const QString file = folder.filePath("pear.ply");
        writeFile(sceneOf(*meshOfSource("uv-sphere:radius=2"), "pear"), file.toStdString());
        QVERIFY(edits::runQuick(document(), {"import", {{"file", file.toStdString()}, {"hidden", true}}}));
        QCOMPARE(document().selection().active(), active);
        const auto names = otherMeshNames(document().scene(), edits::activeMesh(document()));
        QCOMPARE(names.size(), size_t(1));
        QVERIFY(!document().scene().node(node(names[0].c_str())).visible);
        add("morph");
        QCOMPARE(chosen(), names[0]);
    }
};

int main(int argc, char** argv)
{
    return runTests<MorphWindowTest>(argc, argv);
}

#include "morph_test.moc"
