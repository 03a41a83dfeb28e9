// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_alignment.hpp"

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;
using Row = Eigen::RowVector3d;

double square(double value) { return value * value; }

/// The normal equations over the free poses and the calibration. Blocks of what is fixed are left
/// out.
class NormalEquations {
 public:
  NormalEquations(std::size_t multiscans, std::size_t first_free)
      : first_free_(static_cast<Eigen::Index>(first_free)),
        calibration_row_(3 * (static_cast<Eigen::Index>(multiscans) - first_free_)),
        gradient_(Eigen::VectorXd::Zero(calibration_row_ + 3)) {}

  /// Negative for one that is fixed.
  Eigen::Index row_of(std::size_t multiscan) const {
    return 3 * (static_cast<Eigen::Index>(multiscan) - first_free_);
  }
  Eigen::Index calibration_row() const { return calibration_row_; }

  void add_information(Eigen::Index row, Eigen::Index column, const Eigen::Matrix3d& block) {
    if (row < 0 || column < 0) {
      return;
    }
    if (row < column) {
      add_information(column, row, block.transpose());
      return;
    }
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        entries_.emplace_back(row + i, column + k, block(i, k));
      }
    }
  }

  void add_gradient(Eigen::Index row, const Eigen::Vector3d& gradient) {
    if (row >= 0) {
      gradient_.segment<3>(row) += gradient;
    }
  }

  /// Of a measurement that is off by so many squared deviations, its weight known beforehand.
  void add_surprise(double surprise) { surprise_ += surprise; }

  /// The change of everything; none, and endless surprise, where it cannot be told.
  Eigen::VectorXd solve(AlignmentStep& step) const {
    Eigen::SparseMatrix<double> information(gradient_.size(), gradient_.size());
    information.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(information);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(gradient_.size(), 4);
    right.col(0) = -gradient_;
    right.block<3, 3>(calibration_row_ - 3, 1).setIdentity();
    if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 0.0) {
      step.surprise = std::numeric_limits<double>::infinity();
      return Eigen::VectorXd::Zero(gradient_.size());
    }
    const Eigen::MatrixXd solved = factors.solve(right);
    step.last_covariance = solved.block<3, 3>(calibration_row_ - 3, 1);
    step.surprise = surprise_ + factors.vectorD().array().log().sum();
    return solved.col(0);
  }

 private:
  Eigen::Index first_free_;
  Eigen::Index calibration_row_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_;
  double surprise_ = 0.0;
};

/// What is left of the way between two poses after what odometry says of it, and how that changes
/// with the pose before, the one after and the calibration.
struct PieceResidual {
  Eigen::Vector3d value;
  Eigen::Matrix3d by_before;
  Eigen::Matrix3d by_after;
  Eigen::Matrix3d by_calibration;
};

PieceResidual piece_residual(const Pose2& T_map_before,
                             const Pose2& T_map_after,
                             const OdometryPiece& piece,
                             const OdometryCalibration& calibration) {
  const Pose2 driven = calibrated(piece, calibration);
  const Pose2 T_before_after = T_map_before.inverse() * T_map_after;
  const Eigen::Matrix2d to_before =
      Eigen::Rotation2Dd(-T_map_before.heading_rad()).toRotationMatrix();
  const Eigen::Vector2d way_m = T_before_after.position_m();
  PieceResidual residual;
  residual.value << way_m - driven.position_m(),
      geometry::angle_between(driven.heading_rad(), T_before_after.heading_rad());
  residual.by_before.setZero();
  residual.by_before.topLeftCorner<2, 2>() = -to_before;
  residual.by_before.col(2) << way_m.y(), -way_m.x(), -1.0;
  residual.by_after.setIdentity();
  residual.by_after.topLeftCorner<2, 2>() = to_before;
  residual.by_calibration = -calibrated_by_calibration(piece, calibration);
  return residual;
}

void add_piece(const MultiscanGraph& graph,
               std::size_t before,
               const OdometryNoise& noise,
               NormalEquations& equations) {
  const OdometryPiece& piece = graph.pieces[before];
  const PieceResidual residual = piece_residual(graph.multiscans[before].T_map_begin,
                                                graph.multiscans[before + 1].T_map_begin,
                                                piece,
                                                graph.calibration);
  const Eigen::Vector3d piece_variances = square(graph.odometry_scale) * variances(piece, noise);
  const Eigen::Matrix3d weights = piece_variances.cwiseInverse().asDiagonal();
  equations.add_surprise(residual.value.dot(weights * residual.value) +
                         piece_variances.array().log().sum());
  const struct {
    Eigen::Index row;
    const Eigen::Matrix3d& by;
  } parts[] = {{equations.row_of(before), residual.by_before},
               {equations.row_of(before + 1), residual.by_after},
               {equations.calibration_row(), residual.by_calibration}};
  for (std::size_t i = 0; i < std::size(parts); ++i) {
    const Eigen::Matrix3d weighted = parts[i].by.transpose() * weights;
    equations.add_gradient(parts[i].row, weighted * residual.value);
    for (std::size_t k = 0; k <= i; ++k) {
      equations.add_information(parts[i].row, parts[k].row, weighted * parts[k].by);
    }
  }
}

/// How far a patch lies across another one, and how that changes with where the two multiscans are.
struct MatchResidual {
  double value_m;
  double along_m;
  Row by_later;
  Row by_earlier;
};

