// The table of verbs, and how one is run: errors become messages and exit statuses here and nowhere else.
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <new>

#include "app/cli/verb.h"
#include "core/error.h"

namespace mw::cli {

std::span<const Verb> verbs()
{
    static const std::vector<Verb> table{
        infoVerb,   algorithmsVerb, editsVerb,   processVerb, stepVerb, convertVerb,
#ifdef MESHWRIGHT_HAS_RENDER
        renderVerb, galleryVerb,
#endif
        ikVerb,     poseVerb,       terrainVerb, lessonsVerb,
    };
    return table;
}

const Verb* findVerb(std::string_view name)
{
    for (const Verb& v : verbs())
        if (name == v.name) return &v;
    return nullptr;
}

namespace {

// A full disk or a closed pipe must not look like success.
int flushed(int status)
{
    std::cout.flush();
    if (std::cout.good()) return status;
    std::cerr << "meshwright: standard output: cannot be written" << (errno ? std::string(" (") + std::strerror(errno) + ")" : "")
              << "; check the disk or the program that reads the pipe\n";
    return 1;
}

}  // namespace

int runVerb(const Verb& verb, std::span<char* const> words)
{
    std::signal(SIGPIPE, SIG_DFL);  // whoever reads our pipe may stop early, also under a parent that ignores the signal
    std::ios::sync_with_stdio(false);
    try {
        Arguments arguments(words);
        if (arguments.flag("--help", "-h")) {
            std::cout << "usage: meshwright " << verb.usage << '\n';
            return flushed(0);
        }
        return flushed(verb.run(arguments));
    } catch (const UsageError& e) {
        std::cerr << "meshwright: " << verb.name << ": " << e.what() << "\nusage: meshwright " << verb.usage << '\n';
        return 2;
    } catch (const Error& e) {
        std::cerr << "meshwright: " << e.what() << '\n';
    } catch (const Cancelled&) {
        std::cerr << "meshwright: interrupted\n";
        return 130;
    } catch (const std::bad_alloc&) {
        std::cerr << "meshwright: " << verb.name << ": not enough memory for this; try a smaller file or fewer levels\n";
    } catch (const std::exception& e) {
        std::cerr << "meshwright: " << verb.name << ": " << e.what() << '\n';
    }
    return 1;
}

}  // namespace mw::cli
