// The rigid blocks of a run: where they were, how fast, and with which energy; from simulate/bodies.csv.
#pragma once

#include <filesystem>
#include <vector>

#include "analysis/radial_wave.h"
#include "scene/scene.h"

namespace tidewater::postprocess {

struct Body {
    int number = 0;               // from 1, in the order of the scene's blocks
    double mass = 0.0;            // kg (2D: per m of width)
    std::vector<double> time;     // s
    std::vector<double> height;   // z of the centre, m
    std::vector<double> angle;    // degrees; in 3D the length of the rotation vector
    std::vector<double> fastest;  // greatest speed of any of its points, m/s
    std::vector<double> energy;   // kinetic and potential, J (2D: per m)
};

// In the order of their numbers; columns that are not told here are not read. Throws InputError if the file
// is missing or damaged.
std::vector<Body> read_bodies(const std::filesystem::path& path);

// The one of whose wave is spoken; of several the first. There must be one.
const Body& heaviest(const std::vector<Body>& bodies);

// Of the block: its greatest speed, the lesser of its edges in the x-z plane as thickness, in 3D its edge
// along y as width. Throws InputError if the scene has no such block.
analysis::Slide slide_of(const Body& body, const scene::Scene& scene);

// The edges of block `number` and where its centre is at the start, m, and its angle, degrees. Throws
// InputError likewise.
struct BlockShape {
    std::vector<double> size, center;
    double angle = 0.0;
};
BlockShape shape_of(int number, const scene::Scene& scene);

}  // namespace tidewater::postprocess
