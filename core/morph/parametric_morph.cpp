#include "core/morph/parametric_morph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.h"
#include "core/math/predicates.h"
#include "core/mesh/submesh.h"
#include "core/morph/target.h"

namespace mw {

namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

double fromAxis(const glm::vec3& p)
{
    return std::hypot(double(p.x), double(p.z));
}

/// Longitude of (3.57) and (3.59), 0 to 2 pi.
double longitude(const glm::vec3& p)
{
    const double a = std::atan2(double(p.x), double(p.z));
    return a < 0 ? a + 2 * pi : a;
}

TorusShape target(const Morph& p)
{
    if (p.other.mesh.vertexCount() > 0) return torusThrough(p.other.mesh);
    if (p.tube > p.radius) throw Error("the tube of the torus is thicker than its ring; make tube at most as large as radius");
    return {p.radius, p.tube};
}

std::string nameOf(const Morph& p)
{
    return p.other.name.empty() ? "torus" : targetName(p.other.name);
}

Mesh withPlaces(const Mesh& mesh, const std::vector<glm::dvec3>& places, const std::string& name)
{
    Array<float> displacement;
    displacement.reserve(3 * places.size());
    for (size_t v = 0; v < places.size(); ++v)
        for (int k = 0; k < 3; ++k) displacement.push_back(float(places[v][k] - double(mesh.positions()[v][k])));
    return withTarget(mesh, name, std::move(displacement));
}

/// The mesh with its first `done` vertices at the target.
Mesh partly(const Mesh& mesh, const std::vector<glm::dvec3>& places, size_t done)
{
    Array<glm::vec3> at(mesh.positions().begin(), mesh.positions().end());
    for (size_t v = 0; v < done; ++v) at[v] = glm::vec3(places[v]);
    return mesh.withPositions(std::move(at));
}

/// Collects the faces of the cut sphere, and rows of what its vertices and corners are mixed from.
class PoleCutter {
public:
    explicit PoleCutter(const Mesh& mesh) : mesh_(mesh), place_(mesh.vertexCount(), none)
    {
        const glm::dvec3 size = mesh.bounds().size();
        onAxis_ = 1e-6 * std::max({size.x, size.y, size.z});
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) face(f);
    }

    CutSphere result()
    {
        Array<glm::vec3> positions(vertices_.size());
        const Attribute places = blended(floatAttribute("places", Domain::Vertex, 3, flat(mesh_.positions())), vertices_);
        for (size_t v = 0; v < positions.size(); ++v) positions[v] = {float(places.at(v, 0)), float(places.at(v, 1)), float(places.at(v, 2))};
        Mesh out(std::move(positions), std::move(start_), std::move(corners_));
        for (const Attribute& a : mesh_.attributes()) {
            if (a.domain == Domain::Vertex)
                out = out.with(blended(a, vertices_));
            else
                out = out.with(a.domain == Domain::Corner ? blended(a, cornerRows_) : gathered(a, faceOf_));
        }
        return {out.withGroupNames(mesh_.groupNames()), std::move(pole_), std::move(toward_)};
    }

private:
    static Array<float> flat(std::span<const glm::vec3> points)
    {
        Array<float> out;
        for (const glm::vec3& p : points) out.insert(out.end(), {p.x, p.y, p.z});
        return out;
    }
    uint32_t added(int8_t pole, uint32_t toward)
    {
        vertices_.endRow();
        pole_.push_back(pole);
        toward_.push_back(toward);
        return uint32_t(pole_.size() - 1);
    }
    uint32_t vertex(uint32_t v)
    {
        if (place_[v] == none) {
            vertices_.add(v, 1);
            place_[v] = added(0, none);
        }
        return place_[v];
    }
    void corner(uint32_t vertex, const std::vector<std::pair<uint32_t, double>>& from)
    {
        corners_.push_back(vertex);
        for (const auto& [c, w] : from) cornerRows_.add(c, w);
        cornerRows_.endRow();
    }
    void endFace(uint32_t f)
    {
        start_.push_back(uint32_t(corners_.size()));
        faceOf_.push_back(f);
    }

