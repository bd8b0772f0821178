// What edits share: how things are called in the history, and what they require.
#include <glm/gtc/quaternion.hpp>

#include "core/scene/edit_entries.h"

namespace mw {

std::string spoken(const Scene& scene, const std::vector<NodeId>& nodes)
{
    return nodes.size() == 1 ? scene.node(nodes.front()).name : grouped(int64_t(nodes.size())) + " nodes";
}

std::string grouped(int64_t n)
{
    std::string digits = std::to_string(n);
    for (size_t at = digits.size(); at > 3 + size_t(n < 0);) digits.insert(at -= 3, ",");
    return digits;
}

namespace {

std::string lowered(std::string title)
{
    const bool shout = title.size() > 1 && std::isupper(static_cast<unsigned char>(title[1]));  // "UV", "QEM"
    if (!title.empty() && !shout) title[0] = char(std::tolower(static_cast<unsigned char>(title[0])));
    return title;
}

std::string valueWords(const Parameter& p, const ParameterValue& v)
{
    if (const auto* on = std::get_if<bool>(&v)) return *on ? "on" : "off";
    const auto* whole = std::get_if<int64_t>(&v);
    const std::string text = whole ? grouped(*whole) : printed({{p.name, p.type, p.initial, {}, {}}}, {{p.name, v}}).substr(p.name.size() + 1);
    return text + (p.about.unit.empty() ? "" : " " + p.about.unit);
}

}  // namespace

std::string differenceText(const std::vector<Parameter>& parameters, const ParameterValues& before, const ParameterValues& after)
{
    std::string text;
    size_t changed = 0;
    for (const Parameter& p : parameters) {
        const ParameterValue was = valueOf(p, before), is = valueOf(p, after);
        if (was == is || ++changed > 1) continue;
        text = lowered(p.about.title) + " " +
               (is == p.initial && !std::holds_alternative<bool>(is) && !std::holds_alternative<int64_t>(is) ? "back to its default"
                                                                                                             : valueWords(p, is));
    }
    return changed == 1 ? text : changed == 0 ? "same values" : grouped(int64_t(changed)) + " values";
}

MeshObject meshOf(const Scene& scene, NodeId node)
{
    const MeshObject* object = scene.find(scene.node(node).mesh);
    if (!object) throw Error("\"" + scene.node(node).name + "\" shows no mesh; name a node that does");
    return *object;
}

const Operation& operationOf(const std::string& id, Kind accepts, Kind yields)
{
    const Operation& op = operation(id);
    if (op.accepts == accepts && op.yields == yields) return op;
    const std::string wanted = accepts == Kind::Nothing ? std::string("makes a ") + kindName(yields) + " from nothing"
                                                        : std::string("makes a ") + kindName(yields) + " from a " + kindName(accepts);
    throw Error(op.id + " does not fit here: an operation is wanted that " + wanted);
}

std::string freeName(const Scene& scene, const std::string& name)
{
    const auto taken = [&](const std::string& wanted) {
        for (const NodeId n : scene.nodes())
            if (scene.node(n).name == wanted) return true;
        return false;
    };
    // "box 2" goes on as "box 3".
    std::string stem = name;
    const size_t space = name.rfind(' ');
    const bool numbered = space != std::string::npos && space > 0 && space + 1 < name.size() && name.size() - space < 8 &&
                          name.find_first_not_of("0123456789", space + 1) == std::string::npos;
    if (numbered) stem = name.substr(0, space);
    if (!taken(name)) return name;
    int number = numbered ? std::stoi(name.substr(space + 1)) : 1;
    while (taken(stem + " " + std::to_string(++number))) {
    }
    return stem + " " + std::to_string(number);
}

void requireStill(const Scene& scene, NodeId node, const char* what)
{
    const Node& n = scene.node(node);
    if (n.skin) throw Error("\"" + n.name + "\" is bound to a skeleton: " + what + " would tear it off its joints");
    const MeshObject object = meshOf(scene, node);
    for (const Attribute& a : object.base.attributes())
        if (a.name.starts_with(names::morph)) throw Error("\"" + n.name + "\" has morph targets, which " + what + " cannot keep");
}

}  // namespace mw
