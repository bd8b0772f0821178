// Pictures of materials, decoded off the window's thread and kept.
#pragma once
#include <QImage>
#include <QObject>
#include <functional>

#include "core/scene/scene.h"

namespace mw {

/// The picture scaled into `side` x `side`, at once when it is known; else null, and `ready` is called later, unless `receiver` is gone. A
/// picture that cannot be decoded stays null.
QImage decodedPicture(const Image& image, int side, QObject* receiver, std::function<void()> ready);
QSize pictureSize(const Image& image);  ///< from its header; empty when that cannot be read

}  // namespace mw
