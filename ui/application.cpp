#include "ui/application.h"

#include <QApplication>
#include <QPalette>
#include <QSurfaceFormat>
#include <clocale>

#include "ui/theme.h"

namespace mw {

void prepareApplication()
{
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);  // a floated dock keeps its context
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
}

void dressApplication(QApplication& app)
{
    std::setlocale(LC_NUMERIC, "C");
    QCoreApplication::setOrganizationName("meshwright");
    QCoreApplication::setApplicationName("meshwright");
    QGuiApplication::setApplicationDisplayName({});
    followSystemPalette(app.palette());
    chooseTheme(app, themeChoice());
}

}  // namespace mw
