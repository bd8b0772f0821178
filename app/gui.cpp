// Starts the window: the files named are opened, with none there is a scene to begin with.
#include <QApplication>

#include "ui/application.h"
#include "ui/file_commands.h"
#include "ui/main_window.h"

int runGui(int argc, char** argv)
{
    mw::prepareApplication();
    QApplication app(argc, argv);
    mw::dressApplication(app);
    mw::MainWindow window;
    const QStringList files = app.arguments().mid(1);
    window.show();
    if (files.isEmpty())
        window.showWelcome();
    else
        window.files().openAll(files);
    return app.exec();
}