    /// Where the axis meets a face: weights of its corners; nothing when it does not.
    std::vector<std::pair<uint32_t, double>> pierced(uint32_t f) const
    {
        const auto face = mesh_.face(f);
        const uint32_t begin = mesh_.faceStart()[f], n = uint32_t(face.size());
        for (uint32_t k = 0; k < n; ++k)
            if (fromAxis(mesh_.positions()[face[k]]) <= onAxis_) return {{begin + k, 1.0}};
        int left = 0, right = 0;
        const auto flatAt = [&](uint32_t k) { return glm::vec2(mesh_.positions()[face[k % n]].x, mesh_.positions()[face[k % n]].z); };
        for (uint32_t k = 0; k < n; ++k) {
            const int s = orientation(flatAt(k), flatAt(k + 1), glm::vec2(0));
            left += s > 0;
            right += s < 0;
        }
        if ((left > 0) == (right > 0) || left + right + 1 < int(n)) return {};
        for (uint32_t k = 1; k + 1 < n; ++k) {  // the triangle of its fan that holds the axis
            const glm::dvec2 a(flatAt(0)), b(flatAt(k)), c(flatAt(k + 1));
            const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            const double wa = (b.x * c.y - b.y * c.x) / area, wb = (c.x * a.y - c.y * a.x) / area;
            if (area == 0 || wa < -1e-12 || wb < -1e-12 || wa + wb > 1 + 1e-12) continue;
            return {{begin, wa}, {begin + k, wb}, {begin + k + 1, 1 - wa - wb}};
        }
        return {};
    }

    uint32_t poleVertex(const std::vector<std::pair<uint32_t, double>>& at, uint32_t toward)
    {
        double y = 0;
        for (const auto& [c, w] : at) y += w * double(mesh_.positions()[mesh_.cornerVertex()[c]].y);
        const int8_t pole = y < 0 ? -1 : 1;
        const auto [known, fresh] = poles_.try_emplace({pole, toward}, 0);
        if (!fresh) return known->second;
        for (const auto& [c, w] : at)
            if (w != 0) vertices_.add(mesh_.cornerVertex()[c], w);
        return known->second = added(pole, vertex(toward));
    }

    void face(uint32_t f)
    {
        const auto face = mesh_.face(f);
        const uint32_t begin = mesh_.faceStart()[f], n = uint32_t(face.size());
        if (n < 3) return;
        const auto at = pierced(f);
        if (at.empty()) {
            for (uint32_t k = 0; k < n; ++k) {
                const uint32_t v = vertex(face[k]);
                corner(v, {{begin + k, 1.0}});
            }
            return endFace(f);
        }
        for (uint32_t k = 0; k < n; ++k) {  // one face a side, between the spokes to its ends
            const uint32_t a = face[k], b = face[(k + 1) % n];
            const glm::vec3 &p = mesh_.positions()[a], &q = mesh_.positions()[b];
            if (fromAxis(p) <= onAxis_ || fromAxis(q) <= onAxis_ || orientation(glm::vec2(p.x, p.z), glm::vec2(q.x, q.z), glm::vec2(0)) == 0)
                continue;
            for (const uint32_t v : {a, b}) vertex(v);
            const uint32_t atA = poleVertex(at, a), atB = poleVertex(at, b);
            corner(atA, at);
            corner(vertex(a), {{begin + k, 1.0}});
            corner(vertex(b), {{begin + (k + 1) % n, 1.0}});
            corner(atB, at);
            endFace(f);
        }
    }

    const Mesh& mesh_;
    double onAxis_ = 0;
    std::vector<uint32_t> place_, toward_, faceOf_;
    std::vector<int8_t> pole_;
    std::map<std::pair<int8_t, uint32_t>, uint32_t> poles_;
    Stencils vertices_, cornerRows_;
    Array<uint32_t> start_{0u}, corners_;
};

}  // namespace

glm::dvec3 TorusShape::at(double omega, double phi) const
{
    const double out = radius + tube * std::cos(phi);
    return {out * std::sin(omega), tube * std::sin(phi), out * std::cos(omega)};
}

/// rho^2 + y^2 = 2 R rho + (r^2 - R^2): a straight line through the distances from the axis.
TorusShape torusThrough(const Mesh& mesh)
{
    const std::string remedy = "; name a torus about +Y whose centre is the origin, or none and give radius and tube";
    const double n = double(mesh.vertexCount());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const glm::vec3& p : mesh.positions()) {
        const double x = fromAxis(p), y = x * x + double(p.y) * p.y;
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    if (!(spread > 1e-12 * sxx * n)) throw Error("the other mesh is no torus" + remedy);
    const double slope = (n * sxy - sx * sy) / spread, height = (sy - slope * sx) / n;
    const double radius = slope / 2, square = height + radius * radius;
    if (!(square > 0) || !(radius > 0)) throw Error("the other mesh is no torus" + remedy);
    const TorusShape t{radius, std::sqrt(square)};
    for (const glm::vec3& p : mesh.positions())
        if (std::abs(std::hypot(fromAxis(p) - t.radius, double(p.y)) - t.tube) > 0.01 * t.tube) throw Error("the other mesh is no torus" + remedy);
    return t;
}

