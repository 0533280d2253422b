// The thesis's grains of Toyoura sand, to which stiffnesses of other grains are compared.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave::dem {

/// Mean radius of the thesis's representative volume of 1000 grains of Toyoura sand, m (Grading::toyoura at a solid
/// volume of 1.169e-7 m3 per grain).
inline constexpr double thesis_radius = 2.95335e-3;
/// Young's modulus of these grains, Pa (thesis Table 3.1).
inline constexpr double thesis_modulus = 4e9;
/// Rolling and twisting stiffness of these grains, N m/rad (thesis Table 3.1).
inline constexpr double thesis_rotational_stiffness = 0.13;

}  // namespace soilweave::dem
