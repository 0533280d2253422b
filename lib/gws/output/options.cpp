// The options that say which bag is meant.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/data.h"
#include "core/error.h"
#include "core/text/text.h"
#include "files/exchange/table.h"
#include "files/files.h"
#include "gws/identification/bag_runs.h"

namespace soilweave::gws {
namespace {

constexpr Parameter lateral_range{"lateral_stress",        "Pa", 0, 1e9, false, "lateral stress outside the bag",
                                  "no soil pulls on a bag"};

constexpr Parameter compacted_by{"initial_settlement",  "1", 0, 1, false, "compact the bag by this axial strain first",
                                 "at 1 the bag is flat"};
constexpr Parameter compacted_to{
    "initial_surcharge", "Pa", 0, 1e9, true, "compact the bag to this pressure first", "1 GPa is beyond any test"};

/// Returns a parameter under another name.
constexpr Parameter named(Parameter parameter, std::string_view name, std::string_view sentence) {
  parameter.name = name;
  parameter.sentence = sentence;
  return parameter;
}

/// Returns whether a path is a run, or the folder of an unfinished one. Standard input is not examined.
bool is_run(const std::filesystem::path& path) {
  if (path == "-") return false;
  const bool folder = std::filesystem::is_directory(path);
  if (!folder && !io::is_hdf5(path)) return false;
  const std::string kind = io::read_kind(path);
  return kind == "run" || kind == "checkpoint" || kind == "packing";
}

}  // namespace

void CaseOptions::declare(tool::Table& t) {
  t.option(geotextile, "geotextile", "NAME|FILE",
           "name in data/geotextiles, multiple (3PP), TOML file, or FILE.toml:NAME");
  t.option(stiffness, tensile_stiffness);
  t.option(strength, tensile_strength);
  t.option(failure_strain, failure_strain_range);
  t.option(fraction, named(strength_fraction_range, "strength_fraction",
                           "share of the strength at which the bag fails; else 0.5"));
  factors.declare(t);
  t.option(width, named(bag_extent, "width", "width of the bag, B"));
  t.option(height, named(bag_extent, "height", "height of the bag after compaction, H"));
  t.option(soil, "soil", "NAME|FILE", "constants: of data/soils, or a TOML; else toyoura-gws");
  t.option(assignments, "set", "KEY=VALUE",
           "replace a constant, as near_failure_line.kappa=1.4; the last for a key counts");
  t.option(lateral, lateral_range);
  t.option(history, "lateral-history", "FILE", "TSV with surcharge [Pa], lateral_stress [Pa]");
  t.option(initial_settlement, compacted_by);
  t.option(initial_surcharge, compacted_to);
  t.option(tolerance, tolerance_range);
}

std::vector<std::string> CaseOptions::mistakes(bool needs_geotextile) const {
  std::vector<std::string> wrong;
  if (needs_geotextile && geotextile.empty() && !(stiffness && (strength || failure_strain)))
    wrong.emplace_back("no geotextile: give --geotextile NAME, or --stiffness and one of --strength, --failure-strain");
  if (!needs_geotextile && geotextile.empty() && (stiffness ? !strength && !failure_strain : strength.has_value()))
    wrong.push_back(
        fmt::format("--{}: tells no kind of geotextile: give --stiffness and one of --strength, --failure-strain, of "
                    "which the ratio counts, or --failure-strain alone, or leave all out",
                    stiffness ? "stiffness" : "strength"));
  for (const auto& [name, value] : {std::pair{"stiffness", stiffness}, std::pair{"strength", strength}})
    if (const std::string mistake = unit_mistake(name, value.value_or(0)); !mistake.empty())
      wrong.push_back(fmt::format("--{}: {}", name, mistake));
  if (geotextile.empty() && stiffness && strength && failure_strain &&
      std::abs(*strength / (*stiffness * *failure_strain) - 1) > 0.5)
    wrong.push_back(fmt::format(
        "--stiffness, --strength and --failure-strain contradict each other: {:.4g} kN/m at {:.4g} % are {:.4g} kN/m; "
        "leave one of them out",
        *stiffness / 1e3, 100 * *failure_strain, *stiffness * *failure_strain / 1e3));
  doubt_pressure("lateral-stress", lateral, wrong);
  if (!history.empty() && lateral > 0) wrong.emplace_back("--lateral-stress and --lateral-history: give one of them");
  if (initial_settlement && initial_surcharge)
    wrong.emplace_back("--initial-settlement and --initial-surcharge: give one of them");
  return wrong;
}

Geotextile CaseOptions::read_geotextile() const {
  Geotextile found;
  if (!geotextile.empty()) found = find_geotextile(geotextile);
  if (stiffness) found.curve = {};
  if (strength || failure_strain) {
    if (found.curve.known())
      throw DataError(
          fmt::format("geotextile {}: its data sheet has strength and strain at failure: leave out "
                      "--strength and --failure-strain, or change the sheet",
                      found.name));
  }
  if (stiffness || strength || failure_strain) {
    found.stiffness = stiffness.value_or(found.stiffness);
    if (!geotextile.empty()) found.name += " (changed)";
    found.strength = strength                               ? *strength
                     : failure_strain && geotextile.empty() ? *failure_strain * found.stiffness
                                                            : found.strength;
    found.failure_strain = failure_strain       ? *failure_strain
                           : geotextile.empty() ? found.strength / found.stiffness
                                                : found.failure_strain;
  }
  if (found.name.empty()) found.name = "given by its numbers";
  return found;
}

LateralStress CaseOptions::read_lateral(std::vector<io::Source>& sources) const {
  if (history.empty()) return lateral > 0 ? LateralStress::constant(lateral) : LateralStress{};
  const io::TextFile text = io::read_text(history, "lateral history");
  sources.push_back(text.source);
  const io::Series table = io::from_tsv(text.text, history.string());
  const std::string where = history.string();
  if (table.rows() == 0) throw DataError(where + ": has no rows: give one at least, or leave out --lateral-history");
  for (const char* name : {"surcharge", "lateral_stress"}) io::demand_one(table, name, where);
  return {io::in_unit(table, "surcharge", "Pa", where), io::in_unit(table, "lateral_stress", "Pa", where),
          where + ": lateral stress"};
}

std::string ReadCase::soil_line() const {
  if (!chose_soil) return fmt::format("Soil {}, since no --soil is given\n", soil.name);
  if (!soil.estimated.empty()) return fmt::format("Soil {}: {}\n", soil.name, soil.estimated);
  return "";
}

std::vector<Doubt> ReadCase::doubts(const std::vector<double>& stiffnesses, const std::vector<Point>& states) const {
  std::vector<Doubt> all = gws::doubts(soil, chose_soil, the_case, stiffnesses, states);
  all.insert(all.end(), about_geotextile.begin(), about_geotextile.end());
  return all;
}

std::vector<Doubt> ReadCase::response_doubts(const std::vector<double>& stiffnesses,
                                             const std::vector<Point>& states) const {
  std::vector<Doubt> all = doubts(stiffnesses, states);
  if (factors.soil != 1)
    all.push_back({"weakened",
                   "--factor-soil counts against failure alone, but settlements here are those of the weakened soil, "
                   "which may be smaller than the soil's own: leave it out for settlements, or use design"});
  return all;
}

std::vector<Doubt> ReadCase::chart_doubts(const std::vector<ChartRow>& rows) const {
  std::vector<Doubt> all = doubts({rows.front().geotextile.stiffness, rows.back().geotextile.stiffness}, {});
  double first = std::numeric_limits<double>::infinity(), last = 0;
  for (const ChartRow& row : rows) first = std::fmin(first, row.begins), last = std::fmax(last, row.capacity);
  for (Doubt& doubt : beyond_history(the_case.lateral, first, last)) all.push_back(std::move(doubt));
  return all;
}

std::optional<double> ReadCase::asked(const std::optional<double>& surcharge) const {
  return surcharge ? std::optional<double>(*surcharge * factors.load) : std::nullopt;
}

std::string ReadCase::conditions(const Case& bag) const {
  Case original = bag;
  original.soil = soil.soil;
  return gws::conditions(original, factors, chose_fraction);
}

void doubt_pressure(const char* option, double pressure, std::vector<std::string>& wrong) {
  if (pressure > 0 && pressure < 1e3)
    wrong.push_back(fmt::format("--{}: {} Pa is less than a person standing on the bag; did you mean \"{} kPa\"?",
                                option, number_text(pressure), number_text(pressure)));
}

ReadCase CaseOptions::read() const {
  ReadCase read;
  Case& c = read.the_case;
  read.soil = find_soil(soil.empty() ? default_soil : soil, assignments, read.sources, read.scenario);
  c.soil = read.soil.soil;
  c.geotextile = read_geotextile();
  read.about_geotextile = contradictions(c.geotextile);
  c.bag = {width, height};
  c.lateral = read_lateral(read.sources);
  c.strength_fraction = fraction.value_or(c.strength_fraction);
  read.factors = factors;
  c.reduction = factors.reduction();
  read.chose_soil = !soil.empty();
  read.chose_fraction = fraction.has_value();
  c.tolerance = tolerance;
  c.initial_settlement = initial_settlement;
  c.initial_surcharge = initial_surcharge;
  c.lateral.check(c.bag);
  return read;
}

SoilFile find_soil(const std::string& name, const std::vector<std::string>& assignments,
                   std::vector<io::Source>& sources, std::string& resolved) {
  const bool file = name.find('/') != std::string::npos || name.ends_with(".toml");
  const std::vector<std::string> known = file ? std::vector<std::string>() : data_names("soils", ".toml");
  if (!file && std::find(known.begin(), known.end(), name) == known.end())
    throw DataError(
        fmt::format("soil {}: unknown; paths of TOML files are taken too{}", name, suggestion(name, known)));
  const std::filesystem::path path = file ? std::filesystem::path(name) : data_file("soils", name + ".toml");
  const io::TextFile text = io::read_text(path, "soil");
  sources.push_back(text.source);
  Settings document = Settings::parse(text.text, file ? name : "soil " + name);
  for (const std::string& assignment : assignments) document.set(assignment);
  SoilFile read = read_soil(document, {file ? name : path.string(), assignments});
  sources.insert(sources.end(), read.sources.begin(), read.sources.end());
  document.finish();
  const auto renames = [](const std::string& assignment) { return assignment.starts_with("name"); };
  if (!assignments.empty() && std::ranges::none_of(assignments, renames)) read.name += " (changed)";
  resolved = document.resolved();
  return read;
}

io::Series read_series(const std::filesystem::path& path, const std::string& group, std::vector<io::Source>& sources) {
  if (path != "-" && !io::is_hdf5(path)) {
    const io::TextFile text = io::read_text(path, "series");
    sources.push_back(text.source);
    return io::from_tsv(text.text, path.string());
  }
  const io::FieldsFile file = io::read_fields(path, "series");
  sources.push_back(file.source);
  std::string wanted = group;
  // `cell` comes last, since the periodic cell only surrounds a bag.
  for (const char* name : {"loading", "reinforced", "response", "cell"})
    if (wanted.empty() && std::ranges::any_of(file.groups, [&](const auto& one) { return one.name == name; }))
      wanted = name;
  std::vector<std::string> names;
  for (const auto& one : file.groups) {
    if (one.name == wanted) return one.table;
    names.push_back(one.name);
  }
  throw DataError(
      fmt::format("{}: has no table {}; choose --group from {}", path.string(), group, fmt::join(names, ", ")));
}

std::vector<BagSeries> read_bags(const std::vector<std::filesystem::path>& paths, const std::string& group,
                                 const std::vector<std::string>& geotextiles, bool natural,
                                 std::vector<io::Source>& sources) {
  std::vector<BagSeries> bags;
  bool grouped = false, converted = false;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::string where = paths[i].string();
    std::optional<Geotextile> given;
    if (!geotextiles.empty()) given = find_geotextile(geotextiles[i]);
    if (is_run(paths[i])) {
      const io::RunFile run = io::read_states(paths[i], "series");
      sources.push_back(run.source);
      bags.push_back(bag_of_run(run, where, given));
      continue;
    }
    const io::Series table = read_series(paths[i], group, sources);
    grouped = grouped || paths[i] == "-" || io::is_hdf5(paths[i]);
    converted = converted || !(is_loading(table) || is_reinforced(table));
    const double stiffness = given ? given->stiffness : 0;
    const Stiffness of_it{stiffness, given ? "of " + given->name : ""};
    bags.push_back(is_loading(table)      ? bag_of_loading(table, where, of_it)
                   : is_reinforced(table) ? bag_of_reinforced(table, where, of_it)
                                          : bag_series(table, where, stiffness, natural));
  }
  if (!group.empty() && !grouped)
    throw UsageError(fmt::format("--group {} has no effect: no series is a fields file: leave it out", group));
  if (natural && !converted)
    throw UsageError(
        "--strains natural has no effect: runs and their tables loading and reinforced tell their strains: leave it "
        "out");
  for (std::size_t i = 0; i < bags.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (bags[i].equal_rows(bags[k]))
        throw DataError(
            fmt::format("{} and {} hold equal rows: one bag counted twice would narrow the intervals; give it once",
                        bags[k].name, bags[i].name));
  return bags;
}

}  // namespace soilweave::gws
