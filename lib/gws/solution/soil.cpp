// The constants of the wrapped soil.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/soil.h"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/text.h"
#include "gws/solution/estimate.h"

namespace soilweave::gws {
namespace {

constexpr std::array table{
    Constant{"compression_line",
             {"C_t", "1", 0, 1e3, true, "compression index, strain in percent", "soil contracts under pressure"},
             &Soil::C_t},
    Constant{"compression_line",
             {"m", "1", 0, 2, true, "exponent of the mean stress", "soil stiffens with pressure"},
             &Soil::m},
    Constant{"compression_line", {"p_a", "Pa", 0, 1e9, true, "pressure of reference", "a pressure"}, &Soil::p_a},
    Constant{"compression_line",
             {"p_0", "Pa", 0, 1e9, true, "mean stress where strains begin", "the model has no unstressed state"},
             &Soil::p_0},
    Constant{"failure_line",
             {"M", "1", 0, 3, true, "q/p at failure at p_c", "q/p = 3 is a lateral stress of zero"},
             &Soil::M},
    Constant{
        "failure_line",
        {"n", "1", 0, 1, false, "decrease of q/p at failure with pressure", "a failure line straight or bent down"},
        &Soil::n},
    Constant{"failure_line",
             {"p_c", "Pa", 0, 1e12, true, "mean stress where q/p at failure is M", "a pressure"},
             &Soil::p_c},
    Constant{"near_failure_line",
             {"kappa", "1", 0, 1e3, false, "numerator of the hyperbola, strain in percent",
              "below 0 the soil begins beyond failure"},
             &Soil::kappa},
    Constant{"near_failure_line",
             {"lambda", "1", 0, 1e3, true, "strain added, percent", "at lambda = 0 the line begins at infinity"},
             &Soil::lambda},
    Constant{"near_failure_line",
             {"xi", "1", -1, 1, false, "distance beyond the failure line at which the hyperbola ends",
              "a distance between values of q/p"},
             &Soil::xi},
    Constant{"dilatancy_line",
             {"p_1", "1", 0, 1e3, false, "slope of the stress-dilatancy line",
              "soil contracts more the farther it is from failure"},
             &Soil::p_1},
    Constant{"dilatancy_line",
             {"p_2", "1", -10, 10, false, "intercept of the stress-dilatancy line", "a dilation rate"},
             &Soil::p_2},
    Constant{"stiffness",
             {"alpha", "Pa", 0, 1e15, true, "Young's modulus with a geotextile of 1 MN/m",
              "without stiffness strains have no bound"},
             &Soil::alpha},
    Constant{"stiffness",
             {"beta", "1", 0, 2, false, "exponent of the geotextile's stiffness",
              "a stiffer geotextile makes a stiffer bag"},
             &Soil::beta},
    Constant{"stiffness",
             {"poisson_ratio", "1", -1, 0.5, true, "Poisson's ratio of the wrapped soil",
              "at 0.5 the soil is incompressible, below -1 it is unstable"},
             &Soil::poisson_ratio},
};

/// Reads [scatter.LINE]: a standard error for each constant that has one, their correlation, degrees of freedom.
Scatter read_scatter(Settings& at, const std::string& line) {
  static constexpr Parameter correlation{"correlation", "1", -1, 1, false, "correlation matrix, row by row"},
      freedom{"freedom", "1", 0, 1e12, true, "degrees of freedom"};
  Scatter scatter;
  for (const Constant& c : table)
    if (c.line == line) {
      if (const std::string name(c.parameter.name); at.has(name)) {
        scatter.keys.push_back(c.key());
        scatter.standard_errors.push_back(
            at.number({c.parameter.name, c.parameter.unit, 0, 1e15, false, "standard error"}));
      }
    }
  scatter.freedom = at.number(freedom, 1e9);
  const std::size_t size = scatter.keys.size();
  std::vector<double> independent(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) independent[i * size + i] = 1;
  scatter.correlation = at.numbers(correlation, independent);
  if (scatter.correlation.size() != size * size)
    at.mistake("correlation",
               fmt::format("has {} numbers; the {} constants need {}", scatter.correlation.size(), size, size * size));
  return scatter;
}

constexpr std::string_view exact_text =
    "# Fitted to as many points as constants: the scatter from point to point is unknown.\nexact = true\n";

std::string line_of(const Scatter& s) { return s.keys.front().substr(0, s.keys.front().find('.')); }

/// Returns the table [scatter.LINE] as TOML.
std::string scatter_text(const Scatter& s) {
  const std::string line = line_of(s);
  std::string text = fmt::format("\n# Standard errors and their correlation.\n[scatter.{}]\n", line), numbers;
  for (std::size_t i = 0; i < s.keys.size(); ++i)
    text += fmt::format("{} = {}\n", s.keys[i].substr(line.size() + 1), number_text(s.standard_errors[i]));
  for (const double r : s.correlation) numbers += (numbers.empty() ? "" : ", ") + number_text(r);
  return text + fmt::format("correlation = [{}]\nfreedom = {}\n", numbers, number_text(s.freedom));
}

struct Extent {
  Parameter parameter;
  Span Identified::*field;
};
constexpr std::array extents{
    Extent{{"stiffness", "N/m", 0, 1e12, false, "least and greatest stiffness of the geotextiles"},
           &Identified::stiffness},
    Extent{{"mean_stress", "Pa", 0, 1e12, false, "least and greatest mean stress of the soil"},
           &Identified::mean_stress},
    Extent{{"axial_strain", "1", 0, 1, false, "least and greatest axial strain"}, &Identified::axial_strain},
};

Identified read_identified(Settings table) {
  Identified identified;
  for (const Extent& e : extents) {
    if (!table.has(e.parameter.name)) continue;
    const std::vector<double> ends = table.numbers(e.parameter);
    if (ends.size() != 2 || ends[0] > ends[1])
      table.mistake(e.parameter.name, "is no range: give the least and the greatest value");
    else
      identified.*e.field = {ends[0], ends[1]};
  }
  return identified;
}

}  // namespace

void Span::add(double value) {
  *this = known() ? Span{std::min(low, value), std::max(high, value)} : Span{value, value};
}

double Soil::young_modulus(double J) const { return alpha * std::pow(J / 1e6, beta); }

std::string Constant::key() const { return fmt::format("{}.{}", line, parameter.name); }

std::span<const Constant> constants() { return table; }

double Scatter::quantile() const { return gsl_cdf_tdist_Pinv(0.975, freedom); }

SoilFile read_soil(Settings& document, const NamedFiles& files) {
  SoilFile file;
  file.name = document.text("name", "soil");
  std::vector<std::string> lines;
  const bool is_estimate = document.has("estimate");
  if (is_estimate) {
    Settings at = document.table("estimate");
    const Triaxial test = read_estimate(at, files, file.sources);
    if (!document.table("failure_line").has("p_c")) judge_dilation(at, test);
    file.soil = estimated(test);
    file.estimated = marked(test);
    file.doubts = test.doubts;
  }
  for (const Constant& c : table) {
    Settings at = document.table(c.line);
    double& field = file.soil.*c.field;
    field = is_estimate ? at.number(c.parameter, field) : at.number(c.parameter);
    if (lines.empty() || lines.back() != c.line) lines.emplace_back(c.line);
  }
  Settings scatters = document.table("scatter");
  for (const std::string& line : lines) {
    if (!scatters.has(line)) continue;
    Settings at = scatters.table(line);
    if (at.flag({"exact", "whether the line was fitted to as many points as it has constants"}, false))
      file.exact.push_back(line);
    if (Scatter scatter = read_scatter(at, line); !scatter.keys.empty()) file.scatter.push_back(std::move(scatter));
  }
  file.identified = read_identified(document.table("identified"));
  return file;
}

std::string soil_text(const SoilFile& file, std::string_view comment) {
  std::string text;
  for (const std::string& line : lines_of(comment)) text += "# " + line + "\n";
  text += fmt::format("name = \"{}\"\n", file.name);
  std::string_view line;
  for (const Constant& c : table) {
    if (c.line != line) text += fmt::format("\n[{}]\n", c.line);
    line = c.line;
    text += fmt::format("{} = {}\n", c.parameter.name, number_text(file.soil.*c.field));
  }
  bool headed = false;
  for (const Extent& e : extents) {
    const Span& span = file.identified.*e.field;
    if (!span.known()) continue;
    if (!headed) text += "\n# Range of the series that the constants were identified on.\n[identified]\n";
    headed = true;
    text += fmt::format("{} = [{}, {}]\n", e.parameter.name, number_text(span.low), number_text(span.high));
  }
  std::vector<std::string> scattered;
  for (const Scatter& s : file.scatter) {
    if (s.keys.empty()) continue;
    text += scatter_text(s);
    scattered.push_back(line_of(s));
    if (std::ranges::find(file.exact, scattered.back()) != file.exact.end()) text += exact_text;
  }
  for (const std::string& exact : file.exact)
    if (std::ranges::find(scattered, exact) == scattered.end())
      text += fmt::format("\n[scatter.{}]\n{}", exact, exact_text);
  return text;
}

const Scatter* scatter_of(const SoilFile& file, std::string_view key, std::size_t& place) {
  for (const Scatter& s : file.scatter)
    for (std::size_t i = 0; i < s.keys.size(); ++i)
      if (s.keys[i] == key) {
        place = i;
        return &s;
      }
  return nullptr;
}

}  // namespace soilweave::gws
