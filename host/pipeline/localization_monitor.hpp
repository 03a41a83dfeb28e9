// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/localizer_outcome.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/place_check.hpp"
#include "host/localization/stop_scan.hpp"
#include "host/localization/view_difference.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::pipeline {

/// When scans contradict the place where a robot is estimated to be.
struct LocalizationMonitorParams {
  /// A sonar's scan contradicts a place if so many of its echoes come from known places of the map,
  /// and more than this share of them from its floor: the place is then no claim, however sure the
  /// particles are of each other.
  std::size_t contradicting_echoes = 8;
  double contradicting_floor_share = 0.2;
  /// After so many such scans in a row the robot may be anywhere.
  std::size_t contradictions_of_lost = 2;
};

/// Throws std::invalid_argument for a parameter outside of its range.
void validate(const LocalizationMonitorParams& params);

/// Monitors the belief of a particle filter: it compares the place with all others of the map by
/// the last scans (localization::PlaceCheck), and takes back that the robot is localized where its
/// newest scan contradicts the place.
class LocalizationMonitor {
 public:
  /// The map and the model outlive this. Without a model that tells places apart they are not
  /// compared, and only the newest scan is looked at.
  LocalizationMonitor(const mapping::RasterMap& map,
                      localization::ObservationModel* places,
                      double max_range_m,
                      const LocalizationMonitorParams& params = {});

  /// The filter was started at a pose that somebody told. The place is known if the pose is on the
  /// floor; off the floor, the robot may be anywhere.
  void start_at(localization::LocalizerOutcome outcome);
  /// The robot may be anywhere from now on.
  void start_anywhere();

  /// Checks the filter's own belief after a scan.
  localization::CheckedBelief check(const localization::PoseBelief& believed,
                                    const localization::StopScan& scan);
  /// Where the last check left a place doubtful, a belief between two scans is not surer than that,
  /// and has the hypotheses of the check, moved on by odometry.
  void limit_confidence(localization::PoseBelief& belief,
                        const geometry::Pose2& T_odom_robot) const;
  /// How well a scan from a goal would tell the hypotheses apart: localization::ViewDifference.
  /// 0 where places are not compared.
  double telling(const std::vector<localization::PoseHypothesis>& hypotheses,
                 const geometry::Pose2& T_robot_goal) const;

 private:
  localization::CheckedBelief compare_places(localization::PlaceCheck& places,
                                             const localization::PoseBelief& believed,
                                             const localization::StopScan& scan);
  bool contradicts_place(const geometry::Pose2& T_map_robot,
                         const std::vector<localization::RangeReading>& readings) const;

  LocalizationMonitorParams params_;
  const mapping::RasterMap& map_;
  mapping::OccupancyGrid compared_map_;                ///< In its own frame: mapping::grid_of.
  std::optional<localization::PlaceCheck> places_;     ///< Empty where places are not compared.
  std::optional<localization::ViewDifference> views_;  ///< As those.
  /// What the last check said of a place that it did not claim, and where odometry had the robot.
  std::optional<localization::PoseBelief> doubtful_;
  geometry::Pose2 T_odom_checked_;
  std::size_t contradictions_ = 0;  ///< Of the believed place, in a row.
};

}  // namespace echomap::pipeline
