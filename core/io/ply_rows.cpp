#include "core/io/ply_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace mw {

static_assert(std::endian::native == std::endian::little, "binary PLY is read and written on little-endian machines");

namespace {

constexpr Finding extraFinding{"extra-values", "row has more values than its element says: ignored",
                               "rows have more values than their element says: ignored"};
constexpr Finding noListFinding{"missing-list", "row ends before a list that the header announces: taken as empty",
                                "rows end before a list that the header announces: taken as empty"};
constexpr Finding rangeFinding{"value-range", "value is not a whole number of its type: the nearest is taken",
                               "values are not whole numbers of their type: the nearest are taken"};
constexpr Finding trailingFinding{"trailing-bytes", "piece of data after the last element: ignored",
                                  "pieces of data after the last element: ignored"};

template <class T>
T loaded(const char* p, bool swap)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, p, sizeof(T));
    if (swap) std::reverse(bytes, bytes + sizeof(T));
    T v;
    std::memcpy(&v, bytes, sizeof(T));
    return v;
}

/// Calls `f` with a value of the C++ type that `type` names.
template <class F>
auto withType(Scalar type, F&& f)
{
    switch (type) {
        case Scalar::Float32:
            return f(float());
        case Scalar::Float64:
            return f(double());
        case Scalar::Int8:
            return f(int8_t());
        case Scalar::UInt8:
            return f(uint8_t());
        case Scalar::Int16:
            return f(int16_t());
        case Scalar::UInt16:
            return f(uint16_t());
        case Scalar::Int32:
            return f(int32_t());
        case Scalar::UInt32:
            break;
    }
    return f(uint32_t());
}

size_t smallestRow(const PlyElement& element, bool text)
{
    size_t bytes = 0;
    for (const PlyProperty& p : element.properties) bytes += text ? 2 : byteSize(p.list ? p.countType : p.type);
    return bytes;
}

bool hasList(const PlyElement& element)
{
    return std::any_of(element.properties.begin(), element.properties.end(), [](const PlyProperty& p) { return p.list; });
}

uint32_t indexOf(double v)
{
    return v >= 0 && v < double(none) && v == std::floor(v) ? uint32_t(v) : none;
}

/// One property of all rows; no value needs a look.
template <class From, class To>
void copyColumn(const char* from, size_t rowBytes, size_t rows, bool swap, To* to, size_t stride, double divisor)
{
    if (divisor == 1)
        for (size_t i = 0; i < rows; ++i) to[i * stride] = To(loaded<From>(from + i * rowBytes, swap));
    else
        for (size_t i = 0; i < rows; ++i) to[i * stride] = To(double(loaded<From>(from + i * rowBytes, swap)) / divisor);
}

}  // namespace

PlyBody::PlyBody(const PlyHeader& header, const FileBytes& bytes, const std::string& file, Findings& findings, Progress* progress)
    : header_(header),
      bytes_(bytes),
      file_(file),
      findings_(findings),
      progress_(progress),
      p_(bytes.begin() + header.bodyStart),
      line_(header.bodyLine),
      swap_(header.encoding == PlyHeader::Encoding::Big)
{}

void PlyBody::fail(const PlyElement& element, const std::string& what) const
{
    const std::string place =
        header_.encoding == PlyHeader::Encoding::Text ? "line " + std::to_string(line_) : "byte " + std::to_string(p_ - bytes_.begin());
    throw Error(file_, place + ": row " + std::to_string(row_ + 1) + " of element " + inQuotes(element.name) + ": " + what);
}

inline void PlyBody::ends(const PlyElement& element, size_t bytes) const
{
    if (left() < bytes) fail(element, "the file ends inside it; copy or export the file again");
}

size_t PlyBody::checkedCount(const PlyElement& element) const
{
    const bool text = header_.encoding == PlyHeader::Encoding::Text;
    const size_t row = smallestRow(element, text);
    const size_t room = left() + (text ? 1 : 0);  // the last line may lack its end
    if (row == 0) return 0;
    if (element.count >= none - 2 || element.count > room / row)
        throw Error(file_, "the header promises " + std::to_string(element.count) + " rows of element " + inQuotes(element.name) + " (at least " +
                               std::to_string(row) + " bytes each), but only " + std::to_string(left()) +
                               " bytes are left; the file is cut off or its header is wrong");
    return size_t(element.count);
}

size_t PlyBody::mostListValues(const PlyElement& element, const PlyProperty& list) const
{
    const bool text = header_.encoding == PlyHeader::Encoding::Text;
    return (left() + 1 - std::min(left(), size_t(element.count) * smallestRow(element, text))) / (text ? 2 : byteSize(list.type));
}