MatchResidual match_residual(const Pose2& T_map_later,
                             const SurfacePatch& later,
                             const Pose2& T_map_earlier,
                             const SurfacePatch& earlier) {
  const Eigen::Vector2d normal =
      geometry::unit_vector(T_map_earlier.heading_rad() + earlier.normal_rad);
  const Eigen::Vector2d left(-normal.y(), normal.x());
  const Eigen::Vector2d point_m = T_map_later * later.point_m;
  const Eigen::Vector2d apart_m = point_m - T_map_earlier * earlier.point_m;
  // Turning the earlier multiscan turns its normal as well as its point.
  return {normal.dot(apart_m),
          left.dot(apart_m),
          {normal.x(), normal.y(), -left.dot(point_m - T_map_later.position_m())},
          {-normal.x(), -normal.y(), left.dot(point_m - T_map_earlier.position_m())}};
}

void add_match(const PatchMatch& match, const PatchFactor& factor, NormalEquations& equations) {
  equations.add_surprise(-factor.information_per_m2 * square(factor.most_apart_m) *
                         std::sqrt(factor.trust));
  const double weight = factor.information_per_m2 * factor.trust;
  const Eigen::Index row_later = equations.row_of(match.later.multiscan);
  const Eigen::Index row_earlier = equations.row_of(match.earlier.multiscan);
  equations.add_information(
      row_later, row_later, weight * factor.by_later.transpose() * factor.by_later);
  equations.add_information(
      row_earlier, row_earlier, weight * factor.by_earlier.transpose() * factor.by_earlier);
  equations.add_information(
      row_later, row_earlier, weight * factor.by_later.transpose() * factor.by_earlier);
  equations.add_gradient(row_later, weight * factor.across_m * factor.by_later.transpose());
  equations.add_gradient(row_earlier, weight * factor.across_m * factor.by_earlier.transpose());
}

/// What is known of the calibration beforehand; nothing of it may change where it is not sought.
void add_calibration(const MultiscanGraph& graph,
                     bool is_sought,
                     const MultiscanAlignmentParams& params,
                     NormalEquations& equations) {
  if (!is_sought) {
    constexpr double kFixed = 1e12;
    equations.add_information(equations.calibration_row(),
                              equations.calibration_row(),
                              kFixed * Eigen::Matrix3d::Identity());
    return;
  }
  const Eigen::Vector3d sd(params.turn_share_sd, params.drift_sd_rad_per_m, params.drive_share_sd);
  const Eigen::Vector3d information = (graph.steady_scale * sd).cwiseAbs2().cwiseInverse();
  const Eigen::Vector3d gradient = information.cwiseProduct(graph.calibration.values);
  equations.add_surprise(graph.calibration.values.dot(gradient) - information.array().log().sum());
  equations.add_information(equations.calibration_row(),
                            equations.calibration_row(),
                            information.asDiagonal().toDenseMatrix());
  equations.add_gradient(equations.calibration_row(), gradient);
}

Pose2 moved(const Pose2& pose, const Eigen::Vector3d& change) {
  return {pose.x_m() + change[0], pose.y_m() + change[1], pose.heading_rad() + change[2]};
}

}  // namespace

void check(const MultiscanAlignmentParams& params) {
  const bool calibration_ok =
      params.turn_share_sd > 0.0 && params.drift_sd_rad_per_m > 0.0 && params.drive_share_sd > 0.0;
  const bool patches_ok = params.patch_sd_m > 0.0 && params.normal_sd_rad >= 0.0 &&
                          params.most_apart_m > 0.0 && params.match_weight > 0.0;
  if (!params.odometry.is_sound() || !calibration_ok || !patches_ok) {
    throw std::invalid_argument("multiscan alignment: a parameter is outside of its range");
  }
}

PatchFactor patch_factor(const MultiscanGraph& graph,
                         const PatchMatch& match,
                         std::size_t first_wide,
                         const MultiscanAlignmentParams& params) {
  const PlacedPatches& from = graph.multiscans[match.later.multiscan];
  const PlacedPatches& to = graph.multiscans[match.earlier.multiscan];
  const SurfacePatch& later = from.patches[match.later.patch];
  const SurfacePatch& earlier = to.patches[match.earlier.patch];
  const MatchResidual residual = match_residual(from.T_map_begin, later, to.T_map_begin, earlier);
  const double variance_m2 =
      square(params.patch_sd_m) + square(later.offset_sd_m) + square(earlier.offset_sd_m) +
      (square(params.normal_sd_rad) + square(earlier.normal_sd_rad)) * square(residual.along_m);
  const double place_sd_m = match.later.multiscan >= first_wide ? match.place_sd_m : 0.0;
  const double most_apart_m = std::hypot(params.most_apart_m, place_sd_m);
  return {residual.value_m,
          residual.by_later,
          residual.by_earlier,
          params.match_weight / variance_m2,
          most_apart_m,
          1.0 / square(1.0 + square(residual.value_m / most_apart_m))};
}

AlignmentStep align_multiscans(MultiscanGraph& graph,
                               const std::vector<PatchMatch>& matches,
                               std::size_t first_free,
                               std::size_t first_wide,
                               const MultiscanAlignmentParams& params) {
  const bool is_whole = first_free <= 1;
  NormalEquations equations(graph.multiscans.size(), first_free);
  add_calibration(graph, is_whole, params, equations);
  for (std::size_t i = first_free - 1; i + 1 < graph.multiscans.size(); ++i) {
    add_piece(graph, i, params.odometry, equations);
  }
  for (const PatchMatch& match : matches) {
    add_match(match, patch_factor(graph, match, first_wide, params), equations);
  }
  AlignmentStep step{graph.multiscans.back().covariance};
  const Eigen::VectorXd change = equations.solve(step);
  for (std::size_t i = first_free; i < graph.multiscans.size(); ++i) {
    Pose2& pose = graph.multiscans[i].T_map_begin;
    pose = moved(pose, change.segment<3>(equations.row_of(i)));
  }
  if (is_whole) {
    graph.calibration.values += change.tail<3>();
  }
  return step;
}

}  // namespace echomap::slam
