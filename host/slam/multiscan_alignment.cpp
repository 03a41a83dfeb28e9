// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_alignment.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/block_equations.hpp"
#include "host/optimization/robust_kernel.hpp"
#include "host/slam/pose_graph.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;
using geometry::square;
using Row = Eigen::RowVector3d;

/// The poses of the multiscans, those before `first_free` fixed, with the calibration behind them.
optimization::BlockEquations equations_over(std::size_t multiscans,
                                            std::size_t first_free,
                                            bool is_calibration_free) {
  optimization::BlockEquations equations;
  for (std::size_t i = 0; i < multiscans; ++i) {
    i < first_free ? equations.add_fixed_block() : equations.add_block(3);
  }
  is_calibration_free ? equations.add_block(3) : equations.add_fixed_block();
  return equations;
}

/// Answers its part of the negative log evidence, doubled, as the next two do.
double add_piece(const MultiscanGraph& graph,
                 std::size_t before,
                 const OdometryNoise& noise,
                 optimization::BlockEquations& equations) {
  const OdometryPiece& piece = graph.pieces[before];
  const PieceResidual residual = piece_residual(graph.multiscans[before].T_map_begin,
                                                graph.multiscans[before + 1].T_map_begin,
                                                piece,
                                                graph.calibration);
  const Eigen::Vector3d piece_variances = square(graph.odometry_scale) * variances(piece, noise);
  const Eigen::Matrix3d information = piece_variances.cwiseInverse().asDiagonal();
  equations.add<3, 3, 3, 3>(residual.value,
                            information,
                            {before, residual.by_before},
                            {before + 1, residual.by_after},
                            {graph.multiscans.size(), residual.by_calibration});
  return residual.value.dot(information * residual.value) + piece_variances.array().log().sum();
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
  const Eigen::Vector2d left = geometry::perpendicular(normal);
  const Eigen::Vector2d point_m = T_map_later * later.point_m;
  const Eigen::Vector2d apart_m = point_m - T_map_earlier * earlier.point_m;
  // Turning the earlier multiscan turns its normal as well as its point.
  return {normal.dot(apart_m),
          left.dot(apart_m),
          {normal.x(), normal.y(), -left.dot(point_m - T_map_later.position_m())},
          {-normal.x(), -normal.y(), left.dot(point_m - T_map_earlier.position_m())}};
}

double add_match(const PatchMatch& match,
                 const PatchFactor& factor,
                 optimization::BlockEquations& equations) {
  equations.add<3, 3>(factor.across_m,
                      factor.information_per_m2 * factor.robust_weight,
                      {match.later.multiscan, factor.by_later},
                      {match.earlier.multiscan, factor.by_earlier});
  return -factor.information_per_m2 * square(factor.max_apart_m) * std::sqrt(factor.robust_weight);
}

/// What is known of the calibration beforehand.
double add_calibration(const MultiscanGraph& graph,
                       const MultiscanAlignmentParams& params,
                       optimization::BlockEquations& equations) {
  const Eigen::Vector3d sd(
      params.turn_share_stddev, params.drift_stddev_rad_per_m, params.drive_share_stddev);
  const Eigen::Vector3d information = (graph.steady_scale * sd).cwiseAbs2().cwiseInverse();
  const Eigen::Vector3d& values = graph.calibration.values;
  equations.add<3, 3>(
      values, information.asDiagonal(), {graph.multiscans.size(), Eigen::Matrix3d::Identity()});
  return values.dot(information.cwiseProduct(values)) - information.array().log().sum();
}

}  // namespace

void validate(const MultiscanAlignmentParams& params) {
  geometry::ParameterValidator("multiscan alignment")
      .require(params.odometry.is_sound(), "the deviations of odometry must be above 0 and finite")
      .positive("turn_share_stddev", params.turn_share_stddev)
      .positive("drift_stddev_rad_per_m", params.drift_stddev_rad_per_m)
      .positive("drive_share_stddev", params.drive_share_stddev)
      .positive("patch_stddev_m", params.patch_stddev_m)
      .at_least("normal_stddev_rad", params.normal_stddev_rad, 0.0)
      .positive("max_apart_m", params.max_apart_m)
      .positive("match_weight", params.match_weight);
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
      square(params.patch_stddev_m) + square(later.offset_stddev_m) +
      square(earlier.offset_stddev_m) +
      (square(params.normal_stddev_rad) + square(earlier.normal_stddev_rad)) *
          square(residual.along_m);
  const double place_stddev_m = match.later.multiscan >= first_wide ? match.place_stddev_m : 0.0;
  const double max_apart_m = std::hypot(params.max_apart_m, place_stddev_m);
  return {residual.value_m,
          residual.by_later,
          residual.by_earlier,
          params.match_weight / variance_m2,
          max_apart_m,
          optimization::geman_mcclure_weight(square(residual.value_m), max_apart_m)};
}

AlignmentStep align_multiscans(MultiscanGraph& graph,
                               const std::vector<PatchMatch>& matches,
                               std::size_t first_free,
                               std::size_t first_wide,
                               const MultiscanAlignmentParams& params) {
  const bool is_whole = first_free <= 1;
  auto equations = equations_over(graph.multiscans.size(), first_free, is_whole);
  AlignmentStep step{graph.multiscans.back().covariance};
  step.negative_log_evidence = is_whole ? add_calibration(graph, params, equations) : 0.0;
  for (std::size_t i = first_free - 1; i + 1 < graph.multiscans.size(); ++i) {
    step.negative_log_evidence += add_piece(graph, i, params.odometry, equations);
  }
  for (const PatchMatch& match : matches) {
    step.negative_log_evidence +=
        add_match(match, patch_factor(graph, match, first_wide, params), equations);
  }
  const auto solution = equations.solve(graph.multiscans.size() - 1);
  if (!solution) {
    step.negative_log_evidence = std::numeric_limits<double>::infinity();
    return step;
  }
  step.last_covariance = solution->covariance;
  step.negative_log_evidence += solution->log_determinant;
  for (std::size_t i = first_free; i < graph.multiscans.size(); ++i) {
    Pose2& pose = graph.multiscans[i].T_map_begin;
    pose = moved(pose, solution->step_of<3>(i));
  }
  graph.calibration.values += solution->step_of<3>(graph.multiscans.size());
  return step;
}

}  // namespace echomap::slam
