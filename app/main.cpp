// One executable: with a verb it works without a window, else it opens the window on the files named.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "app/cli/verb.h"

namespace {

void overview(std::ostream& out)
{
    out << "usage: meshwright [FILE...]         open the window on the files\n"
           "       meshwright VERB [ARGUMENTS]   work without a window\n"
           "       meshwright --help | --version\n\nVerbs (meshwright VERB --help says more):\n";
    for (const mw::cli::Verb& v : mw::cli::verbs()) {
        std::string name = v.name;
        name.resize(std::max<size_t>(12, name.size() + 1), ' ');
        out << "  " << name << v.help << '\n';
    }
    out << "\nWhere a verb reads a file, sample:mannequin stands for a walking figure that the program makes itself.\nExit status: 0 done, 1 could "
           "not, 2 wrong usage.\n";
}

}  // namespace

#ifdef MESHWRIGHT_HAS_GUI
int runGui(int argc, char** argv);  // app/gui.cpp

namespace {

// Qt ends the whole process when it finds no display, so we look first.
bool hasDisplay()
{
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (const char* value = std::getenv(name); value && *value) return true;
    return false;
}

int openWindow(int argc, char** argv)
{
    if (hasDisplay()) return runGui(argc, argv);
    std::cerr << "meshwright: there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set). These verbs need none:\n\n";
    overview(std::cerr);
    return 1;
}

}  // namespace
#else
namespace {

int openWindow(int, char**)
{
    std::cerr << "meshwright: this build has no window (it was made without MESHWRIGHT_GUI). These verbs need none:\n\n";
    overview(std::cerr);
    return 1;
}

}  // namespace
#endif

int main(int argc, char** argv)
{
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (first == "--help" || first == "-h" || first == "help") {
        overview(std::cout);
        return 0;
    }
    if (first == "--version") {
        std::cout << "meshwright " MESHWRIGHT_VERSION "\n";
        return 0;
    }
    if (const mw::cli::Verb* verb = mw::cli::findVerb(first)) return mw::cli::runVerb(*verb, {argv + 2, size_t(argc - 2)});
    std::error_code ignored;
    const bool option = first.size() > 1 && first[0] == '-';
    const bool sample = first.starts_with("sample:");
    if (option || (!sample && !first.empty() && first.find_first_of("./") == first.npos && !std::filesystem::exists(first, ignored))) {
        std::cerr << "meshwright: '" << first << "' is " << (option ? "an unknown option" : "neither a verb nor a file") << "\n\n";
        overview(std::cerr);
        return 2;
    }
    return openWindow(argc, argv);
}
