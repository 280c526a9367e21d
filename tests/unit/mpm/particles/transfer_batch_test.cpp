#include "mpm/particles/transfer_batch.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <vector>

#include "core/random.h"
#include "mpm/particles/transfer.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int dimension, class Type>
struct Case {
    static constexpr int D = dimension;
    using Real = Type;
};
#define TIDEWATER_CASES Case<2, float>, Case<2, double>, Case<3, float>, Case<3, double>

constexpr int counts[] = {1, 15, 16, 17, 63, 64};

template <class Real>
constexpr double rounding = sizeof(Real) == 4 ? 2e-6 : 4e-15;  // relative to the greatest number involved

double uniform(int stream, int counter) {
    return random_uniform(11, static_cast<std::uint64_t>(stream), static_cast<std::uint64_t>(counter));
}

// Positions over all that a tile admits; the first two are its ends.
template <int D, class Real>
struct Sample {
    Column<Stored<Real>> position[D];
    Vector<D, Real> momentum[batch_size];
    Matrix<D, Real> gradient[batch_size];

    explicit Sample(int count) {
        const double low = -0.5, high = Block<D>::width + 0.4999;
        for (int axis = 0; axis < D; ++axis) {
            for (int p = 0; p < batch_size; ++p) {
                const double between = p == 0 ? 0.0 : p == 1 ? 1.0 : uniform(axis, 64 * count + p);
                position[axis][p] = stored<Real>(low + (high - low) * between);
            }
            // The padding is what load_column makes of it.
            for (int p = count; p < batch_size; ++p) position[axis][p] = position[axis][count - 1];
        }
        for (int p = 0; p < batch_size; ++p) {
            for (int i = 0; i < D; ++i) {
                momentum[p][i] = static_cast<Real>(uniform(10 + i, p) - 0.5);
                for (int k = 0; k < D; ++k)
                    gradient[p](i, k) = static_cast<Real>(uniform(20 + i * D + k, p) - 0.5);
            }
        }
    }
    Vector<D, double> cells(int p) const {
        Vector<D, double> x;
        for (int axis = 0; axis < D; ++axis) x[axis] = cells_of(position[axis][p]);
        return x;
    }
    void fill(TransferBatch<D, Real>& batch) const {
        for (int p = 0; p < batch_size; ++p) {
            for (int i = 0; i < D; ++i) {
                batch.vector[i][p] = momentum[p][i];
                for (int k = 0; k < D; ++k) batch.gradient[i * D + k][p] = gradient[p](i, k);
            }
        }
    }
};

template <int D, class Real>
using TileNodes = std::vector<Node<Real>>;

// Scatters a batch into an empty tile.
template <int D, class Real>
TileNodes<D, Real> scattered(Real mass, int count, TransferBatch<D, Real>& batch) {
    Strips<D, Real> strips{};
    scatter_batch<D, Real>(mass, count, batch, strips);
    TileNodes<D, Real> tile(Block<D>::tile_size, Node<Real>::Zero());
    sum_strips<D, Real>(strips, tile[0].data());
    return tile;
}

}  // namespace

TEST_CASE_TEMPLATE("gathering a batch equals gathering its particles one by one", C, TIDEWATER_CASES) {
    constexpr int D = C::D;
    using Real = typename C::Real;
    TileNodes<D, Real> tile(Block<D>::tile_size, Node<Real>::Zero());
    for (int n = 0; n < Block<D>::tile_nodes; ++n) {
        for (int lane = 0; lane < 4; ++lane)
            tile[static_cast<std::size_t>(n)][lane] = static_cast<Real>(uniform(40 + lane, n) - 0.5);
    }
    TransferBatch<D, Real> batch;
    double worst = 0.0;
    for (const int count : counts) {
        const Sample<D, Real> sample(count);
        locate<D, Real>(sample.position, batch.stencil);
        gather_batch<D, Real>(tile[0].data(), batch);
        for (int p = 0; p < batch_size; ++p) {
            Vector<D, Real> velocity;
            Matrix<D, Real> gradient;
            gather<D, Real>(sample.cells(p), tile.data(), velocity, gradient);
            for (int i = 0; i < D; ++i) {
                worst = std::max(worst, std::abs(static_cast<double>(batch.vector[i][p] - velocity[i])));
                for (int k = 0; k < D; ++k) {
                    const Real difference = batch.gradient[i * D + k][p] - gradient(i, k);
                    worst = std::max(worst, std::abs(static_cast<double>(difference)));
                }
            }
        }
    }
    INFO("D = " << D << ", " << sizeof(Real) << " bytes: worst " << worst);
    CHECK(worst < rounding<Real>);
}

