// The words of a step: titles, sentences and formulas of its lesson, with the step's numbers put in.
#pragma once
#include <QString>
#include <vector>

#include "core/catalog/catalog.h"
#include "core/steps/stepper.h"

namespace mw {

struct PhaseWords {
    QString id, title, sentence, formula;  ///< sentence and formula are rich text with {name} and {letter|role}
};

/// In the order of the lesson; empty for an algorithm without one.
std::vector<PhaseWords> phasesOf(const Operation& op);
/// The lesson's words, or the bare id where it has none.
PhaseWords phaseOf(const Operation& op, const QString& id);

/// How a number is called and written.
QString numberTitle(const Operation& op, const QString& name, const std::string& phase = {});
QString numberText(const Operation& op, const QString& name, double value, const std::string& phase = {});
bool isLogarithmic(const Operation& op, const QString& name);
/// The number to plot before one was chosen; empty when the lesson says none.
QString plottedFirst(const Operation& op);
/// The number that these are plotted over; empty: the step.
QString plottedOver(const Operation& op, const QStringList& numbers);

/// {name} becomes the step's number, {letter|role} the letter in that role's colour. A number the step has not got becomes a dash.
QString filled(const Operation& op, const QString& rich, const StepRecord& step);
/// Numbers the formula sets out as a matrix: they need no row of their own.
bool isInMatrix(const Operation& op, const std::string& phase, const QString& number);
/// Worth showing at every step, not only at those that give it.
bool isWorthACurve(const Operation& op, const QString& number);

/// The elements a step is about, as "Edge v, w" and "635 – 2,478".
struct FocusWords {
    QString title, text;
    Role role;
};
std::vector<FocusWords> focusOf(const StepRecord& step);

}  // namespace mw
