#include "app/cli/clip_options.h"

#include <charconv>
#include <cmath>

#include "app/cli/output.h"
#include "core/error.h"
#include "core/io/io.h"
#include "core/scene/adopt_clips.h"

namespace mw::cli {

ClipOptions takeClipOptions(Arguments& arguments)
{
    ClipOptions o;
    o.clip = arguments.value("--clip");
    const std::optional<std::string> text = arguments.value("--time");
    if (!text) return o;
    double seconds = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), seconds);
    if (error != std::errc() || end != text->data() + text->size() || !std::isfinite(seconds))
        throw UsageError("--time wants seconds, like 0.6, not \"" + *text + "\"");
    o.time = seconds;
    return o;
}

const Clip& clipOf(const std::string& file, const Scene& scene, const ClipOptions& options)
{
    const std::vector<ClipId> clips = scene.clips();
    if (clips.empty()) throw Error(file, "there is no clip in it; leave --clip and --time out");
    if (!options.clip) return *scene.find(clips.front());
    std::string known;
    for (size_t i = 0; i < clips.size(); ++i) {
        const Clip& clip = *scene.find(clips[i]);
        if (clip.name == *options.clip || "#" + std::to_string(i) == *options.clip) return clip;
        known += (i ? ", #" : "#") + std::to_string(i) + " \"" + clip.name + "\"";
    }
    throw Error(file, "there is no clip \"" + *options.clip + "\"; it has " + known);
}

void addMotion(Scene& scene, const std::string& file, const std::string& motion, Progress* progress)
{
    const Imported in = readFile(motion, progress);
    warn(motion, in.warnings);
    if (in.scene.clips().empty()) throw Error(motion, "there is no clip in it");
    if (adoptClips(scene, in.scene).empty())
        throw Error(motion, "its clips move another skeleton than that of " + file + ": names or bone lengths differ");
}

}  // namespace mw::cli