TEST_CASE_TEMPLATE("scattering a batch equals scattering its particles one by one", C, TIDEWATER_CASES) {
    constexpr int D = C::D;
    using Real = typename C::Real;
    TransferBatch<D, Real> batch;
    double worst = 0.0;
    for (const int count : counts) {
        const Sample<D, Real> sample(count);
        TileNodes<D, double> plain(Block<D>::tile_size, Node<double>::Zero());
        locate<D, Real>(sample.position, batch.stencil);
        sample.fill(batch);
        const TileNodes<D, Real> tile = scattered<D, Real>(Real(3), count, batch);
        for (int p = 0; p < count; ++p) {
            scatter<D, double>(sample.cells(p), 3.0, sample.momentum[p].template cast<double>(),
                               sample.gradient[p].template cast<double>(), plain.data());
        }
        for (std::size_t n = 0; n < tile.size(); ++n) {
            for (const int lane : {0, 1, 2, 3})
                worst = std::max(worst, std::abs(static_cast<double>(tile[n][lane]) - plain[n][lane]));
            if (D == 2) CHECK(tile[n][2] == Real(0));
        }
        for (int n = Block<D>::tile_nodes; n < Block<D>::tile_size; ++n)
            CHECK(tile[static_cast<std::size_t>(n)].isZero(Real(0)));
    }
    INFO("D = " << D << ", " << sizeof(Real) << " bytes: worst " << worst);
    CHECK(worst < 5.0 * rounding<Real>);  // up to 64 particles of mass 3 on few nodes
}

TEST_CASE_TEMPLATE("what the padding holds changes neither the tile nor the particles", C, TIDEWATER_CASES) {
    constexpr int D = C::D;
    using Real = typename C::Real;
    for (const int count : counts) {
        Sample<D, Real> sample(count);
        TileNodes<D, Real> first, second;
        TransferBatch<D, Real> batch;
        std::vector<Vector<D, Real>> read[2];
        for (auto* tile : {&first, &second}) {
            locate<D, Real>(sample.position, batch.stencil);
            sample.fill(batch);
            *tile = scattered<D, Real>(Real(3), count, batch);
            gather_batch<D, Real>((*tile)[0].data(), batch);
            for (int p = 0; p < count; ++p) {
                Vector<D, Real> v;
                for (int i = 0; i < D; ++i) v[i] = batch.vector[i][p];
                read[tile == &second].push_back(v);
            }
            for (int p = count; p < batch_size; ++p) {
                sample.momentum[p].setConstant(Real(1e6));
                for (auto& column : sample.position) column[p] = stored<Real>(1.3);
            }
        }
        for (std::size_t n = 0; n < first.size(); ++n) CHECK((first[n] == second[n]).all());
        CHECK(read[0] == read[1]);
    }
}

TEST_CASE_TEMPLATE("a batch's weights sum to one but for a rounding", C, TIDEWATER_CASES) {
    constexpr int D = C::D;
    using Real = typename C::Real;
    const Sample<D, Real> sample(64);
    TransferBatch<D, Real> batch;
    locate<D, Real>(sample.position, batch.stencil);
    for (int p = 0; p < 64; ++p) {
        for (const auto& weight : batch.stencil.weight) {
            const double sum = static_cast<double>(weight[0][p]) + static_cast<double>(weight[1][p]) +
                               static_cast<double>(weight[2][p]);
            CHECK(std::abs(sum - 1.0) <= std::numeric_limits<Real>::epsilon());
        }
    }
}
