// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/echo_feature.hpp"
#include "host/slam/odometry_piece.hpp"
#include "host/slam/stop_heading.hpp"

namespace echomap::slam {

/// What is worth how much when stops are aligned; standard deviations.
struct StopGraphParams {
  /// Odometry between two headings at rest: a wheel that slips turns the body by the square root of
  /// what it rolled. Times a scale that is learnt.
  OdometryNoise odometry{0.002, 0.03, 0.01, 0.003, 0.015};
  /// Scales that are tried: from tyres that hardly slip to ones that do.
  std::vector<double> odometry_scales{0.25, 0.5, 1.0};
  /// Systematic errors of the odometry: share of a turn, drift of the heading, share of a drive.
  double turn_share_stddev = 0.03;
  double drift_stddev_rad_per_m = 0.05;
  double drive_share_stddev = 0.03;
  /// Range of a surface, and from where on one is taken for another's.
  double range_stddev_m = 0.025;
  double max_range_error_m = 0.08;
  /// Bearing of a surface: little, because the heading below is made of the same readings.
  double bearing_stddev_rad = 0.2;
  /// Heading of a stop, besides what its readings leave open: features are not quite where the map
  /// has them. Headings that are off by more than the second count less and less.
  double heading_stddev_rad = 0.01;
  double max_heading_error_rad = 0.14;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const StopGraphParams& params);

/// Readings that were taken at rest in one heading; a full sweep has two.
struct GraphStand {
  geometry::Pose2 T_map_robot;
  bool is_free = true;
  std::size_t robot = 0;  ///< Whose odometry it is: index of its calibration.
  /// From the stand before it in the graph; empty where others lie between.
  std::optional<OdometryPiece> piece_before;
  /// The heading in the map that its readings are most likely from.
  std::optional<HeadingEstimate> heading;
};

/// A surface that a stop has measured, and which feature it is.
struct GraphSighting {
  std::size_t stand = 0;
  Eigen::Vector2d T_robot_sonar_m = Eigen::Vector2d::Zero();
  double range_m = 0.0;
  double robot_bearing_rad = 0.0;  ///< In the robot's frame.
};

/// A wall, post or round thing, and the sightings of it.
struct GraphFeature {
  mapping::EchoFeature feature;
  std::vector<GraphSighting> sightings;
};

/// How two stands lie to each other as something else than walls and odometry tells.
struct GraphRelation {
  std::size_t from = 0;
  std::size_t to = 0;
  geometry::Pose2 T_from_to;
  double position_stddev_m = 0.0;
  double heading_stddev_rad = 0.0;  ///< Infinite where only the place is known.
};

/// Stops of one robot or several, the walls and posts that they share, and the errors of the
/// odometry between them.
struct StopGraph {
  std::vector<GraphStand> stands;
  std::vector<GraphFeature> features;
  std::vector<GraphRelation> relations = {};
  std::vector<OdometryCalibration> calibrations{1};  ///< One of each robot.
  double odometry_scale = 1.0;
};

/// Least squares over stands, features and calibration (graph SLAM; Thrun, Burgard and Fox 2005,
/// chapter 11), some steps. If all stands are free, the first one stays where it was in the end:
/// its heading is a variable as all others, and the map is turned back to it.
void align_stops(const StopGraphParams& params, StopGraph& graph);

/// Of x, y (m) and heading (rad) of one stand as a graph has it, against the first one; empty where
/// nothing ties the two.
std::optional<Eigen::Matrix3d> covariance_of(const StopGraphParams& params,
                                             StopGraph graph,
                                             std::size_t stand);

/// Minus the logarithm of how likely the ways between the stands and the calibration are, as they
/// are now, by odometry alone at its scale of 1; without constants.
double odometry_cost(const StopGraphParams& params, const StopGraph& graph);

}  // namespace echomap::slam
