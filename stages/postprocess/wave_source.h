// Where a scene's waves come from and which way they run.
#pragma once

#include <vector>

#include "bodies.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

// The heaviest block; it makes the greatest wave. The scene must have one.
const scene::Block& wave_maker(const scene::Scene& scene);

// There the block's wave runs to the left; never in a scene without a block.
bool is_left_of_block(const scene::Scene& scene, double x);

// Where a wave starts, from where distances count, and the wall that it runs towards: x, m.
struct WavePath {
    double source = 0.0, wall = 0.0;

    bool to_the_right() const { return wall > source; }
};

// As in the laboratory, of a block within a cell of a wall that wall is the source; of one in the open its
// centre at the start, from which waves run both ways, the one to the right first.
std::vector<WavePath> block_wave_paths(const BlockShape& block, const scene::Scene& scene);

// The path to the right, or else the one there is: of the heaviest block; without one from `front`, where
// the ice ends, or from the left wall if front is NaN.
WavePath main_wave_path(const scene::Scene& scene, double front);

}  // namespace tidewater::postprocess
