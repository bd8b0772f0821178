// Writes what Blender and we then both draw: spheres from rough to polished, matt and metal (spheres.glb), and an environment of ours as a
// picture of all directions (studio.hdr).
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "core/io/io.h"
#include "render/environment.h"

namespace mw {
namespace {

Scene spheres()
{
    const Mesh ball = std::get<Mesh>(apply(operation("icosphere"), {}, checked(operation("icosphere").parameters, {{"subdivisions", int64_t(4)}})));
    const Mesh smooth = ball.with(floatAttribute("normal", Domain::Vertex, 3, [&] {
        Array<float> n;
        for (const glm::vec3& p : ball.positions()) n.insert(n.end(), {p.x, p.y, p.z});
        return n;
    }()));
    Scene s;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column) {
            Material m;
            m.name = "row " + std::to_string(row) + " column " + std::to_string(column);
            m.baseColor = row == 1 ? glm::dvec4(0.9, 0.6, 0.25, 1) : row == 2 ? glm::dvec4(0.75, 0.75, 0.75, 1) : glm::dvec4(0.15, 0.35, 0.6, 1);
            m.metallic = row > 0;
            m.roughness = 0.1 + 0.2 * column;
            Node n;
            n.name = m.name;
            n.local.translation = {2.3 * (column - 2), 2.3 * (1 - row), 0};
            n.mesh = s.add(MeshObject{m.name, smooth, {s.add(m)}, {}});
            s.add(n);
        }
    return s;
}

/// Radiance's format, uncompressed: columns run as atan2(-y, x) of a world with z up, rows from above.
void writeHdr(const Environment& e, const std::filesystem::path& file, int width)
{
    const int height = width / 2;
    FILE* out = std::fopen(file.string().c_str(), "wb");
    if (!out) throw Error(file.string(), "cannot be written");
    std::fprintf(out, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", height, width);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double around = 2 * std::numbers::pi * ((x + 0.5) / width - 0.5), up = std::numbers::pi * (0.5 - (y + 0.5) / height);
            const glm::dvec3 z(std::cos(around) * std::cos(up), -std::sin(around) * std::cos(up), std::sin(up));
            const glm::vec3 c = radiance(e, glm::vec3(float(z.x), float(z.z), float(-z.y)));
            int exponent = 0;
            const float most = std::max({c.x, c.y, c.z}), scale = most > 1e-9f ? std::frexp(most, &exponent) * 256 / most : 0;
            const unsigned char rgbe[4] = {static_cast<unsigned char>(c.x * scale), static_cast<unsigned char>(c.y * scale),
                                           static_cast<unsigned char>(c.z * scale), static_cast<unsigned char>(most > 1e-9f ? exponent + 128 : 0)};
            std::fwrite(rgbe, 1, 4, out);
        }
    std::fclose(out);
}

}  // namespace
}  // namespace mw

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    mw::writeFile(mw::spheres(), folder / "spheres.glb");
    mw::writeHdr(*mw::findEnvironment("studio"), folder / "studio.hdr", 1024);
    return 0;
}
