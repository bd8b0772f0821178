// The card over the view at first start: open, recent files, samples. Any edit, drop or Esc closes it.
#pragma once
#include <QFrame>

#include "ui/file_commands.h"

namespace mw {

class WelcomeCard : public QFrame {
    Q_OBJECT

public:
    WelcomeCard(Session& session, FileCommands& files, QWidget* parent);

protected:
    void keyPressEvent(QKeyEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    void place();
    std::shared_ptr<void> subscription_;
};

}  // namespace mw
