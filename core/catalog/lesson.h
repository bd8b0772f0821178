// The words of an algorithm: what the step player says at each phase, in which formula, and how it calls the numbers.
// One JSON file an algorithm, resources/lessons/ID.json; all of it is compiled in.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace mw {

/// How a number of a step is shown.
struct LessonNumber {
    std::string name;                ///< as the algorithm calls it
    std::string title;               ///< for people
    std::string format;              ///< "integer", "N significant", "N decimals", "percent", "degrees", "words"
    std::vector<std::string> words;  ///< of format "words": value 0, 1, 2, ...
    bool plot = false;               ///< worth a curve
    bool log = false;                ///< of logarithmic height
};

struct LessonPhase {
    std::string id;        ///< as in Step(id)
    std::string title;     ///< "Quadric of every vertex"
    std::string sentence;  ///< one or two; rich text with placeholders
    std::string formula;   ///< rich text; may be empty
    std::vector<LessonNumber> numbers;
};

/// Rich text (intro, sentences, formulas) is HTML as a text browser shows it: i, b, sub, sup and tables. `{name}` stands for a number of the step,
/// `{v|current}` for the letter v in the colour of a role (current, neighbour, new, removed, rejected). `&lbrace;` is a plain brace.
struct Lesson {
    std::string id;  ///< of the operation
    std::string title;
    std::string section;             ///< of the book
    std::string intro;               ///< rich text
    std::vector<std::string> tries;  ///< "try": exercises, rich text
    /// A scene to try it on: a source with parameters ("icosphere:subdivisions=3") and operations on it, as on the command line.
    struct Scene {
        std::string source;
        std::vector<std::string> operations;
        std::string parameters;               ///< of the algorithm itself: "ratio=0.2"
        double azimuth = 30, elevation = 20;  ///< degrees, of the camera
    } scene;
    std::string plot;      ///< the number to plot at first; empty: none
    std::string plotOver;  ///< the number that those worth a curve are plotted over, as "sweep"; empty: the step
    std::vector<LessonPhase> phases;

    const LessonPhase* phase(std::string_view phaseId) const;
    /// Of that phase, else of any phase.
    const LessonNumber* number(std::string_view phaseId, std::string_view name) const;
};

/// Throws Error that names the field when the text is no JSON, a field is missing or of the wrong type, or a placeholder is not closed.
Lesson parseLesson(std::string_view text);
/// All that are compiled in, by id; parsed once.
const std::vector<Lesson>& lessons();
/// Null when there is none.
const Lesson* findLesson(std::string_view id);

}  // namespace mw
