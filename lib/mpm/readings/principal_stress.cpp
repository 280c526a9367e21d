#include "mpm/readings/principal_stress.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "mpm/base/instantiate.h"
#include "mpm/materials/ice_lane.h"

namespace tidewater::mpm {

using namespace ice_lane;

namespace {

constexpr std::size_t particles_per_task = 4096;

// The max. eigenvalue of a symmetric tensor whose trace is 0.
template <int D>
double max_eigenvalue(const double* dev) {
    if constexpr (D == 2) return std::hypot(dev[0], dev[1]);
    Eigen::Matrix3d tensor;
    tensor << dev[0], dev[1], dev[2], dev[1], dev[3], dev[4], dev[2], dev[4], dev[5];
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
        .computeDirect(tensor, Eigen::EigenvaluesOnly)
        .eigenvalues()[2];
}

}  // namespace

template <int D>
double max_principal_stress(const IceModel& model, const std::array<double, symmetric_size<D>>& strain) {
    Column<double> lane[symmetric_size<D>];
    for (int c = 0; c < symmetric_size<D>; ++c) lane[c][0] = strain[static_cast<std::size_t>(c)];
    const Split<D, double> b = split<D>(lane, 0);
    const double volume = clamp_volume(b.volume);
    const double shear = model.shear_modulus() * inverse_stretch2<D>(volume);
    const double pull = 0.5 * model.bulk_modulus(D) * b.volume;
    return (pull + shear * max_eigenvalue<D>(b.dev)) / std::sqrt(1.0 + volume);
}

template <int D, class Real>
std::vector<float> principal_stress(const IceModel& model, const Particles<D, Real>& particles) {
    if (particles.material != Material::ice) return {};
    std::vector<float> stress(particles.size());
    parallel_for(
        stress.size(),
        [&](std::size_t p) {
            std::array<double, symmetric_size<D>> strain;
            for (std::size_t c = 0; c < strain.size(); ++c) {
                strain[c] = static_cast<double>(particles.strain[c][p]);
            }
            stress[p] = static_cast<float>(max_principal_stress<D>(model, strain));
        },
        particles_per_task);
    return stress;
}

template double max_principal_stress<2>(const IceModel&, const std::array<double, 3>&);
template double max_principal_stress<3>(const IceModel&, const std::array<double, 6>&);
#define TIDEWATER_INSTANTIATE(D, Real) \
    template std::vector<float> principal_stress(const IceModel&, const Particles<D, Real>&);
TIDEWATER_FOR_EACH_KIND(TIDEWATER_INSTANTIATE)

}  // namespace tidewater::mpm