int32_t PlyBody::whole(double value)
{
    const double nearest = std::isnan(value) ? 0 : std::clamp(std::nearbyint(value), -2147483648.0, 2147483647.0);
    if (nearest != value) findings_.add(rangeFinding);
    return int32_t(nearest);
}

void PlyBody::store(PlyColumn& column, double value)
{
    if (auto** f = std::get_if<float*>(&column.to))
        (*f)[row_ * column.stride] = float(value / column.divisor);
    else if (auto** d = std::get_if<double*>(&column.to))
        (*d)[row_ * column.stride] = value / column.divisor;
    else if (auto** i = std::get_if<int32_t*>(&column.to))
        (*i)[row_ * column.stride] = whole(value);
}

/// The length, then so many values of at least `bytesEach` bytes.
template <class Value>
void PlyBody::readList(const PlyElement& element, PlyColumn& column, size_t bytesEach, Value&& value)
{
    const double length = value(column.property.countType);
    if (!(length >= 0) || length != std::floor(length))
        fail(element, "a list cannot have " + std::to_string(length) + " values (" + inQuotes(column.property.name) + ")");
    const size_t most = (left() + 1) / bytesEach;
    if (length > double(most))
        fail(element, "the list " + inQuotes(column.property.name) + " says it has " + std::to_string(uint64_t(length)) +
                          " values, more than the file has bytes for");
    const size_t n = size_t(length);
    const Scalar type = column.property.type;
    if (column.indices) {
        for (size_t i = 0; i < n; ++i) column.indices->values.push(indexOf(value(type)));
        if (column.indices->values.size() >= none - 2) fail(element, "more corners than 32-bit indices can number");
        column.indices->start.push(uint32_t(column.indices->values.size()));
    } else if (column.list) {
        std::visit(
            [&](auto& lists) {
                using T = std::remove_reference_t<decltype(lists.values[0])>;
                for (size_t i = 0; i < n; ++i) {
                    const double v = value(type);
                    if constexpr (std::is_same_v<T, int32_t>)
                        lists.values.push(whole(v));
                    else
                        lists.values.push(T(v));
                }
                lists.start.push(uint32_t(lists.values.size()));
            },
            *column.list);
    } else {
        for (size_t i = 0; i < n; ++i) value(type);
    }
}

double PlyBody::textValue(const PlyElement& element, const PlyColumn& column, Scalar type)
{
    while (*p_ == ' ' || *p_ == '\t') ++p_;
    double d = 0;
    float f = 0;
    const char* start = p_;
    const bool read = type == Scalar::Float32 ? parseNumber(p_, f) : parseNumber(p_, d);
    if (!read || !endsToken(*p_)) {
        p_ = start;
        const std::string_view token = tokenAt(p_);
        fail(element, (token.empty() ? "the line ends where a value is expected" : inQuotes(token) + " is no number") + std::string(" (") +
                          inQuotes(column.property.name) + ")");
    }
    return type == Scalar::Float32 ? double(f) : d;
}

/// Goes to the next value of a row of text; false when the line ends.
bool PlyBody::nextInLine()
{
    while (*p_ == ' ' || *p_ == '\t') ++p_;
    return *p_ != '\n' && *p_ != '\r' && p_ < bytes_.end();
}

/// Rows may stop before a list that the header should not have had: it counts as empty.
void PlyBody::noList(PlyColumn& column)
{
    findings_.add(noListFinding, [&] { return "line " + std::to_string(line_) + ": " + inQuotes(column.property.name); });
    if (column.indices) column.indices->start.push(uint32_t(column.indices->values.size()));
    if (column.list) std::visit([](auto& lists) { lists.start.push(uint32_t(lists.values.size())); }, *column.list);
}

/// A row a line; blank lines are passed over.
void PlyBody::readText(const PlyElement& element, std::vector<PlyColumn>& columns)
{
    const size_t rows = size_t(element.count);
    for (row_ = 0; row_ < rows; ++row_) {
        for (; p_ < bytes_.end() && endsToken(*p_); ++p_) line_ += *p_ == '\n';
        if (p_ >= bytes_.end()) fail(element, "the file ends before it; " + std::to_string(rows) + " rows were promised");
        for (PlyColumn& c : columns) {
            if (c.property.list && !nextInLine())
                noList(c);
            else if (c.property.list)
                readList(element, c, 2, [&](Scalar type) { return textValue(element, c, type); });
            else
                store(c, textValue(element, c, c.property.type));
        }
        while (*p_ == ' ' || *p_ == '\t') ++p_;
        if (*p_ != '\n' && *p_ != '\r') {
            if (p_ < bytes_.end()) findings_.add(extraFinding, [&] { return "line " + std::to_string(line_); });
            while (p_ < bytes_.end() && *p_ != '\n' && *p_ != '\r') ++p_;
        }
        if (progress_ && (row_ & 0xffff) == 0) progress_->at(float(double(p_ - bytes_.begin()) / double(bytes_.size())));
    }
}

