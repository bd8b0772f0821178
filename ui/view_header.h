// The line above the views (what is picked, shading, colours, camera), the strip of tools beside them and the notes over them.
#pragma once
#include <QWidget>

#include "ui/session.h"

namespace mw {

class ViewArea;
class Viewport;
struct Actions;

/// What is shared by all views, and, while there is only one, what it has for itself.
QWidget* makeViewHeader(Session& session, ViewArea& views, Actions& actions, QWidget* parent);
/// Above one of several views: its shading, colours, level and camera.
QWidget* makePaneHeader(Session& session, ViewArea& views, Viewport& viewport, Actions& actions, QWidget* parent);
QWidget* makeToolStrip(Actions& actions, QWidget* parent);
/// What lies over a view, one below another from its top left: the level shown, what a terrain counts, what is measured, and why the tool in
/// hand has no handles.
void makeHuds(Session& session, Viewport& viewport);

}  // namespace mw
