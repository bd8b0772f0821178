// What a lesson is tried on: its scene as a value.
#pragma once
#include "core/catalog/catalog.h"
#include "core/catalog/lesson.h"

namespace mw {

/// The source of the lesson's scene and the operations on it. Nothing for an algorithm that is a source itself. Throws Error, Cancelled.
Value lessonSubject(const Lesson& lesson, Progress* progress = nullptr);

}  // namespace mw
