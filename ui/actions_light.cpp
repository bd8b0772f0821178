// Lights, matcaps, and pictures of what the view shows.
#include <QActionGroup>
#include <glm/gtc/constants.hpp>

#include "render/environment.h"
#include "render/matcap.h"
#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include "ui/actions.h"
#include "ui/pictures.h"

namespace mw {

void Actions::makeLight()
{
    ViewState& view = s_.view;
    auto* group = new QActionGroup(window_);
    const auto addLight = [&](const QString& title, const QString& about, const QString& environment) {
        auto* a = make(title, "", "", about, [&view, environment] {
            view.options.lighting = environment.isEmpty() ? Lighting::ThreePoint : Lighting::Environment;
            if (!environment.isEmpty()) view.options.environment = environment.toStdString();
            view.touch();
        });
        a->setCheckable(true);
        a->setData(environment);
        group->addAction(a);
        lights << a;
    };
    addLight("Three lights", "A key light, a fill and a rim that go with the camera", {});
    for (const Environment& e : environments()) addLight(e.title, e.about, e.name);
    turnLight = make("Turn light 30\u00b0", "", "", "Turn the surroundings about the upright axis; the three lights go with the camera", [&view] {
        view.options.environmentTurn = std::fmod(view.options.environmentTurn + glm::radians(30.0), glm::two_pi<double>());
        view.touch();
    });
    shadows = toggle("Shadows", "", "", "Of the brightest light, on objects and on the ground", &ViewOptions::shadows);
    checker = toggle("Checker", "", "", "Squares by texture coordinates in place of the colour: ten a unit", &ViewOptions::checker);

    auto* spheres = new QActionGroup(window_);
    for (const Matcap& m : mw::matcaps()) {
        auto* a = make(m.title, "", "", QString("Shade as a sphere of this: %1").arg(QString(m.title).toLower()), [&view, name = m.name] {
            view.options.shading = Shading::Matcap;
            view.options.matcap = name;
            view.touch();
        });
        a->setCheckable(true);
        a->setData(QString(m.name));
        spheres->addAction(a);
        matcaps << a;
    }
    picture = make("Save picture...", "picture", "", "Save what the view shows as PNG, in any size", [this] { askPicture(s_, viewport(), window_); });
    turntable = make("Save turntable...", "", "", "Save pictures of the scene as it turns once before the camera",
                     [this] { askTurntable(s_, viewport(), window_); });
}

void Actions::refreshLight()
{
    const ViewOptions& o = s_.view.options;
    const QString name = o.lighting == Lighting::Environment ? QString::fromStdString(o.environment) : QString();
    for (QAction* a : lights) a->setChecked(a->data().toString() == name);
    for (QAction* a : matcaps) a->setChecked(o.shading == Shading::Matcap && a->data().toString().toStdString() == o.matcap);
    turnLight->setEnabled(o.lighting == Lighting::Environment);
}

}  // namespace mw
