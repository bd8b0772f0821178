// What every panel is given. Panels know the document and these services, never each other.
#pragma once
#include <QString>
#include <functional>

#include "core/scene/document.h"
#include "ui/jobs.h"
#include "ui/steps/step_session.h"
#include "ui/view_state.h"

namespace mw {

class EvaluationService;
class Playback;

struct Session {
    Document& document;
    Jobs& jobs;
    ViewState& view;
    StepSession& steps;
    EvaluationService* evaluations = nullptr;               ///< who keeps the stacks' results up to date
    Playback* playback = nullptr;                           ///< who moves the playhead
    std::function<void(const QString& text)> trouble = {};  ///< says what could not be done
    std::function<void(const QString& text)> notice = {};   ///< says what was done
};

}  // namespace mw
