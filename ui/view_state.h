// What is looked at, and how: no part of the document or its history. Panels and viewport share it.
#pragma once
#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "core/scene/document.h"
#include "core/terrain/brush.h"
#include "render/renderer.h"

namespace mw {

enum class PickKind { Object, Vertex, Edge, Face, Joint };

class ViewState : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    Camera camera;
    ViewOptions options;
    PickKind pickKind = PickKind::Object;
    QString colourBy;                     ///< id of a query operation ("vertex-valence"), or empty: material
    std::map<MeshId, size_t> shownLevel;  ///< 0 base .. n; absent: the result
    NodeId hovered;
    std::vector<Mark> flashes;  ///< marks panels put into the view (offenders under the mouse)
    bool dimOthers = false;     ///< everything but marked elements at 35 %

    // Time: which clip poses the scene, and where its playhead stands. ui/playback.h moves it.
    ClipId clip;      ///< none: the scene rests
    double time = 0;  ///< seconds
    bool showBones = true, showMeshes = true;

    // Terrain: the brush in hand, what is drawn over the ground, and the place under the pointer.
    Brush brush;
    bool brushInHand = false;
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
    void touchBrush() { emit brushChanged(); }  ///< after setting the brush or taking it in hand

    void touch() { emit changed(); }  ///< after setting any of the above
    void frameNodes(std::vector<NodeId> nodes) { emit frameRequested(std::move(nodes)); }
    void frameBounds(const Bounds& world) { emit boundsRequested(world); }

    void setTime(double seconds)
    {
        time = seconds;
        emit timeChanged();
    }

signals:
    void changed();
    void brushChanged();
    void groundChanged();                                ///< the place under the pointer
    void timeChanged();                                  ///< clip or playhead alone
    void frameRequested(std::vector<mw::NodeId> nodes);  ///< empty: all
    void boundsRequested(const mw::Bounds& world);
};

}  // namespace mw
