// The pass over a run's frames, one in memory at a time: what each frame's products are, and which of them a
// change, a new frame or an interruption left to be made.
//
// A product of a frame is current if its files carry the stamp (stamps.h) of
//     the program, the frame's file (name, size, time of its last change), the dimension, Δx and the like of
//     the scene that was simulated, the product's own settings, and, where it follows from the frames before
//     as icebergs do, the fingerprint of the frame before.
// A frame is read only if a product of it is not current.
//
// Test: tests/pipeline/postprocess_rerun_test.sh
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/stage.h"
#include "frames.h"
#include "io/snapshot.h"
#include "stamps.h"

namespace tidewater::postprocess {

struct FrameProduct {
    std::string name;
    std::string settings;  // what it depends on besides the frame: scene::values_of its keys, for instance
    // Its files of a frame, relative to the stage's folder; none: nothing is made of this frame.
    std::function<std::vector<std::string>(std::size_t frame)> files;
    // Writes those files, each whole, with this provenance.
    std::function<void(std::size_t frame, const io::Snapshot&, const Provenance&)> make;
    bool follows = false;  // make() needs the frame before to have been made
};

// "frames/<product>_0007.csv", for results of a frame from which those of the run are gathered.
std::string frame_file(const std::string& product, std::size_t frame, const std::string& extension = "csv");

// Makes what is not current, in the order of the frames, in each in the order of the products. What is
// outdated is removed before anything is made. Progress under the name `what` goes to standard error.
void make_frame_products(const StageContext& context, const Frames& frames,
                         std::span<const FrameProduct> products, const std::string& what, Stamps& stamps);

}  // namespace tidewater::postprocess
