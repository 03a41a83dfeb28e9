// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace echomap::optimization {

/// The normal equations of weighted least squares over one block of `kSize` unknowns:
/// H = sum of J^T W J and g = sum of J^T W r for residuals r with Jacobians J and weights W
/// (Grisetti et al. 2010, equations 14 to 18). Everything stands on the stack.
template <int kSize>
class NormalEquations {
 public:
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Matrix = Eigen::Matrix<double, kSize, kSize>;

  /// Adds a residual of several numbers with its information matrix.
  template <int kRows>
  void add(const Eigen::Matrix<double, kRows, 1>& residual,
           const Eigen::Matrix<double, kRows, kSize>& jacobian,
           const Eigen::Matrix<double, kRows, kRows>& information) {
    const Eigen::Matrix<double, kSize, kRows> weighted = jacobian.transpose() * information;
    information_ += weighted * jacobian;
    gradient_ += weighted * residual;
  }

  /// Adds a residual of one number, weighted by the inverse of its variance.
  void add(double residual, const Eigen::Matrix<double, 1, kSize>& jacobian, double information) {
    const Vector weighted = information * jacobian.transpose();
    information_ += weighted * jacobian;
    gradient_ += residual * weighted;
  }

  /// Adds what is known of the unknowns themselves: they are `deviation` off their expected values.
  void add_prior(const Vector& deviation, const Matrix& information) {
    information_ += information;
    gradient_ += information * deviation;
  }

  /// Adds residuals that were summed elsewhere.
  void add(const NormalEquations& other, double weight) {
    information_ += weight * other.information_;
    gradient_ += weight * other.gradient_;
  }

  /// H: the inverse of the estimate's covariance.
  const Matrix& information() const { return information_; }
  /// g: half the derivative of the sum of squares.
  const Vector& gradient() const { return gradient_; }

  /// The step of Gauss and Newton, -H^-1 g; empty where it is not finite.
  std::optional<Vector> solve() const {
    const Vector step = -information_.ldlt().solve(gradient_);
    return step.allFinite() ? std::optional(step) : std::nullopt;
  }

 private:
  Matrix information_ = Matrix::Zero();
  Vector gradient_ = Vector::Zero();
};

}  // namespace echomap::optimization
