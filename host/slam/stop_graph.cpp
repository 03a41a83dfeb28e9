// SPDX-License-Identifier: MIT
#include "host/slam/stop_graph.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/block_equations.hpp"
#include "host/optimization/robust_kernel.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;
using geometry::square;
using optimization::BlockEquations;

constexpr int kSteps = 3;
/// Keeps a graph in which all is free from floating, and a feature that is hardly determined near
/// where it was; metres and radians.
constexpr double kAnchorStddev = 0.1;
constexpr double kFeatureStddev = 0.5;

/// The equations of a graph, and minus twice the logarithm of its likelihood so far.
struct Equations {
  BlockEquations blocks;
  double negative_log_likelihood = 0.0;
};

double robust_cost(double squared_error, double kernel) {
  return squared_error * optimization::inlier_share(squared_error, kernel);
}

Equations equations_over(const StopGraph& graph) {
  Equations equations;
  for (const GraphStand& stand : graph.stands) {
    stand.is_free ? equations.blocks.add_block(3) : equations.blocks.add_fixed_block();
  }
  for (std::size_t i = 0; i < graph.calibrations.size(); ++i) {
    equations.blocks.add_block(3);
  }
  for (std::size_t i = 0; i < graph.features.size(); ++i) {
    equations.blocks.add_block(2);
  }
  return equations;
}

/// Odometry to a stand from the one before it, where one of them can move.
std::optional<PieceResidual> odometry_residual(const StopGraph& graph, std::size_t stand) {
  const GraphStand& after = graph.stands[stand];
  if (stand == 0 || !after.piece_before) {
    return std::nullopt;
  }
  const GraphStand& before = graph.stands[stand - 1];
  if (!after.is_free && !before.is_free) {
    return std::nullopt;
  }
  return piece_residual(
      before.T_map_robot, after.T_map_robot, *after.piece_before, graph.calibrations[after.robot]);
}

std::size_t block_of_calibration(const StopGraph& graph, std::size_t robot) {
  return graph.stands.size() + robot;
}

std::size_t block_of_feature(const StopGraph& graph, std::size_t feature) {
  return graph.stands.size() + graph.calibrations.size() + feature;
}

void add_odometry(const StopGraph& graph, const StopGraphParams& params, Equations& equations) {
  for (std::size_t i = 1; i < graph.stands.size(); ++i) {
    const auto residual = odometry_residual(graph, i);
    if (!residual) {
      continue;
    }
    const Eigen::Vector3d variance =
        square(graph.odometry_scale) * variances(*graph.stands[i].piece_before, params.odometry);
    const Eigen::Matrix3d information = variance.cwiseInverse().asDiagonal();
    equations.blocks.add<3, 3, 3, 3>(
        residual->value,
        information,
        {i - 1, residual->by_before},
        {i, residual->by_after},
        {block_of_calibration(graph, graph.stands[i].robot), residual->by_calibration});
    equations.negative_log_likelihood +=
        residual->value.dot(information * residual->value) + variance.array().log().sum();
  }
}

Eigen::Vector3d calibration_stddevs(const StopGraphParams& params) {
  return {params.turn_share_stddev, params.drift_stddev_rad_per_m, params.drive_share_stddev};
}

void add_calibration(const StopGraph& graph, const StopGraphParams& params, Equations& equations) {
  const Eigen::Vector3d information = calibration_stddevs(params).cwiseAbs2().cwiseInverse();
  for (std::size_t robot = 0; robot < graph.calibrations.size(); ++robot) {
    const Eigen::Vector3d& values = graph.calibrations[robot].values;
    equations.blocks.add<3, 3>(values,
                               information.asDiagonal(),
                               {block_of_calibration(graph, robot), Eigen::Matrix3d::Identity()});
    equations.negative_log_likelihood += values.dot(information.cwiseProduct(values));
  }
}

