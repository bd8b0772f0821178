// The card over the view at first start: open, recent files, samples, lessons. Any edit, drop or Esc closes it.
#pragma once
#include <QFrame>

#include "ui/file_commands.h"

class QGridLayout;

namespace mw {

class ThumbnailMaker;

class WelcomeCard : public QFrame {
    Q_OBJECT

public:
    WelcomeCard(Session& session, FileCommands& files, QWidget* parent);
    /// The part of the parent above the card: the model belongs there.
    int freeHeight() const { return y(); }

signals:
    void lessonsWanted();
    void newTerrainWanted();
    void hidden();

protected:
    void keyPressEvent(QKeyEvent* e) override;
    void hideEvent(QHideEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void place();
    QWidget* head();
    QWidget* recentFiles();
    QWidget* sampleScenes();
    QWidget* lessons();
    void refill();
    Session& session_;
    FileCommands& files_;
    ThumbnailMaker* pictures_;
    QWidget* content_ = nullptr;
    std::shared_ptr<void> subscription_;
};

}  // namespace mw
