// What an OFF file says, before it becomes a scene. Between off_parser.cpp, off_binary.cpp and off_reader.cpp.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "core/io/file.h"
#include "core/io/findings.h"
#include "core/io/placement.h"
#include "core/io/text.h"
#include "core/steps/progress.h"

namespace mw {

struct OffHeader {
    bool texcoord = false, color = false, normal = false, homogeneous = false, dimensions = false, binary = false;
    size_t bodyStart = 0;  ///< byte; in a binary file behind the line's end
    uint64_t line = 1;     ///< of the byte before
    /// Values of a vertex besides its colour.
    size_t plainValues() const { return 3 + homogeneous + 3 * normal + 2 * texcoord; }
};

struct OffData {
    /// How the colour of a face is given.
    enum class Color : uint8_t { None, Index, Whole3, Whole4, Fraction3, Fraction4 };
    static constexpr uint32_t wrongIndex = none - 1;  ///< an index was given, but it cannot be right

    Filling<glm::vec3> positions, normals;  ///< normals: empty or one a vertex
    Filling<glm::vec2> texcoords;           ///< empty or one a vertex
    Filling<glm::vec4> colors;              ///< empty or one a vertex, as they stand
    int colorSize = 0;                      ///< 3 or 4
    Filling<uint32_t> faceStart, cornerVertex;
    Filling<Color> faceColorKind;  ///< empty or one a face
    Filling<glm::vec4> faceColor;  ///< with it, as they stand
    Stated stated;                 ///< by comments
    Findings findings;

    void addFaceColor(size_t face, Color kind, glm::vec4 value)
    {
        if (kind == Color::None && faceColorKind.size() == 0) return;
        faceColorKind.fill(face, Color::None);
        faceColor.fill(face, glm::vec4(1));
        faceColorKind.push(kind);
        faceColor.push(value);
    }
};

/// Nothing when the bytes do not begin like an OFF file.
bool readOffHeader(std::string_view text, OffHeader& header);
/// Throw Error, Cancelled.
void parseOff(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress);
/// Gives whether the file is big-endian.
bool parseBinaryOff(const FileBytes& bytes, const OffHeader& header, const std::string& file, OffData& data, Progress* progress);

}  // namespace mw
