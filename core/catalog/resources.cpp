// Finding an embedded text by its path.
#include "core/catalog/resources.h"

namespace mw {

std::string_view resourceText(std::string_view path)
{
    for (const Resource& r : resources()) {
        if (!path.ends_with(r.path)) continue;
        if (path.size() == r.path.size() || path[path.size() - r.path.size() - 1] == '/') return r.text;
    }
    return {};
}

}  // namespace mw
