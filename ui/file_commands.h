// Opening, importing, saving, exporting: each as a job; the open scene stays when one does not succeed.
#pragma once
#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>

#include "core/io/io.h"
#include "ui/session.h"

class QWidget;

namespace mw {

class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Session& session, QWidget* window);

    // Without dialogs: these return at once, a job does the rest.
    void open(const QString& file, std::function<void()> then = {});
    void openAll(const QStringList& files);  ///< the first one, then the others are added to it
    void import(const QStringList& files);   ///< adds to the scene
    void saveTo(const QString& file, std::function<void()> then = {});
    void exportTo(const QString& file, const WriteOptions& options = {}, bool onlySelected = false);
    /// `sample`: the name that stands for it on a command line ("sample:rock").
    void openScene(Scene scene, const QString& historyName, const QString& sample = {});

    // With dialogs.
    void openDialog();
    void importDialog();
    void save(std::function<void()> then = {});
    void saveDialog(std::function<void()> then = {});
    void exportDialog();
    /// Asks about unsaved work, then goes on, now or after saving; not at all when the user stays.
    void whenSaved(std::function<void()> then);

    QStringList recent() const;
    /// Asks where a recent file has gone to; it then takes its place in the list, or leaves it.
    void findRecent(const QString& file);
    static QString readFilter();
    static QString writeFilter();
    /// What the user chose for files of this ending, last time; nothing: as the file says.
    static ImportOptions keptPlacement(const QString& file);
    static void keepPlacement(const QString& file, const Placement& placement);
    /// Nothing but what the program showed at its start: a dropped file takes its place.
    bool showsWelcomeScene() const;
    /// The name of what is open, for the title.
    QString title() const;

signals:
    void opened();  ///< another scene is there
    void added(std::vector<mw::NodeId> nodes);
    void trouble(const QString& text);                                           ///< could not; the scene is as it was
    void notice(const QString& text, const std::vector<mw::Warning>& warnings);  ///< done
    /// A file has been read: what its numbers were taken for, and by whom. `roots` are what came in.
    void placed(const QString& file, const mw::Placement& placement, bool fromFile, const std::vector<mw::NodeId>& roots);
    void exportWanted();
    void recentChanged();
    void remembered(const QString& file);  ///< opened or saved

private:
    void remember(const QString& file);
    bool takeMotion(const QString& file, const Imported& read);
    void sayRead(const QString& verb, const QString& file, const Imported& read, const std::vector<NodeId>& roots);
    Session& session_;
    QWidget* window_;
    bool project_ = false;  // the open file is one of ours
};

}  // namespace mw
