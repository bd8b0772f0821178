// What a subdivision by tables does beside the points of its levels, whatever the scheme: attributes, textures, the meshes, tables to remember.
#pragma once
#include <string>

#include "core/subdivide/carried.h"
#include "core/subdivide/corner_surface.h"
#include "core/subdivide/face_edges.h"
#include "core/subdivide/lanes.h"
#include "core/subdivide/remembered.h"

namespace mw {

/// `Level`: tables of a level, such as LoopLevel, with vertex, faces(), refined(last), keepForPoints() and bytes().
template <class Level>
class Refinement {
public:
    /// `mesh`: what is refined, made from `input`. `levelOf`: tables of a mesh of texture coordinates.
    template <class LevelOf>
    Refinement(const Mesh& input, const Mesh& mesh, Texturing uv, const LevelOf& levelOf) : input_(input), attributes_(mesh.attributes())
    {
        if (uv == Texturing::Linear) return;
        for (CornerSurface& s : cornerSurfacesOf(mesh)) {
            std::erase_if(attributes_, [&s](const Attribute& a) { return a.id() == s.attribute.id(); });
            Level level = levelOf(s.mesh);
            Array<glm::vec3> points = lanes::padded(s.mesh.positions());
            textures_.push_back({std::move(s), std::move(level), std::move(points)});
        }
    }
    /// What lies on the mesh to the next level. `pointsOf`(level, points): the points of the level after one.
    template <class PointsOf>
    void refine(const Origins& origins, const PointsOf& pointsOf, bool last)
    {
        for (Texture& t : textures_) {
            Array<glm::vec3> points = pointsOf(t.level, t.points);
            t.level = t.level.refined(last);
            t.points = std::move(points);
        }
        attributes_ = carried(attributes_, origins);
    }
    /// The mesh of a level of faces with `corners`. The last one gives its arrays away.
    Mesh mesh(Level& level, Array<glm::vec3>& places, uint32_t corners, bool last) const
    {
        Array<uint32_t> start = lanes::evenStarts(level.faces(), corners);
        Mesh out = last ? Mesh(std::move(places), std::move(start), std::move(level.vertex)) : Mesh(places, std::move(start), level.vertex);
        out = out.withGroupNames(input_.groupNames());
        if (!input_.lines().empty()) out = out.withLines(input_.lines());
        out = withAttributes(std::move(out), attributes_);
        for (const Texture& t : textures_) out = out.with(cornerValues(t.surface, t.points, t.level.vertex));
        return out;
    }
    /// Tables of a level that is done.
    void keep(Level level)
    {
        level.keepForPoints();
        tables_.push_back(std::move(level));
    }
    /// The result with all tables that were kept.
    void remember(Remembered<std::vector<Level>>& memory, std::string key, const Mesh& result)
    {
        size_t bytes = result.bytes();
        for (const Level& l : tables_) bytes += l.bytes();
        memory.keep(input_, std::move(key), result, std::move(tables_), bytes);
    }

private:
    /// Texture coordinates that are subdivided themselves.
    struct Texture {
        CornerSurface surface;
        Level level;
        Array<glm::vec3> points;
    };
    Mesh input_;
    std::vector<Attribute> attributes_;
    std::vector<Texture> textures_;
    std::vector<Level> tables_;
};

}  // namespace mw
