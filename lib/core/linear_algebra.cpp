// Eigensystems of tensors, and factors and products of matrices of any size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace soilweave {

Eigensystem<Mat3> eigensystem(const Mat3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
Eigensystem<Mat2> eigensystem(const Mat2& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat2> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
Eigensystem<Mat2> eigensystem_in_closed_form(const Mat2& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat2> solver;
  solver.computeDirect(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

Cholesky::Cholesky(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  lower_ = factor.matrixL();
  positive_ = factor.info() == Eigen::Success;
}

Eigen::VectorXd Cholesky::solve(Eigen::VectorXd right) const {
  lower_.triangularView<Eigen::Lower>().solveInPlace(right);
  lower_.transpose().triangularView<Eigen::Upper>().solveInPlace(right);
  return right;
}

Eigen::MatrixXd Cholesky::inverted() const {
  Eigen::MatrixXd found(lower_.rows(), lower_.cols());
  for (Eigen::Index k = 0; k < found.cols(); ++k) found.col(k) = solve(Eigen::VectorXd::Unit(found.rows(), k));
  return found;
}

Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a * b; }

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.transpose() * b; }

}  // namespace soilweave
