#include "core/io/file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <unistd.h>

#include "core/mesh/large_pages.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

struct Handle {
    int value;
    ~Handle()
    {
        if (value >= 0) ::close(value);
    }
};

std::string sizeText(uint64_t bytes)
{
    return bytes < 10'000'000 ? std::to_string(bytes) + " bytes" : std::to_string(bytes / 1'000'000) + " MB";
}

/// Opens an ordinary file for reading and gives its size.
Handle openFile(const fs::path& file, uint64_t& size)
{
    // O_NONBLOCK: a pipe without a writer must not hang.
    Handle h{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (h.value < 0) {
        const int e = errno;
        if (e == ENOENT) throw Error(file.string(), "there is no such file; check the name");
        if (e == EACCES) throw Error(file.string(), "may not be read; check its permissions");
        throw Error(file.string(), std::string("cannot be opened: ") + std::strerror(e));
    }
    struct stat s {};
    if (::fstat(h.value, &s) != 0) throw Error(file.string(), std::string("cannot be looked at: ") + std::strerror(errno));
    if (S_ISDIR(s.st_mode)) throw Error(file.string(), "is a folder; name a file in it");
    if (!S_ISREG(s.st_mode)) throw Error(file.string(), "is not an ordinary file; save the data to a file first");
    size = uint64_t(s.st_size);
    return h;
}

/// Up to `size` bytes; fewer when the file has become shorter.
size_t readInto(int handle, char* to, size_t size, const fs::path& file)
{
    size_t got = 0;
    while (got < size) {
        const ssize_t n = ::read(handle, to + got, std::min<size_t>(size - got, size_t(1) << 30));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw Error(file.string(), std::string("reading failed: ") + std::strerror(errno));
        if (n == 0) break;
        got += size_t(n);
    }
    return got;
}

}  // namespace

FileBytes::FileBytes(size_t size) : bytes_(std::make_unique_for_overwrite<char[]>(size + padding)), size_(size)
{
    preferLargePages(bytes_.get(), size + padding);
    std::memset(bytes_.get() + size, 0, padding);
    bytes_[size] = '\n';
}

FileBytes readBytes(const fs::path& file, uint64_t cap)
{
    uint64_t size = 0;
    const Handle h = openFile(file, size);
    if (size > cap) throw Error(file.string(), "has " + sizeText(size) + ", the most that is read is " + sizeText(cap) + "; split it first");
    try {
        FileBytes bytes(size);
        const size_t got = readInto(h.value, bytes.data(), size, file);
        if (got != size) throw Error(file.string(), "became shorter while it was read; read it again when its writer has finished");
        return bytes;
    } catch (const std::bad_alloc&) {
        throw Error(file.string(), "has " + sizeText(size) + ", more than the free memory");
    }
}

std::string readStart(const fs::path& file, size_t bytes)
{
    uint64_t size = 0;
    const Handle h = openFile(file, size);
    std::string start(size_t(std::min<uint64_t>(size, bytes)), '\0');
    start.resize(readInto(h.value, start.data(), start.size(), file));
    return start;
}

fs::path insideFolder(const fs::path& folder, std::string name)
{
    for (char& c : name)
        if (c == '\\') c = '/';
    if (name.empty() || name.find('\0') != std::string::npos) return {};
    const bool drive = name.size() > 1 && name[1] == ':';
    const fs::path relative = fs::path(name).lexically_normal();
    if (drive || relative.is_absolute() || relative.begin() == relative.end() || *relative.begin() == "..") return {};
    std::error_code e;
    const fs::path base = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, e);
    if (e) return {};
    const fs::path full = fs::weakly_canonical(base / relative, e);
    if (e) return {};
    const fs::path back = full.lexically_relative(base);
    if (back.empty() || *back.begin() == "..") return {};
    return full;
}

OutputFile::OutputFile(const fs::path& file) : file_(file), target_(file), buffer_(size_t(1) << 20)
{
    std::error_code e;
    if (fs::is_symlink(file, e)) target_ = fs::weakly_canonical(file, e);  // the link stays a link
    if (target_.empty()) throw Error(file.string(), "is a link that leads nowhere: " + e.message());
    if (fs::exists(target_, e) && !fs::is_regular_file(target_, e)) throw Error(file.string(), "is not an ordinary file; choose another name");
    const fs::path folder = target_.parent_path().empty() ? fs::path(".") : target_.parent_path();
    if (!fs::is_directory(folder, e)) throw Error(file.string(), "its folder does not exist; make it first");
    std::random_device random;
    for (int attempt = 0; attempt < 100 && handle_ < 0; ++attempt) {
        temporary_ = folder / ("." + target_.filename().string().substr(0, 200) + "." + std::to_string(random()) + ".tmp");
        handle_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (handle_ < 0 && errno != EEXIST) fail("cannot be written");
    }
    if (handle_ < 0) fail("cannot be written");
}

OutputFile::~OutputFile()
{
    if (handle_ >= 0) ::close(handle_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::fail(const char* doing) const
{
    throw Error(file_.string(), std::string(doing) + ": " + std::strerror(errno));
}

void OutputFile::flush(size_t room)
{
    for (size_t done = 0; done < used_;) {
        const ssize_t n = ::write(handle_, buffer_.data() + done, used_ - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail("writing failed");
        done += size_t(n);
    }
    used_ = 0;
    if (buffer_.size() < room) buffer_.resize(room);
}

void OutputFile::write(const void* bytes, size_t size)
{
    const char* from = static_cast<const char*>(bytes);
    while (size > 0) {
        if (used_ == buffer_.size()) flush();
        const size_t n = std::min(size, buffer_.size() - used_);
        std::memcpy(buffer_.data() + used_, from, n);
        used_ += n;
        from += n;
        size -= n;
    }
}

void OutputFile::close()
{
    if (handle_ < 0) return;
    flush();
    const int h = handle_;
    handle_ = -1;
    if (::close(h) != 0) fail("writing failed");
}

void OutputFile::commit()
{
    close();
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot be put in place");
    temporary_.clear();
}

}  // namespace mw
