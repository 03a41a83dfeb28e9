// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::slam {

/// What a sonar measures of walls and posts, for the likelihood of a heading. Values are ours, of
/// the size that an HC-SR04 in simulated rooms has; the edges are softer than the simulation's.
struct StopHeadingParams {
  double beam_half_angle_rad = 0.2269;  ///< Of the robot's profile.
  /// A smooth wall answers while it is met at most so far off the perpendicular.
  double max_incidence_rad = 0.2269;
  /// The chance of an echo falls from 73 to 27 % over twice this angle.
  double wall_edge_rad = 0.0524;
  double post_edge_rad = 0.0314;
  /// Chance of an echo from straight ahead.
  double wall_chance = 0.97;
  double post_chance = 0.73;
  /// Chance that a reading is of something that is not in the scene, or silent for no reason.
  double clutter_chance = 0.15;
  double range_stddev_m = 0.035;
  /// A wall continues at least so far beyond the pieces that were measured.
  double wall_end_m = 0.3;
  double max_range_m = 4.0;
  /// Headings that are tried to either side, and their spacing.
  double max_turn_rad = 0.1745;
  double step_rad = 0.0087;
  /// Fewer readings do not estimate a heading.
  std::size_t min_readings = 8;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const StopHeadingParams& params);

/// A robot's heading in the map.
struct HeadingEstimate {
  double heading_rad = 0.0;
  double stddev_rad = 0.0;
};

/// The walls and posts around a stop, and what a sonar measures of them.
class SonarScene {
 public:
  SonarScene(const mapping::MatchedSurfaces& matched, const StopHeadingParams& params);

  /// The heading of a robot that took these readings at rest: mean and standard deviation over all
  /// headings near the one that they are placed with, each as likely as all ranges and silences
  /// are in this scene (a forward model; Thrun 2003). Empty for too few readings, or where no
  /// feature is in sight.
  std::optional<HeadingEstimate> heading_of(const mapping::Scan& readings) const;

  /// Logarithm of how likely readings at rest are as they are placed, at least one.
  double log_likelihood_of(const mapping::Scan& readings) const;
  /// The same of each reading for itself.
  std::vector<double> log_likelihoods_of(const mapping::Scan& readings) const;

 private:
  /// A wall or post as seen from one place.
  struct Facing {
    double range_m = 0.0;
    double bearing_rad = 0.0;
    double width_rad = 0.0;  ///< Off the axis of the beam by this, half of the echoes are left.
    double edge_rad = 0.0;
    double chance = 0.0;
    bool is_wall = false;
  };

  /// The nearest first.
  std::vector<Facing> facing_from(const Eigen::Vector2d& sonar_m) const;
  bool is_hidden(const Eigen::Vector2d& from_m, const Eigen::Vector2d& point_m) const;
  double log_likelihood(const std::vector<Facing>& facing,
                        double axis_rad,
                        const std::optional<double>& range_m) const;
  /// The same of all readings, turned by `turn_rad`.
  double log_likelihood(const std::vector<Facing>& facing,
                        const mapping::Scan& readings,
                        double turn_rad) const;

  std::vector<mapping::MatchedWall> walls_;
  std::vector<mapping::EchoFeature> points_;  ///< Posts and round things.
  StopHeadingParams params_;
};

}  // namespace echomap::slam
