#include "app/cli/render_compare.h"

#include <algorithm>

#include "core/catalog/catalog.h"

namespace mw::cli {

namespace {

constexpr size_t mostInRow = 3, mostVariants = 9;

size_t columnsOf(size_t count)
{
    return count == 4 ? 2 : std::min(count, mostInRow);
}

}  // namespace

std::vector<Variant> takeVariants(Arguments& arguments)
{
    std::vector<Variant> out;
    for (const std::string& text : arguments.values("--compare")) {
        Variant v{text, {}};
        if (text != "as-is") {
            v.call = parseCall(text);
            if (v.call->operation->accepts != Kind::Mesh || v.call->operation->yields != Kind::Mesh)
                throw UsageError("--compare wants operations that make a mesh of a mesh, or as-is; " + v.call->operation->id + " does not");
        }
        out.push_back(std::move(v));
    }
    if (out.size() == 1) throw UsageError("--compare wants to be said twice or more: one view for each; as-is stands for the input");
    if (out.size() > mostVariants) throw UsageError("--compare was said " + std::to_string(out.size()) + " times; nine views are the most");
    return out;
}

std::vector<Frame> variantFrames(const Frame& base, std::span<const Variant> variants, Progress* progress)
{
    std::vector<Frame> frames;
    for (const Variant& v : variants) {
        Frame frame = base;
        for (DrawObject& o : frame.objects) {
            if (!v.call) continue;
            o.mesh = std::get<Mesh>(apply(*v.call->operation, o.mesh, v.call->values, progress));
            o.pose = nullptr;  // of the mesh before
        }
        frames.push_back(std::move(frame));
    }
    return frames;
}

void shareRange(std::vector<Frame>& frames)
{
    double low = 0, high = 0;
    bool first = true;
    for (const Frame& f : frames)
        for (const DrawObject& o : f.objects) {
            if (!o.heat) continue;
            low = first ? o.heat->low : std::min(low, o.heat->low);
            high = first ? o.heat->high : std::max(high, o.heat->high);
            first = false;
        }
    for (Frame& f : frames)
        for (DrawObject& o : f.objects) {
            if (!o.heat) continue;
            HeatMap h = *o.heat;
            h.low = low;
            h.high = high;
            o.heat = std::make_shared<const HeatMap>(std::move(h));
        }
}

void shareCamera(std::vector<Frame>& frames, double aspect)
{
    Frame all = frames.front();
    for (size_t i = 1; i < frames.size(); ++i) all.objects.insert(all.objects.end(), frames[i].objects.begin(), frames[i].objects.end());
    frameTightly(all, aspect);
    for (Frame& f : frames) f.camera = all.camera;
}

PictureSize viewSize(const PictureSize& size, size_t count)
{
    const size_t columns = columnsOf(count), rows = (count + columns - 1) / columns;
    return {std::max(1, size.width / int(columns)), std::max(1, size.height / int(rows))};
}

Picture sideBySide(Offscreen& offscreen, std::vector<Frame>& frames, std::span<const Variant> variants, const PictureSize& size)
{
    Picture all{size.width, size.height, std::vector<uint8_t>(size_t(size.width) * size_t(size.height) * 4, 255)};
    const PictureSize each = viewSize(size, frames.size());
    const size_t columns = columnsOf(frames.size());
    for (size_t i = 0; i < frames.size(); ++i) {
        Flat name;
        name.kind = Flat::Kind::Text;
        name.at = {glm::vec2(14, 22)};
        name.text = variants[i].name;
        frames[i].flats.push_back(std::move(name));
        const Picture p = offscreen.draw(frames[i], each.width, each.height);
        const size_t left = (i % columns) * size_t(each.width), top = (i / columns) * size_t(each.height);
        for (size_t y = 0; y < size_t(p.height); ++y)
            std::copy_n(p.rgba.data() + 4 * y * size_t(p.width), 4 * size_t(p.width), all.rgba.data() + 4 * ((top + y) * size_t(all.width) + left));
    }
    return all;
}

}  // namespace mw::cli
