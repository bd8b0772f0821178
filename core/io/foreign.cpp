#include "core/io/foreign.h"

namespace mw {

bool isForeign(std::string_view e)
{
    return e == ".fbx" || e == ".x" || e == ".md5mesh" || e == ".md5anim" || e == ".dae" || e == ".3ds";
}

Imported readForeign(const std::filesystem::path&, Progress*)
{
    throw Error("not yet");
}

}  // namespace mw