inline double PlyBody::binaryValue(Scalar type)
{
    return withType(type, [&](auto sample) {
        const auto v = loaded<decltype(sample)>(p_, swap_);
        p_ += sizeof v;
        return double(v);
    });
}

void PlyBody::readBinary(const PlyElement& element, std::vector<PlyColumn>& columns)
{
    const size_t rows = size_t(element.count);
    for (row_ = 0; row_ < rows; ++row_) {
        for (PlyColumn& c : columns) {
            const auto value = [&](Scalar type) {
                ends(element, byteSize(type));
                return binaryValue(type);
            };
            if (c.property.list)
                readList(element, c, byteSize(c.property.type), value);
            else
                store(c, value(c.property.type));
        }
        if (progress_ && (row_ & 0xffff) == 0) progress_->at(float(double(p_ - bytes_.begin()) / double(bytes_.size())));
    }
}

/// Scalars only: column by column.
void PlyBody::readFixed(const PlyElement& element, std::vector<PlyColumn>& columns, size_t rowBytes)
{
    const size_t rows = size_t(element.count);
    size_t offset = 0;
    for (PlyColumn& c : columns) {
        std::visit(
            [&](auto to) {
                if constexpr (!std::is_same_v<decltype(to), std::monostate>)
                    withType(c.property.type,
                             [&](auto sample) { copyColumn<decltype(sample)>(p_ + offset, rowBytes, rows, swap_, to, c.stride, c.divisor); });
            },
            c.to);
        offset += byteSize(c.property.type);
        if (progress_) progress_->at(float(double(p_ - bytes_.begin()) / double(bytes_.size())));
    }
    p_ += rows * rowBytes;
}

/// The common form, a list of 32-bit indices with its length in a byte and nothing else; false when it is not that.
bool PlyBody::readPlainFaces(const PlyElement& element, std::vector<PlyColumn>& columns)
{
    PlyColumn& c = columns[0];
    const bool plain = columns.size() == 1 && c.indices && c.property.countType == Scalar::UInt8 && byteSize(c.property.type) == 4 &&
                       isInteger(c.property.type) && !swap_;
    if (!plain) return false;
    // Negative indices are above any number of vertices when taken as unsigned.
    const size_t rows = size_t(element.count);
    const char *p = p_, *end = bytes_.end();
    Filling<uint32_t>& values = c.indices->values;
    uint32_t* start = c.indices->start.room(rows);
    size_t size = values.size();
    for (row_ = 0; row_ < rows; ++row_) {
        const size_t n = uint8_t(*p);  // after the last byte there is padding
        if (size_t(end - p) < 1 + 4 * n) {
            p_ = p;
            ends(element, 1 + 4 * n);
        }
        uint32_t* to = values.room(n);
        if (n == 3)
            std::memcpy(to, p + 1, 12);
        else if (n > 0)
            std::memcpy(to, p + 1, 4 * n);
        size += n;
        values.cut(size);
        start[row_] = uint32_t(size);
        p += 1 + 4 * n;
        if (progress_ && (row_ & 0xffff) == 0) progress_->at(float(double(p - bytes_.begin()) / double(bytes_.size())));
    }
    c.indices->start.cut(c.indices->start.size() + rows);
    p_ = p;
    return true;
}

void PlyBody::read(const PlyElement& element, std::vector<PlyColumn>& columns)
{
    row_ = 0;
    if (checkedCount(element) == 0) return;
    if (header_.encoding == PlyHeader::Encoding::Text)
        readText(element, columns);
    else if (!hasList(element))
        readFixed(element, columns, smallestRow(element, false));
    else if (!readPlainFaces(element, columns))
        readBinary(element, columns);
}

void PlyBody::skip(const PlyElement& element)
{
    std::vector<PlyColumn> nowhere;
    for (const PlyProperty& p : element.properties) nowhere.push_back({p, {}, 1, 1, nullptr, nullptr});
    read(element, nowhere);
}

void PlyBody::finish()
{
    const char* p = p_;
    while (p < bytes_.end() && endsToken(*p)) ++p;
    if (p < bytes_.end()) findings_.add(trailingFinding, [&] { return std::to_string(bytes_.end() - p_) + " bytes"; });
}

}  // namespace mw
