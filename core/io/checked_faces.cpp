#include "core/io/checked_faces.h"

#include <algorithm>
#include <cmath>

namespace mw {

std::vector<uint32_t> mendPositions(Array<glm::vec3>& positions)
{
    float probe = 0;  // stays 0 unless something is not finite
    for (const glm::vec3& p : positions) probe += (p.x + p.y + p.z) * 0.f;
    std::vector<uint32_t> broken;
    if (probe == 0) return broken;
    Bounds bounds;
    for (size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
            bounds.add(glm::dvec3(p));
        else
            broken.push_back(uint32_t(i));
    }
    const glm::vec3 centre(bounds.centre());
    for (uint32_t i : broken) positions[i] = centre;
    return broken;
}

std::vector<uint32_t> mendPositions(Array<glm::vec3>& positions, CountsFrom from, const std::string& file, Findings& findings)
{
    const size_t count = positions.size();
    std::vector<uint32_t> broken = mendPositions(positions);
    if (broken.size() == count)
        throw Error(file, "none of its " + std::to_string(count) + " vertices has a finite position; check the program that wrote it");
    for (uint32_t v : broken)
        findings.add(
            found::position, [&] { return vertexPlace(v + int64_t(from), count, from); }, v);
    return broken;
}

Array<uint32_t> CheckedFaces::take(Array<uint32_t> perCorner) const
{
    if (all || perCorner.empty()) return perCorner;
    Array<uint32_t> kept(corners.size());
    for (size_t i = 0; i < kept.size(); ++i) kept[i] = perCorner[corners[i]];
    return kept;
}

CheckedFaces checkedFaces(Array<uint32_t> start, Array<uint32_t> cornerVertex, size_t vertexCount, const std::vector<uint32_t>& broken,
                          const std::function<void(uint32_t, uint32_t)>& leftOut)
{
    CheckedFaces out;
    uint32_t largest = 0;
    for (uint32_t v : cornerVertex) largest = std::max(largest, v);
    if (broken.empty() && (cornerVertex.empty() || largest < vertexCount)) {
        out.faceStart = std::move(start);
        out.cornerVertex = std::move(cornerVertex);
        return out;
    }
    std::vector<bool> bad(vertexCount);
    for (uint32_t v : broken) bad[v] = true;
    const auto wrong = [&](uint32_t v) { return v >= vertexCount || bad[v]; };
    out.all = false;
    out.faceStart.push_back(0);
    for (uint32_t f = 0; f + 1 < start.size(); ++f) {
        const auto first = cornerVertex.begin() + start[f], last = cornerVertex.begin() + start[f + 1];
        if (auto c = std::find_if(first, last, wrong); c != last) {
            leftOut(f, *c);
            continue;
        }
        out.faces.push_back(f);
        for (uint32_t c = start[f]; c < start[f + 1]; ++c) out.corners.push_back(c);
        out.cornerVertex.insert(out.cornerVertex.end(), first, last);
        out.faceStart.push_back(uint32_t(out.cornerVertex.size()));
    }
    return out;
}

CheckedFaces checkedFaces(Array<uint32_t> start, Array<uint32_t> cornerVertex, size_t vertexCount, const std::vector<uint32_t>& broken,
                          Findings& findings, const std::function<std::string(uint32_t, uint32_t)>& place)
{
    for (uint32_t f = 0; f + 1 < start.size(); ++f)
        if (start[f + 1] - start[f] < 3) findings.add(found::smallFace, [&] { return place(f, none); });
    return checkedFaces(std::move(start), std::move(cornerVertex), vertexCount, broken, [&](uint32_t f, uint32_t v) {
        findings.add(v < vertexCount ? found::brokenFace : found::faceIndex, [&] { return place(f, v); });
    });
}

Array<uint32_t> checkedLines(const Array<uint32_t>& pairs, size_t vertexCount, const std::vector<uint32_t>& broken,
                             const std::function<void(size_t)>& leftOut)
{
    Array<uint32_t> kept;
    const auto good = [&](uint32_t v) { return v < vertexCount && !std::binary_search(broken.begin(), broken.end(), v); };
    for (size_t i = 0; i + 1 < pairs.size(); i += 2) {
        if (good(pairs[i]) && good(pairs[i + 1])) {
            kept.push_back(pairs[i]);
            kept.push_back(pairs[i + 1]);
        } else {
            leftOut(i / 2);
        }
    }
    return kept;
}

std::string vertexPlace(int64_t number, size_t count, CountsFrom from)
{
    return "vertex " + std::to_string(number) + " of " + std::to_string(count) + (from == CountsFrom::One ? "" : ", counted from 0");
}

std::string facePlace(uint32_t face, CountsFrom from)
{
    return from == CountsFrom::One ? "face " + std::to_string(face + 1) + " of the file" : "face " + std::to_string(face) + ", counted from 0";
}

}  // namespace mw
