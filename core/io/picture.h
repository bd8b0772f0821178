// What kind of picture some bytes are, and whether other programs will take them, without decoding the pixels.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mw {

/// "image/png", "image/jpeg", or empty. Only the beginning is looked at.
std::string pictureType(std::span<const uint8_t> bytes);

/// The picture as a glTF should have it: whole up to its pixels, and without the colour profiles, pixel shapes and animations of PNG, which
/// glTF says must be ignored and validators complain about. The same pointer when there is nothing to do, null when it is damaged.
std::shared_ptr<const std::vector<uint8_t>> portablePicture(const std::shared_ptr<const std::vector<uint8_t>>& bytes);

}  // namespace mw
