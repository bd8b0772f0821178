// The timeline: clips, transport, tracks with keys.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeTimelinePanel(Session& session, QWidget* parent);

/// Space, arrows, Home and End move the playhead while `on` has the focus and no algorithm is stepped.
void installPlaybackShortcuts(Session& session, QWidget* on);

}  // namespace mw
