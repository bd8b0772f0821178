#include "core/repair/components.h"

#include <algorithm>

#include "core/mesh/union_find.h"

namespace mw {

std::vector<std::vector<uint32_t>> tinyComponents(const Mesh& mesh, double share)
{
    UnionFind sets(mesh.vertexCount());
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (const uint32_t v : mesh.face(f)) sets.join(mesh.face(f)[0], v);
    struct Component {
        uint32_t root;
        double diagonal = 0;
    };
    Array<uint32_t> number(mesh.vertexCount(), none);
    std::vector<Component> components;
    std::vector<Bounds> boxes;
    Bounds whole;
    for (const uint32_t v : mesh.cornerVertex()) {
        const uint32_t root = sets.root(v);
        if (number[root] == none) {
            number[root] = uint32_t(components.size());
            components.push_back({number[root], 0});
            boxes.emplace_back();
        }
        boxes[number[root]].add(glm::dvec3(mesh.positions()[v]));
    }
    for (size_t i = 0; i < boxes.size(); ++i) {
        whole.add(boxes[i]);
        components[i].diagonal = boxes[i].diagonal();
    }
    std::stable_sort(components.begin(), components.end(), [](const Component& a, const Component& b) { return a.diagonal < b.diagonal; });
    std::vector<uint32_t> rank(components.size(), none);
    std::vector<std::vector<uint32_t>> out;
    for (size_t i = 0; i + 1 < components.size() && components[i].diagonal < share * whole.diagonal(); ++i) {
        rank[components[i].root] = uint32_t(i);
        out.emplace_back();
    }
    if (out.empty()) return out;
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.face(f).empty()) continue;
        const uint32_t i = rank[number[sets.root(mesh.face(f)[0])]];
        if (i != none) out[i].push_back(f);
    }
    return out;
}

}  // namespace mw
