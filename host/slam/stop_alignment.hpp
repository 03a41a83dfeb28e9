// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"
#include "host/slam/bent_surfaces.hpp"
#include "host/slam/stop_graph.hpp"
#include "host/slam/stop_heading.hpp"
#include "host/slam/stop_stand.hpp"

namespace echomap::slam {

/// How stops are aligned; values are ours, chosen in simulated rooms.
struct StopAlignmentParams {
  StopStandParams stands;
  mapping::SonarSurfaceParams surfaces;
  /// Bearings of one feature agree better than when a map is drawn: a feature made of two surfaces
  /// turns the stops that measured it.
  mapping::SurfaceMatchingParams matching{.wall_bearing_tolerance_rad = 0.18,
                                          .post_bearing_tolerance_rad = 0.18};
  /// Tolerances grow by this factor in the first round, when headings are poor.
  double first_tolerance_factor = 1.4;
  StopHeadingParams heading;
  StopGraphParams graph;
  /// Matching and aligning take turns.
  int rounds = 2;
  /// Besides where the method and the last alignment have them, the stops are begun with odometry
  /// that drifts by so much to either side, up to so many stops: two wheels of an unknown
  /// difference.
  double tried_drift_rad_per_m = 0.05;
  std::size_t drift_tried_stops = 12;
  /// A reading counts so much of a measurement when alignments are compared, because neighbours in
  /// a beam share their errors. Another start has to be better by so much (log-likelihood).
  double reading_weight = 0.1;
  double min_gain = 2.0;
  /// Starts that are nearer to each other in all stands end in the same alignment.
  double same_start_rad = 0.01;
  double same_start_m = 0.01;
  /// Number of newest stops that an alignment moves. `holders` is the number of others, the
  /// nearest, that stay and hold them.
  std::size_t window = 25;
  std::size_t holders = 15;
  /// Every so many stops a wider window moves: what was held before may be bent.
  std::size_t wide_every = 8;
  std::size_t wide_window = 100;
};

/// Places the stops of a robot where they agree on walls and posts, with odometry between them
/// (docs/algorithms/multiscan_slam.md). The first stop stays. Which surfaces are one is a matter of
/// where the stops begin, so several starts are tried.
class StopAlignment {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit StopAlignment(const StopAlignmentParams& params = {});

  /// Takes the readings of the next stop, at least one, in the order of time.
  void add_stop(std::vector<StopReading> readings);
  /// Aligns the newest stops. `T_slam_stands` are the poses at the first reading of each stand
  /// before the alignment.
  void align(const std::vector<geometry::Pose2>& T_slam_stands);

  const std::vector<StopStand>& stands() const { return stands_; }
  /// The robot at the first reading of each stand, as aligned last.
  const std::vector<geometry::Pose2>& T_map_stands() const { return T_map_stands_; }
  /// The readings of each stop, as aligned last.
  std::vector<mapping::Scan> scans() const;

 private:
  /// Where the stands are placed, and how likely that is (logarithm, without constants).
  struct Placement {
    std::vector<geometry::Pose2> T_map_stands;
    OdometryCalibration calibration;
    double log_likelihood = 0.0;
  };

  std::size_t first_stand_of(std::size_t stop) const;
  /// The stands before they are aligned, in the order in which they are to be tried.
  std::vector<std::vector<geometry::Pose2>> starts(
      std::size_t first_free, const std::vector<geometry::Pose2>& T_slam_stands) const;
  /// By the method's poses, of which the heading drifts by so much more.
  std::vector<geometry::Pose2> start_by_slam(std::size_t first_free,
                                             const std::vector<geometry::Pose2>& T_slam_stands,
                                             double drift_rad_per_m) const;
  /// As aligned last, the newest stop by the odometry as calibrated then.
  std::vector<geometry::Pose2> start_by_last_alignment() const;
  OdometryPiece odometry_before(std::size_t stand) const;
  Placement aligned_from(const std::vector<geometry::Pose2>& T_map_stands,
                         const OdometryCalibration& calibration,
                         std::size_t first_free);
  /// Of all readings at rest, each stop's by what the others have seen.
  double log_likelihood_of(const std::vector<std::size_t>& stops);
  /// The stops of the graph, in order: the free ones, the one before them and the nearest others.
  std::vector<std::size_t> stops_around(std::size_t first_free) const;
  mapping::Scan readings_of(std::size_t stop) const;
  mapping::Scan resting_readings_of(std::size_t stand) const;
  const mapping::ScanSurfaces& surfaces_of(std::size_t stop);
  mapping::MatchedSurfaces match(const std::vector<std::size_t>& stops, double tolerance_factor);
  /// Returns the graph as it was solved.
  StopGraph align_once(const std::vector<std::size_t>& stops, std::size_t first_free, int round);
  StopGraph graph_over(const std::vector<std::size_t>& stops,
                       std::size_t first_free,
                       const mapping::MatchedSurfaces& matched) const;

  StopAlignmentParams params_;
  std::vector<std::vector<StopReading>> stops_;
  std::vector<StopStand> stands_;
  std::vector<geometry::Pose2> T_map_stands_;
  std::vector<BentSurfaces> surfaces_;  ///< Of each stop.
  OdometryCalibration calibration_;
};

}  // namespace echomap::slam
