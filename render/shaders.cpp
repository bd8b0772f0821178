// Compiles and links programs; errors are told in terms of the files they are made of.
#include "render/shaders.h"

#include <cctype>
#include <vector>

#include "core/error.h"
#include "render/shader_sources.h"

namespace mw {
namespace {

constexpr const char* camera[] = {"camera.glsl"};
constexpr const char* object[] = {"camera.glsl", "object.glsl"};
constexpr const char* lit[] = {"camera.glsl", "object.glsl", "lights.glsl", "materials.glsl", "shadow.glsl", "heat.glsl", "surface.glsl"};
constexpr const char* shadowed[] = {"camera.glsl", "object.glsl", "lights.glsl", "shadow.glsl"};
constexpr const char* disc[] = {"camera.glsl", "object.glsl", "lights.glsl"};
constexpr const char* canvas[] = {"camera.glsl", "heat.glsl"};
constexpr const char* lines[] = {"camera.glsl", "object.glsl", "heat.glsl"};

constexpr const char* ground[] = {"camera.glsl", "object.glsl", "lights.glsl", "heat.glsl", "terrain.glsl"};
constexpr const char* groundPlaces[] = {"camera.glsl", "object.glsl", "terrain.glsl"};

constexpr const char* surfaceVariants[] = {"FLAT",         "COLOR",   "MATERIAL",    "HEAT",          "HEAT_CATEGORY", "HEAT_FACE",
                                           "DIMMED",       "DENSE",   "MAP_BASE",    "MAP_ROUGHNESS", "MAP_NORMAL",    "MAP_OCCLUSION",
                                           "MAP_EMISSIVE", "TANGENT", "ENVIRONMENT", "SHADOW",        "MATCAP",        "CHECKER"};
constexpr const char* shadowVariants[] = {"MAP_BASE"};
constexpr const char* wireVariants[] = {"EDGE_FLAGS"};
constexpr const char* lineVariants[] = {"HALO", "HEAT"};
constexpr const char* discVariants[] = {"COLOR"};
constexpr const char* poseVariants[] = {"SPLIT", "MORPHED", "SKINNED"};
constexpr const char* posedOutputs[] = {"posedPosition", "posedNormal"};
constexpr const char* terrainVariants[] = {"FLAT", "DENSE", "WATER", "PLAIN", "BORDERS", "BRUSH"};

constexpr ProgramRow table[] = {
    {ProgramId::Background, "background", "background.vert", nullptr, "background.frag", camera, {}},
    {ProgramId::Surface, "surface", "surface.vert", nullptr, "surface.frag", lit, surfaceVariants},
    {ProgramId::Wire, "wire", "wire.vert", "wire.geom", "wire.frag", object, wireVariants},
    {ProgramId::Line, "line", "line.vert", "line.geom", "line.frag", lines, lineVariants},
    {ProgramId::Disc, "disc", "disc.vert", nullptr, "disc.frag", disc, discVariants},
    {ProgramId::FaceMark, "face mark", "face_mark.vert", nullptr, "face_mark.frag", object, {}},
    {ProgramId::Needle, "needle", "needle.vert", "line.geom", "line.frag", lines, lineVariants},
    {ProgramId::Canvas, "canvas", "canvas.vert", nullptr, "canvas.frag", canvas, {}},
    {ProgramId::Outline, "outline", "background.vert", nullptr, "outline.frag", object, {}},
    {ProgramId::Ids, "ids", "ids.vert", nullptr, "ids.frag", object, {}},
    {ProgramId::IdPoints, "id points", "id_points.vert", nullptr, "id_points.frag", object, {}},
    {ProgramId::Pose, "pose", "pose.vert", nullptr, nullptr, object, poseVariants, std::span(posedOutputs, 1)},
    {ProgramId::PoseNormals, "pose with normals", "pose.vert", nullptr, nullptr, object, poseVariants, posedOutputs},
    {ProgramId::Terrain, "terrain", "terrain.vert", nullptr, "terrain.frag", ground, terrainVariants, {}, "terrain.tesc", "terrain.tese"},
    {ProgramId::TerrainWire, "terrain wire", "terrain.vert", "wire.geom", "wire.frag", groundPlaces, {}, {}, "terrain.tesc", "terrain.tese", true},
    {ProgramId::TerrainIds, "terrain ids", "terrain.vert", nullptr, "terrain_ids.frag", groundPlaces, {}, {}, "terrain.tesc", "terrain.tese", true},
    {ProgramId::Shadow, "shadow", "shadow.vert", nullptr, "shadow.frag", object, shadowVariants},
    {ProgramId::GroundShadow, "ground shadow", "ground_shadow.vert", nullptr, "ground_shadow.frag", shadowed, {}},
};

const ProgramRow& rowOf(ProgramId id)
{
    for (const ProgramRow& r : table)
        if (r.id == id) return r;
    throw Error("a shader program is missing from its table");
}

/// The texts of one stage in order; `#line` numbers them, so that a message can name the file again.
struct StageText {
    std::string text;
    std::vector<std::string> files;

