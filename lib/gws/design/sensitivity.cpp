// Sensitivities and Monte Carlo bands.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/design/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>

#include "core/error.h"
#include "core/linear_algebra.h"
#include "gws/solution/secant.h"

namespace soilweave::gws {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Outcome {
  double capacity = none, settlement = none;
  double service_settlement = none, service_tension = none;  // at the surcharge asked for
};

Outcome outcome(const Case& bag, const std::optional<double>& surcharge) {
  try {
    const Answers answers(bag);
    const Response& response = answers.ultimate();
    Outcome found{response.last().surcharge, response.last().settlement() - response.start().settlement(), none, none};
    if (surcharge && answers.reaches(*surcharge)) {
      const Answers::Answer service = answers.under(*surcharge);
      found.service_settlement = service.settlement();
      found.service_tension = service.at.hoop_tension;
    }
    return found;
  } catch (const DataError&) {
    return {};
  }
}

/// A quantity that can be varied: its name, its unit, and its place in a case.
struct Handle {
  std::string key, unit;
  std::function<double&(Case&)> place;
};

std::vector<Handle> handles() {
  std::vector<Handle> all;
  for (const Constant& c : constants())
    all.push_back(
        {c.key(), std::string(c.parameter.unit), [field = c.field](Case& bag) -> double& { return bag.soil.*field; }});
  all.push_back({"geotextile.stiffness", "N/m", [](Case& bag) -> double& { return bag.geotextile.stiffness; }});
  all.push_back({"geotextile.strength", "N/m", [](Case& bag) -> double& { return bag.geotextile.strength; }});
  all.push_back({"strength_fraction", "1", [](Case& bag) -> double& { return bag.strength_fraction; }});
  all.push_back({"width", "m", [](Case& bag) -> double& { return bag.bag.width; }});
  all.push_back({"height", "m", [](Case& bag) -> double& { return bag.bag.height; }});
  return all;
}

double quantile(std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Band band(std::vector<double> values) {
  if (values.empty()) return {none, none, none};
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.025), quantile(values, 0.5), quantile(values, 0.975)};
}

/// Draws from the multivariate t distribution of one line's constants.
class Draw {
 public:
  explicit Draw(const Scatter& scatter) : scatter_(scatter) {
    const auto k = static_cast<Eigen::Index>(scatter.keys.size());
    const Cholesky root(Eigen::Map<const Eigen::MatrixXd>(scatter.correlation.data(), k, k));
    if (!root.positive())
      throw DataError("scatter of " + scatter.keys.front() + " and its like: the correlation is not positive definite");
    lower_ = root.lower();
  }
  void operator()(Soil& soil, std::mt19937_64& random) const {
    std::normal_distribution<double> normal;
    Eigen::VectorXd z(lower_.rows());
    for (double& value : z) value = normal(random);
    std::gamma_distribution<double> gamma(scatter_.freedom / 2, 2);  // chi square
    const Eigen::VectorXd t = lower_ * z * std::sqrt(scatter_.freedom / gamma(random));
    for (const Constant& c : constants())
      for (std::size_t i = 0; i < scatter_.keys.size(); ++i)
        if (scatter_.keys[i] == c.key()) soil.*c.field += scatter_.standard_errors[i] * t[static_cast<Eigen::Index>(i)];
  }

 private:
  const Scatter& scatter_;
  Eigen::MatrixXd lower_;
};

std::optional<Answers> answered(const Case& bag, Bands& bands) {
  for (const Constant& c : constants())
    if (!c.parameter.contains(bag.soil.*c.field)) {
      ++bands.left_out[c.key() + " out of its range"];
      return std::nullopt;
    }
  try {
    return Answers(bag);
  } catch (const DataError& error) {
    ++bands.left_out[error.what()];
    return std::nullopt;
  }
}

/// Returns the names of constants without their lines, with commas between them.
std::string names(const std::vector<std::string>& keys) {
  std::string all;
  for (const std::string& key : keys) all += (all.empty() ? "" : ", ") + key.substr(key.find('.') + 1);
  return all.empty() ? "none" : all;
}

