// The two lower floors of the PLY reader: the header, and rows of values put where they are wanted. ply_reader.cpp decides where that is.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "core/io/file.h"
#include "core/io/findings.h"
#include "core/io/placement.h"
#include "core/io/text.h"
#include "core/mesh/attribute.h"
#include "core/steps/progress.h"

namespace mw {

struct PlyProperty {
    std::string name;
    Scalar type = Scalar::Float32;
    bool list = false;
    Scalar countType = Scalar::UInt8;
};
struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;
};
struct PlyHeader {
    enum class Encoding { Text, Little, Big } encoding = Encoding::Text;
    std::vector<PlyElement> elements;
    std::vector<std::string> groupNames;  ///< "comment group NAME", as the writer here puts them
    Stated stated;                        ///< by comments
    size_t bodyStart = 0;                 ///< byte
    uint64_t bodyLine = 1;                ///< lines before it, and one
};
/// Throws Error naming the line.
PlyHeader readPlyHeader(const FileBytes& bytes, const std::string& file);

size_t byteSize(Scalar type);
const char* plyName(Scalar type);  ///< "float", "uchar", ...
bool isInteger(Scalar type);

/// Lists of a row, one after the other.
template <class T>
struct PlyLists {
    Filling<uint32_t> start;  ///< rows + 1
    Filling<T> values;
};
using PlyIndices = PlyLists<uint32_t>;  ///< negative and fractional ones become `none`
using PlyValues = std::variant<PlyLists<float>, PlyLists<double>, PlyLists<int32_t>>;

/// Where the values of a property go: value i of a scalar to `to`[i * stride], divided by `divisor`. All null: nowhere.
struct PlyColumn {
    PlyProperty property;
    std::variant<std::monostate, float*, double*, int32_t*> to;
    size_t stride = 1;
    double divisor = 1;
    PlyIndices* indices = nullptr;
    PlyValues* list = nullptr;
};

/// Goes through the body, element by element.
class PlyBody {
public:
    PlyBody(const PlyHeader& header, const FileBytes& bytes, const std::string& file, Findings& findings, Progress* progress);
    /// Throws Error when the file cannot hold as many rows as the header says. Gives the number of rows.
    size_t checkedCount(const PlyElement& element) const;
    /// At most so many values can still come in the lists of the element's rows.
    size_t mostListValues(const PlyElement& element, const PlyProperty& list) const;
    /// `columns` are those of the element, in order. Throws Error, Cancelled.
    void read(const PlyElement& element, std::vector<PlyColumn>& columns);
    void skip(const PlyElement& element);
    void finish();  ///< says what is left over

private:
    size_t left() const { return size_t(bytes_.end() - p_); }
    bool nextInLine();
    void noList(PlyColumn& column);
    void readText(const PlyElement& element, std::vector<PlyColumn>& columns);
    void readFixed(const PlyElement& element, std::vector<PlyColumn>& columns, size_t rowBytes);
    bool readPlainFaces(const PlyElement& element, std::vector<PlyColumn>& columns);
    void readBinary(const PlyElement& element, std::vector<PlyColumn>& columns);
    double textValue(const PlyElement& element, const PlyColumn& column, Scalar type);
    double binaryValue(Scalar type);
    template <class Value>
    void readList(const PlyElement& element, PlyColumn& column, size_t bytesEach, Value&& value);
    void store(PlyColumn& column, double value);
    int32_t whole(double value);
    [[noreturn]] void fail(const PlyElement& element, const std::string& what) const;
    void ends(const PlyElement& element, size_t bytes) const;

    const PlyHeader& header_;
    const FileBytes& bytes_;
    const std::string& file_;
    Findings& findings_;
    Progress* progress_;
    const char* p_;
    uint64_t line_;
    size_t row_ = 0;
    bool swap_;
};

}  // namespace mw
