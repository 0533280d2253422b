// Eigensystems of tensors, and factors and products of matrices of any size.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eigen's templates would be compiled in every source that uses them, which takes seconds per source. These functions
// are compiled once. Sums and products of small tensors use Eigen directly.
#pragma once

#include <Eigen/Core>

#include "core/tensor.h"

namespace soilweave {

/// Eigenvalues of a symmetric tensor in ascending order, and unit eigenvectors as columns in their order. The sign of
/// an eigenvector is arbitrary.
template <class Tensor>
struct Eigensystem {
  Eigen::Vector<double, Tensor::RowsAtCompileTime> values;
  Tensor vectors;
};
Eigensystem<Mat3> eigensystem(const Mat3& symmetric);
Eigensystem<Mat2> eigensystem(const Mat2& symmetric);
/// Returns the eigensystem in closed form, which is faster and less exact for nearly equal eigenvalues.
Eigensystem<Mat2> eigensystem_in_closed_form(const Mat2& symmetric);
/// Returns the largest eigenvalue of a symmetric matrix.
double largest_eigenvalue(const Eigen::MatrixXd& symmetric);

/// Cholesky factor L of a symmetric matrix L L^T.
class Cholesky {
 public:
  explicit Cholesky(const Eigen::MatrixXd& matrix);
  /// Returns whether the matrix is positive definite. If it is not, the other results are meaningless.
  bool positive() const { return positive_; }
  /// Returns L, with zeros above its diagonal.
  const Eigen::MatrixXd& lower() const { return lower_; }
  /// Returns the solution x of (L L^T) x = right.
  Eigen::VectorXd solve(Eigen::VectorXd right) const;
  /// Returns (L L^T)^-1.
  Eigen::MatrixXd inverted() const;

 private:
  Eigen::MatrixXd lower_;
  bool positive_;
};

/// Returns a solution x of matrix x = right, for a symmetric matrix that is positive semidefinite.
Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Returns a b.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Returns a^T b.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace soilweave
