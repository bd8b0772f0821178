#include "ui/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>

#include "core/io/io.h"
#include "core/scene/adopt_clips.h"
#include "ui/evaluation_service.h"

namespace mw {
namespace {

std::filesystem::path pathOf(const QString& file)
{
    return std::filesystem::path(file.toStdU16String());
}

QString nameOf(const QString& file)
{
    return QFileInfo(file).fileName();
}

QString filterOf(bool writing, const QString& all)
{
    QStringList lines, endings;
    for (const FileFormat& f : fileFormats()) {
        if (writing ? !f.writes : !f.reads) continue;
        QStringList own;
        for (const auto& e : f.extensions) own << "*" + QString::fromStdString(e);
        lines << QString::fromStdString(f.name) + " (" + own.join(' ') + ")";
        endings << own;
    }
    if (!all.isEmpty()) lines.prepend(all + " (" + endings.join(' ') + ")");
    return lines.join(";;");
}

std::vector<NodeId> withMesh(const Scene& scene)
{
    for (NodeId n : scene.nodes())
        if (scene.node(n).mesh || scene.node(n).terrain) return {n};
    return {};
}

// In the worker: what drawing needs, and the numbers the panels show at once.
void warmAll(const Scene& scene)
{
    for (MeshId id : scene.meshes()) warm(scene.find(id)->base);
}

}  // namespace

FileCommands::FileCommands(Session& session, QWidget* window) : QObject(window), session_(session), window_(window) {}

QString FileCommands::readFilter()
{
    return filterOf(false, "All readable files");
}

QString FileCommands::title() const
{
    const auto& file = session_.document.file();
    return file.empty() ? "Untitled" : nameOf(QString::fromStdU16String(file.u16string()));
}

void FileCommands::open(const QString& file)
{
    session_.jobs.start(
        "Open " + nameOf(file),
        [this, file](Progress& progress) -> std::function<void()> {
            auto read = std::make_shared<Imported>(readFile(pathOf(file), &progress));
            warmAll(read->scene);
            return [this, file, read] {
                session_.steps.close();
                session_.view.shownLevel.clear();
                project_ = read->project;
                const auto nodes = withMesh(read->scene);
                session_.document.open(std::move(read->scene), pathOf(file), "Open " + nameOf(file).toStdString());
                if (!nodes.empty()) session_.document.select({nodes, {}, {}});
                remember(file);
                emit opened();
                const QString units = read->units == "unknown" || read->units.empty() ? "in metres (the file does not say)"
                                                                                      : "in " + QString::fromStdString(read->units);
                emit notice(QString("Read %1 as %2, %3.").arg(nameOf(file), QString::fromStdString(read->format), units), read->warnings);
            };
        },
        [this](const QString& text) { emit trouble(text + " The open scene is as it was."); });
}

void FileCommands::openScene(Scene scene, const QString& historyName)
{
    session_.steps.close();
    session_.view.shownLevel.clear();
    project_ = false;
    const auto nodes = withMesh(scene);
    session_.document.open(std::move(scene), {}, historyName.toStdString());
    if (!nodes.empty()) session_.document.select({nodes, {}, {}});
    emit opened();
}

void FileCommands::import(const QStringList& files)
{
    for (const QString& file : files)
        session_.jobs.start(
            "Import " + nameOf(file),
            [this, file](Progress& progress) -> std::function<void()> {
                auto read = std::make_shared<Imported>(readFile(pathOf(file), &progress));
                warmAll(read->scene);
                return [this, file, read] {
                    Scene next = session_.document.scene();
                    if (read->scene.meshes().empty() && takeMotion(file, *read)) return;
                    const std::vector<NodeId> roots = next.merge(read->scene);
                    session_.document.commit("Import " + nameOf(file).toStdString(), std::move(next), {roots, {}, {}});
                    remember(file);
                    emit added(roots);
                    emit notice("Added " + nameOf(file) + " to the scene.", read->warnings);
                };
            },
            [this](const QString& text) { emit trouble(text + " The open scene is as it was."); });
}

// A file of motion alone goes to the character it is for, when there is one.
bool FileCommands::takeMotion(const QString& file, const Imported& read)
{
    Scene next = session_.document.scene();
    const std::vector<ClipId> clips = adoptClips(next, read.scene);
    if (clips.empty()) return false;
    session_.document.commit("Import motion " + nameOf(file).toStdString(), std::move(next));
    session_.view.clip = clips.front();
    session_.view.setTime(0);
    session_.view.touch();
    remember(file);
    emit notice("Added the motion of " + nameOf(file) + " to the character.", read.warnings);
    return true;
}

void FileCommands::saveTo(const QString& file, std::function<void()> then)
{
    const auto scene = session_.document.snapshot();
    session_.jobs.start(
        "Save " + nameOf(file),
        [this, file, scene, then, evaluator = session_.evaluations->evaluator()](Progress& progress) -> std::function<void()> {
            const auto lost = writeFile(*scene, pathOf(file), {.project = true, .evaluator = evaluator.get()}, &progress);
            return [this, file, scene, then, lost] {
                project_ = true;
                if (session_.document.snapshot() == scene) session_.document.saved(pathOf(file));
                remember(file);
                emit notice("Saved " + nameOf(file) + ".", lost);
                if (then) then();
            };
        },
        [this](const QString& text) { emit trouble("Not saved. " + text); });
}

void FileCommands::exportTo(const QString& file)
{
    const auto scene = session_.document.snapshot();
    session_.jobs.start(
        "Export " + nameOf(file),
        [this, file, scene, evaluator = session_.evaluations->evaluator()](Progress& progress) -> std::function<void()> {
            const auto lost = writeFile(*scene, pathOf(file), {.evaluator = evaluator.get()}, &progress);
            return [this, file, lost] { emit notice("Exported " + nameOf(file) + ".", lost); };
        },
        [this](const QString& text) { emit trouble("Not exported. " + text); });
}

void FileCommands::openDialog()
{
    const QString file = QFileDialog::getOpenFileName(window_, "Open", {}, readFilter());
    if (!file.isEmpty()) whenSaved([this, file] { open(file); });
}

void FileCommands::importDialog()
{
    const QStringList files = QFileDialog::getOpenFileNames(window_, "Import into the scene", {}, readFilter());
    if (!files.isEmpty()) import(files);
}

void FileCommands::save(std::function<void()> then)
{
    if (project_ && !session_.document.file().empty())
        saveTo(QString::fromStdU16String(session_.document.file().u16string()), std::move(then));
    else
        saveDialog(std::move(then));
}

void FileCommands::saveDialog(std::function<void()> then)
{
    QFileInfo now(QString::fromStdU16String(session_.document.file().u16string()));
    const QString proposed = session_.document.file().empty() ? "untitled.glb" : now.path() + "/" + now.completeBaseName() + ".glb";
    QString file = QFileDialog::getSaveFileName(window_, "Save project", proposed, "Meshwright project (*.glb)");
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += ".glb";
    saveTo(file, std::move(then));
}

void FileCommands::exportDialog()
{
    QString file =
        QFileDialog::getSaveFileName(window_, "Export the evaluated scene", QFileInfo(title()).completeBaseName() + ".glb", filterOf(true, {}));
    if (!file.isEmpty()) exportTo(QFileInfo(file).suffix().isEmpty() ? file + ".glb" : file);
}

void FileCommands::whenSaved(std::function<void()> then)
{
    if (!session_.document.modified()) return then();
    QMessageBox box(QMessageBox::Question, "Unsaved changes", "Save the changes to " + title() + " first?",
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) save(std::move(then));
    if (answer == QMessageBox::Discard) then();
}

QStringList FileCommands::recent() const
{
    return QSettings().value("files/recent").toStringList();
}

void FileCommands::findRecent(const QString& file)
{
    const QString now = QFileDialog::getOpenFileName(window_, "Where is " + nameOf(file) + " now?", QFileInfo(file).path(), readFilter());
    QStringList all = recent();
    all.removeAll(file);
    QSettings().setValue("files/recent", all);
    emit recentChanged();
    if (!now.isEmpty()) whenSaved([this, now] { open(now); });
}

void FileCommands::remember(const QString& file)
{
    QStringList all = recent();
    const QString path = QFileInfo(file).absoluteFilePath();
    all.removeAll(path);
    all.prepend(path);
    QSettings().setValue("files/recent", QStringList(all.mid(0, 8)));
    emit recentChanged();
    emit remembered(path);
}

}  // namespace mw
