// Small files made on the spot, and the one mesh of what was read.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include "core/io/io.h"

#include "mesh_checks.h"

namespace mw::test {

/// A folder that is gone with the object.
struct Folder {
    std::filesystem::path path;
    Folder()
    {
        // In memory where the system has such a folder: some tests write thousands of files.
        const bool memory = ::access("/dev/shm", W_OK) == 0;
        std::string name =
            ((memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path()) / "meshwright-test-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path = name;
    }
    ~Folder()
    {
        std::error_code e;
        std::filesystem::remove_all(path, e);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
};

inline const MeshObject& objectOf(const Scene& scene)
{
    return *scene.find(scene.meshes().at(0));
}
inline const Mesh& meshOf(const Imported& in)
{
    return objectOf(in.scene).base;
}
inline const Warning* warning(const std::vector<Warning>& all, const std::string& code)
{
    for (const Warning& w : all)
        if (w.code == code) return &w;
    return nullptr;
}
/// The text of the Error that `f` throws, or empty.
template <class F>
std::string errorOf(F&& f)
{
    try {
        f();
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}
/// `text` with each `from` as `to`.
inline std::string replaced(const std::string& text, char from, const std::string& to)
{
    std::string out;
    for (const char c : text) out += c == from ? to : std::string(1, c);
    return out;
}
inline std::string bytesOf(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace mw::test
