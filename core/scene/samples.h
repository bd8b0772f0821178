// Scenes made by the program: to try things on without a file. "sample:NAME" stands for a file wherever one is read.
#pragma once
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace mw {

struct Sample {
    const char *id, *title, *about;  ///< "rock", "Scanned rock", one line
    Scene (*make)();                 ///< well under a second
};

/// blossom, rock, quadruped, gears, broken, mannequin, terrain. The first one welcomes.
const std::vector<Sample>& samples();
/// Throws Error that lists the names.
Scene sampleScene(std::string_view id);

// In files of their own.
Scene mannequinScene();  ///< a figure with a skeleton, a skin and the motions "Walk" and "Idle"
Scene blossomScene();    ///< a coarse star with Loop subdivision as modifier
Scene rockScene();       ///< as a scanner gives it: 82 thousand faces, holes, vertices nobody uses, colours
Scene quadrupedScene();  ///< a dog of quads, closed, symmetric
Scene gearsScene();      ///< three wheels of quads that mesh, genus 5, 6 and 7
Scene brokenScene();     ///< a pear with every defect that the worklist knows
Scene terrainScene();

}  // namespace mw
