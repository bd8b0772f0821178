// Identity of everything but positions.
#include "core/subdivide/remembered.h"

#include <algorithm>

namespace mw {

FaceIdentity::FaceIdentity(const Mesh& mesh) : names_(std::to_string(mesh.vertexCount()))
{
    add(mesh.faceStart());
    add(mesh.cornerVertex());
    add(mesh.lines());
    for (const Attribute& a : mesh.attributes()) {
        names_ += '\n' + a.name + ' ' + std::to_string(int(a.domain)) + ' ' + std::to_string(a.components) + ' ' + std::to_string(int(a.stored));
        std::visit([this](const auto& v) { add(v); }, a.values);
    }
    for (const std::string& g : mesh.groupNames()) names_ += "\ngroup " + g;
}

void FaceIdentity::add(const void* id, std::weak_ptr<const void> owner)
{
    arrays_.emplace_back(id, std::move(owner));
}

bool FaceIdentity::gone() const
{
    return std::any_of(arrays_.begin(), arrays_.end(), [](const auto& a) { return a.first && a.second.expired(); });
}

bool FaceIdentity::operator==(const FaceIdentity& o) const
{
    if (names_ != o.names_ || arrays_.size() != o.arrays_.size() || gone() || o.gone()) return false;
    for (size_t i = 0; i < arrays_.size(); ++i)
        if (arrays_[i].first != o.arrays_[i].first) return false;
    return true;
}

}  // namespace mw
