// One row of a run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>

#include "dem/state/overlap.h"

namespace soilweave::dem {
namespace {

// Value of a quantity that is not defined for the state.
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

struct Coordination {
  double all = 0;                // 2 Nc/N
  double mechanical = no_value;  // Thornton (2000): (2 Nc - N1)/(N - N0 - N1)
  double sliding = no_value;     // share of the contacts
};

Coordination coordination_of(const io::Snapshot& s) {
  std::vector<int> count(s.grains.size(), 0);
  double sliding = 0;
  for (std::size_t c = 0; c < s.contacts.size(); ++c) {
    for (const std::int32_t b : s.contacts.bodies[c])
      if (b >= 0) ++count[static_cast<std::size_t>(b)];
    sliding += s.contacts.sliding[c];
  }
  const double n = static_cast<double>(count.size());
  const auto n0 = static_cast<double>(std::count(count.begin(), count.end(), 0));
  const auto n1 = static_cast<double>(std::count(count.begin(), count.end(), 1));
  double ends = 0;
  for (const int k : count) ends += k;
  const double m = static_cast<double>(s.contacts.size());
  return {ends / n, n > n0 + n1 ? (ends - n1) / (n - n0 - n1) : no_value, m > 0 ? sliding / m : no_value};
}

// Quantities of a row, gathered once. Stress, strain and void ratio have no value unless the cell is periodic along all
// axes, because other cells do not follow their grains.
struct Moment {
  Moment(const Simulation& of, const io::Snapshot& state, int number)
      : simulation(of),
        dimension(state.grains.dimension),
        stage(number),
        stress(of.measures().stress),
        strain(of.strain()),
        void_ratio(of.void_ratio()),
        coordination(coordination_of(state)),
        largest_overlap(deepest_of(state.contacts, of.bodies()).relative) {
    if (of.cell().all_periodic()) return;
    stress.setConstant(no_value), strain.setConstant(no_value), void_ratio = no_value;
  }

  double stress_ratio() const {
    const int last = dimension - 1;
    const double axial = stress(last, last), lateral = (stress.diagonal().head(dimension).sum() - axial) / last;
    return lateral > 0 ? axial / lateral : no_value;
  }

  const Simulation& simulation;
  int dimension, stage;
  Mat3 stress;
  Vec3 strain;
  double void_ratio;
  Coordination coordination;
  double largest_overlap;
};

struct Quantity {
  const char *name, *unit, *long_name;
  double (*value)(const Moment&);
};

double deviatoric_strain(const Vec3& strain, int dimension) {
  const Mat3 e = strain.asDiagonal();
  return (dimension == 3 ? 2.0 / 3.0 : 2.0) * deviatoric_stress(e, dimension);
}

using M = Moment;
constexpr std::array quantities = {
    Quantity{"step", "1", "time steps since the start", [](const M& m) { return double(m.simulation.steps()); }},
    Quantity{"time", "s", "time since the start", [](const M& m) { return m.simulation.time(); }},
    Quantity{"stage", "1", "number of the loading stage, from 0", [](const M& m) { return double(m.stage); }},
    Quantity{"strain_xx", "1", "natural strain along x, compression positive", [](const M& m) { return m.strain.x(); }},
    Quantity{"strain_yy", "1", "natural strain along y, compression positive", [](const M& m) { return m.strain.y(); }},
    Quantity{"strain_zz", "1", "natural strain along z, compression positive", [](const M& m) { return m.strain.z(); }},
    Quantity{"strain_axial", "1", "natural strain along the loading axis",
             [](const M& m) { return m.strain[m.dimension - 1]; }},
    Quantity{"strain_volumetric", "1", "sum of the natural strains, contraction positive",
             [](const M& m) { return m.strain.sum(); }},
    Quantity{"strain_deviatoric", "1", "deviatoric strain, sqrt(2/3 e:e) in 3D",
             [](const M& m) { return deviatoric_strain(m.strain, m.dimension); }},
    Quantity{"stress_xx", "Pa", "stress, compression positive", [](const M& m) { return m.stress(0, 0); }},
    Quantity{"stress_yy", "Pa", "stress, compression positive", [](const M& m) { return m.stress(1, 1); }},
    Quantity{"stress_zz", "Pa", "stress, compression positive", [](const M& m) { return m.stress(2, 2); }},
    Quantity{"stress_xy", "Pa", "shear stress", [](const M& m) { return m.stress(0, 1); }},
    Quantity{"stress_yz", "Pa", "shear stress", [](const M& m) { return m.stress(1, 2); }},
    Quantity{"stress_zx", "Pa", "shear stress", [](const M& m) { return m.stress(2, 0); }},
    Quantity{"mean_stress", "Pa", "mean stress p", [](const M& m) { return mean(m.stress, m.dimension); }},
    Quantity{"deviatoric_stress", "Pa", "deviatoric stress q",
             [](const M& m) { return deviatoric_stress(m.stress, m.dimension); }},
    Quantity{"stress_ratio", "1", "axial stress over mean lateral stress", [](const M& m) { return m.stress_ratio(); }},
    Quantity{"void_ratio", "1", "void ratio of the cell, overlaps counted twice",
             [](const M& m) { return m.void_ratio; }},
    Quantity{"coordination_number", "1", "2 Nc/N", [](const M& m) { return m.coordination.all; }},
    Quantity{"mechanical_coordination_number", "1", "(2 Nc - N1)/(N - N0 - N1), Thornton (2000)",
             [](const M& m) { return m.coordination.mechanical; }},
    Quantity{"sliding_fraction", "1", "share of contacts at the Coulomb limit",
             [](const M& m) { return m.coordination.sliding; }},
    Quantity{"unbalanced_force", "1", "mean resultant on grains over mean contact force",
             [](const M& m) { return m.simulation.unbalanced_force(); }},
    Quantity{"largest_overlap", "1", "largest overlap over the smaller radius",
             [](const M& m) { return m.largest_overlap; }},
    Quantity{"time_step", "s", "time step", [](const M& m) { return m.simulation.time_step(); }},
};

}  // namespace

io::Series empty_series() {
  io::Series series;
  for (const Quantity& q : quantities) series.columns.push_back({q.name, q.unit, q.long_name, {}});
  for (const EnergyColumn& c : Energies().columns())
    series.columns.push_back({std::string(c.name), "J", std::string(c.sentence), {}});
  return series;
}

void record(const Simulation& simulation, const io::Snapshot& state, const Energies& energies, int stage,
            io::Series& series) {
  const Moment moment(simulation, state, stage);
  std::size_t column = 0;
  for (const Quantity& q : quantities) series.columns[column++].values.push_back(q.value(moment));
  for (const EnergyColumn& c : energies.columns()) series.columns[column++].values.push_back(c.value);
}

void demand_distinct_columns(const io::Series& first_row) {
  std::set<std::string_view> names;
  for (const io::Column& c : first_row.columns)
    if (c.values.size() != 1 || !names.insert(c.name).second)
      throw std::logic_error("two quantities have the column " + c.name + " of the series: rename the energy term");
}

}  // namespace soilweave::dem
