// Uniaxial compression between two plates, in stations of engineering strain, with optional unloading.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/beside.h"
#include "dem/loading/path.h"

namespace soilweave::dem {

/// Displacements of two plates. Strains are engineering strains of the height between them.
class Uniaxial final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "uniaxial";
  /// Reads plates, height, rate, and strains.
  static Uniaxial read(Settings& table) {
    static constexpr Parameter height{"height", "m", 0, 1e3, true, "height that engineering strains refer to"};
    static constexpr Parameter strain{"strain", "1",   -1,
                                      1,        false, "engineering strain at the end, compression positive"};
    static constexpr Parameter increment{"increment", "1", 0, 1, true, "strain between recorded stations"};
    static constexpr Parameter list{"stations", "1",   -1,
                                    1,          false, "strains to record at, up and down, instead of strain"};
    static constexpr Parameter rate{"rate", "1/s", 0, 1e3, true, "strain rate"};
    Uniaxial path;
    path.lower_ = table.text({"lower", "name of the lower plate"}, "bottom"),
    path.upper_ = table.text({"upper", "name of the upper plate"}, "top");
    path.both_ = table.choice({"moving", "which plates move"}, {"both", "upper"}, "both") == "both";
    path.height_ = table.number(height);
    path.rate_ = table.number(rate, 0.1);
    if (table.has("stations")) {
      refuse_beside(table, "stations", {strain.name, increment.name});
      path.strain_ = table.numbers(list);
      return path;
    }
    const double end = table.number(strain), step = table.number(increment, 0.01);
    path.strain_ = stations_every(step, end, table);
    return path;
  }

  std::size_t stations() const override { return strain_.size(); }
  AxisGoals goals(std::size_t, const PathState&) const override { return {}; }
  std::optional<Between> between() const override { return Between{lower_, upper_, height_}; }
  int least_dimension() const override { return 3; }
  double nominal_strain(std::size_t station) const override { return strain_[station]; }
  std::vector<DriveGoal> drives(std::size_t station) const override {
    const double share = both_ ? 0.5 : 1, way = share * height_ * strain_[station], speed = share * height_ * rate_;
    std::vector<DriveGoal> goals = {{upper_, DriveGoal::Kind::displacement, -Vec3::UnitZ(), way, speed}};
    if (both_) goals.push_back({lower_, DriveGoal::Kind::displacement, Vec3::UnitZ(), way, speed});
    return goals;
  }

 private:
  /// Names of the plates.
  std::string lower_, upper_;
  /// Whether both plates move.
  bool both_ = true;
  /// Height, m, and strain rate, 1/s.
  double height_ = 0, rate_ = 0;
  /// Engineering strain at each station, compression positive.
  std::vector<double> strain_;
};

}  // namespace soilweave::dem