CutSphere cutAtPoles(const Mesh& mesh)
{
    return PoleCutter(mesh).result();
}

Mesh withoutCaps(const Mesh& mesh)
{
    const Bounds bounds = mesh.bounds();
    const double slack = 1e-5 * bounds.size().y;
    ElementSet caps{ElementKind::Face, {}};
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        bool low = true, high = true;
        for (const uint32_t v : mesh.face(f)) {
            low = low && mesh.positions()[v].y <= bounds.min.y + slack;
            high = high && mesh.positions()[v].y >= bounds.max.y - slack;
        }
        if (low || high) caps.indices.push_back(f);
    }
    return caps.indices.empty() ? mesh : withoutElements(mesh, caps);
}

Generator cylinderTorus(Mesh input, Morph parameters, Stage<Mesh>& stage)
{
    const TorusShape torus = target(parameters);
    const Mesh mesh = withoutCaps(input);
    if (mesh.faceCount() == 0) throw Error("cylinder-torus wants a cylinder about +Y; no face of the mesh runs between its lower and its upper end");
    const double low = mesh.bounds().min.y, height = parameters.height > 0 ? parameters.height : mesh.bounds().size().y;
    std::vector<glm::dvec3> places(mesh.vertexCount());
    size_t done = 0;
    stage.show([&] { return partly(mesh, places, done); });
    for (; done < places.size(); ++done) {
        const glm::vec3& p = mesh.positions()[done];
        if (fromAxis(p) == 0) throw Error("vertex " + std::to_string(done) + " lies on the axis of the cylinder; leave such vertices out");
        const double theta = longitude(p), y = double(p.y) - low, phi = 2 * pi * y / height - pi;
        places[done] = torus.at(theta, phi);
        if (stage.watched())
            co_yield Step("cylinder")
                .vertex(uint32_t(done), Role::Current, "P")
                .point(glm::vec3(places[done]), Role::New, "Q")
                .segment(p, glm::vec3(places[done]), Role::Neighbour)
                .number("theta", theta / degree)
                .number("y", y)
                .number("height", height)
                .number("phi", phi / degree)
                .number("mapped", double(done + 1))
                .progress(double(done) / double(places.size()));
        else if ((done & 0xffff) == 0xffff)
            co_yield Step("cylinder").number("mapped", double(done)).progress(double(done) / double(places.size()));
    }
    stage.finish(withPlaces(mesh, places, nameOf(parameters)));
}

Generator sphereTorus(Mesh input, Morph parameters, Stage<Mesh>& stage)
{
    const TorusShape torus = target(parameters);
    const CutSphere cut = cutAtPoles(input);
    const Mesh& mesh = cut.mesh;
    if (mesh.faceCount() == 0) throw Error("sphere-torus wants a sphere about the origin; the mesh has no faces");
    std::vector<glm::dvec3> places(mesh.vertexCount());
    size_t done = 0;
    stage.show([&] { return partly(mesh, places, done); });
    for (; done < places.size(); ++done) {
        const glm::vec3 &p = mesh.positions()[done], &l = cut.pole[done] ? mesh.positions()[cut.toward[done]] : p;
        const double alpha = longitude(l), delta = cut.pole[done] ? cut.pole[done] * pi / 2 : std::atan2(double(p.y), fromAxis(p)), phi = 2 * delta;
        places[done] = torus.at(alpha, phi);
        if (stage.watched())
            co_yield Step("sphere")
                .vertex(uint32_t(done), Role::Current, "P")
                .point(glm::vec3(places[done]), Role::New, "Q")
                .segment(p, glm::vec3(places[done]), Role::Neighbour)
                .number("alpha", alpha / degree)
                .number("delta", delta / degree)
                .number("phi", phi / degree)
                .number("mapped", double(done + 1))
                .progress(double(done) / double(places.size()));
        else if ((done & 0xffff) == 0xffff)
            co_yield Step("sphere").number("mapped", double(done)).progress(double(done) / double(places.size()));
    }
    stage.finish(withPlaces(mesh, places, nameOf(parameters)));
}

}  // namespace mw
