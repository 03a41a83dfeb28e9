// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/place_search.hpp"

namespace echomap::localization {

/// When a place is claimed, and when it is given up.
struct PlaceCheckParams {
  PlaceSearchParams search;
  /// A place is claimed from this probability on: of such claims as many have to be right.
  double claimed_from = 0.95;
  /// A place that is claimed, or told, is given up below this probability.
  double lost_below = 0.1;
  /// Prior probability that a robot is not where it is told to be, or has been carried off since.
  double elsewhere_chance = 0.09;
  /// Places that are less probable are not told.
  double told_from = 0.02;
  /// By how much a filter at the right place departs from the way that the wheels went between two
  /// scans: standard deviations, at rest, and a metre and a radian of the net motion. Of 34 such
  /// stops of simulated robots none had a chi squared, of three degrees of freedom, above 5.2;
  /// three stops at wrong places had 11 to 22 (docs/decisions/0020).
  double departure_m = 0.04;
  double departure_per_m = 0.03;
  double departure_rad = 0.03;
  double departure_per_rad = 0.01;
  /// From this chi squared on, its 95th percentile, the prior of a known place counts less.
  double usual_departure = 7.8;
};

/// How well a search tells a pose: standard deviations.
inline constexpr double kFoundStddevM = 0.1;
inline constexpr double kFoundStddevRad = 0.1;

/// Whether the newest scan alone speaks against a place.
using Contradicts = std::function<bool(const geometry::Pose2& T_map_robot)>;

/// What a check says of a filter's belief.
struct CheckedBelief {
  PoseBelief belief;
  /// Where the filter has to start again, since it follows another place.
  std::optional<geometry::Pose2> T_map_restart;
};

/// Where a filter had a robot at a scan, and where odometry had it.
struct FollowedPose {
  geometry::Pose2 T_map_robot;
  geometry::Pose2 T_odom_robot;
};

/// Checks the place that a filter believes in against all places of the map, by the last scans
/// together (PlaceSearch). Where the robot may be anywhere, its place is claimed when no other
/// explains the scans nearly as well; else all that do are told, each with its probability. Where
/// its place is known, told or claimed before, another place has to be so much better that it
/// outweighs how seldom robots are carried off; less so where the filter has departed from the way
/// that the wheels went since the last scan.
class PlaceCheck {
 public:
  /// The model outlives this.
  explicit PlaceCheck(ObservationModel& model, const PlaceCheckParams& params = {});

  /// The robot's place is known from now on.
  void begin_known();
  /// The robot may be anywhere from now on.
  void begin_anywhere();
  /// As that, but the newest scan was heard there, too.
  void doubt();
  bool is_known() const { return is_known_; }

  /// After a scan from where the robot is now. Without a reading that counts the belief is as it
  /// was. Lost is told once, when a known place is given up.
  CheckedBelief check(const PoseBelief& believed, StopScan scan, const Contradicts& contradicts);

 private:
  CheckedBelief check_known(const PoseBelief& believed, const Contradicts& contradicts);
  CheckedBelief check_anywhere(const PoseBelief& believed, const Contradicts& contradicts);
  /// How much of the prior of the known place is left to a filter that has it there now.
  double prior_share(const FollowedPose& now) const;
  /// The believed place and the others, by so many of the newest scans and the prior probability
  /// that the robot is elsewhere, which is spread evenly over the others. Of the prior of the
  /// believed place only that share holds.
  std::vector<FoundPlace> places_by_scans(const geometry::Pose2& T_map_believed,
                                          std::size_t newest,
                                          double prior_share);

  PlaceCheckParams params_;
  PlaceSearch search_;
  bool is_known_ = false;                   ///< Else the robot may be anywhere.
  geometry::Pose2 T_odom_robot_;            ///< At the newest scan.
  std::optional<FollowedPose> last_known_;  ///< At the last scan of a known place.
  bool was_known_ = false;                  ///< Until the next check tells that it is not any more.
};

}  // namespace echomap::localization
