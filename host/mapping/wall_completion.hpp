// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"
#include "host/mapping/door_evidence.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// When a wall goes on where no echo came from. A sonar hears a wall only from before it, so that
/// stretches stay unheard where the robot does not come near. Ours, chosen in simulated rooms.
struct WallCompletionParams {
  /// Between two pieces of a wall that are farther apart than this, nothing is known.
  double bridged_m = 1.2;
  /// Farther than this a wall is not prolonged to a corner.
  double reach_m = 0.6;
  /// To a post this near to its line, the edge of what the wall belongs to, not farther than this.
  double edge_off_line_m = 0.06;
  double edge_reach_m = 0.8;
  /// Walls that meet at less than this are one wall, or none.
  double min_angle_rad = 0.5;
  /// What was heard this much behind a wall was heard through a gap in it.
  double behind_m = 0.12;
  /// A gap is open where a stop that faces it got no echo from it, or only one from behind, or
  /// echoes from as far off as its ends. It faces it if the foot of the perpendicular is at least
  /// so far inside of the gap,
  double faced_inside_m = 0.1;
  /// if it is not farther off than this, which is within the sonar's range,
  double faced_range_m = 3.0;
  /// and has looked to within this of the foot.
  double faced_half_angle_rad = 0.11;
  /// Ends are told from a wall where they are at least so much farther off than the foot would be:
  /// 2 sigma of the mean of a few echoes and the wall's own place, to each side of the middle.
  double told_apart_m = 0.04;
  DoorEvidenceParams doors;
  /// Of a door that echoes leave room for, so much to each side stays wall: where it is is not
  /// known better.
  double door_side_m = 0.1;
};

/// How much farther off than the foot of the perpendicular the nearer end of a gap is; 0 where the
/// foot is not in the gap.
double end_excess_m(const Eigen::Vector2d& from_m, const geometry::Segment& gap);

/// What of a piece of a wall lies between or beside the pieces of it that were heard, which are in
/// order.
std::vector<MatchedWall::Piece> gaps_between(const std::vector<MatchedWall::Piece>& heard,
                                             const MatchedWall::Piece& piece);

/// Closes gaps in walls. A gap stays open through which a surface was heard or the robot has
/// driven, or which did not answer a stop before it as a wall does. All in the map frame.
class WallCompletion {
 public:
  /// What was heard: the features by those that support them, other surfaces as the scans have
  /// them; `scans` outlives this. `track_m` is where the robot's centre has been.
  WallCompletion(const MatchedSurfaces& matched,
                 const std::vector<ScanSurfaces>& scans,
                 const std::vector<Eigen::Vector2d>& track_m,
                 const WallCompletionParams& params);

  /// The walls without what was not heard and is open, the gaps between their pieces bridged, and
  /// prolonged to the corner with another one where both come near enough to it, or else to a post
  /// on their line.
  std::vector<MatchedWall> completed(const MatchedSurfaces& matched) const;

 private:
  std::vector<MatchedWall::Piece> without_doors(const MatchedWall& wall) const;
  std::vector<MatchedWall::Piece> bridged(const MatchedWall& wall) const;
  double prolonged_m(const MatchedSurfaces& matched,
                     std::size_t wall,
                     double end_m,
                     double up) const;
  std::optional<double> corner_m(const std::vector<MatchedWall>& walls,
                                 std::size_t wall,
                                 double end_m,
                                 double up) const;
  std::optional<double> edge_m(const MatchedSurfaces& matched,
                               const MatchedWall& wall,
                               double end_m,
                               double up) const;
  bool is_closed(const geometry::Segment& gap) const;
  bool is_heard_open(const geometry::Segment& gap) const;
  bool hears_open(const ScanSurfaces& scan, const geometry::Segment& gap) const;

  WallCompletionParams params_;
  const std::vector<ScanSurfaces>& scans_;
  std::vector<geometry::Segment> sights_;
  std::vector<geometry::Segment> track_;
};

}  // namespace echomap::mapping
