// Colour tables.
#include "render/colors.h"

#include <cmath>
#include <span>

namespace mw {
namespace {

constexpr uint32_t viridis[] = {0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725};
constexpr uint32_t diverging[] = {0x2166AC, 0x4393C3, 0x92C5DE, 0xD1E5F0, 0xF7F7F7, 0xFDDBC7, 0xF4A582, 0xD6604D, 0xB2182B};
constexpr uint32_t categories[categoryCount] = {0x60A8DE, 0xF0DE18, 0xDE1860, 0x18F0BA, 0xDE7218, 0x188472, 0x964EDE, 0xA8A872,
                                                0xBA84A8, 0x18DEF0, 0xA8DE84, 0xDEA83C, 0x6072A8, 0xDE2A18, 0xA8844E, 0xDE18A8,
                                                0x84BA96, 0xA86072, 0xA8603C, 0x8484F0, 0xF0A8CC, 0xF072CC, 0x18A884, 0x2AA8BA};
constexpr double viridisFrom = 0.06;  // so that the low end does not sink into the dark view

constexpr ThemeColors dark{hex(0x3A3F46), hex(0x25282D), hex(0x1F2225), hex(0x3D434A), hex(0x17191C), hex(0xE6E8EB),
                           hex(0xAEB5BD), hex(0x7F868E), hex(0x59616A), hex(0x101215), hex(0x5B6877), hex(0x2A2E34)};
constexpr ThemeColors light{hex(0xE9ECEF), hex(0xC9CED4), hex(0xF4F5F7), hex(0xC3C9D0), hex(0xFFFFFF), hex(0x1C2126),
                            hex(0x4A535D), hex(0x7D8690), hex(0x9AA2AB), hex(0x101215), hex(0xB4C6D8), hex(0xE6EAED)};

glm::vec3 between(std::span<const uint32_t> stops, double t)
{
    const double x = t * double(stops.size() - 1);
    const size_t i = std::min(size_t(x), stops.size() - 2);
    return glm::mix(hex(stops[i]), hex(stops[i + 1]), float(x - double(i)));
}

void put(std::vector<uint8_t>& pixels, glm::vec3 c)
{
    for (int k = 0; k < 3; ++k) pixels.push_back(uint8_t(std::lround(255 * c[k])));
    pixels.push_back(255);
}

}  // namespace

const ThemeColors& themeColors(Theme theme)
{
    return theme == Theme::Dark ? dark : light;
}

glm::vec3 roleColor(Role role)
{
    switch (role) {
        case Role::Current:
            return hex(0xFFE14D);
        case Role::Neighbour:
            return hex(0x86B7DC);
        case Role::New:
            return hex(0x31F0A8);
        case Role::Removed:
            return hex(0xFC422F);
        case Role::Rejected:
            return hex(0xBE46E1);
    }
    return {1, 1, 1};
}

std::vector<uint8_t> heatTablePixels()
{
    std::vector<uint8_t> pixels;
    for (int i = 0; i < heatEntries; ++i) put(pixels, between(viridis, viridisFrom + (1 - viridisFrom) * i / (heatEntries - 1.0)));
    for (int i = 0; i < heatEntries; ++i) put(pixels, between(diverging, i / (heatEntries - 1.0)));
    for (int i = 0; i < heatEntries; ++i) put(pixels, hex(categories[i % categoryCount]));
    return pixels;
}

glm::vec3 categoryColor(int i)
{
    return hex(categories[i % categoryCount]);
}

HeatRow heatRow(const HeatMap& heat)
{
    if (heat.table && heat.column < heat.table->columns.size() && heat.table->columns[heat.column].categorical) return categoryRow;
    return heat.low < 0 && heat.high == -heat.low ? divergingRow : viridisRow;
}

const HeatMap* heatOf(const DrawObject& o, ElementKind rows)
{
    const HeatMap* h = o.heat.get();
    if (!h || !h->table || h->column >= h->table->columns.size() || h->table->rows != rows) return nullptr;
    const size_t n = h->table->columns[h->column].values.size();
    const bool fits = (rows == ElementKind::Vertex && n == o.mesh.vertexCount()) || (rows == ElementKind::Face && n == o.mesh.faceCount()) ||
                      (rows == ElementKind::Edge && 2 * n == h->table->edges.size());
    return fits ? h : nullptr;
}

glm::vec3 linearOf(glm::vec3 c)
{
    glm::vec3 r;
    for (int k = 0; k < 3; ++k) r[k] = c[k] <= 0.04045f ? c[k] / 12.92f : std::pow((c[k] + 0.055f) / 1.055f, 2.4f);
    return r;
}

}  // namespace mw
