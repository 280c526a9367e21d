// Types that every folder shares. SI units throughout: m, kg, s, Pa. Axes: x along the fjord, the last axis
// up; y, present in 3D only, across it. A point in 2D is (x, z), in 3D (x, y, z).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

namespace tidewater {

template <int D, class Real>
using Vector = Eigen::Matrix<Real, D, 1>;

template <int D, class Real>
using Matrix = Eigen::Matrix<Real, D, D>;

// The number is what snapshots store per particle.
enum class Material : std::uint8_t { water = 0, ice = 1, rigid = 2 };
inline constexpr std::array all_materials{Material::water, Material::ice, Material::rigid};

std::string_view material_name(Material material);

}  // namespace tidewater
