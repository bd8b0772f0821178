// Selection of elements: grown, along edges, by what they have in common (ui/UI.md 4).
#include <QMenu>
#include <QWidget>

#include "core/catalog/entries.h"
#include "core/repair/select_elements.h"
#include "ui/actions.h"
#include "ui/selection_popup.h"

namespace mw {
namespace {

using selecting::Find;

struct Bend {
    double angle = 20;
    template <class V>
    void describe(V& v)
    {
        v.number("angle", angle,
                 {.title = "Angle", .help = "The greatest bend between two faces that is crossed.", .unit = "°", .min = 0, .max = 180});
    }
};

struct Sharp {
    double angle = 30;
    template <class V>
    void describe(V& v)
    {
        v.number("angle", angle, {.title = "Angle", .help = "Edges whose faces bend more than this.", .unit = "°", .min = 0, .max = 180});
    }
};

struct Plane {
    double angle = 2, distance = 0.5;
    template <class V>
    void describe(V& v)
    {
        v.number("angle", angle, {.title = "Angle", .help = "Between the normals and that of the plane.", .unit = "°", .min = 0, .max = 90});
        v.number("distance", distance,
                 {.title = "Distance", .help = "From the plane, of the diagonal of the mesh.", .unit = "%", .min = 0, .max = 100, .softMax = 5});
    }
};

struct Valence {
    int64_t least = 7, most = 100;
    template <class V>
    void describe(V& v)
    {
        v.integer("least", least, {.title = "From", .help = "Fewest edges at a vertex.", .min = 0, .max = 1e6, .softMax = 20});
        v.integer("most", most, {.title = "To", .help = "Most edges at a vertex.", .min = 0, .max = 1e6, .softMax = 100});
    }
};

template <class P>
P with(const ParameterValues& given)
{
    return filled<P>(checked(described<P>(), given));
}

Find convertedTo(ElementKind kind, bool touching)
{
    return [kind, touching](const Mesh& m, const ElementSet& s, Progress&) { return converted(m, s, kind, touching); };
}

/// The edges that a walk begins at: those selected, or the sides of selected faces.
ElementSet edgesOf(const Mesh& m, const ElementSet& s)
{
    return converted(m, s, ElementKind::Edge);
}

// Checks of core/repair/defects.h as the menu names them.
struct Check {
    const char *id, *title;
};
constexpr Check checks[] = {{"holes", "Holes"},
                            {"nonmanifold-edges", "Non-manifold edges"},
                            {"nonmanifold-vertices", "Non-manifold vertices"},
                            {"orientation", "Inconsistent orientation"},
                            {"degenerate-faces", "Degenerate faces"},
                            {"duplicate-faces", "Duplicate faces"},
                            {"self-intersections", "Self-intersections"},
                            {"tiny-components", "Tiny components"},
                            {"coincident-vertices", "Coincident vertices"},
                            {"isolated-vertices", "Isolated vertices"}};

}  // namespace

void Actions::makeSelectElements()
{
    const auto add = [this](QList<QAction*>& list, const QString& text, const QString& key, const QString& tip, Find find) {
        list << make(text, "", key, tip, [this, text, find] { selecting::run(s_, text, find); });
    };
    add(growths, "Grow", "Ctrl++; Ctrl+=", "Take in the next ring of elements",
        [](const Mesh& m, const ElementSet& s, Progress&) { return grown(m, s); });
    add(growths, "One-ring", "", "The elements around the selection, without it",
        [](const Mesh& m, const ElementSet& s, Progress&) { return without(grown(m, s), s); });
    add(growths, "Two-ring", "", "The elements around the selection and those around them, without it",
        [](const Mesh& m, const ElementSet& s, Progress&) { return without(grown(m, grown(m, s)), s); });
    add(growths, "Shrink", "Ctrl+-", "Leave out the outermost ring", [](const Mesh& m, const ElementSet& s, Progress&) { return shrunk(m, s); });
    add(growths, "Connected", "Shift+L", "Everything that hangs together with the selection",
        [](const Mesh& m, const ElementSet& s, Progress&) { return connected(m, s); });
    add(growths, "Edge loop", "", "Follow the selected edges straight on; a double click on an edge does it, too",
        [](const Mesh& m, const ElementSet& s, Progress&) { return edgeLoop(m, edgesOf(m, s)); });
    add(growths, "Edge ring", "", "Follow the selected edges across quads",
        [](const Mesh& m, const ElementSet& s, Progress&) { return edgeRing(m, edgesOf(m, s)); });
    add(growths, "Boundary loop", "", "The boundary loops that the selection touches",
        [](const Mesh& m, const ElementSet& s, Progress&) { return boundaryLoops(m, s); });
    growths << make("Flat region...", "", "", "Flood over faces that bend less than an angle", [this] {
        selecting::showPopup(s_, viewArea_, "Flat region", described<Bend>(),
                             [](const Mesh& m, const ElementSet& s, const ParameterValues& v) { return flatRegion(m, s, with<Bend>(v).angle); });
    });
    growths << make("Coplanar faces...", "", "", "Faces anywhere in the plane of the selection", [this] {
        selecting::showPopup(s_, viewArea_, "Coplanar faces", described<Plane>(), [](const Mesh& m, const ElementSet& s, const ParameterValues& v) {
            const Plane p = with<Plane>(v);
            return coplanar(m, s, p.angle, p.distance / 100 * m.bounds().diagonal());
        });
    });

    add(conversions, "Vertices", "", "All vertices of the selection", convertedTo(ElementKind::Vertex, false));
    add(conversions, "Edges", "", "Edges that lie wholly in the selection", convertedTo(ElementKind::Edge, false));
    add(conversions, "Faces", "", "Faces that lie wholly in the selection", convertedTo(ElementKind::Face, false));
    add(conversions, "Edges touched", "", "Edges that have a part in the selection", convertedTo(ElementKind::Edge, true));
    add(conversions, "Faces touched", "", "Faces that have a part in the selection", convertedTo(ElementKind::Face, true));

    add(searches, "Boundary edges", "", "Edges with one face only",
        [](const Mesh& m, const ElementSet&, Progress&) { return boundary(m, ElementKind::Edge); });
    searches << make("Sharp edges...", "", "", "Edges whose faces bend more than an angle", [this] {
        selecting::showPopup(s_, viewArea_, "Sharp edges", described<Sharp>(),
                             [](const Mesh& m, const ElementSet&, const ParameterValues& v) { return sharpEdges(m, with<Sharp>(v).angle); });
    });
    searches << make("Vertices by valence...", "", "", "Vertices with so many edges", [this] {
        selecting::showPopup(s_, viewArea_, "Vertices by valence", described<Valence>(),
                             [](const Mesh& m, const ElementSet&, const ParameterValues& v) {
                                 const Valence p = with<Valence>(v);
                                 return ofValence(m, size_t(p.least), size_t(p.most));
                             });
    });
    for (const Check& c : checks)
        add(defects, c.title, "", QString("Select what the check \"%1\" finds").arg(c.title),
            [id = std::string(c.id)](const Mesh& m, const ElementSet&, Progress& p) { return elementsWithDefect(m, id, &p); });
}

void Actions::fillSelectElements(QMenu* menu)
{
    menu->addActions(growths);
    menu->addMenu("Convert to")->addActions(conversions);
    menu->addSeparator();
    menu->addActions(searches);
    menu->addMenu("By defect")->addActions(defects);
}

void Actions::refreshSelectElements()
{
    const Selection& selection = s_.document.selection();
    const bool mesh = selecting::activeMesh(s_).has_value(), some = mesh && !selection.elements.indices.empty();
    for (const QList<QAction*>& list : {growths, conversions})
        for (QAction* a : list) a->setEnabled(some);
    for (const QList<QAction*>& list : {searches, defects})
        for (QAction* a : list) a->setEnabled(mesh);
}

}  // namespace mw
