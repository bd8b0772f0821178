// A plot of the algorithm's numbers over its steps.
#pragma once
#include <QWidget>

#include "ui/session.h"

namespace mw {

QWidget* makePlotPanel(Session& session, QWidget* parent);

/// The numbers as text: a line a step that gave any, a column a number.
QByteArray seriesAsCsv(const StepSession& steps, const QStringList& numbers);

}  // namespace mw
