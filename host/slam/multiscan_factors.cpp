// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_factors.hpp"

#include <map>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "host/geometry/square.hpp"
#include "host/optimization/normal_equations.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

/// What is known no better than to a metre or a radian is not told: linearised it means nothing.
constexpr double kMinInformation = 1.0;

PoseEdge edge_of_piece(const MultiscanGraph& graph,
                       std::size_t before,
                       const OdometryNoise& noise) {
  const OdometryPiece& piece = graph.pieces[before];
  const Pose2 driven = calibrated(piece, graph.calibration);
  const Eigen::Vector3d spread = geometry::square(graph.odometry_scale) * variances(piece, noise);
  const Eigen::Matrix3d on_axes_before = spread.cwiseInverse().asDiagonal();
  return {before, before + 1, driven, in_frame_of(driven, on_axes_before), false};
}

/// The squared errors of two multiscans' matches by x, y and heading of the later one in the map.
using Pull = optimization::NormalEquations<3>;

/// The one edge that pulls as all the matches do. Empty where they know too little.
std::optional<PoseEdge> edge_of_matches(const MultiscanGraph& graph,
                                        std::size_t earlier,
                                        std::size_t later,
                                        const Pull& pull) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> known(pull.information());
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d direction = known.eigenvectors().col(i);
    if (const double value = known.eigenvalues()[i]; value >= kMinInformation) {
      information += value * direction * direction.transpose();
      change -= direction.dot(pull.gradient()) / value * direction;
    }
  }
  if (information.isZero()) {
    return std::nullopt;
  }
  const Pose2& T_map_later = graph.multiscans[later].T_map_begin;
  const Pose2 T_map_measured = moved(T_map_later, change);
  return PoseEdge{earlier,
                  later,
                  graph.multiscans[earlier].T_map_begin.inverse() * T_map_measured,
                  in_frame_of(T_map_measured, information),
                  false};
}

}  // namespace

FactorGraph factor_graph(const MultiscanGraph& graph,
                         const std::vector<PatchMatch>& matches,
                         std::size_t first_wide,
                         const MultiscanAlignmentParams& params) {
  FactorGraph factors;
  for (const PlacedPatches& multiscan : graph.multiscans) {
    factors.T_map_nodes.push_back(multiscan.T_map_begin);
  }
  for (std::size_t before = 0; before < graph.pieces.size(); ++before) {
    factors.edges.push_back(edge_of_piece(graph, before, params.odometry));
  }
  std::map<std::pair<std::size_t, std::size_t>, Pull> pulls;
  for (const PatchMatch& match : matches) {
    const PatchFactor factor = patch_factor(graph, match, first_wide, params);
    pulls[{match.earlier.multiscan, match.later.multiscan}].add(
        factor.across_m, factor.by_later, factor.information_per_m2 * factor.robust_weight);
  }
  for (const auto& [multiscans, pull] : pulls) {
    if (const auto edge = edge_of_matches(graph, multiscans.first, multiscans.second, pull)) {
      factors.edges.push_back(*edge);
    }
  }
  return factors;
}

}  // namespace echomap::slam
