// Drawing and reading the id buffer.
#include "render/id_buffer.h"

#include <algorithm>

namespace mw {
namespace {

constexpr float pointSize = 7;  // somewhat more than it looks: points are small

void drawObject(DrawContext& c, const DrawObject& o)
{
    ObjectBlock block = c.blockOf(o.worldFromLocal);
    block.ids.x = int(o.node.value);
    if (hasLoosePoints(o.mesh)) {
        c.use(ProgramId::IdPoints);
        c.clearAttributes();
        block.stroke.x = pointSize;
        c.setObject(block);
        gl::attribute({0, c.positions(o)});
        glDrawArrays(GL_POINTS, 0, GLsizei(o.mesh.vertexCount()));
    }
    if (o.mesh.faceCount() == 0) return;
    SurfaceWants wants;
    wants.normals = wants.colors = false;
    const BoundSurface s = bindSurface(c, o, wants);
    c.use(ProgramId::Ids);
    const GLuint faces = triangleFaceTexture(c.gpu.cache, *s.layout);
    if (faces) c.texture(triangleFaceUnit, GL_TEXTURE_BUFFER, faces);
    block.ids.z = faces != 0;
    for (const SurfaceLayout::Run& run : s.layout->runs) drawRun(c, s, run, block);
}

}  // namespace

IdBuffer::State IdBuffer::stateOf(const DrawContext& c)
{
    State s;
    s.numbers = {double(c.size.x), double(c.size.y), c.frame.options.pixelRatio};
    const auto add = [&](const glm::dmat4& m) {
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) s.numbers.push_back(m[i][k]);
    };
    add(c.viewFromWorld);
    add(c.clipFromView);
    for (const DrawObject& o : c.frame.objects) {
        s.numbers.push_back(o.node.value);
        add(o.worldFromLocal);
        s.arrays.push_back(o.mesh.positions().id());
        s.arrays.push_back(o.mesh.cornerVertex().id());
        s.arrays.push_back(o.mesh.faceStart().id());
        s.owners.emplace_back(o.mesh.positions().owner());
        s.owners.emplace_back(o.mesh.faceStart().owner());
        s.poses.push_back(o.pose ? *o.pose : MeshPose());
    }
    for (const DrawTerrain& d : c.frame.terrains) {
        const Terrain& t = d.terrain;
        add(d.worldFromLocal);
        for (const double v :
             {double(d.node.value), t.extent, t.maximumHeight, t.waterLevel, double(t.detail.patches), t.detail.nearLevel, t.detail.farLevel,
              t.detail.nearDistance, t.detail.farDistance, double(t.detail.corrected), double(t.map.width()), double(t.map.height())})
            s.numbers.push_back(v);
        for (uint32_t y = 0; y < t.map.tilesY(); ++y)
            for (uint32_t x = 0; x < t.map.tilesX(); ++x) s.maps.push_back(t.map.tile(x, y));
    }
    return s;
}

bool IdBuffer::current(const State& s) const
{
    // Addresses may be used again once their arrays are gone; an owner that has expired tells.
    for (size_t i = 0; i < drawn_.owners.size(); ++i)
        if (drawn_.owners[i].expired() && drawn_.arrays[3 * (i / 2)]) return false;
    return s.numbers == drawn_.numbers && s.arrays == drawn_.arrays && s.poses == drawn_.poses &&
           std::equal(s.maps.begin(), s.maps.end(), drawn_.maps.begin(), drawn_.maps.end(),
                      [](const auto& a, const auto& b) { return a.id() == b.id(); });
}

void IdBuffer::resize(glm::ivec2 size)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    if (size == size_) return;
    size_ = size;
    glBindRenderbuffer(GL_RENDERBUFFER, ids_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RG32UI, size.x, size.y);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, ids_.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
}

void IdBuffer::draw(DrawContext& c)
{
    uploadFrameBlocks(c);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    constexpr GLuint nothing[4] = {0, 0, 0, 0};
    constexpr GLfloat far = 1;
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
    for (const DrawObject& o : c.frame.objects) drawObject(c, o);
    drawTerrainIds(c);
}

SeenWindow IdBuffer::read(DrawContext& c, glm::ivec2 low, glm::ivec2 high)
{
    const bool sized = size_ == c.size;
    resize(c.size);
    State state = stateOf(c);
    if (!sized || !current(state)) {
        draw(c);
        drawn_ = std::move(state);
    }
    SeenWindow w;
    w.low = glm::clamp(low, glm::ivec2(0), c.size);
    w.high = glm::clamp(high, w.low, c.size);
    const glm::ivec2 extent = w.high - w.low;
    w.ids.resize(size_t(extent.x) * size_t(extent.y));
    if (w.ids.empty()) return w;
    std::vector<SeenId> rows(w.ids.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(w.low.x, c.size.y - w.high.y, extent.x, extent.y, GL_RG_INTEGER, GL_UNSIGNED_INT, rows.data());
    const size_t n = size_t(extent.x);
    for (size_t y = 0; y < size_t(extent.y); ++y) std::copy_n(rows.data() + (size_t(extent.y) - 1 - y) * n, n, w.ids.data() + y * n);
    return w;
}

}  // namespace mw
