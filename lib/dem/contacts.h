// Candidate pairs and the contacts among them, as flat arrays sorted by (first, second): geometry memory, law memory,
// and the forces of the last sweep. A pair whose grains do not touch holds zeros.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/lanes.h"
#include "core/tensor.h"
#include "dem/laws/contact.h"

namespace soilweave::dem {

struct Contacts {
  std::vector<std::int32_t> first, second;  // grain indices, first < second; a plane k is -1 - k in second
  std::vector<Vec3i> image;                 // cell offset of the second grain
  std::vector<std::uint8_t> touching;
  std::vector<V3<double>> normal;             // of the last sweep: part of the history
  std::vector<Memory<double>> memory;         // N, N m
  std::vector<double> overlap, normal_force;  // m, N
  std::vector<std::uint8_t> sliding;
  std::vector<V3<double>> branch;                       // m, centre to centre
  std::vector<V3<double>> force;                        // N, on the second body
  std::vector<V3<double>> torque_first, torque_second;  // N m
  std::vector<double> normal_stiffness, shear_stiffness, rolling_stiffness, twisting_stiffness;

  // Grain b's pairs are body_pairs[body_start[b] .. body_start[b+1]), ascending: the fixed order of every per-grain
  // sum.
  std::vector<std::int32_t> body_start, body_pairs;

  std::size_t size() const { return first.size(); }
  void resize(std::size_t n) {
    first.resize(n), second.resize(n), image.resize(n), touching.resize(n), normal.resize(n), memory.resize(n);
    overlap.resize(n), normal_force.resize(n), sliding.resize(n), branch.resize(n), force.resize(n);
    torque_first.resize(n), torque_second.resize(n);
    normal_stiffness.resize(n), shear_stiffness.resize(n), rolling_stiffness.resize(n), twisting_stiffness.resize(n);
  }
  /// Everything a pair carries from one list to the next.
  void copy(std::size_t to, const Contacts& from, std::size_t at) {
    touching[to] = from.touching[at], normal[to] = from.normal[at], memory[to] = from.memory[at];
    overlap[to] = from.overlap[at], normal_force[to] = from.normal_force[at], sliding[to] = from.sliding[at];
    branch[to] = from.branch[at], force[to] = from.force[at];
    torque_first[to] = from.torque_first[at], torque_second[to] = from.torque_second[at];
    normal_stiffness[to] = from.normal_stiffness[at], shear_stiffness[to] = from.shear_stiffness[at];
    rolling_stiffness[to] = from.rolling_stiffness[at], twisting_stiffness[to] = from.twisting_stiffness[at];
  }
  /// No contact, no history, no force.
  void clear(std::size_t k);
  /// Rebuilds body_start and body_pairs for n grains.
  void index(std::size_t n);
};

}  // namespace soilweave::dem
