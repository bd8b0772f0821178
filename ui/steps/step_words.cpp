// See step_words.h.
#include "ui/steps/step_words.h"

#include <QObject>
#include <QRegularExpression>
#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "core/catalog/lesson.h"
#include "ui/look.h"

namespace mw {

namespace {

const char* kindWord(ElementKind k, bool many)
{
    switch (k) {
        case ElementKind::Vertex:
            return many ? "Vertices" : "Vertex";
        case ElementKind::Edge:
            return many ? "Edges" : "Edge";
        case ElementKind::Face:
            return many ? "Faces" : "Face";
        case ElementKind::Corner:
            return many ? "Corners" : "Corner";
        case ElementKind::Joint:
            return many ? "Joints" : "Joint";
        case ElementKind::Cell:
            return many ? "Cells" : "Cell";
        case ElementKind::Point:
            return many ? "Points" : "Point";
        case ElementKind::Segment:
            return many ? "Segments" : "Segment";
        case ElementKind::Object:
            break;
    }
    return many ? "Objects" : "Object";
}

QString elementText(const Focus& f)
{
    if (f.kind == ElementKind::Edge) return look::count(f.index) + " – " + look::count(f.other);
    if (f.kind == ElementKind::Point) return QString("(%1, %2, %3)").arg(look::number(f.at.x), look::number(f.at.y), look::number(f.at.z));
    if (f.kind == ElementKind::Segment) return QObject::tr("length %1").arg(look::number(glm::distance(f.at, f.to)));
    return look::count(f.index);
}

std::optional<Role> roleOf(const QString& word)
{
    static const QStringList words{"current", "neighbour", "new", "removed", "rejected"};
    const qsizetype i = words.indexOf(word);
    return i < 0 ? std::nullopt : std::optional(Role(i));
}

}  // namespace

namespace {

const Lesson* lessonOf(const Operation& op)
{
    return findLesson(op.id);
}

const LessonNumber* lessonNumber(const Operation& op, const std::string& phase, const QString& name)
{
    const Lesson* l = lessonOf(op);
    return l ? l->number(phase, name.toStdString()) : nullptr;
}

PhaseWords wordsOf(const LessonPhase& p)
{
    return {QString::fromStdString(p.id), QString::fromStdString(p.title), QString::fromStdString(p.sentence), QString::fromStdString(p.formula)};
}

}  // namespace

std::vector<PhaseWords> phasesOf(const Operation& op)
{
    std::vector<PhaseWords> all;
    if (const Lesson* l = lessonOf(op))
        for (const LessonPhase& p : l->phases) all.push_back(wordsOf(p));
    return all;
}

PhaseWords phaseOf(const Operation& op, const QString& id)
{
    const Lesson* l = lessonOf(op);
    const LessonPhase* p = l ? l->phase(id.toStdString()) : nullptr;
    return p ? wordsOf(*p) : PhaseWords{id, id, {}, {}};
}

QString numberTitle(const Operation& op, const QString& name, const std::string& phase)
{
    const LessonNumber* n = lessonNumber(op, phase, name);
    return n ? QString::fromStdString(n->title) : name;
}

QString numberText(const Operation& op, const QString& name, double value, const std::string& phase)
{
    const LessonNumber* n = lessonNumber(op, phase, name);
    return look::formatted(value, n ? n->format : std::string(), n ? n->words : std::vector<std::string>());
}

bool isLogarithmic(const Operation& op, const QString& name)
{
    const LessonNumber* n = lessonNumber(op, {}, name);
    return n && n->log;
}

bool isWorthACurve(const Operation& op, const QString& name)
{
    const LessonNumber* n = lessonNumber(op, {}, name);
    return n && n->plot;
}

QString plottedFirst(const Operation& op)
{
    const Lesson* l = lessonOf(op);
    return l ? QString::fromStdString(l->plot) : QString();
}

QString plottedOver(const Operation& op, const QStringList& numbers)
{
    const Lesson* l = lessonOf(op);
    const bool all = std::all_of(numbers.begin(), numbers.end(), [&](const QString& n) { return isWorthACurve(op, n); });
    return l && all ? QString::fromStdString(l->plotOver) : QString();
}

bool isInMatrix(const Operation& op, const std::string& phase, const QString& number)
{
    const QString formula = phaseOf(op, QString::fromStdString(phase)).formula;
    const qsizetype table = formula.indexOf("<table");
    return table >= 0 && formula.indexOf('{' + number + '}', table) >= 0;
}

QString filled(const Operation& op, const QString& rich, const StepRecord& step)
{
    static const QRegularExpression place("\\{([^{}|]+)(?:\\|([a-z]+))?\\}");
    QString out;
    qsizetype from = 0;
    for (auto i = place.globalMatch(rich); i.hasNext();) {
        const QRegularExpressionMatch m = i.next();
        out += rich.mid(from, m.capturedStart() - from);
        from = m.capturedEnd();
        if (const std::optional<Role> role = roleOf(m.captured(2))) {
            out += QString("<span style='color:%1'><i>%2</i></span>").arg(look::roleTextColor(*role).name(), m.captured(1));
            continue;
        }
        const std::string name = m.captured(1).toStdString();
        const auto n = std::find_if(step.numbers.begin(), step.numbers.end(), [&](const Number& x) { return name == x.name; });
        out += n == step.numbers.end() ? QString("–") : numberText(op, m.captured(1), n->value, step.phase).toHtmlEscaped();
    }
    return out + rich.mid(from);
}

std::vector<FocusWords> focusOf(const StepRecord& step)
{
    // One of a kind and role is named; many are counted.
    std::vector<FocusWords> found;
    std::vector<std::pair<std::pair<ElementKind, Role>, size_t>> counts;
    for (const Focus& f : step.focus) {
        if (f.label) {
            found.push_back({QString("%1 %2").arg(QObject::tr(kindWord(f.kind, false)), QString::fromUtf8(f.label)), elementText(f), f.role});
            continue;
        }
        const std::pair key(f.kind, f.role);
        auto c = std::find_if(counts.begin(), counts.end(), [&](const auto& x) { return x.first == key; });
        if (c == counts.end())
            counts.push_back({key, 1});
        else
            ++c->second;
    }
    for (const auto& [key, n] : counts) {
        const auto f =
            std::find_if(step.focus.begin(), step.focus.end(), [&](const Focus& x) { return !x.label && std::pair(x.kind, x.role) == key; });
        const QString kind = QObject::tr(kindWord(key.first, n > 1));
        const bool plain = key.second == Role::Current;
        found.push_back({plain ? kind : QObject::tr("%1, %2").arg(kind, look::roleName(key.second).toLower()),
                         n > 1 ? look::count(n) : elementText(*f), key.second});
    }
    std::stable_sort(found.begin(), found.end(), [](const FocusWords& a, const FocusWords& b) { return a.role < b.role; });
    return found;
}

}  // namespace mw
