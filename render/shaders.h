// The one table of programs. Each is made of files of resources/shaders, which are part of the binary; chunks that several share are
// listed here, not pasted. Programs are compiled when first used (some 5 ms each).
#pragma once
#include <map>
#include <span>
#include <string>

#include "render/gl.h"

namespace mw {

enum class ProgramId {
    Background,
    Surface,
    Wire,
    Line,
    Disc,
    FaceMark,
    Needle,
    Canvas,
    Outline,
    Ids,
    IdPoints,
    Pose,
    PoseNormals,
    Terrain,
    TerrainWire,
    TerrainIds,
    Shadow,
    GroundShadow
};

/// Variants of a program are defines before its text.
struct ProgramRow {
    ProgramId id;
    const char* name;
    const char* vertex;
    const char* geometry;  ///< null: none
    const char* fragment;
    std::span<const char* const> chunks;         ///< put before every stage
    std::span<const char* const> variants;       ///< defines it knows; see variant bits
    std::span<const char* const> captured = {};  ///< outputs kept in buffers by transform feedback, one each
    const char* control = nullptr;               ///< tessellation
    const char* evaluation = nullptr;
    bool positionOnly = false;  ///< nothing but places goes from the evaluation on
};
std::span<const ProgramRow> programTable();

/// Text of an embedded file. Throws Error when there is none.
std::string_view shaderFile(std::string_view name);

/// Bits of ProgramId::Surface's variants, in the order of its row; Line and Needle know Halo and lineHeat, Wire knows EdgeFlags.
namespace variant {
inline constexpr unsigned flat = 1, color = 2, material = 4, heat = 8, heatCategory = 16, heatFace = 32, dimmed = 64, dense = 128;
inline constexpr unsigned mapBase = 256, mapRoughness = 512, mapNormal = 1024, mapOcclusion = 2048, mapEmissive = 4096, tangent = 8192;
inline constexpr unsigned environment = 1 << 14, shadow = 1 << 15, matcap = 1 << 16, checker = 1 << 17;
inline constexpr unsigned edgeFlags = 1, halo = 1, lineHeat = 2, pointColor = 1;
inline constexpr unsigned poseSplit = 1, poseMorphed = 2, poseSkinned = 4;
inline constexpr unsigned denseGround = 2, water = 4, plain = 8, borders = 16, brush = 32;  // of Terrain, with flat
}  // namespace variant

// Where things are bound, in every program.
inline constexpr GLuint cameraBlock = 0, lightsBlock = 1, objectBlock = 2, terrainBlock = 3;
enum TextureUnit : GLint {
    heatUnit,
    faceValueUnit,
    triangleFaceUnit,
    baseColorUnit,
    maskUnit,
    atlasUnit,
    edgeFlagUnit,
    poseDataUnit,
    jointSlotUnit,
    jointWeightUnit,
    morphUnit,
    morphNormalUnit,
    heightUnit,
    layerUnit,
    roughnessUnit,
    normalUnit = 16,  // 15 is where textures are made
    occlusionUnit,
    emissiveUnit,
    environmentUnit,
    reflectanceUnit,
    shadowUnit,
    matcapUnit
};

class Programs {
public:
    ~Programs();
    /// Bit i of `variant` switches the i-th define of the row on. Throws Error naming file and line.
    GLuint get(ProgramId id, unsigned variant = 0);

private:
    std::map<std::pair<ProgramId, unsigned>, GLuint> made_;
};

}  // namespace mw
