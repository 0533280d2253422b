// A strip of yarns between two clamps, and the stages that pull it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "dem/run/scenario.h"
#include "packing/expand/plan.h"

namespace soilweave::support {

inline const std::string node_law =
    "law = \"hertz-mindlin\"\nyoung_modulus = \"8 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 21\n";
inline const std::string node_materials =
    "[contact]\n" + node_law + "[[material]]\n" + node_law.substr(node_law.find('\n') + 1);

/// Returns a strip one cell wide and n long, with 5 mm yarns; two cells hang between the clamps of its ends.
inline io::Snapshot strip(int n) {
  const packing::Plan plan = packing::read_plan(
      "[container]\nshape = \"none\"\n[[sheet]]\ncells = [1, " + std::to_string(n) + ", 1]\n" + node_materials, "plan",
      {});
  return packing::assemble({}, plan);
}

/// Returns the scenario of these stages for a strip of this half length (m) between the clamps "left" and "right".
inline dem::Scenario pulled(const std::string& curve, const std::string& stages, double half) {
  const auto box = [](double low, double high) {
    return "low = [-1, " + std::to_string(low) + ", -1]\nhigh = [1, " + std::to_string(high) + ", 1]\n";
  };
  return dem::read_scenario(node_materials + "[[geotextile]]\n" + curve + "[[clamp]]\nname = \"left\"\n" +
                                box(-half - 1e-3, -half + 1e-3) + "[[clamp]]\nname = \"right\"\n" +
                                box(half - 1e-3, half + 1e-3) +
                                "[equilibrium]\nunbalanced_force = 1e-9\n[numerics]\ndamping = 0.8\n" + stages,
                            "test", {});
}

constexpr double slow = 1e-3;  // m/s

/// Returns the stage that moves the right clamp by `distance` (m) in so many parts, at `speed` (m/s).
inline std::string move(double distance, int parts, double speed = slow) {
  return "[[stage]]\npath = \"drive\"\nparts = " + std::to_string(parts) +
         "\n[[stage.move]]\npart = \"right\"\nalong = [0, " + (distance > 0 ? "1" : "-1") +
         ", 0]\ndistance = " + std::to_string(std::abs(distance)) + "\nspeed = " + std::to_string(speed) + "\n";
}

/// The curve of the yarns of PE, as a scenario writes it.
inline const std::string pe_points = "yarn_strain = [0.02, 0.06, 0.17035]\nyarn_tension = [8.4, 20.6, 47.5]\n";

}  // namespace soilweave::support
