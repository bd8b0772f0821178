// Opening, importing, saving, exporting: each as a job; the open scene stays when one does not succeed.
#pragma once
#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>

#include "core/error.h"
#include "ui/session.h"

class QWidget;

namespace mw {

struct Imported;

class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Session& session, QWidget* window);

    // Without dialogs: these return at once, a job does the rest.
    void open(const QString& file);
    void import(const QStringList& files);  ///< adds to the scene
    void saveTo(const QString& file, std::function<void()> then = {});
    void exportTo(const QString& file);
    void openScene(Scene scene, const QString& historyName);

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
    /// The name of what is open, for the title.
    QString title() const;

signals:
    void opened();  ///< another scene is there
    void added(std::vector<mw::NodeId> nodes);
    void trouble(const QString& text);                                           ///< could not; the scene is as it was
    void notice(const QString& text, const std::vector<mw::Warning>& warnings);  ///< done
    void recentChanged();
    void remembered(const QString& file);  ///< opened or saved

private:
    void remember(const QString& file);
    bool takeMotion(const QString& file, const struct Imported& read);
    Session& session_;
    QWidget* window_;
    bool project_ = false;  // the open file is one of ours
};

}  // namespace mw
