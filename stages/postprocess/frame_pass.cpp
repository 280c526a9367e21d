#include "frame_pass.h"

#include <algorithm>
#include <cstdio>

#include "core/hash.h"
#include "core/progress.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

using Fingerprints = std::vector<std::string>;  // one per frame

// Of one product; a frame's depends on the one before where the product follows.
Fingerprints fingerprints(const std::string& run, const Frames& frames, const FrameProduct& product) {
    Fingerprints all;
    std::string before;
    for (std::size_t frame = 0; frame < frames.files.size(); ++frame) {
        const std::string made_from =
            run + "\n" + frames.stamp(frame) + "\n" + product.name + "\n" + product.settings + "\n" + before;
        all.push_back(hash_hex(hash_text(made_from)));
        if (product.follows) before = all.back();
    }
    return all;
}

// What a product made is told to come from the simulated scene and its own settings, not from keys that do
// not count for it.
Provenance product_provenance(const StageContext& context, const FrameProduct& product) {
    Provenance provenance = context.provenance;
    const std::string simulated = scene_hash(context.scene, scene::Stage::simulate);
    provenance.scene_hash = hash_hex(hash_text(simulated + product.settings));
    return provenance;
}

struct Work {
    std::size_t frame = 0, product = 0;
};

// What is to be made; the rest is current. Where a product follows, all after the first that is not current.
std::vector<Work> outdated(const Frames& frames, std::span<const FrameProduct> products,
                           std::span<const Fingerprints> made_from, Stamps& stamps) {
    std::vector<Work> work;
    for (std::size_t p = 0; p < products.size(); ++p) {
        bool follows_outdated = false;
        for (std::size_t frame = 0; frame < frames.files.size(); ++frame) {
            const auto names = products[p].files(frame);
            const bool current = std::ranges::all_of(
                names, [&](const std::string& name) { return stamps.current(name, made_from[p][frame]); });
            for (const std::string& name : names) stamps.claim(name);
            if (current && !follows_outdated) continue;
            if (!names.empty()) work.push_back({frame, p});
            follows_outdated = products[p].follows;
        }
    }
    std::ranges::stable_sort(work, {}, &Work::frame);
    return work;
}

}  // namespace

std::string frame_file(const std::string& product, std::size_t frame, const std::string& extension) {
    return "frames/" + io::numbered_name(product, frame, extension);
}

void make_frame_products(const StageContext& context, const Frames& frames,
                         std::span<const FrameProduct> products, const std::string& what, Stamps& stamps) {
    const std::string run = program_fingerprint() + scene_hash(context.scene, scene::Stage::simulate);
    std::vector<Fingerprints> made_from;
    for (const FrameProduct& product : products) made_from.push_back(fingerprints(run, frames, product));
    const std::vector<Work> work = outdated(frames, products, made_from, stamps);
    for (const Work& each : work) {
        for (const std::string& name : products[each.product].files(each.frame)) stamps.remove(name);
    }
    if (work.empty()) return;
    Progress progress(what);
    for (auto next = work.begin(); next != work.end();) {
        const std::size_t frame = next->frame;
        const io::Snapshot snapshot = read_frame(frames, frame, context.scene);
        for (; next != work.end() && next->frame == frame; ++next) {
            const FrameProduct& product = products[next->product];
            product.make(frame, snapshot, product_provenance(context, product));
            for (const std::string& name : product.files(frame))
                stamps.mark(name, made_from[next->product][frame]);
        }
        progress.update(static_cast<double>(next - work.begin()) / static_cast<double>(work.size()),
                        "t = " + io::format_fixed(snapshot.time, 2) + " s");
    }
}

}  // namespace tidewater::postprocess
