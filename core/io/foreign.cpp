#include "core/io/foreign.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/io/file.h"
#include "core/io/gltf.h"
#include "core/io/placement.h"

namespace mw {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

constexpr const char* remedy = "; open it in another program and export it as glTF";
constexpr int outOfMemory = 3;                  // exit status of meshwright-import
constexpr size_t mostWords = size_t(16) << 20;  // of its standard error
constexpr size_t resultFloor = size_t(256) << 20, resultPerByte = 16;

fs::path importer(const fs::path& file)
{
    if (const char* named = std::getenv("MESHWRIGHT_IMPORT"); named && *named) return named;
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const fs::path beside = self.parent_path() / "meshwright-import";
    if (!error && access(beside.c_str(), X_OK) == 0) return beside;
    throw Error(file.string(), "the program meshwright-import that reads such files is not beside this one (" + self.parent_path().string() +
                                   "); install meshwright again, or open the file in another program and export it as glTF");
}

/// A pipe whose ends are closed with it.
struct Pipe {
    int read = -1, write = -1;
    Pipe()
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw Error(std::string("no pipe can be made (") + std::strerror(errno) + "); close some files and try again");
        read = ends[0], write = ends[1];
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() { closeRead(), closeWrite(); }
    void closeRead() { closeEnd(read); }
    void closeWrite() { closeEnd(write); }
    static void closeEnd(int& end)
    {
        if (end >= 0) close(end);
        end = -1;
    }
};

/// A running program in a process group of its own. Ended and reaped with this object, whatever happens.
class Child {
public:
    Child(const fs::path& program, const fs::path& argument, const Pipe& out, const Pipe& err);
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        if (pid_ <= 0) return;
        kill(-pid_, SIGKILL);
        while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    /// Its wait status once it has ended.
    bool ended(int& status)
    {
        if (waitpid(pid_, &status, WNOHANG) != pid_) return false;
        pid_ = -1;
        return true;
    }

private:
    pid_t pid_ = -1;
};

Child::Child(const fs::path& program, const fs::path& argument, const Pipe& out, const Pipe& err)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.write, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t all, nothing;
    sigfillset(&all);
    sigemptyset(&nothing);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &nothing);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    std::string name = program.string(), file = fs::absolute(argument).string();
    char* const words[] = {name.data(), file.data(), nullptr};
    const int error = posix_spawn(&pid_, name.c_str(), &actions, &attributes, words, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) {
        pid_ = -1;
        throw Error(name + " cannot be started (" + std::strerror(error) + "); install meshwright again");
    }
}

/// Twice what meshwright-import allows itself of computing: other programs may be busy.
std::chrono::seconds patience()
{
    const char* value = std::getenv("MESHWRIGHT_IMPORT_SECONDS");
    unsigned seconds = 0;
    if (!value || std::from_chars(value, value + std::strlen(value), seconds).ec != std::errc() || seconds == 0 || seconds > 100000) seconds = 60;
    return std::chrono::seconds(2 * seconds);
}

struct Output {
    std::vector<uint8_t> result;
    std::string words;
    int status = 0;
};

/// False at the end of the pipe.
template <class Bytes>
bool take(int from, Bytes& to, size_t most, const char* what)
{
    std::array<char, 1 << 16> buffer;
    const ssize_t n = read(from, buffer.data(), buffer.size());
    if (n < 0) return errno == EINTR || errno == EAGAIN;
    if (to.size() + size_t(n) > most)
        throw Error(std::string(what) + " grows beyond " + std::to_string(most >> 20) + " MiB; the file is damaged" + remedy);
    to.insert(to.end(), buffer.data(), buffer.data() + n);
    return n > 0;
}