    void add(const char* file)
    {
        text += "#line 1 " + std::to_string(files.size()) + "\n";
        text += shaderFile(file);
        text += "\n";
        files.emplace_back(file);
    }
};

/// Drivers begin a message with "3:12(5):" or "3(12) :", the number of the text and the line.
std::string withFileNames(const std::string& log, const std::vector<std::string>& files)
{
    std::string out;
    for (size_t begin = 0; begin < log.size();) {
        const size_t end = std::min(log.find('\n', begin), log.size() - 1) + 1;
        std::string line = log.substr(begin, end - begin);
        begin = end;
        size_t i = line.starts_with("ERROR: ") ? 7 : 0;
        const size_t first = i;
        while (i < line.size() && std::isdigit(static_cast<unsigned char>(line[i]))) ++i;
        if (i > first && i < line.size() && (line[i] == ':' || line[i] == '(')) {
            const size_t file = std::stoul(line.substr(first, i - first));
            if (file < files.size()) line.replace(first, i - first, "resources/shaders/" + files[file]);
        }
        out += line;
    }
    return out;
}

GLuint compile(GLenum stage, const ProgramRow& row, const char* file, const std::string& defines)
{
    StageText t;
    t.text = "#version 410 core\n" + defines;
    for (const char* chunk : row.chunks) t.add(chunk);
    t.add(file);
    const GLuint shader = glCreateShader(stage);
    const char* text = t.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0, length = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(size_t(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(size_t(length));
    glDeleteShader(shader);
    throw Error("the graphics driver does not compile the shader " + std::string(row.name) + ":\n" + withFileNames(log, t.files));
}

void bindPoints(GLuint program)
{
    constexpr std::pair<const char*, GLuint> blocks[] = {
        {"Camera", cameraBlock}, {"Lights", lightsBlock}, {"Object", objectBlock}, {"Terrain", terrainBlock}};
    for (const auto& [name, point] : blocks) {
        const GLuint index = glGetUniformBlockIndex(program, name);
        if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, point);
    }
    constexpr std::pair<const char*, GLint> samplers[] = {
        {"heatTable", heatUnit},
        {"faceValues", faceValueUnit},
        {"triangleFaces", triangleFaceUnit},
        {"baseColorMap", baseColorUnit},
        {"maskMap", maskUnit},
        {"atlasMap", atlasUnit},
        {"edgeFlags", edgeFlagUnit},
        {"poseData", poseDataUnit},
        {"jointSlots", jointSlotUnit},
        {"jointWeights", jointWeightUnit},
        {"morphDeltas", morphUnit},
        {"morphNormals", morphNormalUnit},
        {"heightMap", heightUnit},
        {"layerMap", layerUnit},
        {"roughnessMap", roughnessUnit},
        {"normalMap", normalUnit},
        {"occlusionMap", occlusionUnit},
        {"emissiveMap", emissiveUnit},
        {"environmentMap", environmentUnit},
        {"reflectanceTable", reflectanceUnit},
        {"shadowMap", shadowUnit},
        {"matcapMap", matcapUnit},
    };
    glUseProgram(program);
    for (const auto& [name, unit] : samplers) {
        const GLint location = glGetUniformLocation(program, name);
        if (location >= 0) glUniform1i(location, unit);
    }
}

GLuint link(const ProgramRow& row, unsigned variant)
{
    std::string defines = row.positionOnly ? "#define POSITION_ONLY\n" : "";
    for (size_t i = 0; i < row.variants.size(); ++i)
        if (variant >> i & 1) defines += "#define " + std::string(row.variants[i]) + "\n";
    const std::pair<GLenum, const char*> stages[] = {{GL_VERTEX_SHADER, row.vertex},
                                                     {GL_TESS_CONTROL_SHADER, row.control},
                                                     {GL_TESS_EVALUATION_SHADER, row.evaluation},
                                                     {GL_GEOMETRY_SHADER, row.geometry},
                                                     {GL_FRAGMENT_SHADER, row.fragment}};
    std::vector<GLuint> shaders;
    for (const auto& [stage, file] : stages)
        if (file) shaders.push_back(compile(stage, row, file, defines));
    const GLuint program = glCreateProgram();
    for (const GLuint s : shaders) glAttachShader(program, s);
    if (!row.captured.empty()) glTransformFeedbackVaryings(program, GLsizei(row.captured.size()), row.captured.data(), GL_SEPARATE_ATTRIBS);
    glLinkProgram(program);
    for (const GLuint s : shaders) {
        glDetachShader(program, s);
        glDeleteShader(s);
    }
    GLint good = 0, length = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) {
        glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
        std::string log(size_t(std::max(length, 1)), '\0');
        glGetProgramInfoLog(program, length, &length, log.data());
        glDeleteProgram(program);
        throw Error("the graphics driver does not link the shader program " + std::string(row.name) + ":\n" + log.c_str());
    }
    bindPoints(program);
    return program;
}

}  // namespace

std::span<const ProgramRow> programTable()
{
    return table;
}

std::string_view shaderFile(std::string_view name)
{
    for (const ShaderSource& s : shaderSources())
        if (name == s.name) return s.text;
    throw Error("the shader file resources/shaders/" + std::string(name) + " is not part of this program");
}

Programs::~Programs()
{
    for (const auto& [key, program] : made_) glDeleteProgram(program);
}

GLuint Programs::get(ProgramId id, unsigned variant)
{
    GLuint& program = made_[{id, variant}];
    if (!program) program = link(rowOf(id), variant);
    return program;
}

void gl::attribute(const Attribute& a)
{
    glBindBuffer(GL_ARRAY_BUFFER, a.buffer);
    glEnableVertexAttribArray(a.location);
    glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, a.stride, reinterpret_cast<const void*>(a.offset));
    glVertexAttribDivisor(a.location, a.divisor);
}

}  // namespace mw
