// Tables of gws-solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"

namespace soilweave::gws {
namespace {

struct Quantity {
  const char *name, *unit, *long_name;
  std::function<double(const Point&)> value;
};

io::Series table_of(const std::vector<Point>& points, const std::vector<Quantity>& quantities) {
  io::Series table;
  for (const Quantity& q : quantities) {
    io::Column column{q.name, q.unit, q.long_name, {}};
    for (const Point& point : points) column.values.push_back(q.value(point));
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace

io::Series response_table(const std::vector<Point>& points, const Case& what) {
  using P = const Point&;
  const bool secants = what.geotextile.secant_at > 0;  // each row then has the stiffness at its own strain
  const auto stiffness = [secants, J = what.geotextile.stiffness](const Point& p) {
    return secants && p.hoop_strain > 0 ? p.hoop_tension / p.hoop_strain : J;
  };
  const double compacted = points.empty() ? 0 : points.front().settlement();
  return table_of(
      points,
      {{"surcharge", "Pa", "vertical pressure on the bag", [](P p) { return p.surcharge; }},
       {"lateral_stress", "Pa", "lateral stress outside the bag", [](P p) { return p.lateral; }},
       {"settlement", "1", "axial strain since compaction", [=](P p) { return p.settlement() - compacted; }},
       {"strain_axial", "1", "axial strain", [](P p) { return p.soil.strain_axial / 100; }},
       {"strain_radial", "1", "lateral strain", [](P p) { return p.soil.strain_radial / 100; }},
       {"strain_volumetric", "1", "volumetric strain", [](P p) { return p.soil.strain_volumetric / 100; }},
       {"strain_deviatoric", "1", "deviatoric strain", [](P p) { return p.soil.strain_deviatoric / 100; }},
       {"axial_stress", "Pa", "axial stress in the soil", [](P p) { return p.soil.axial_stress(); }},
       {"radial_stress", "Pa", "lateral stress in the soil", [](P p) { return p.soil.lateral_stress(); }},
       {"mean_stress", "Pa", "mean stress p in the soil", [](P p) { return p.soil.p; }},
       {"deviatoric_stress", "Pa", "deviatoric stress q in the soil", [](P p) { return p.soil.p * p.soil.obliquity; }},
       {"stress_obliquity", "1", "q/p", [](P p) { return p.soil.obliquity; }},
       {"failure_obliquity", "1", "q/p at failure at this p", [](P p) { return p.soil.failure_obliquity; }},
       {"stress_ratio", "1", "axial over lateral stress in the soil",
        [](P p) { return p.soil.axial_stress() / p.soil.lateral_stress(); }},
       {"stress_increment_ratio", "1", "axial over lateral stress increment",
        [](P p) { return p.soil.stress_increment_ratio(); }},
       {"dilation_rate", "1", "plastic volume increase over plastic deviatoric strain",
        [](P p) { return -p.soil.dilatancy; }},
       {"plastic_strain_ratio", "1", "lateral over axial plastic strain increment",
        [](P p) { return p.soil.plastic_ratio; }},
       {"hoop_strain", "1", "strain of the geotextile", [](P p) { return p.hoop_strain; }},
       {"hoop_tension", "N/m", "tension of the geotextile", [](P p) { return p.hoop_tension; }},
       {"tensile_stiffness", "N/m", "stiffness of the geotextile", stiffness},
       {"reinforcing_efficiency", "1/m", "surcharge over stiffness of the geotextile",
        [=](P p) { return p.surcharge / stiffness(p); }}});
}

io::Series readable(const std::vector<Point>& points) {
  using P = const Point&;
  const double compacted = points.empty() ? 0 : points.front().settlement();
  return table_of(points, {{"surcharge", "kPa", "", [](P p) { return p.surcharge / 1e3; }},
                           {"settlement", "%", "", [=](P p) { return 100 * (p.settlement() - compacted); }},
                           {"lateral", "%", "", [](P p) { return p.soil.strain_radial; }},
                           {"volumetric", "%", "", [](P p) { return p.soil.strain_volumetric; }},
                           {"deviatoric", "%", "", [](P p) { return p.soil.strain_deviatoric; }},
                           {"sigma_a", "kPa", "", [](P p) { return p.soil.axial_stress() / 1e3; }},
                           {"sigma_r", "kPa", "", [](P p) { return p.soil.lateral_stress() / 1e3; }},
                           {"p", "kPa", "", [](P p) { return p.soil.p / 1e3; }},
                           {"q/p", "1", "", [](P p) { return p.soil.obliquity; }},
                           {"M_f", "1", "", [](P p) { return p.soil.failure_obliquity; }},
                           {"dilation", "1", "", [](P p) { return -p.soil.dilatancy; }},
                           {"hoop", "%", "", [](P p) { return 100 * p.hoop_strain; }},
                           {"tension", "kN/m", "", [](P p) { return p.hoop_tension / 1e3; }}});
}

std::string heading(const Case& what, const std::string& soil) {
  const Geotextile& g = what.geotextile;
  return fmt::format(
      "Geotextile {}: stiffness {:.4g} kN/m{}, strength {:.4g} kN/m, strain at failure {:.4g} %\n"
      "Bag {:.4g} x {:.4g} x {:.4g} mm; soil {}, Young's modulus {:.4g} MPa with this geotextile\n",
      g.name, g.stiffness / 1e3,
      g.secant_at > 0 ? fmt::format(" (secant at the {:.4g} % it reaches)", 100 * g.secant_at) : "", g.strength / 1e3,
      100 * g.failure_strain, 1e3 * what.bag.width, 1e3 * what.bag.width, 1e3 * what.bag.height, soil,
      what.soil.young_modulus(g.stiffness) / 1e6);
}

std::string verdict(const Response& response, const Case& what) {
  const Point& last = response.last();
  const double settled = last.settlement() - response.start().settlement();
  std::string text = fmt::format("{} {:.1f} kPa at a settlement of {:.2f} % ({:.1f} mm): {}.\n",
                                 response.failed() ? "Ultimate bearing capacity" : "Ends at", last.surcharge / 1e3,
                                 100 * settled, 1e3 * what.bag.height * settled, reason(response.end()));
  if (response.start().settlement() > 0)
    text += fmt::format(
        "Compacted to {:.1f} kPa, which it took {:.2f} % of its height to reach; settlements count from there.\n",
        response.start().surcharge / 1e3, 100 * response.start().settlement());
  text += fmt::format("Reinforcing efficiency (surcharge over stiffness) {:.4g} 1/m.\n",
                      last.surcharge / what.geotextile.stiffness);
  return text;
}

void demand_reached(const Response& response, std::optional<double> surcharge) {
  if (surcharge && response.failed())
    throw TargetNotReached(fmt::format("{:.6g} kPa are not reached: the bag bears {:.6g} kPa: {}", *surcharge / 1e3,
                                       response.last().surcharge / 1e3, reason(response.end())));
}

std::string aligned(const io::Series& table, int digits) {
  std::vector<std::vector<std::string>> columns;
  for (const io::Column& column : table.columns) {
    std::vector<std::string> cells{column.name, column.unit == "1" ? "" : column.unit};
    double greatest = 0;
    bool whole = true;
    for (const double v : column.values) {
      if (std::isfinite(v)) greatest = std::max(greatest, std::abs(v));
      whole = whole && v == std::floor(v);
    }
    const int before = greatest >= 1 ? static_cast<int>(std::log10(greatest)) + 1 : 1;
    for (const double v : column.values)
      cells.push_back(fmt::format("{:.{}f}", v, whole ? 0 : std::clamp(digits - before, 0, 3)));
    columns.push_back(std::move(cells));
  }
  std::string text;
  for (std::size_t row = 0; row < table.rows() + 2; ++row) {
    std::string line;
    for (const auto& cells : columns) {
      std::size_t width = 0;
      for (const std::string& cell : cells) width = std::max(width, cell.size());
      line += fmt::format("{}{:>{}}", line.empty() ? "" : "  ", cells[row], width);
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace soilweave::gws
