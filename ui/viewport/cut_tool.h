// Cutting by clicks: from vertex to vertex along the shortest way of edges, shown as the pointer moves; the whole way becomes a modifier.
#pragma once
#include "core/parameterize/cut_graph.h"
#include "ui/viewport/prepared.h"
#include "ui/viewport/tool.h"

namespace mw {

class CutTool : public Tool {
public:
    explicit CutTool(ToolView& view);
    bool click(const PointerEvent& e) override;
    void rest(const PointerEvent& e) override;
    void leave() override;
    bool key(const QKeyEvent& e) override;  ///< Enter cuts, Backspace takes the last vertex back
    bool abort() override;                  ///< clears
    void decorate(Frame& frame) override;
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    bool marksHover() const override { return false; }

    /// A vertex the way passes, and the vertices from the one before it up to it: empty for the first, and where the way was not awaited.
    struct Stop {
        uint32_t vertex = none;
        std::vector<uint32_t> way;
    };
    const std::vector<Stop>& stops() const { return stops_; }
    /// From the last stop to the vertex under the pointer; empty when there is none, or while ways are being looked for.
    const std::vector<uint32_t>& way() const { return hoverWay_; }

private:
    struct Target {
        NodeId node;
        uint32_t vertex = none;
        bool operator==(const Target&) const = default;
    };
    std::optional<Target> under(const PointerEvent& e);
    QString obstacle(const Target& t) const;  ///< why it can be no stop; empty: nothing
    bool stillThere();                        ///< the mesh in view is the one the stops are of; else they are cleared
    void take(uint32_t vertex);
    void prepared();
    void showWay();
    void commit();
    void clear();

    NodeId node_;
    Mesh mesh_;  // of the stops
    std::vector<Stop> stops_;
    std::optional<uint32_t> awaited_;  // clicked before the ways from the last stop were known
    std::optional<Target> hover_;
    std::vector<uint32_t> hoverWay_;
    Prepared<EdgeDistances> ways_;  // from the last stop to everywhere
};

}  // namespace mw
