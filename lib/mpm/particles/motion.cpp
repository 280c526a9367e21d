#include "mpm/particles/motion.h"

#include "mpm/base/instantiate.h"
#include "mpm/particles/transfer_batch.h"

namespace tidewater::mpm {

template <int D, class Real>
BlockMotion motion_of_block(const Grid<D, Real>& grid, const std::vector<Particles<D, Real>>& bodies,
                            std::size_t slot) {
    alignas(64) Tile<D, Real> from;
    load_velocities(grid, slot, from.data());
    TransferBatch<D, Real> batch;
    Column<Real> along{}, squares{};
    for (const auto& particles : bodies) {
        for_each_batch(particles, slot, [&](std::size_t, int, const Column<Stored<Real>>* position) {
            locate<D, Real>(position, batch.stencil);
            gather_batch<D, Real>(from.data()->data(), batch);
            Column<Real> sum{};
            for (const auto& v : batch.vector) {
                take_max_size(v, along);
                for (int p = 0; p < batch_size; ++p) sum[p] += v[p] * v[p];
            }
            for (const auto& g : batch.gradient) {
                for (int p = 0; p < batch_size; ++p) sum[p] += Real(0.25) * g[p] * g[p];
            }
            take_max_size(sum, squares);
        });
    }
    const auto max_of = [](const Column<Real>& column) {
        return static_cast<double>(*std::max_element(column.value, column.value + batch_size));
    };
    return {.along = max_of(along), .all = std::sqrt(max_of(squares))};
}

#define TIDEWATER_INSTANTIATE(D, Real)                                                                 \
    template BlockMotion motion_of_block(const Grid<D, Real>&, const std::vector<Particles<D, Real>>&, \
                                         std::size_t);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
