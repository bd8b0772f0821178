// The line above the view (what is picked, shading, colours, camera) and the strip of tools beside it.
#pragma once
#include <QWidget>

#include "ui/session.h"

namespace mw {

class Viewport;
struct Actions;

QWidget* makeViewHeader(Session& session, Viewport& viewport, Actions& actions, QWidget* parent);
QWidget* makeToolStrip(Actions& actions, QWidget* parent);
/// Triangles, patches and the height under the pointer: over the view while there is a terrain.
QWidget* makeGroundHud(Session& session, Viewport& viewport);
/// "Showing Base mesh, level 0 of 5. Show result": over the view while another level is shown.
QWidget* makeLevelHud(Session& session, QWidget* parent);

}  // namespace mw
