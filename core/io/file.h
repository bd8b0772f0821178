// Files as bytes: whole files in, bounded; files out, all or nothing.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace mw {

/// A whole file in memory, followed by a line end and zeros, so that parsers need to look for the end only at line ends.
class FileBytes {
public:
    static constexpr size_t padding = 64;  ///< readable bytes after end(): '\n', then zeros

    FileBytes() = default;
    explicit FileBytes(size_t size);  ///< uninitialised, padded
    char* data() { return bytes_.get(); }
    const char* data() const { return bytes_.get(); }
    const char* begin() const { return bytes_.get(); }
    const char* end() const { return bytes_.get() + size_; }
    size_t size() const { return size_; }
    std::string_view text() const { return {bytes_.get(), size_}; }

private:
    std::unique_ptr<char[]> bytes_;
    size_t size_ = 0;
};

/// Larger files hold more elements than 32-bit indices can number.
inline constexpr uint64_t largestFile = uint64_t(8) << 30;

/// Throws Error when it is missing, a folder, no ordinary file, not readable, or larger than `cap`.
FileBytes readBytes(const std::filesystem::path& file, uint64_t cap = largestFile);
/// The first bytes, for finding out what a file is. Throws as readBytes.
std::string readStart(const std::filesystem::path& file, size_t bytes);

/// `bytes` as UTF-8 with '\n' as line end: byte order marks and UTF-16 are taken care of. `file` is for the Error.
FileBytes plainText(FileBytes bytes, const std::string& file);

/// `name`, as found inside a file, as a path in `folder` or below; empty when it is absolute or leads out of it (also by a link). Backslashes
/// count as slashes.
std::filesystem::path insideFolder(const std::filesystem::path& folder, std::string name);

/// Collects what is written in a temporary file beside the target; commit() renames it, anything else leaves the target as it was.
class OutputFile {
public:
    explicit OutputFile(const std::filesystem::path& file);  ///< throws Error
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(const void* bytes, size_t size);
    void write(std::string_view text) { write(text.data(), text.size()); }
    /// At least `bytes` of room in the buffer to write to directly; then say with advance() how many were used.
    char* room(size_t bytes)
    {
        if (buffer_.size() - used_ < bytes) flush(bytes);
        return buffer_.data() + used_;
    }
    void advance(const char* to) { used_ = size_t(to - buffer_.data()); }
    void close();   ///< all bytes are on their way to the disk; throws Error (full)
    void commit();  ///< close() and rename

private:
    void flush(size_t room = 0);
    [[noreturn]] void fail(const char* doing) const;

    std::filesystem::path file_, target_, temporary_;
    int handle_ = -1;
    std::vector<char> buffer_;
    size_t used_ = 0;
};

}  // namespace mw
