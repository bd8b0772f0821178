#include "core/io/bvh.h"

namespace mw {

Imported readBvh(const std::filesystem::path&, Progress*)
{
    throw Error("not yet");
}

std::vector<Warning> writeBvh(const Scene&, const std::filesystem::path&, Progress*)
{
    throw Error("not yet");
}

}  // namespace mw
