#include "ui/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>

#include "core/io/io.h"
#include "core/io/preflight.h"
#include "core/scene/adopt_clips.h"
#include "ui/edit_commands.h"
#include "ui/evaluation_service.h"
#include "ui/placement_words.h"
#include "ui/words.h"

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

// The edit that does the same from a shell.
EditCall importCall(const QString& file)
{
    EditCall call{"import", {{"file", pathOf(file).string()}}};
    const ImportOptions kept = FileCommands::keptPlacement(file);
    if (kept.metresPerUnit) call.values["unit"] = *kept.metresPerUnit;
    if (kept.up) call.values["up"] = std::string(*kept.up == UpAxis::Y ? "y" : *kept.up == UpAxis::Z ? "z" : "x");
    return call;
}

/// With a full stop, so that another sentence can follow.
QString ended(const QString& text)
{
    return text.endsWith('.') ? text : text + ".";
}

/// What makes a shell read a file the same way.
std::vector<std::string> readOptions(const ImportOptions& kept)
{
    std::vector<std::string> options;
    if (kept.metresPerUnit) options.insert(options.end(), {"--unit", QString::number(*kept.metresPerUnit, 'g', 17).toStdString()});
    if (kept.up) options.insert(options.end(), {"--up", *kept.up == UpAxis::Y ? "y" : *kept.up == UpAxis::Z ? "z" : "x"});
    return options;
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

void FileCommands::open(const QString& file, std::function<void()> then)
{
    session_.jobs.start(
        "Open " + nameOf(file),
        [this, file, then](Progress& progress) -> std::function<void()> {
            auto read = std::make_shared<Imported>(readFile(pathOf(file), &progress, keptPlacement(file)));
            warmAll(read->scene);
            return [this, file, read, then] {
                session_.steps.close();
                session_.view.shownLevel.clear();
                project_ = read->project;
                const auto nodes = withMesh(read->scene);
                session_.document.open(std::move(read->scene), pathOf(file), "Open " + nameOf(file).toStdString(),
                                       {pathOf(file).string(), readOptions(keptPlacement(file))});
                if (!nodes.empty()) session_.document.select({nodes, {}, {}});
                remember(file);
                emit opened();
                sayRead("Read", file, *read, session_.document.scene().roots());
                if (then) then();
            };
        },
        [this](const QString& text) { emit trouble(ended(text) + " The open scene is as it was."); });
}

void FileCommands::openAll(const QStringList& files)
{
    if (files.isEmpty()) return;
    open(files.front(), [this, rest = files.mid(1)] { import(rest); });
}

bool FileCommands::showsWelcomeScene() const
{
    const auto& history = session_.document.history();
    return session_.document.scene().nodes().empty() || (history.size() == 1 && history.front().name == "Welcome scene");
}

void FileCommands::sayRead(const QString& verb, const QString& file, const Imported& read, const std::vector<NodeId>& roots)
{
    if (read.project || (read.scene.meshes().empty() && !read.scene.terrains().empty()))  // metres by their nature
        return emit notice(QString("%1 %2.").arg(verb, nameOf(file)), read.warnings);
    const ImportOptions kept = keptPlacement(file);
    const bool chosen = kept.up || kept.metresPerUnit;
    const QString who = chosen ? "chosen for such files" : read.placementFromFile ? "from the file" : "assumed";
    emit notice(QString("%1 %2 (%3) as %4 (%5).").arg(verb, nameOf(file), QString::fromStdString(read.format), placementText(read.placement), who),
                read.warnings);
    emit placed(file, read.placement, read.placementFromFile, roots);
}

ImportOptions FileCommands::keptPlacement(const QString& file)
{
    QSettings settings;
    const QString key = "import/" + QFileInfo(file).suffix().toLower();
    if (!settings.contains(key + "/unit")) return {};
    const double unit = settings.value(key + "/unit").toDouble();
    const int up = settings.value(key + "/up").toInt();
    if (!(unit > 0 && unit < 1e9) || up < 0 || up > 2) return {};
    return {unit, UpAxis(up)};
}

void FileCommands::keepPlacement(const QString& file, const Placement& placement)
{
    const QString key = "import/" + QFileInfo(file).suffix().toLower();
    QSettings().setValue(key + "/unit", placement.metresPerUnit);
    QSettings().setValue(key + "/up", int(placement.up));
}

void FileCommands::openScene(Scene scene, const QString& historyName, const QString& sample)
{
    session_.steps.close();
    session_.view.shownLevel.clear();
    project_ = false;
    const auto nodes = withMesh(scene);
    session_.document.open(std::move(scene), {}, historyName.toStdString(), {sample.toStdString(), {}});
    if (!nodes.empty()) session_.document.select({nodes, {}, {}});
    emit opened();
}

// One after the other: each is an edit of the scene that the one before has left.
void FileCommands::import(const QStringList& files)
{
    for (const QString& file : files)
        session_.jobs.start(
            "Import " + nameOf(file),
            [this, file](Progress& progress) -> std::function<void()> {
                auto read = std::make_shared<Imported>(readFile(pathOf(file), &progress, keptPlacement(file)));
                warmAll(read->scene);
                return [this, file, read] {
                    Scene next = session_.document.scene();
                    if (read->scene.meshes().empty() && takeMotion(file, *read)) return;
                    const std::vector<NodeId> roots = next.merge(read->scene);
                    session_.document.commit("Import " + nameOf(file).toStdString(), std::move(next), {roots, {}, {}}, {importCall(file)});
                    remember(file);
                    emit added(roots);
                    sayRead("Added", file, *read, roots);
                };
            },
            [this](const QString& text) { emit trouble(ended(text) + " The open scene is as it was."); });
}

// A file of motion alone goes to the character it is for, when there is one.
bool FileCommands::takeMotion(const QString& file, const Imported& read)
{
    Scene next = session_.document.scene();
    const std::vector<ClipId> clips = adoptClips(next, read.scene);
    if (clips.empty()) return false;
    session_.document.commit("Import motion " + nameOf(file).toStdString(), std::move(next), {importCall(file)});
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

void FileCommands::exportTo(const QString& file, const WriteOptions& options, bool onlySelected)
{
    const auto whole = session_.document.snapshot();
    const std::vector<NodeId> selected = session_.document.selection().nodes;
    session_.jobs.start(
        "Export " + nameOf(file),
        [this, file, whole, selected, options, onlySelected,
         evaluator = session_.evaluations->evaluator()](Progress& progress) -> std::function<void()> {
            const Scene scene = onlySelected ? onlyNodes(*whole, selected) : *whole;
            WriteOptions o = options;
            o.evaluator = evaluator.get();
            const auto lost = writeFile(scene, pathOf(file), o, &progress);
            const ExportedAmount amount =
                amountOf(scene, [&](MeshId id) { return evaluator->evaluate(*scene.find(id), &progress, {}, &scene).result(); });
            return [this, file, lost, amount] {
                QStringList parts;
                if (amount.meshes) parts << counted(amount.meshes, "mesh", "meshes") << counted(amount.faces, "face", "faces");
                if (amount.terrains) parts << counted(amount.terrains, "terrain", "terrains");
                if (amount.clips) parts << counted(amount.clips, "clip", "clips");
                parts << sizeText(QFileInfo(file).size());
                emit notice("Exported " + nameOf(file) + ": " + parts.join(", ") + ".", lost);
            };
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
    emit exportWanted();
}

QString FileCommands::writeFilter()
{
    return filterOf(true, {});
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
