// Pictures of the view in files: one, or a turntable. Drawn off-screen, a picture at a time, so that the window keeps answering.
#pragma once
#include <QString>

#include "ui/session.h"

class QWidget;

namespace mw {

class Viewport;

struct PictureWish {
    int width = 1920, height = 1080;
    bool transparent = false, grid = true;
    int count = 36;        ///< of a turntable
    bool animated = true;  ///< one file that plays (APNG); else one a picture
};

/// What the view shows, without marks of selection and pointer, for a picture of this size.
Frame pictureFrame(const Session& session, Viewport& viewport, const PictureWish& wish);
/// Throws Error.
void savePicture(const Session& session, Viewport& viewport, const PictureWish& wish, const QString& file);
/// A job. `file` is "turn.apng", or "turn.png" for turn-000.png and so on.
void saveTurntable(Session& session, Viewport& viewport, const PictureWish& wish, const QString& file);

/// The same after a dialog that asks for size and file.
void askPicture(Session& session, Viewport& viewport, QWidget* parent);
void askTurntable(Session& session, Viewport& viewport, QWidget* parent);

}  // namespace mw