void add_headings(const StopGraph& graph, const StopGraphParams& params, Equations& equations) {
  for (std::size_t i = 0; i < graph.stands.size(); ++i) {
    const GraphStand& stand = graph.stands[i];
    if (!stand.heading) {
      continue;
    }
    const double error_rad =
        geometry::angle_between(stand.heading->heading_rad, stand.T_map_robot.heading_rad());
    const double stddev_rad = std::hypot(stand.heading->stddev_rad, params.heading_stddev_rad);
    const double squared_error = square(error_rad / stddev_rad);
    const double kernel = params.max_heading_error_rad / stddev_rad;
    equations.blocks.add<3>(
        error_rad,
        optimization::geman_mcclure_weight(squared_error, kernel) / square(stddev_rad),
        {i, Eigen::RowVector3d(0.0, 0.0, 1.0)});
    equations.negative_log_likelihood += robust_cost(squared_error, kernel);
  }
}

void add_sighting(const StopGraph& graph,
                  std::size_t feature,
                  const GraphSighting& sighting,
                  const StopGraphParams& params,
                  Equations& equations) {
  const Pose2& T_map_robot = graph.stands[sighting.stand].T_map_robot;
  const mapping::EchoFeature& seen = graph.features[feature].feature;
  const mapping::FeatureView view = view_from(T_map_robot * sighting.T_robot_sonar_m, seen);
  const Eigen::Vector2d towards = geometry::unit_vector(view.bearing_rad);
  const std::size_t block = block_of_feature(graph, feature);
  const double squared_error = square((view.range_m - sighting.range_m) / params.range_stddev_m);
  const double kernel = params.max_range_error_m / params.range_stddev_m;
  equations.blocks.add<3, 2>(
      view.range_m - sighting.range_m,
      optimization::geman_mcclure_weight(squared_error, kernel) / square(params.range_stddev_m),
      {sighting.stand, Eigen::RowVector3d(-towards.x(), -towards.y(), 0.0)},
      {block, view.jacobian.row(0)});
  equations.blocks.add<3, 2>(
      geometry::angle_between(T_map_robot.heading_rad() + sighting.robot_bearing_rad,
                              view.bearing_rad),
      1.0 / square(params.bearing_stddev_rad),
      {sighting.stand, Eigen::RowVector3d(0.0, 0.0, -1.0)},
      {block, view.jacobian.row(1)});
  equations.negative_log_likelihood += robust_cost(squared_error, kernel);
}

void add_features(const StopGraph& graph, const StopGraphParams& params, Equations& equations) {
  for (std::size_t i = 0; i < graph.features.size(); ++i) {
    equations.blocks.add<2, 2>(Eigen::Vector2d::Zero(),
                               Eigen::Matrix2d::Identity() / square(kFeatureStddev),
                               {block_of_feature(graph, i), Eigen::Matrix2d::Identity()});
    for (const GraphSighting& sighting : graph.features[i].sightings) {
      add_sighting(graph, i, sighting, params, equations);
    }
  }
}

void add_relations(const StopGraph& graph, Equations& equations) {
  for (const GraphRelation& relation : graph.relations) {
    const OdometryPiece measured{relation.T_from_to};
    const PieceResidual residual = piece_residual(graph.stands[relation.from].T_map_robot,
                                                  graph.stands[relation.to].T_map_robot,
                                                  measured,
                                                  {});
    const double per_m2 = 1.0 / square(relation.position_stddev_m);
    const Eigen::Vector3d information(per_m2, per_m2, 1.0 / square(relation.heading_stddev_rad));
    equations.blocks.add<3, 3, 3>(residual.value,
                                  information.asDiagonal(),
                                  {relation.from, residual.by_before},
                                  {relation.to, residual.by_after});
    equations.negative_log_likelihood +=
        residual.value.dot(information.cwiseProduct(residual.value));
  }
}

void apply(const optimization::BlockSolution& solution, StopGraph& graph) {
  for (std::size_t i = 0; i < graph.stands.size(); ++i) {
    const Eigen::Vector3d step = solution.step_of<3>(i);
    Pose2& pose = graph.stands[i].T_map_robot;
    pose = Pose2(pose.x_m() + step.x(), pose.y_m() + step.y(), pose.heading_rad() + step.z());
  }
  for (std::size_t robot = 0; robot < graph.calibrations.size(); ++robot) {
    graph.calibrations[robot].values += solution.step_of<3>(block_of_calibration(graph, robot));
  }
  for (std::size_t i = 0; i < graph.features.size(); ++i) {
    graph.features[i].feature.value += solution.step_of<2>(block_of_feature(graph, i));
  }
}