Output run(const fs::path& program, const fs::path& file, size_t mostResult, Progress* progress)
{
    Pipe out, err;
    Child child(program, file, out, err);
    out.closeWrite(), err.closeWrite();
    Output all;
    const auto deadline = Clock::now() + patience();
    const auto look = [&] {
        if (progress) progress->at(progress->fraction);
        if (Clock::now() > deadline) throw Error("reading it takes longer than " + std::to_string(patience().count()) + " s" + remedy);
    };
    while (out.read >= 0 || err.read >= 0) {
        look();
        pollfd ends[2] = {{out.read, POLLIN, 0}, {err.read, POLLIN, 0}};  // closed ones are passed over
        if (poll(ends, 2, 40) < 0 && errno != EINTR) throw Error(std::string("the importer cannot be heard (") + std::strerror(errno) + ")");
        if (ends[0].revents && !take(out.read, all.result, mostResult, "what is made of it")) out.closeRead();
        if (ends[1].revents && !take(err.read, all.words, mostWords, "what is said about it")) err.closeRead();
    }
    while (!child.ended(all.status)) {
        look();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return all;
}

/// The last line of its standard error, an object; libraries may have spoken before.
nlohmann::json report(const std::string& words)
{
    const size_t end = words.find_last_not_of(" \r\n");
    if (end == words.npos) return {};
    const size_t before = words.find_last_of('\n', end);
    nlohmann::json said = nlohmann::json::parse(words.substr(before == words.npos ? 0 : before + 1, end - before), nullptr, false);
    return said.is_object() ? said : nlohmann::json();
}

std::string textOf(const nlohmann::json& from, const char* key)
{
    const auto found = from.find(key);
    return found != from.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Why it ended without a result.
std::string reason(int status, const nlohmann::json& said)
{
    const std::string memory = "reading it takes more memory than the importer may have; the file is damaged or too large" + std::string(remedy);
    if (WIFSIGNALED(status)) switch (WTERMSIG(status)) {
            case SIGXCPU:
                return std::string("the importer was ended because reading it took too long") + remedy;
            case SIGKILL:
                return std::string("the importer was ended from outside, for want of memory or time, while reading it") + remedy;
            case SIGSEGV:
            case SIGBUS:
            case SIGABRT:
            case SIGILL:
            case SIGFPE:
                return std::string("the importer ended by a memory error while reading it; the file is damaged or of an unusual kind") + remedy;
            default:
                return "the importer was ended by signal " + std::to_string(WTERMSIG(status)) + " while reading it" + remedy;
        }
    if (WEXITSTATUS(status) == outOfMemory) return memory;
    if (const std::string why = textOf(said, "error"); !why.empty()) return why;
    return "the importer could not read it (it ended with status " + std::to_string(WEXITSTATUS(status)) + ")" + remedy;
}

}  // namespace

bool isForeign(std::string_view e)
{
    return e == ".fbx" || e == ".x" || e == ".md5mesh" || e == ".md5anim" || e == ".dae" || e == ".3ds";
}

Imported readForeign(const fs::path& file, Progress* progress)
{
    readStart(file, 1);  // a missing file, a folder and the like are told as with every other format
    std::error_code ignored;
    const auto bytes = fs::file_size(file, ignored);
    const fs::path program = importer(file);
    try {
        Output output = run(program, file, resultFloor + resultPerByte * size_t(bytes), progress);
        const nlohmann::json said = report(output.words);
        if (!WIFEXITED(output.status) || WEXITSTATUS(output.status) != 0) throw Error(reason(output.status, said));
        Imported in = readGltf(output.result, {}, {GltfReadOptions::Project::Always}, progress);
        in.project = false;
        in.format = textOf(said, "format");
        in.units = textOf(said, "units");
        if (const auto metres = said.find("metresPerUnit"); metres != said.end() && metres->is_number() && metres->get<double>() > 0)
            in.placement.metresPerUnit = metres->get<double>();
        in.placement.up = upAxisOf(textOf(said, "up")).value_or(UpAxis::Y);
        in.placementFromFile = said.value("placementFromFile", false);
        if (const auto list = said.find("warnings"); list != said.end() && list->is_array())
            for (const nlohmann::json& w : *list) in.warnings.push_back({textOf(w, "code"), textOf(w, "text"), {}});
        return in;
    } catch (const Error& e) {
        throw Error(file.string(), e.file().empty() ? e.reason() : e.what());
    }
}

}  // namespace mw
