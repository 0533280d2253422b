// Stations of a run at which nothing bears.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/idle_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/text.h"

namespace soilweave::analysis {
namespace {

constexpr std::string_view follows = "a lower rate, or rest_drag = \"critical\", lets the grains follow the plane";

// Returns the rows of a stage, one for each station that was reached. Row 0 is the packing before its first stage.
std::vector<std::size_t> rows_of(const io::Series& series, std::size_t stage) {
  const std::vector<double>& stages = series.at("stage").values;
  std::vector<std::size_t> rows;
  for (std::size_t row = 1; row < stages.size(); ++row)
    if (stages[row] == static_cast<double>(stage)) rows.push_back(row);
  return rows;
}

// Returns whether a plane bears no force in a row.
bool is_idle(const io::Series& series, const std::string& plane, std::size_t row) {
  return std::ranges::all_of(std::string_view("xyz"), [&](char axis) {
    const io::Column* force = series.find(fmt::format("force_{}_{}", plane, axis));
    return force && force->values[row] == 0;
  });
}

// Returns how far a plane has moved towards the grains in a row, m.
double pushed(const io::Series& series, const dem::RigPart& part, const Vec3& normal, std::size_t row) {
  double way = 0;
  for (int a = 0; a < 3; ++a)
    if (const io::Column* moved = series.find(fmt::format("displacement_{}_{}", part.name, "xyz"[a])))
      way += moved->values[row] * normal[a];
  return way;
}

bool displaces(const dem::Stage& stage, const dem::RigPart& part) {
  return std::ranges::any_of(stage.path->drives(0), [&](const dem::DriveGoal& goal) {
    return goal.part == part.name && goal.kind == dem::DriveGoal::Kind::displacement;
  });
}

std::optional<Doubt> idle_plate(const dem::Scenario& scenario, const io::Series& series, std::size_t s,
                                const dem::RigPart& part) {
  const std::vector<std::size_t> rows = rows_of(series, s);
  if (rows.empty() || !displaces(scenario.stages[s], part)) return std::nullopt;
  const Vec3 normal = scenario.planes.normal[part.number].normalized();
  bool bore = false;
  // A plate that returns to where it was may miss grains that have settled.
  double farthest = 0, at_first = 0;
  std::size_t idle = 0, first = 0;
  for (std::size_t row = 0; row <= rows.back(); ++row) {
    const double way = pushed(series, part, normal, row);
    const bool is_new = row >= rows.front() && way > farthest;
    farthest = std::max(farthest, way);
    if (!is_idle(series, part.name, row))
      bore = true;
    else if (is_new && (bore || row == rows.back()) && idle++ == 0)
      first = row, at_first = way;
  }
  if (idle == 0) return std::nullopt;
  return Doubt{
      "idle-plate",
      fmt::format("stage \"{}\" has pushed the plane \"{}\" {:.3g} m towards the grains at station {}, and nothing "
                  "presses against it ({}): {}",
                  scenario.stages[s].name, part.name, at_first, first - rows.front() + 1,
                  bore ? fmt::format("{} of {} stations", idle, rows.size()) : "nor did anything before",
                  bore ? follows : "bring it to the grains by a load first ([[stage.load]]), or push it further")};
}

// Greatest strain of the wave that leaves a clamp, over the strain at which the yarns' curve first bends. Clamps of
// 0.01, 0.03, 0.1 and 0.3 m/s reach 0.06, 0.18, 0.6 and 1.8 in the strip of chapter 3 (PE, 100 mm long). At 2 mm its
// force is then 0.6, 2.6, 11 and 26 % below that at 1 mm/s.
constexpr double largest_wave = 0.1;

// Returns the speed of waves along the yarns of a geotextile, m/s; 0 if it has none.
double wave_speed(const io::Snapshot& state, const dem::WireCurve& curve, std::int32_t geotextile) {
  double mass = 0, length = 0;
  for (std::size_t k = 0; k < state.yarns.size(); ++k) {
    if (state.yarns.geotextile_id[k] != geotextile) continue;
    for (const std::int32_t node : state.yarns.nodes[k])
      mass += 0.5 * state.grains.mass[static_cast<std::size_t>(node)];
    length += state.yarns.rest_length[k];
  }
  return length > 0 ? std::sqrt(curve.tension.front() / curve.strain.front() * length / mass) : 0;
}

// Returns the greatest speed at which a stage displaces a clamp, m/s.
double clamp_speed(const dem::Scenario& scenario, const dem::Stage& stage) {
  double speed = 0;
  for (const dem::RigPart& part : dem::parts_of(scenario))
    for (const dem::DriveGoal& goal : stage.path->drives(0))
      if (part.is_clamp && goal.part == part.name && goal.kind == dem::DriveGoal::Kind::displacement)
        speed = std::max(speed, goal.speed);
  return speed;
}

}  // namespace

std::vector<Doubt> clamp_doubts(const dem::Scenario& scenario, const io::Snapshot& start) {
  for (const dem::Stage& stage : scenario.stages) {
    const double speed = stage.way_unbalanced_force > 0 ? 0 : clamp_speed(scenario, stage);
    for (std::size_t g = 0; g < scenario.model.geotextiles.size(); ++g) {
      const dem::WireCurve& curve = scenario.model.geotextiles[g];
      const double wave = wave_speed(start, curve, static_cast<std::int32_t>(g));
      const double slow = largest_wave * curve.strain.front() * wave;
      if (!(wave > 0) || !(speed > slow)) continue;
      return {{"clamp-speed",
               fmt::format(
                   "stage \"{}\" moves a clamp at {:.3g} m/s, and the wave that leaves it strains yarns by {:.2g} %, "
                   "where their curve bends at {:.2g} %: forces depend on the speed; {:.2g} m/s is slow enough",
                   stage.name, speed, 100 * speed / wave, 100 * curve.strain.front(), rounded_down(slow))}};
    }
  }
  return {};
}

std::vector<Doubt> idle_plate_doubts(const dem::Scenario& scenario, const io::Series& series) {
  for (std::size_t s = 0; s < scenario.stages.size(); ++s)
    for (const dem::RigPart& part : dem::parts_of(scenario)) {
      if (part.is_clamp) continue;
      if (std::optional<Doubt> doubt = idle_plate(scenario, series, s, part)) return {*std::move(doubt)};
    }
  return {};
}

std::vector<Doubt> no_contact_doubts(const dem::Scenario& scenario, const io::Series& series) {
  const std::vector<double>& contacts = series.at("coordination_number").values;
  bool touched = !contacts.empty() && contacts[0] > 0;
  for (std::size_t s = 0; s < scenario.stages.size(); ++s) {
    const std::vector<std::size_t> rows = rows_of(series, s);
    std::size_t apart = 0, first = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (contacts[rows[k]] > 0)
        touched = true;
      else if (touched && apart++ == 0)
        first = k;
    }
    if (apart == 0) continue;
    return {
        {"no-contact",
         fmt::format(
             "stage \"{}\": at {} of {} stations, first at number {}, no grains touch, so that "
             "stresses are zero: either the loading threw the grains apart, or they liquefy; a lower rate shows which",
             scenario.stages[s].name, apart, rows.size(), first + 1)}};
  }
  return {};
}

}  // namespace soilweave::analysis
