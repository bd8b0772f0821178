// Parameters described once. A parameter struct has `template <class V> void describe(V& v)`, which calls the functions of Describer
// below; property editor, command line, JSON and printed reference are made from what it says.
//
//   struct Smooth {
//       int64_t iterations = 10;
//       double lambda = 0.5;
//       Method method = Method::Taubin;
//       template <class V> void describe(V& v) {
//           v.integer("iterations", iterations, {.title = "Iterations", .help = "How often every vertex moves.", .min = 1, .max = 1000, .softMax =
//           50}); v.number("lambda", lambda, {.title = "Step", .help = "Share of the way to the mean of the ring.", .min = 0, .max = 1});
//           v.choice("method", method, {"laplacian", "taubin"}, {.title = "Method", .help = "..."});
//       }
//   };
#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/mesh/other_mesh.h"

namespace mw {

enum class ParameterType { Flag, Integer, Number, Choice, Text, Point, Object, File };

/// Choices are held by name, objects by node name, files by path.
using ParameterValue = std::variant<bool, int64_t, double, std::string, glm::dvec3>;

/// What a describe() says beside name and default. Hard range min..max; soft range for sliders (NaN: the hard one).
struct About {
    std::string title = {}, help = {}, unit = {};
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
    double softMin = std::numeric_limits<double>::quiet_NaN(), softMax = std::numeric_limits<double>::quiet_NaN();
    bool logarithmic = false, advanced = false;
    std::string when = {};  ///< "stop=ratio": shown only while that choice holds (still accepted otherwise)
    bool optional = false;  ///< objects: may be left empty
};

struct Parameter {
    std::string name;
    ParameterType type = ParameterType::Number;
    ParameterValue initial;
    About about;
    std::vector<std::string> choices;
};

/// Values by name; what is not there has its default. A plain value: compared, copied, hashed, written as JSON.
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// Throws Error naming the parameter, its range or choices, and what was given. Converts integers to numbers and the like.
ParameterValues checked(const std::vector<Parameter>& parameters, const ParameterValues& given);
/// From "k=v,k=v" of the command line (numbers with '.', points as x/y/z, flags as true or false). A value may stand between double quotes,
/// in which \" and \\ are a quote and a backslash: with="faces=100,method=\"a, b\"". Throws Error.
ParameterValues parsed(const std::vector<Parameter>& parameters, std::string_view text);
/// The inverse of parsed(): only what differs from the defaults, quoted where it must be.
std::string printed(const std::vector<Parameter>& parameters, const ParameterValues& values);
/// The same with all that `values` has.
std::string printedAll(const std::vector<Parameter>& parameters, const ParameterValues& values);
/// Checked, and without those that have their defaults: equal settings are equal values.
ParameterValues unlikeDefaults(const std::vector<Parameter>& parameters, const ParameterValues& values);
nlohmann::json toJson(const ParameterValues& values);
ParameterValues parametersFromJson(const std::vector<Parameter>& parameters, const nlohmann::json& json);
ParameterValue valueOf(const Parameter& p, const ParameterValues& values);

/// The visitor that lists what a struct describes. `Filler` (below) is the one that fills it.
class Describer {
public:
    std::vector<Parameter> parameters;

    void flag(const char* name, bool& v, About a) { add(name, ParameterType::Flag, v, std::move(a)); }
    void integer(const char* name, int64_t& v, About a) { add(name, ParameterType::Integer, v, std::move(a)); }
    void number(const char* name, double& v, About a) { add(name, ParameterType::Number, v, std::move(a)); }
    void text(const char* name, std::string& v, About a) { add(name, ParameterType::Text, v, std::move(a)); }
    void point(const char* name, glm::dvec3& v, About a) { add(name, ParameterType::Point, v, std::move(a)); }
    void object(const char* name, std::string& v, About a) { add(name, ParameterType::Object, v, std::move(a)); }
    /// A further mesh to work with.
    void object(const char* name, OtherMesh& v, About a) { add(name, ParameterType::Object, v.name, std::move(a)); }
    void file(const char* name, std::string& v, About a) { add(name, ParameterType::File, v, std::move(a)); }
    /// `E` is an enum whose values are 0, 1, ... in the order of `names`.
    template <class E>
    void choice(const char* name, E& v, std::vector<std::string> names, About a)
    {
        add(name, ParameterType::Choice, names.at(size_t(v)), std::move(a));
        parameters.back().choices = std::move(names);
    }

private:
    void add(const char* name, ParameterType t, ParameterValue v, About a) { parameters.push_back({name, t, std::move(v), std::move(a), {}}); }
};

/// Fills a struct from checked values.
class Filler {
public:
    /// `others`: the meshes of object parameters, when there are any.
    explicit Filler(const ParameterValues& values, const std::map<std::string, Mesh, std::less<>>* others = nullptr)
        : values_(values), others_(others)
    {}
    void flag(const char* name, bool& v, const About&) { take(name, v); }
    void integer(const char* name, int64_t& v, const About&) { take(name, v); }
    void number(const char* name, double& v, const About&) { take(name, v); }
    void text(const char* name, std::string& v, const About&) { take(name, v); }
    void point(const char* name, glm::dvec3& v, const About&) { take(name, v); }
    void object(const char* name, std::string& v, const About&) { take(name, v); }
    void object(const char* name, OtherMesh& v, const About&)
    {
        take(name, v.name);
        if (!others_) return;
        if (auto i = others_->find(name); i != others_->end()) v.mesh = i->second;
    }
    void file(const char* name, std::string& v, const About&) { take(name, v); }
    template <class E>
    void choice(const char* name, E& v, const std::vector<std::string>& names, const About&)
    {
        std::string chosen = names.at(size_t(v));
        take(name, chosen);
        for (size_t i = 0; i < names.size(); ++i)
            if (names[i] == chosen) v = E(i);
    }

private:
    template <class T>
    void take(const char* name, T& v)
    {
        if (auto i = values_.find(name); i != values_.end()) v = std::get<T>(i->second);
    }
    const ParameterValues& values_;
    const std::map<std::string, Mesh, std::less<>>* others_;
};

}  // namespace mw
