// Yarns of geotextiles: their tensions, and the forces on their nodes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact/contacts.h"
#include "dem/contact/wire.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"

namespace soilweave::dem {

/// Sums over the yarns.
struct YarnSums {
  /// Energy that unloading returns, J.
  double elastic = 0;
  /// Energy lost by yielding and breaking in the last step, J.
  double dissipated = 0;
  /// Sum of the tensions, N.
  double tension = 0;
  /// Number of yarns under tension.
  std::int64_t taut = 0;
  /// Number of broken yarns.
  std::int64_t broken = 0;
  /// Sum of -T l n (x) n over tension, length and direction of each yarn, N m.
  Mat3 force_branch = Mat3::Zero();

  YarnSums& operator+=(const YarnSums& s) {
    elastic += s.elastic, dissipated += s.dissipated, tension += s.tension;
    taut += s.taut, broken += s.broken, force_branch += s.force_branch;
    return *this;
  }
};

/// All yarns of a simulation, in blocks of one register.
class Yarns {
 public:
  Yarns() = default;
  /// `curves`: by geotextile_id.
  /// Throws DataError if the record names a missing curve, or if two fabrics share a node.
  Yarns(const io::YarnsRecord& record, std::size_t grains, std::vector<WireCurve> curves);

  /// Returns whether there are yarns.
  bool any() const { return !blocks_.empty(); }
  /// Returns the fabric of every grain, -1 for soil; empty without yarns.
  std::vector<std::int32_t> fabric_of() const;
  /// Replaces the curves between stages; the history stays.
  void set_curves(std::vector<WireCurve> curves) { curves_ = std::move(curves); }

  /// Stretches all yarns to the present positions, and adds their tensions to the forces on their nodes.
  /// Each node adds its yarns in a fixed order, so that threads do not change bits. `time`: time of new breaks, s.
  void run(double time, int threads, Bodies& bodies);
  /// Returns the sums of the last run().
  const YarnSums& sums() const { return sums_; }

  /// Returns the largest stiffness over mass of the nodes, 1/s2; 0 without yarns.
  /// It includes the contact stiffnesses that ContactSweep::stiffen left in Bodies::stiffness.
  double stiffness_over_mass(const Bodies& bodies, const Contacts& contacts) const;
  /// Returns the affine stiffness of taut yarns times squared lengths along the axes, N m.
  /// A yarn resists stretching along its direction, and sideways motion like a taut string.
  Vec3 affine_stiffness(int threads) const;
  /// Returns the yarns as files hold them.
  io::YarnsRecord record() const;

 private:
  /// Yarns of one geotextile. Lanes from `count` on are empty and count as broken.
  struct Block {
    static constexpr std::size_t size = width<Lane4>;
    /// Byte offsets of the nodes from the first grain.
    std::uint32_t first[size]{}, second[size]{};
    /// Length without tension, m.
    Lane4 rest_length = broadcast<Lane4>(1);
    /// Tension, N, and length, m, at the last evaluation; 0 before the first.
    Lane4 tension{}, length{};
    /// History of each yarn.
    WireHistory<Lane4> history{{}, ~Mask<Lane4>{}};
    /// Geotextile of the block, and its number of yarns.
    std::int32_t geotextile, count = 0;

    explicit Block(std::int32_t of) : geotextile(of) {}
  };
  /// Time and place of a break.
  struct Breakage {
    /// Time, s.
    double time = 0;
    /// Place of the break, m.
    Vec3 position = Vec3::Zero();
  };
  /// Lays the yarns out in blocks.
  void lay_out(const io::YarnsRecord& record);
  /// Lists the yarn ends at each node.
  void list_ends(const io::YarnsRecord& record);
  /// Returns the steepest slope of each geotextile's curve, N per unit of strain.
  std::vector<double> stiffest() const;
  YarnSums stretch(double time, const Bodies& bodies, std::size_t block);
  void note_breakage(double time, const Bodies& bodies, std::size_t slot);

  LargeVector<Block> blocks_;
  /// Unit vector from first to second node, and tension, N, for each slot: a lane of a block.
  LargeVector<Lane4> pulls_;
  /// Slot of each yarn of the record.
  std::vector<std::size_t> slot_;
  /// Breaks by slot.
  std::vector<Breakage> breakage_;
  /// Curves by geotextile_id.
  std::vector<WireCurve> curves_;
  /// Grains that are nodes, ascending.
  std::vector<std::int32_t> node_;
  /// `ends_`: the yarn ends, node by node. `start_`: index of the first end of each node.
  /// An end is stored as twice its slot, plus one at the yarn's second node.
  std::vector<std::uint32_t> start_, ends_;
  /// Sums by group of blocks.
  std::vector<YarnSums> partial_;
  YarnSums sums_;
  /// Data of the record that never change.
  io::YarnsRecord identity_;
  std::size_t grains_ = 0;
};

}  // namespace soilweave::dem
