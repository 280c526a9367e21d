#include "mpm/readings/principal_stress.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <type_traits>

#include "mpm/step/settle.h"
#include "support/tank.h"
#include "unit/mpm/ice_support.h"

using namespace tidewater;
using namespace tidewater::mpm;
using namespace tidewater::mpm::ice_support;

namespace {

template <int D>
double of_strain(const IceModel& model, const Tensor<D>& strain) {
    std::array<double, symmetric_size<D>> columns;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        columns[c] = strain(places[D - 2][c].first, places[D - 2][c].second);
    }
    return max_principal_stress<D>(model, columns);
}

// A slab 12 m high that fills the box from wall to wall, its height in cells of 1 m, and that may not fail.
Start<2> confined_slab() {
    Start<2> start;
    start.cell_size = 1.0;
    start.cells = {16, 16};
    start.parameters.ice.fracture = false;
    auto& ice = start.bodies.emplace_back();
    ice.material = Material::ice;
    ice.points = test::lattice<2>(1.0, start.cells, 2, 0.0, [](const auto& x) { return x[1] < 12.0; });
    ice.volume = 16.0 * 12.0;
    ice.mass = start.parameters.ice.density * ice.volume;
    return start;
}

}  // namespace

TEST_CASE("the greatest principal stress is the greatest eigenvalue of τ/J, of any strain") {
    Random random(1);
    const IceModel model;
    const auto check = [&]<int D>(std::integral_constant<int, D>) {
        for (int n = 0; n < 200; ++n) {
            const double size = std::pow(10.0, -6.0 + 0.025 * n);
            const Tensor<D> f = Tensor<D>::Identity() + random_tensor<D>(random, size);
            const Tensor<D> strain = f * f.transpose() - Tensor<D>::Identity();
            const double j2 = 1.0 + volume_of<D>(strain);
            if (j2 < 1e-4) continue;
            const Tensor<D> cauchy = reference_stress<D>(model, strain) / std::sqrt(j2);
            const double expected =
                Eigen::SelfAdjointEigenSolver<Tensor<D>>(cauchy, Eigen::EigenvaluesOnly).eigenvalues()[D - 1];
            CHECK(std::abs(of_strain<D>(model, strain) - expected) < 1e-7 * cauchy.norm());
        }
    };
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
}

TEST_CASE("without a strain there is no stress, and under equal pressure from all sides it is minus that") {
    const IceModel model;
    CHECK(of_strain<2>(model, Tensor<2>::Zero()) == 0.0);
    CHECK(of_strain<3>(model, Tensor<3>::Zero()) == 0.0);
    for (const double strain : {-1e-3, -1e-6, 1e-6, 1e-3}) {
        const Tensor<3> all = strain * Tensor<3>::Identity();
        const double j = std::pow(1.0 + strain, 1.5);
        CHECK(of_strain<3>(model, all) == doctest::Approx(-pressure_of<3>(model, all) / j).epsilon(1e-12));
        CHECK(of_strain<3>(model, all) ==
              doctest::Approx(1.5 * strain * model.bulk_modulus(3)).epsilon(1e-3));
    }
}

TEST_CASE("a bar under tension has the tension that Young's modulus gives, whichever way it points") {
    const IceModel model;
    const double e = 1e-4, nu = model.poisson_ratio, pull = model.youngs_modulus * e;
    Eigen::Vector3d along(1.0 + e, 1.0 - nu * e, 1.0 - nu * e);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    const Tensor<3> bar = turn * along.cwiseAbs2().asDiagonal() * turn.transpose() - Tensor<3>::Identity();
    CHECK(of_strain<3>(model, bar) == doctest::Approx(pull).epsilon(1e-3));

    // In plane strain as if E were E/(1−ν²) and ν ν/(1−ν).
    const double side = 1.0 - nu / (1.0 - nu) * e;
    const Eigen::Vector2d slice((1.0 + e) * (1.0 + e), side * side);
    const Eigen::Matrix2d tilt = Eigen::Rotation2Dd(0.4).matrix();
    const Tensor<2> plane = tilt * slice.asDiagonal() * tilt.transpose() - Tensor<2>::Identity();
    CHECK(of_strain<2>(model, plane) == doctest::Approx(pull / (1.0 - nu * nu)).epsilon(1e-3));
}

TEST_CASE_TEMPLATE("ice at rest between walls is pressed sideways by ν/(1−ν) of its weight", Real, float,
                   double) {
    auto s = make_simulation<2, Real>(confined_slab());
    begin_settling(s);
    for (int steps = 0; !settle_step(s, 200.0); ++steps) REQUIRE(steps < 20000);
    const auto& ice = s.bodies[0];
    const IceModel& model = s.parameters.ice;
    const auto stress = principal_stress(model, ice);
    REQUIRE(stress.size() == ice.size());
    const double sideways = model.poisson_ratio / (1.0 - model.poisson_ratio), weight = model.density * 9.81;
    for (std::size_t slot = 0; slot + 1 < ice.begin.size(); ++slot) {
        const auto block = block_at<2>(s.grid.particle_blocks[slot]);
        for (std::size_t p = ice.begin[slot]; p < ice.begin[slot + 1]; ++p) {
            const double depth = 12.0 - global_position(s.grid.layout, block, ice, p)[1];
            if (depth < 1.5) continue;  // the surface's cell is only partly full
            const double off = static_cast<double>(stress[p]) + sideways * weight * depth;
            CHECK(std::abs(off) < 0.02 * sideways * weight * 12.0);
        }
    }
}

TEST_CASE("water has no principal stress of ice, and no ice no value") {
    Particles<2, float> water;
    water.id = {0, 1};
    CHECK(principal_stress(IceModel{}, water).empty());
    Particles<3, float> ice;
    ice.material = Material::ice;
    CHECK(principal_stress(IceModel{}, ice).empty());
}
