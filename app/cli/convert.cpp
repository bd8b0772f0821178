// convert IN OUT: by ending, all that the target format can hold.
#include <iostream>

#include "app/cli/clip_options.h"
#include "app/cli/output.h"
#include "app/cli/placement_options.h"
#include "app/cli/verb.h"
#include "core/io/io.h"

namespace mw::cli {

namespace {

int run(Arguments& arguments)
{
    const bool keep = arguments.flag("--project"), ascii = arguments.flag("--ascii"), bigEndian = arguments.flag("--big-endian");
    const ImportOptions options = takeImportOptions(arguments);
    const Placement placement = takeOutPlacement(arguments);
    const std::optional<std::string> motion = arguments.value("--motion");
    const std::vector<std::string> files = arguments.finish({"IN", "OUT"});
    std::vector<Warning> lost;
    {
        Working working("reading " + files[0]);
        Imported in = readFile(files[0], working.progress(), options);
        warn(files[0], in.warnings);
        if (motion) addMotion(in.scene, files[0], *motion, working.progress());
        working.now("writing " + files[1]);
        lost = writeFile(in.scene, files[1], {.project = keep || in.project, .binary = !ascii, .bigEndian = bigEndian, .placement = placement},
                         working.progress());
    }
    warn(files[1], lost);
    return 0;
}

}  // namespace

const Verb convertVerb{"convert", "from one file format to another",
                       "convert IN OUT [--unit UNIT] [--up y|z|x] [--out-unit UNIT] [--out-up y|z|x] [--motion FILE]\n"
                       "        [--project] [--ascii] [--big-endian]\n\n"
                       "Formats are known by the ending. What the target format cannot hold is said on standard error.\n"
                       "  --motion    also the clips of this file, made for the skeleton of IN (same names of joints)\n"
                       "  --project   glTF: also keep polygons and modifiers, so that Meshwright can go on editing (a project does so anyway)\n"
                       "  --ascii     OFF, PLY, STL: as text\n"
                       "  --big-endian    PLY: the order of bytes\n"
                       "  --unit UNIT     what a number in IN means: mm, cm, m, in, ft, or how many metres; overrules what the file says\n"
                       "  --up y|z|x      which axis of IN points up; overrules what the file says\n"
                       "  --out-unit UNIT what a number in OUT shall mean (OBJ, OFF, PLY, STL; glTF is always in metres); m unless said\n"
                       "  --out-up y|z|x  which axis of OUT shall point up (OBJ, OFF, PLY, STL; in glTF it is always y); y unless said\n\n"
                       "  meshwright convert part.stl part.glb --unit mm --up z\n",
                       run};

}  // namespace mw::cli
