#include "core/io/height_picture.h"

namespace mw {

Imported readHeightPicture(const std::filesystem::path&, Progress*)
{
    throw Error("not yet");
}

std::vector<Warning> writeHeightPicture(const Scene&, const std::filesystem::path&, Progress*)
{
    throw Error("not yet");
}

}  // namespace mw
