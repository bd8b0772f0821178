#include "ui/panels/view_section.h"

#include <cmath>
#include <numbers>

#include "render/environment.h"
#include "render/matcap.h"
#include "ui/panels/fold.h"
#include "ui/parameter_form.h"

namespace mw {
namespace {

template <class List>
std::vector<std::string> namesOf(const List& list)
{
    std::vector<std::string> names;
    for (const auto& one : list) names.push_back(one.name);
    return names;
}

/// Choices are known to the renderer only, so the rows are put together here.
std::vector<Parameter> rows()
{
    const auto choice = [](const char* name, std::vector<std::string> names, About about) {
        return Parameter{name, ParameterType::Choice, names.front(), std::move(about), names};
    };
    std::vector<Parameter> all;
    all.push_back(choice("light", {"three-point", "environment"},
                         {.title = "Light", .help = "Three lamps that turn with the camera, or light from all round."}));
    all.push_back(choice("environment", namesOf(environments()),
                         {.title = "Environment", .help = "What is mirrored and lights from around.", .when = "light=environment"}));
    all.push_back(
        {"turn",
         ParameterType::Number,
         0.0,
         {.title = "Turn", .help = "The environment about the vertical.", .unit = "°", .min = -180, .max = 180, .when = "light=environment"},
         {}});
    all.push_back({"shadows", ParameterType::Flag, false, {.title = "Shadows", .help = "Of the key light, on objects and on the ground."}, {}});
    all.push_back(
        {"checker", ParameterType::Flag, false, {.title = "Checker", .help = "Squares by texture coordinate in place of the base colour."}, {}});
    all.push_back(choice("matcap", namesOf(matcaps()), {.title = "Matcap", .help = "The sphere that matcap shading looks up."}));
    all.push_back(
        choice("normals", {"area", "angle", "plain"},
               {.title = "Normals",
                .help = "What a face counts in the normal of a vertex: its area, its angle there, or as much as any other. For meshes without "
                        "normals of their own."}));
    return all;
}

ParameterValues valuesOf(const ViewState& view)
{
    static constexpr const char* weights[] = {"area", "angle", "plain"};
    const ViewOptions& o = view.options;
    // Turns beyond half a turn are the same as those within.
    const double turn = std::remainder(o.environmentTurn * 180 / std::numbers::pi, 360.0);
    return {{"light", std::string(o.lighting == Lighting::Environment ? "environment" : "three-point")},
            {"environment", o.environment},
            {"turn", std::round(turn * 1e6) / 1e6},
            {"shadows", o.shadows},
            {"checker", o.checker},
            {"matcap", o.matcap},
            {"normals", std::string(weights[size_t(view.normalWeight)])}};
}

void apply(const ParameterValues& v, ViewState& view)
{
    const std::vector<Parameter> described = rows();
    const auto value = [&](size_t i) { return valueOf(described[i], v); };
    ViewOptions& o = view.options;
    o.lighting = std::get<std::string>(value(0)) == "environment" ? Lighting::Environment : Lighting::ThreePoint;
    o.environment = std::get<std::string>(value(1));
    o.environmentTurn = std::get<double>(value(2)) * std::numbers::pi / 180;
    o.shadows = std::get<bool>(value(3));
    o.checker = std::get<bool>(value(4));
    o.matcap = std::get<std::string>(value(5));
    const std::string weight = std::get<std::string>(value(6));
    view.normalWeight = weight == "plain" ? NormalWeight::Plain : weight == "angle" ? NormalWeight::Angle : NormalWeight::Area;
    view.touch();
}

}  // namespace

QWidget* makeViewSection(Session& session, QWidget* parent)
{
    auto* fold = new Fold("View", "view", false, parent);
    auto* form = new ParameterForm(rows(), valuesOf(session.view), fold);
    form->setObjectName("viewForm");
    fold->inside()->addWidget(form);
    QObject::connect(form, &ParameterForm::edited, fold, [&session](const ParameterValues& v) { apply(v, session.view); });
    QObject::connect(form, &ParameterForm::committed, fold, [&session](const ParameterValues& v) { apply(v, session.view); });
    QObject::connect(&session.view, &ViewState::changed, form, [&session, form] { form->setValues(valuesOf(session.view)); });
    return fold;
}

}  // namespace mw
