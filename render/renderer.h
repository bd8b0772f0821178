// Draws a frame (objects, options, overlays) into the bound framebuffer. OpenGL 4.1 core through libepoxy; no Qt. The window gives it a
// context, the command line makes one by surfaceless EGL (render/offscreen.h). Nothing unchanged is uploaded again.
#pragma once
#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/table.h"
#include "core/scene/scene.h"
#include "core/scene/scene_pose.h"
#include "core/steps/stepper.h"
#include "render/camera.h"

namespace mw {

enum class Shading { Smooth, Flat, Wire, Matcap };
enum class Lighting { ThreePoint, Environment };
enum class Theme { Dark, Light };

/// Values of a table on a mesh, as colours.
struct HeatMap {
    std::shared_ptr<const Table> table;
    size_t column = 0;
    double low = 0, high = 1;  ///< the range shown; see heatRange()
    bool shared = false;       ///< that range is the one of all views side by side; the legend says so
};
/// 2nd to 98th percentile, or all when that is empty.
std::pair<double, double> heatRange(const Column& column);

/// The pictures of a material, encoded (PNG, JPEG), shared with the scene; null: none.
enum PictureUse : size_t { basePicture, roughnessPicture, normalPicture, occlusionPicture, emissivePicture, pictureUses };
using EncodedPicture = std::shared_ptr<const std::vector<uint8_t>>;
using MaterialPictures = std::array<EncodedPicture, pictureUses>;

/// One node to draw.
struct DrawObject {
    NodeId node;
    glm::dmat4 worldFromLocal{1};
    Mesh mesh;
    std::vector<std::shared_ptr<const Material>> materials;  ///< by slot; may be empty
    std::vector<MaterialPictures> pictures;                  ///< by slot; may be shorter
    std::shared_ptr<const HeatMap> heat;
    std::shared_ptr<const MeshPose> pose;  ///< null: as the mesh is; skinned ones stand by their joints, worldFromLocal is then identity
    bool selected = false, hovered = false, dimmed = false;
};

/// One bone: from a joint to where it ends. Drawn through what hides it.
struct DrawBone {
    NodeId node;                 ///< the joint it turns with
    glm::vec3 head{0}, tail{0};  ///< world; equal for a joint without a child
    glm::vec4 color{1};          ///< sRGB
    bool selected = false, hovered = false;
};

/// A terrain, drawn in patches that are tessellated by their distance.
struct DrawTerrain {
    NodeId node;
    glm::dmat4 worldFromLocal{1};
    Terrain terrain;
    bool textured = true;  ///< layers by height; else clay
    enum class Overlay { None, PatchBorders, Level, Slope } overlay = Overlay::None;
    /// What a stroke would reach, draped on the ground.
    struct BrushMark {
        glm::dvec2 at{0};                         ///< x, z, local
        double radius = 1, halfStrengthAt = 0.5;  ///< metres; the inner ring
    };
    std::optional<BrushMark> brush = {};
    bool selected = false, hovered = false;
};

/// Elements marked on one object: selection, hover, offenders, or the focus of a step.
struct Mark {
    NodeId node;
    ElementKind kind = ElementKind::Vertex;
    std::vector<uint32_t> indices;  ///< edges: vertex pairs
    glm::vec4 color{1};             ///< sRGB, as in ui/UI.md
    float width = 2;                ///< of lines, or diameter of discs, logical pixels
    enum class Style { Solid, Dashed, Hatched, Plus } style = Style::Solid;
    bool through = false;  ///< drawn through what hides it
};
struct Label {
    glm::vec3 atWorld;
    std::string text;
    glm::vec4 color{1};
};
/// A point, or a segment, given by place.
struct MarkPoint {
    glm::vec3 atWorld;
    glm::vec4 color{1};
    float diameter = 8;                ///< or width of the line, logical pixels
    std::optional<glm::vec3> toWorld;  ///< makes it a segment
    bool dashed = false;
    bool through = false;  ///< drawn through what hides it
};

/// Something flat over the picture, in logical pixels from the top left: handles of tools, a lasso, a number at the pointer.
struct Flat {
    enum class Kind { Line, Disc, Quad, Text } kind = Kind::Line;
    std::vector<glm::vec2> at;  ///< line: its points; disc: centre; quad: four corners, convex; text: the middle of its left side
    glm::vec4 color{1};         ///< sRGB
    float width = 2;            ///< of the line; diameter of the disc
    bool halo = true;           ///< dark, so that it shows on anything
    std::string text = {};      ///< on a dark plate
};

/// A part of the picture, in device pixels from the top left; `high` is outside.
struct Region {
    glm::ivec2 low{0}, high{0};
    std::vector<uint8_t> mask = {};  ///< row by row, not 0 inside; empty: the whole rectangle
    bool contains(glm::dvec2 pixel) const;
};
/// What a closed line encloses (even-odd), cut to a picture of this size.
Region polygonRegion(const std::vector<glm::dvec2>& corners, glm::ivec2 size);

struct ViewOptions {
    Shading shading = Shading::Smooth;
    Theme theme = Theme::Dark;
    bool wireOverlay = false, xray = false, grid = true, axes = true, orientationMarker = true, legend = true;
    bool transparentBackground = false;
    bool normalsNeedles = false, faceNeedles = false;  ///< at vertices, at the middles of faces
    Lighting lighting = Lighting::ThreePoint;
    std::string environment = "studio";  ///< one of render/environment.h
    double environmentTurn = 0;          ///< radians about +Y
    bool shadows = false;                ///< of the key light, on objects and on the ground
    bool checker = false;                ///< squares by texture coordinate in place of the base colour
    std::string matcap = "clay";         ///< name of the sphere that Shading::Matcap looks up
    int samples = 4;                     ///< wanted multisampling of off-screen pictures
    double pixelRatio = 1;               ///< device pixels a logical pixel
};

struct Frame {
    Camera camera;
    uint64_t scene = 0;  ///< the same in two frames: they differ in camera, marks, points, labels and flats alone; 0: nothing is known
    ViewOptions options;
    std::vector<DrawObject> objects = {};
    std::vector<DrawTerrain> terrains = {};
    std::vector<DrawBone> bones = {};
    std::vector<Mark> marks = {};
    std::vector<MarkPoint> points = {};
    std::vector<Label> labels = {};
    std::vector<Flat> flats = {};
};

/// All visible nodes of a scene at a pose. `shown` gives the mesh to draw of each mesh object.
Frame frameOf(const Scene& scene, const std::function<Mesh(MeshId)>& shown, const ScenePose& pose = {});
Bounds boundsOf(const Frame& frame);
/// Moves the frame's camera, without turning it, to where everything just fits; closer than Camera::frame, which only knows a box.
void frameTightly(Frame& frame, double aspect);

/// What lies under a pixel.
struct Pick {
    NodeId node;
    uint32_t face = none;         ///< payload face at the pixel; none when it is beside the surface or on a loose point
    uint32_t vertex = none;       ///< nearest visible vertex within the tolerance
    glm::uvec2 edge{none, none};  ///< nearest visible edge within the tolerance, lower vertex first
    glm::dvec3 atWorld{0};
};

class Renderer {
public:
    /// A context must be current, here and in every call. Throws Error when it is older than 4.1 or a shader does not compile.
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;

    /// Draws into framebuffer `target`, `size` in device pixels.
    void draw(const Frame& frame, unsigned target, glm::ivec2 size);
    /// What is at a pixel (device pixels, origin top left) or, of vertices and edges, near it; tolerances as in ui/UI.md 3. Cheap while
    /// camera and objects stay as they are. Leaves another framebuffer bound.
    std::optional<Pick> pick(const Frame& frame, glm::ivec2 size, glm::dvec2 pixel);
    /// All faces visible in a region, ascending, by node; a terrain without faces.
    std::vector<std::pair<NodeId, std::vector<uint32_t>>> visibleFaces(const Frame& frame, glm::ivec2 size, const Region& region);
    /// Triangles and vertices of the last picture, and bytes uploaded for it.
    struct Counts {
        size_t triangles = 0, vertices = 0, uploadedBytes = 0;
        bool kept = false;  ///< what lies beneath the marks was drawn before
    };
    Counts counts() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace mw
