// meshwright-import FILE: a foreign file as our own project on standard output. Standard error gets one line of JSON: format, units and
// warnings, or the error. It limits itself: CPU seconds by MESHWRIGHT_IMPORT_SECONDS (60), memory by the size of the
// file, at most MESHWRIGHT_IMPORT_MEMORY in MiB (4096).
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "app/importer/read.h"
#include "core/io/gltf.h"
#include "core/io/placement.h"

#ifdef __SANITIZE_ADDRESS__
// Assimp leaks when it refuses a file. Its crashes shall look as they do without sanitizers, and the address space cannot be limited.
extern "C" const char* __asan_default_options()
{
    return "detect_leaks=0:abort_on_error=1:handle_segv=0:handle_sigbus=0:handle_sigfpe=0:max_allocation_size_mb=1024:hard_rss_limit_mb=3000";
}
#endif

namespace {

constexpr int outOfMemory = 3;

rlim_t setting(const char* name, rlim_t otherwise)
{
    const char* value = std::getenv(name);
    unsigned long number = 0;
    if (value && std::from_chars(value, value + std::strlen(value), number).ec == std::errc() && number > 0) return number;
    return otherwise;
}

void limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard)
{
    const rlimit both{soft, hard};
    setrlimit(what, &both);
}

void limitMyself([[maybe_unused]] const char* file)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for the result any more
    limit(RLIMIT_CORE, 0, 0);
    const rlim_t seconds = setting("MESHWRIGHT_IMPORT_SECONDS", 60);
    limit(RLIMIT_CPU, seconds, seconds + 1);
#ifndef __SANITIZE_ADDRESS__
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    const rlim_t floor = rlim_t(1) << 30, most = setting("MESHWRIGHT_IMPORT_MEMORY", 4096) << 20;
    const rlim_t bytes = ignored || size > most ? most : std::min(most, floor + 64 * rlim_t(size));
    limit(RLIMIT_AS, bytes, bytes);
#endif
}

void say(const nlohmann::json& what)
{
    std::cerr << what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

bool writeAll(const std::vector<uint8_t>& bytes)
{
    for (size_t at = 0; at < bytes.size();) {
        const ssize_t n = write(STDOUT_FILENO, bytes.data() + at, bytes.size() - at);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        at += size_t(n);
    }
    return true;
}

int run(const char* file)
{
    const mw::Imported in = mw::readByAssimp(file);
    const std::vector<uint8_t> glb = mw::glbOf(in.scene, {.project = true});
    nlohmann::json warnings = nlohmann::json::array();
    for (const mw::Warning& w : in.warnings) warnings.push_back({{"code", w.code}, {"text", w.text}});
    say({{"format", in.format},
         {"units", in.units},
         {"metresPerUnit", in.placement.metresPerUnit},
         {"up", mw::upText(in.placement.up)},
         {"placementFromFile", in.placementFromFile},
         {"warnings", warnings}});
    return writeAll(glb) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2 || argv[1][0] == '-') {
        std::cerr
            << "usage: meshwright-import FILE > OUT.glb\n\nReads FBX, X, MD5, COLLADA and 3D Studio files for meshwright; `meshwright convert` is "
               "what you want.\n";
        return 2;
    }
    limitMyself(argv[1]);
    try {
        return run(argv[1]);
    } catch (const mw::Error& e) {
        say({{"error", e.reason()}});
    } catch (const std::bad_alloc&) {
        return outOfMemory;
    } catch (const std::exception& e) {
        say({{"error", std::string("could not be read (") + e.what() + "); open it in another program and export it as glTF"}});
    }
    return 1;
}
