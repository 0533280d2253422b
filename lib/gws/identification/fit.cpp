// Least squares with intervals, by GSL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/fit.h"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/error.h"

namespace soilweave::gws {
namespace {

struct Problem {
  const std::vector<double>& observed;
  const std::function<void(const double*, double*)>& model;
};

/// GSL minimizes fitted - observed.
int deviations(const gsl_vector* parameters, void* problem, gsl_vector* result) {
  const auto& [observed, model] = *static_cast<Problem*>(problem);
  std::vector<double> fitted(observed.size());
  model(parameters->data, fitted.data());
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (!std::isfinite(fitted[i])) return GSL_EDOM;
    gsl_vector_set(result, i, fitted[i] - observed[i]);  // the result may be the column of a matrix
  }
  return GSL_SUCCESS;
}

using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;
using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;

/// Returns whether the angle between each column of the Jacobian and the span of the others exceeds rounding. The
/// variance times the column's squared norm is 1/sin^2 of that angle. GSL returns a variance of 0 for a dependent
/// column.
bool determines(const gsl_matrix* jacobian, const gsl_matrix* covariance) {
  for (std::size_t i = 0; i < jacobian->size2; ++i) {
    const gsl_vector_const_view column = gsl_matrix_const_column(jacobian, i);
    const double norm = gsl_blas_dnrm2(&column.vector), inflation = norm * norm * gsl_matrix_get(covariance, i, i);
    if (!(inflation > 0 && inflation * least_sine * least_sine < 1)) return false;
  }
  return true;
}

/// Returns estimates, errors and residuals from the solver's final state.
Fit evaluated(const Workspace& solver, const gsl_matrix* covariance, const std::vector<double>& observed) {
  const std::size_t n = solver->f->size, k = solver->x->size;
  const gsl_matrix* jacobian = gsl_multifit_nlinear_jac(solver.get());
  Fit found;
  found.freedom = static_cast<double>(n - k);
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) squares += solver->f->data[i] * solver->f->data[i];
  const double scatter = n > k ? std::sqrt(squares / found.freedom) : 0;
  const auto unscaled = [&](std::size_t i, std::size_t j) { return gsl_matrix_get(covariance, i, j); };
  for (std::size_t i = 0; i < k; ++i) {
    found.estimates.push_back(gsl_vector_get(solver->x, i));
    found.standard_errors.push_back(scatter * std::sqrt(unscaled(i, i)));
    for (std::size_t j = 0; j < k; ++j)
      found.correlation.push_back(unscaled(i, j) / std::sqrt(unscaled(i, i) * unscaled(j, j)));
  }
  for (std::size_t i = 0; i < n; ++i) {
    double leverage = 0;
    for (std::size_t a = 0; a < k; ++a)
      for (std::size_t b = 0; b < k; ++b)
        leverage += gsl_matrix_get(jacobian, i, a) * unscaled(a, b) * gsl_matrix_get(jacobian, i, b);
    const double residual = -solver->f->data[i], error = scatter * std::sqrt(std::max(0.0, 1 - leverage));
    found.residuals.push_back(residual);
    found.studentized.push_back(error > 0 ? residual / error : 0);
  }
  summarize(found, observed, k);
  return found;
}

}  // namespace

void summarize(Fit& fit, const std::vector<double>& observed, std::size_t constants) {
  const std::size_t n = observed.size();
  double squares = 0, mean = 0, total = 0, greatest = 0;
  for (const double r : fit.residuals) squares += r * r;
  fit.scatter = n > constants ? std::sqrt(squares / static_cast<double>(n - constants)) : 0;
  for (const double y : observed) {
    mean += y / static_cast<double>(n);
    greatest = std::max(greatest, std::abs(y));
  }
  const bool given = !fit.studentized.empty();
  for (std::size_t i = 0; i < n; ++i) {
    fit.fitted.push_back(observed[i] - fit.residuals[i]);
    if (!given) fit.studentized.push_back(fit.scatter > 0 ? fit.residuals[i] / fit.scatter : 0);
    if (std::abs(fit.residuals[i]) < data_accuracy * greatest) fit.studentized[i] = 0;
    total += (observed[i] - mean) * (observed[i] - mean);
  }
  fit.determination = total > 0 ? 1 - squares / total : 1;
}

double Fit::half_width(std::size_t i) const {
  if (!(freedom > 0)) return std::numeric_limits<double>::infinity();
  return standard_errors[i] * gsl_cdf_tdist_Pinv(0.975, freedom);
}

Fit fit(const std::string& what, const std::vector<double>& observed, const std::vector<double>& start,
        const std::function<void(const double*, double*)>& model) {
  const std::size_t n = observed.size(), k = start.size();
  if (n < k) throw DataError(fmt::format("{}: {} points for {} constants; give more", what, n, k));
  gsl_set_error_handler_off();  // failures come back as codes
  Problem problem{observed, model};
  gsl_multifit_nlinear_fdf functions{};
  functions.f = deviations;
  functions.n = n;
  functions.p = k;
  functions.params = &problem;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  settings.h_df = 1e-5;  // cube root of the rounding error: best for central differences
  const Workspace solver(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, k),
                         gsl_multifit_nlinear_free);
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), k);
  int reason = 0;
  const auto undetermined = [&](int status) {
    return DataError(
        fmt::format("{}: the points do not determine its {} constants ({}); give points over a wider range", what, k,
                    gsl_strerror(status)));
  };
  int status = gsl_multifit_nlinear_init(&first.vector, &functions, solver.get());
  if (status != GSL_SUCCESS) throw undetermined(status);
  status = gsl_multifit_nlinear_driver(1000, 1e-12, 1e-12, 0, nullptr, nullptr, &reason, solver.get());
  // A search that starts at its minimum makes no progress. GSL then returns GSL_EMAXITER, with GSL_ENOPROG as the
  // reason.
  if (status != GSL_SUCCESS && status != GSL_ENOPROG && reason != GSL_ENOPROG) throw undetermined(status);
  const gsl_matrix* jacobian = gsl_multifit_nlinear_jac(solver.get());
  const Matrix covariance(gsl_matrix_alloc(k, k), gsl_matrix_free);
  gsl_multifit_nlinear_covar(jacobian, 0, covariance.get());
  if (!determines(jacobian, covariance.get())) throw undetermined(GSL_ESING);
  return evaluated(solver, covariance.get(), observed);
}

}  // namespace soilweave::gws
