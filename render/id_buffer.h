// Which node and face is seen at each pixel. Drawn again only when camera, size or objects have changed, so that following the pointer
// costs a read of a few pixels.
#pragma once
#include <memory>
#include <vector>

#include "render/draw_context.h"

namespace mw {

struct SeenId {
    uint32_t node = 0;  ///< 0: nothing
    uint32_t element = 0;
    bool isTerrain() const { return element == 0xffffffffu; }
    bool isPoint() const { return (element & 0x80000000u) != 0; }  ///< a loose vertex, else a face
    uint32_t index() const { return element & 0x7fffffffu; }
    bool operator==(const SeenId&) const = default;
};

/// A rectangle of the id buffer; pixels from the top left.
struct SeenWindow {
    glm::ivec2 low{0}, high{0};  ///< high is outside
    std::vector<SeenId> ids;
    SeenId at(int x, int y) const
    {
        if (x < low.x || y < low.y || x >= high.x || y >= high.y) return {};
        return ids[size_t(y - low.y) * size_t(high.x - low.x) + size_t(x - low.x)];
    }
};

class IdBuffer {
public:
    /// Draws it if something has changed, then reads; the rectangle is cut to the picture.
    SeenWindow read(DrawContext& c, glm::ivec2 low, glm::ivec2 high);

private:
    void draw(DrawContext& c);
    void resize(glm::ivec2 size);
    struct State {
        std::vector<double> numbers;
        std::vector<const void*> arrays;
        std::vector<std::weak_ptr<const void>> owners;
        std::vector<MeshPose> poses;
        std::vector<Shared<float>> maps;  // tiles of terrains
    };
    static State stateOf(const DrawContext& c);
    bool current(const State& s) const;

    gl::Framebuffer framebuffer_;
    gl::Renderbuffer ids_, depth_;
    glm::ivec2 size_{0};
    State drawn_;
};

std::optional<Pick> pickAt(DrawContext& c, IdBuffer& ids, glm::dvec2 pixel);
/// The faces of a rectangle, ascending, by node.
std::vector<std::pair<NodeId, std::vector<uint32_t>>> facesIn(const SeenWindow& window, const Region& region);

}  // namespace mw
