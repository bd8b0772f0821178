// What is looked at, and how: no part of the document or its history. Panels and viewport share it.
#pragma once
#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "core/mesh/weighted_normals.h"
#include "core/scene/document.h"
#include "core/terrain/brush.h"
#include "render/renderer.h"

namespace mw {

enum class PickKind { Object, Vertex, Edge, Face, Joint };

/// What a press or a drag in the view does.
enum class ToolKind { Select, Box, Lasso, Move, Rotate, Scale, Measure, Brush, Collapse, Cut };

/// A level that stands for the variant of the last modifier that a view shows.
constexpr size_t variantLevel = size_t(-1);

/// What each of several views side by side has for itself.
struct ViewSettings {
    Camera camera;
    ViewOptions options;
    QString colourBy;                     ///< id of a query operation ("vertex-valence"), or empty: material
    std::map<MeshId, size_t> shownLevel;  ///< 0 base .. n, or variantLevel; absent: the result
    std::map<MeshId, Modifier> variant;   ///< in place of the last modifier, while the level is variantLevel
    bool showBones = true, showMeshes = true;
    /// How smooth shading and needles weigh the faces at a vertex, on meshes without normals of their own.
    NormalWeight normalWeight = NormalWeight::Area;
};

/// The settings it inherits are those of the active view: the one used last. Panels and actions speak to that one.
class ViewState : public QObject, public ViewSettings {
    Q_OBJECT

public:
    using QObject::QObject;

    // Views side by side.
    int views() const { return int(settings_.size()); }
    int activeView() const { return active_; }
    ViewSettings& of(int view) { return view == active_ ? *this : settings_[size_t(view)]; }
    const ViewSettings& of(int view) const { return view == active_ ? *this : settings_[size_t(view)]; }
    void setViews(int count);  ///< new ones begin as the active one is; the first stays
    void activate(int view);
    bool linked = true;     ///< cameras move together
    void follow(int view);  ///< after moving the camera of a view: the others come along when linked

    // Tools.
    ToolKind tool = ToolKind::Select;
    bool localAxes = false;    ///< handles along the node's own axes; else along the world's
    bool pivotCentre = false;  ///< about the middle of the selection; else each about its own origin
    void take(ToolKind kind);  ///< in hand

    PickKind pickKind = PickKind::Object;
    NodeId hovered;
    std::vector<Mark> flashes;  ///< marks panels put into the view (offenders under the mouse)
    bool dimOthers = false;     ///< everything but marked elements at 35 %
    /// What a panel draws at elements it explains: arrows, letters. Places are the world's. Not while stepping.
    struct Sketch {
        std::vector<Mark> marks;
        std::vector<MarkPoint> points;
        std::vector<Label> labels;
    } sketch;

    // Time: which clip poses the scene, and where its playhead stands. ui/playback.h moves it.
    ClipId clip;      ///< none: the scene rests
    double time = 0;  ///< seconds

    // Terrain: the brush in hand, what is drawn over the ground, and the place under the pointer.
    Brush brush;
    DrawTerrain::Overlay groundOverlay = DrawTerrain::Overlay::None;
    struct GroundPlace {
        NodeId node;
        glm::dvec3 local{0};
        double distance = 0;  ///< from the eye to the centre of the patch, metres
        int level = 0;        ///< of the patch inside
        size_t triangles = 0;
        bool operator==(const GroundPlace&) const = default;
    };
    std::optional<GroundPlace> ground;

    void setGround(std::optional<GroundPlace> place)
    {
        if (place == ground) return;
        ground = std::move(place);
        emit groundChanged();
    }
    void touchBrush() { emit brushChanged(); }  ///< after setting the brush

    void touch();  ///< after setting any of the above
    void frameNodes(std::vector<NodeId> nodes) { emit frameRequested(std::move(nodes)); }
    void frameBounds(const Bounds& world) { emit boundsRequested(world); }

    void setTime(double seconds)
    {
        time = seconds;
        emit timeChanged();
    }

signals:
    void changed();
    void camerasFollowed();  ///< other views than the one moved have a new camera
    void viewsChanged();     ///< how many there are, or which one is active
    void toolChanged();      ///< the tool in hand; brushChanged() follows
    void brushChanged();
    void groundChanged();                                ///< the place under the pointer
    void timeChanged();                                  ///< clip or playhead alone
    void frameRequested(std::vector<mw::NodeId> nodes);  ///< empty: all
    void boundsRequested(const mw::Bounds& world);

private:
    std::vector<ViewSettings> settings_ = std::vector<ViewSettings>(1);  // that of the active view is out of date
    int active_ = 0;
};

}  // namespace mw
