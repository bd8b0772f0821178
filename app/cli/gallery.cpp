// gallery DIR: the book's figures and a picture for each operation, as files, and gallery.json that says what they are and which numbers are
// in them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/gallery_pictures.h"
#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "app/cli/verb.h"
#include "app/figures/figures.h"
#include "core/catalog/catalog.h"
#include "render/offscreen.h"

namespace mw::cli {

namespace {

using nlohmann::json;

struct Wanted {
    std::filesystem::path folder;
    std::optional<std::string> only;
    PictureSize size;
    std::optional<Theme> theme;
    double scale = 1.5;
};

bool wanted(const OperationPicture& p, const Wanted& w)
{
    return findOperation(p.operation) && (!w.only || *w.only == p.id || *w.only == p.operation);
}

/// The id, the number of the figure, or how either begins: "2." is chapter 2.
bool wanted(const figures::Figure& f, const Wanted& w)
{
    return !w.only || std::string_view(f.id).starts_with(*w.only) || *w.only == f.number;
}

json numberJson(const figures::Number& n)
{
    return std::visit([](const auto& v) { return json(v); }, n);
}

json drawFigure(Offscreen& offscreen, const figures::Figure& f, const Wanted& w)
{
    figures::Page page(w.theme.value_or(Theme::Light));
    f.make(page);
    const figures::Page::Made made =
        page.draw(offscreen, std::string(f.number[0] == 'T' ? "" : "Figure ") + f.number + "   " + f.title, float(w.scale));
    const std::string name = std::string(f.id) + ".png";
    writePng(made.picture, (w.folder / name).string());
    json j{{"id", f.id}, {"figure", f.number}, {"title", f.title}, {"proves", f.proves}, {"captions", made.captions}, {"file", name}};
    j["size"] = {made.picture.width, made.picture.height};
    j["text"] = {{"outside", made.outside}, {"covered", made.covered}};
    j["numbers"] = json::object();
    for (const auto& [key, value] : page.numbers()) j["numbers"][key] = numberJson(value);
    return j;
}

json drawOperation(Offscreen& offscreen, const OperationPicture& p, const Wanted& w)
{
    Frame frame = p.make();
    frame.options.theme = w.theme.value_or(Theme::Dark);
    frameTightly(frame, double(w.size.width) / w.size.height);
    frame.camera.distance *= 1.1;  // room for the labels
    const std::string name = std::string(p.id) + ".png";
    writePng(offscreen.draw(frame, w.size.width, w.size.height), (w.folder / name).string());
    return {{"id", p.id}, {"operation", p.operation}, {"file", name}};
}

void checkWanted(const Wanted& w)
{
    const auto pictures = operationPictures();
    const auto& figures = figures::allFigures();
    if (std::any_of(pictures.begin(), pictures.end(), [&](const auto& p) { return wanted(p, w); }) ||
        std::any_of(figures.begin(), figures.end(), [&](const auto& f) { return wanted(f, w); }))
        return;
    std::string ids;
    for (const auto& p : pictures) ids += std::string(ids.empty() ? "" : ", ") + p.id;
    for (const auto& f : figures) ids += std::string(", ") + f.id;
    throw Error("there is no picture \"" + w.only.value_or("") + "\"; there are " + ids);
}

Wanted take(Arguments& arguments)
{
    Wanted w;
    w.only = arguments.value("--only");
    w.size = takeSize(arguments, {1280, 640});
    if (const std::optional<std::string> scale = arguments.value("--scale")) {
        w.scale = std::atof(scale->c_str());
        if (!(w.scale >= 0.5 && w.scale <= 4)) throw UsageError("--scale wants a number from 0.5 to 4, not \"" + *scale + "\"");
    }
    w.theme = takeThemeIfSaid(arguments);
    w.folder = arguments.finish({"DIR"})[0];
    return w;
}

int run(Arguments& arguments)
{
    const Wanted w = take(arguments);
    checkWanted(w);
    std::error_code failed;
    std::filesystem::create_directories(w.folder, failed);
    if (failed) throw Error(w.folder.string(), "the folder cannot be made (" + failed.message() + "); choose another");
    Offscreen offscreen;
    Working working("drawing");
    json all{{"figures", json::array()}, {"operations", json::array()}};
    const auto add = [&](const char* list, const char* id, auto draw) {
        working.now(id);
        all[list].push_back(draw());
        std::cout << (w.folder / (std::string(id) + ".png")).string() << std::endl;
    };
    for (const OperationPicture& p : operationPictures())
        if (wanted(p, w)) add("operations", p.id, [&] { return drawOperation(offscreen, p, w); });
    for (const figures::Figure& f : figures::allFigures())
        if (wanted(f, w)) add("figures", f.id, [&] { return drawFigure(offscreen, f, w); });
    const std::filesystem::path file = w.folder / "gallery.json";
    std::ofstream out(file);
    out << all.dump(1, ' ', false, json::error_handler_t::replace) << '\n';
    if (!out.flush()) throw Error(file.string(), "the list of pictures could not be written; check the folder and the space left");
    return 0;
}

}  // namespace

const Verb galleryVerb{
    "gallery", "the book's figures, and pictures of what the operations do",
    "gallery DIR [--only ID] [--scale S] [--size WxH] [--theme dark|light]\n\n"
    "Writes one PNG for each figure of the book and each operation, made from shapes of the program's own, prints the file names, and writes\n"
    "gallery.json: titles, captions, and the numbers of each figure.\n\n"
    "  --only ID    one of them, or figures whose id begins like that: 2. is chapter 2\n"
    "  --scale S    pixels a point of the figures, 1.5 unless said\n"
    "  --size WxH   of the operations' pictures, 1280x640 unless said\n"
    "  --theme T    figures are light and operations dark unless said\n",
    run};

}  // namespace mw::cli