BandRow row_of(const std::vector<Answers>& draws, double settlement) {
  BandRow row;
  row.settlement = settlement;
  std::vector<double> surcharge, axial, radial, hoop;
  for (const Answers& draw : draws) {
    const Response& response = draw.ultimate();
    if (response.start().settlement() + settlement > response.last().settlement()) continue;
    const Point at = draw.settled(settlement).at;
    surcharge.push_back(at.surcharge);
    axial.push_back(at.soil.axial_stress());
    radial.push_back(at.soil.lateral_stress());
    hoop.push_back(at.hoop_strain);
  }
  row.samples = surcharge.size();
  row.surcharge = band(surcharge);
  row.axial_stress = band(axial);
  row.radial_stress = band(radial);
  row.hoop_strain = band(hoop);
  return row;
}

}  // namespace

std::vector<Sensitivity> sensitivities(const Case& given, const SoilFile& soil, double share) {
  Case bag = given;
  bag.until.reset();
  std::vector<Sensitivity> found;
  for (const Handle& handle : handles()) {
    const auto varied = [&](double value) {
      Case other = bag;
      handle.place(other) = value;
      for (double& tension : other.geotextile.curve.tension)
        tension *= other.geotextile.stiffness / bag.geotextile.stiffness;
      return outcome(other, given.until);
    };
    Case copy = bag;
    Sensitivity s;
    s.key = handle.key, s.unit = handle.unit, s.value = handle.place(copy);
    std::size_t place = 0;
    const Scatter* scatter = scatter_of(soil, handle.key, place);
    s.interval = scatter != nullptr;
    const double reach = scatter ? scatter->quantile() * scatter->standard_errors[place] : share * std::abs(s.value);
    s.low = s.value - reach;
    s.high = s.value + reach;
    const double step = 1e-3 * std::max(std::abs(s.value), 1e-3);
    const Outcome below = varied(s.value - step), above = varied(s.value + step), low = varied(s.low),
                  high = varied(s.high);
    s.capacity_derivative = (above.capacity - below.capacity) / (2 * step);
    s.settlement_derivative = (above.settlement - below.settlement) / (2 * step);
    s.capacity_low = low.capacity;
    s.capacity_high = high.capacity;
    s.settlement_low = low.settlement;
    s.settlement_high = high.settlement;
    s.asked = given.until.has_value();
    s.service_settlement_derivative = (above.service_settlement - below.service_settlement) / (2 * step);
    s.service_tension_derivative = (above.service_tension - below.service_tension) / (2 * step);
    s.service_settlement_low = low.service_settlement;
    s.service_settlement_high = high.service_settlement;
    found.push_back(s);
  }
  return found;
}

Bands monte_carlo(const Case& given, const SoilFile& soil, std::int64_t samples, std::uint64_t seed, std::int64_t n) {
  Case bag = given;
  bag.until.reset();
  std::vector<Draw> draws;
  for (const Scatter& scatter : soil.scatter) draws.emplace_back(scatter);
  if (draws.empty())
    throw DataError("soil " + soil.name +
                    ": no constant has a scatter; identify them, or write [scatter.LINE] into the soil file");
  Bands bands;
  for (const Constant& c : constants()) {
    std::size_t place = 0;
    const Scatter* scatter = scatter_of(soil, c.key(), place);
    (scatter && scatter->standard_errors[place] > 0 ? bands.varied : bands.held).push_back(c.key());
  }
  const Answers all_as_given(bag);
  const Response& undisturbed = all_as_given.ultimate();
  std::mt19937_64 random(seed);
  std::vector<Answers> answers;
  for (std::int64_t k = 0; k < samples; ++k) {
    Case one = bag;
    for (const Draw& draw : draws) draw(one.soil, random);
    if (auto found = answered(one, bands)) answers.push_back(std::move(*found));
  }
  if (answers.empty()) throw DataError("no draw has a response; the first reason: " + bands.left_out.begin()->first);
  bands.samples = answers.size();
  std::vector<double> capacity, settlement;
  for (const Answers& draw : answers) {
    const Response& response = draw.ultimate();
    capacity.push_back(response.last().surcharge);
    settlement.push_back(response.last().settlement() - response.start().settlement());
  }
  bands.capacity = band(capacity);
  bands.settlement = band(settlement);
  const double reach = undisturbed.last().settlement() - undisturbed.start().settlement();
  for (std::int64_t i = 0; i <= n; ++i)
    bands.rows.push_back(row_of(answers, reach * static_cast<double>(i) / static_cast<double>(n)));
  return bands;
}

std::string variation(const Bands& bands) {
  const std::string held = bands.held.empty() ? "" : "; held, having none: " + names(bands.held);
  return fmt::format("varied by their scatter: {}{}", names(bands.varied), held);
}

}  // namespace soilweave::gws
