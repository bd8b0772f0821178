// Lessons: the list by chapter, and the text of one.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeLessonsPanel(Session& session, QWidget* parent);
QWidget* makeLessonTextPanel(Session& session, QWidget* parent);

}  // namespace mw
