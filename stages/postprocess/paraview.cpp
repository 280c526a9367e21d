#include "paraview.h"

#include "core/files.h"
#include "io/collection.h"
#include "particles.h"
#include "surfaces.h"
#include "view_script.h"

namespace tidewater::postprocess {
namespace {

void write_product_collection(const StageContext& context, const Frames& frames, const FrameProduct& product,
                              const std::string& name) {
    std::vector<io::CollectionEntry> entries;
    for (std::size_t frame = 0; frame < frames.times.size(); ++frame) {
        for (const std::string& file : product.files(frame)) entries.push_back({file, frames.times[frame]});
    }
    if (!entries.empty()) io::write_collection(context.folder / name, entries, context.provenance);
}

}  // namespace

ParaviewProducts paraview_products(const StageContext& context, const FrameProduct& icebergs,
                                   const FrameProduct& surface) {
    return {particles_product(context, icebergs), water_surface_product(context, surface),
            body_surfaces_product(context, icebergs)};
}

void write_collections(const StageContext& context, const Frames& frames, const ParaviewProducts& products) {
    write_product_collection(context, frames, products.particles, "particles.pvd");
    write_product_collection(context, frames, products.water_surface, "water_surface.pvd");
    write_product_collection(context, frames, products.iceberg_surfaces, "iceberg_surfaces.pvd");
    write_text(context.folder / "view.py", view_script);
}

}  // namespace tidewater::postprocess
