#include "mpm/particles/transfer.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <vector>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <int D>
Vector<D, double> node_position(int n) {
    Vector<D, double> x;
    for (int axis = D - 1; axis >= 0; --axis, n /= Block<D>::tile_width)
        x[axis] = n % Block<D>::tile_width - 1;
    return x;
}

// Positions over the whole range that a tile admits, its ends included.
template <int D>
std::vector<Vector<D, double>> sample_positions() {
    const double low = -0.5, high = Block<D>::width + 0.4999;
    std::vector<Vector<D, double>> samples{Vector<D, double>::Constant(low),
                                           Vector<D, double>::Constant(high)};
    for (std::uint64_t n = 0; n < 50; ++n) {
        Vector<D, double> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = low + (high - low) * random_uniform(7, static_cast<std::uint64_t>(axis), n);
        samples.push_back(x);
    }
    return samples;
}

template <int D>
Matrix<D, double> sample_gradient(std::uint64_t n) {
    Matrix<D, double> g;
    for (int k = 0; k < D * D; ++k)
        g(k / D, k % D) = random_uniform(8, static_cast<std::uint64_t>(k), n) - 0.5;
    return g;
}

}  // namespace

TEST_CASE_TEMPLATE("scatter conserves mass, momentum and its moment about the origin", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    std::uint64_t n = 0;
    for (const auto& x : sample_positions<D>()) {
        const Matrix<D, double> gradient = sample_gradient<D>(++n);
        const Vector<D, double> momentum = gradient.col(0);
        std::vector<Node<double>> tile(Block<D>::tile_nodes, Node<double>::Zero());
        scatter<D, double>(x, 3.0, momentum, gradient, tile.data());
        double mass = 0;
        Vector<D, double> sum = Vector<D, double>::Zero();
        Matrix<D, double> moment = Matrix<D, double>::Zero();
        for (int i = 0; i < Block<D>::tile_nodes; ++i) {
            const Node<double>& node = tile[static_cast<std::size_t>(i)];
            mass += node[mass_lane];
            sum += node.head<D>().matrix();
            moment += node.head<D>().matrix() * node_position<D>(i).transpose();
        }
        CHECK(mass == doctest::Approx(3.0).epsilon(1e-14));
        CHECK((sum - momentum).norm() < 1e-14);
        // Σ w (x_i − x_p)(x_i − x_p)ᵀ = ¼ I in cells.
        CHECK((moment - (momentum * x.transpose() + 0.25 * gradient)).norm() < 1e-13);
    }
}

TEST_CASE_TEMPLATE("gather returns any affine velocity field exactly", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    std::uint64_t n = 100;
    for (const auto& x : sample_positions<D>()) {
        const Matrix<D, double> slope = sample_gradient<D>(++n);
        std::vector<Node<double>> tile(Block<D>::tile_nodes, Node<double>::Zero());
        for (int i = 0; i < Block<D>::tile_nodes; ++i) {
            tile[static_cast<std::size_t>(i)].head<D>() = (slope * node_position<D>(i)).array() + 2.0;
        }
        Vector<D, double> velocity;
        Matrix<D, double> gradient;
        gather<D, double>(x, tile.data(), velocity, gradient);
        CHECK((velocity - (slope * x + Vector<D, double>::Constant(2.0))).norm() < 1e-13);
        CHECK((gradient - slope).norm() < 1e-13);
    }
}