Equations linearised(const StopGraphParams& params, const StopGraph& graph) {
  Equations equations = equations_over(graph);
  equations.blocks.add<3, 3>(Eigen::Vector3d::Zero(),
                             Eigen::Matrix3d::Identity() / square(kAnchorStddev),
                             {0, Eigen::Matrix3d::Identity()});
  add_odometry(graph, params, equations);
  add_calibration(graph, params, equations);
  add_headings(graph, params, equations);
  add_features(graph, params, equations);
  add_relations(graph, equations);
  return equations;
}

/// Makes one step of Gauss and Newton. Returns the negative log evidence before it, doubled, by the
/// method of Laplace, without what does not depend on the scale of the odometry.
double step(const StopGraphParams& params, StopGraph& graph) {
  const Equations equations = linearised(params, graph);
  const auto solution = equations.blocks.solve();
  if (!solution) {
    return std::numeric_limits<double>::infinity();
  }
  apply(*solution, graph);
  return equations.negative_log_likelihood + solution->log_determinant;
}

}  // namespace

void validate(const StopGraphParams& params) {
  geometry::ParameterValidator("stop graph")
      .require(params.odometry.is_sound(), "the deviations of odometry must be above 0 and finite")
      .require(!params.odometry_scales.empty(), "odometry_scales hold at least one")
      .positive("turn_share_stddev", params.turn_share_stddev)
      .positive("drift_stddev_rad_per_m", params.drift_stddev_rad_per_m)
      .positive("drive_share_stddev", params.drive_share_stddev)
      .positive("range_stddev_m", params.range_stddev_m)
      .positive("max_range_error_m", params.max_range_error_m)
      .positive("bearing_stddev_rad", params.bearing_stddev_rad)
      .positive("heading_stddev_rad", params.heading_stddev_rad)
      .positive("max_heading_error_rad", params.max_heading_error_rad);
}

void align_stops(const StopGraphParams& params, StopGraph& graph) {
  if (graph.stands.empty()) {
    return;
  }
  const Pose2 T_map_first = graph.stands.front().T_map_robot;
  double min_negative_log_evidence = std::numeric_limits<double>::infinity();
  StopGraph best = graph;
  for (const double scale : params.odometry_scales) {
    StopGraph tried = graph;
    tried.odometry_scale = scale;
    double negative_log_evidence = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      negative_log_evidence = step(params, tried);
    }
    if (negative_log_evidence < min_negative_log_evidence) {
      min_negative_log_evidence = negative_log_evidence;
      best = std::move(tried);
    }
  }
  graph = std::move(best);
  if (!graph.stands.front().is_free) {
    return;  // What is held keeps the frame.
  }
  const Pose2 T_map_moved = T_map_first * graph.stands.front().T_map_robot.inverse();
  for (GraphStand& stand : graph.stands) {
    stand.T_map_robot = T_map_moved * stand.T_map_robot;
  }
}

std::optional<Eigen::Matrix3d> covariance_of(const StopGraphParams& params,
                                             StopGraph graph,
                                             std::size_t stand) {
  if (stand == 0) {
    return Eigen::Matrix3d::Zero();
  }
  graph.stands.front().is_free = false;
  const auto solution = linearised(params, graph).blocks.solve(stand);
  return solution ? std::optional<Eigen::Matrix3d>(solution->covariance) : std::nullopt;
}

double odometry_cost(const StopGraphParams& params, const StopGraph& graph) {
  double squares = 0.0;
  for (const OdometryCalibration& calibration : graph.calibrations) {
    squares += calibration.values.cwiseQuotient(calibration_stddevs(params)).squaredNorm();
  }
  for (std::size_t i = 1; i < graph.stands.size(); ++i) {
    if (const auto residual = odometry_residual(graph, i)) {
      const Eigen::Vector3d variance = variances(*graph.stands[i].piece_before, params.odometry);
      squares += residual->value.cwiseAbs2().cwiseQuotient(variance).sum();
    }
  }
  return 0.5 * squares;
}

}  // namespace echomap::slam
