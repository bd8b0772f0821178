// Reads lessons, strictly: a slip in one is found by a test and not by a student.
#include "core/catalog/lesson.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/catalog/resources.h"

namespace mw {

namespace {

using nlohmann::json;

/// One object of the file and where it stands, for error texts; remembers which fields were asked for.
class Reader {
public:
    Reader(const json& object, std::string place) : object_(object), place_(std::move(place))
    {
        if (!object.is_object()) fail("is not an object");
    }
    /// Throws when a field was not asked for: most likely it is misspelt.
    void end() const
    {
        for (const auto& [key, value] : object_.items())
            if (!asked_.contains(key)) fail("has the unknown field \"" + key + "\"");
    }
    std::string text(const char* name, bool needed = true)
    {
        const json* v = field(name, needed);
        if (!v) return {};
        if (!v->is_string()) fail(std::string("field \"") + name + "\" is not a text");
        return v->get<std::string>();
    }
    std::vector<std::string> texts(const char* name)
    {
        std::vector<std::string> out;
        for (const json& v : list(name, false)) {
            if (!v.is_string()) fail(std::string("field \"") + name + "\" holds something that is not a text");
            out.push_back(v.get<std::string>());
        }
        return out;
    }
    bool flag(const char* name)
    {
        const json* v = field(name, false);
        if (v && !v->is_boolean()) fail(std::string("field \"") + name + "\" is neither true nor false");
        return v && v->get<bool>();
    }
    double number(const char* name, double otherwise)
    {
        const json* v = field(name, false);
        if (v && !v->is_number()) fail(std::string("field \"") + name + "\" is not a number");
        return v ? v->get<double>() : otherwise;
    }
    const json& list(const char* name, bool needed)
    {
        static const json empty = json::array();
        const json* v = field(name, needed);
        if (v && !v->is_array()) fail(std::string("field \"") + name + "\" is not a list");
        return v ? *v : empty;
    }
    const json* field(const char* name, bool needed)
    {
        asked_.insert(name);
        const auto i = object_.find(name);
        if (i == object_.end() && needed) fail(std::string("lacks the field \"") + name + "\"");
        return i == object_.end() ? nullptr : &*i;
    }
    [[noreturn]] void fail(const std::string& what) const { throw Error(place_ + " " + what + "; correct the lesson file"); }

private:
    const json& object_;
    std::string place_;
    std::set<std::string, std::less<>> asked_;
};

/// Every brace opens a placeholder: a name, or a letter and a role.
void checkPlaceholders(const Reader& in, const char* field, std::string_view text)
{
    static const std::set<std::string_view> roles = {"current", "neighbour", "new", "removed", "rejected"};
    for (size_t open = text.find('{'); open != text.npos; open = text.find('{', open + 1)) {
        const size_t close = text.find('}', open);
        const std::string where = std::string("field \"") + field + "\"";
        if (close == text.npos) in.fail(where + " has a { without its }");
        const std::string_view inner = text.substr(open + 1, close - open - 1);
        const size_t bar = inner.find('|');
        if (inner.empty() || inner.find('{') != inner.npos) in.fail(where + " has a { without its }");
        if (bar != inner.npos && !roles.contains(inner.substr(bar + 1))) in.fail(where + " names an unknown role in {" + std::string(inner) + "}");
    }
}

void checkFormat(const Reader& in, const LessonNumber& n)
{
    static const std::set<std::string_view> plain = {"integer", "percent", "degrees", "words"};
    const bool digits = n.format.size() > 2 && n.format[0] >= '1' && n.format[0] <= '9' && n.format[1] == ' ';
    const std::string_view rest = digits ? std::string_view(n.format).substr(2) : std::string_view();
    if (!plain.contains(n.format) && rest != "significant" && rest != "decimals") in.fail("has the unknown format \"" + n.format + "\"");
    if ((n.format == "words") == n.words.empty()) in.fail("needs the list \"words\" exactly when its format is \"words\"");
}

LessonNumber numberOf(const json& j, const std::string& place)
{
    Reader in(j, place);
    LessonNumber n{in.text("name"), in.text("title"), in.text("format"), in.texts("words"), in.flag("plot"), in.flag("log")};
    checkFormat(in, n);
    in.end();
    return n;
}

LessonPhase phaseOf(const json& j, const std::string& place)
{
    Reader in(j, place);
    LessonPhase p{in.text("id"), in.text("title"), in.text("sentence"), in.text("formula", false), {}};
    size_t i = 0;
    for (const json& n : in.list("numbers", false)) p.numbers.push_back(numberOf(n, place + ", number " + std::to_string(++i)));
    checkPlaceholders(in, "sentence", p.sentence);
    checkPlaceholders(in, "formula", p.formula);
    in.end();
    return p;
}

Lesson::Scene sceneOf(const json& j)
{
    Reader in(j, "scene");
    Lesson::Scene s{in.text("source"), in.texts("operations"), in.text("parameters", false), 30, 20};
    if (const json* camera = in.field("camera", false)) {
        Reader c(*camera, "camera");
        s.azimuth = c.number("azimuth", s.azimuth);
        s.elevation = c.number("elevation", s.elevation);
        c.end();
    }
    in.end();
    return s;
}

}  // namespace

const LessonPhase* Lesson::phase(std::string_view phaseId) const
{
    const auto i = std::find_if(phases.begin(), phases.end(), [&](const LessonPhase& p) { return p.id == phaseId; });
    return i == phases.end() ? nullptr : &*i;
}

const LessonNumber* Lesson::number(std::string_view phaseId, std::string_view name) const
{
    const LessonNumber* any = nullptr;
    for (const LessonPhase& p : phases)
        for (const LessonNumber& n : p.numbers)
            if (n.name == name && (!any || p.id == phaseId)) any = &n;
    return any;
}

Lesson parseLesson(std::string_view text)
{
    json j;
    try {
        j = json::parse(text);
    } catch (const json::exception& e) {
        throw Error(std::string("lesson is no JSON: ") + e.what());
    }
    Reader in(j, "lesson");
    Lesson l{in.text("id"), in.text("title"), in.text("section"), in.text("intro"), in.texts("try"), {}, {}, {}, {}};
    l.plot = in.text("plot", false);
    l.plotOver = in.text("plotOver", false);
    if (const json* scene = in.field("scene", true)) l.scene = sceneOf(*scene);
    for (const json& p : in.list("phases", true)) l.phases.push_back(phaseOf(p, "phase " + std::to_string(l.phases.size() + 1)));
    if (l.phases.empty()) in.fail("has no phases");
    for (const std::string& plotted : {l.plot, l.plotOver})
        if (!plotted.empty() && !l.number("", plotted)) in.fail("plots \"" + plotted + "\", which is no number of it");
    checkPlaceholders(in, "intro", l.intro);
    in.end();
    return l;
}

const std::vector<Lesson>& lessons()
{
    static const std::vector<Lesson> all = [] {
        std::vector<Lesson> list;
        for (const Resource& r : resources()) {
            if (!r.path.starts_with("resources/lessons/")) continue;
            try {
                list.push_back(parseLesson(r.text));
            } catch (const Error& e) {
                throw Error(std::string(r.path), e.reason());
            }
        }
        return list;
    }();
    return all;
}

const Lesson* findLesson(std::string_view id)
{
    for (const Lesson& l : lessons())
        if (l.id == id) return &l;
    return nullptr;
}

}  // namespace mw
