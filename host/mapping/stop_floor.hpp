// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/mapping/bearing_profile.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// What a stop may say of the floor around it. Ours, chosen in simulated rooms.
struct StopFloorParams {
  /// A sonar hears nothing from farther away, and says nothing of what is there.
  double max_range_m = 4.0;
  /// Between two surfaces farther apart than this a stop knows nothing of the floor.
  double max_gap_rad = 1.1;
  /// Floor nearer to the border between two surfaces than this is not called free: noise and half a
  /// cell.
  double margin_m = 0.04;
  /// A wall hides the floor behind it for so far beyond its seen ends, too.
  double hidden_beyond_ends_m = 0.1;
  /// The two faces of a wall are at least so far apart, or else one may seem to be before the
  /// other.
  double wall_thickness_m = 0.1;
  /// The readings this near to a direction tell whether it is free up to a wall.
  double looks_half_angle_rad = 0.11;
  /// An echo this near to a direction ends the floor there, short of it by `echo_margin_m`, where
  /// nothing that stops agree on explains it.
  double echo_half_angle_rad = 0.157;
  double echo_margin_m = 0.05;
  /// A wall within the sonar's range answers from the foot of the perpendicular, which lies within
  /// a right angle of any other place on it. Where no surface was heard this near to a direction,
  /// the floor there is free as far as `open_share` of the range: what is smaller than a wall is
  /// not heard from so far.
  double open_half_angle_rad = 1.5707963267948966;
  double open_share = 0.65;
};

/// How far the floor reaches, all around.
struct FloorReach {
  /// As far as the stop's own echoes tell: up to the echo, or to a wall that was heard in that
  /// direction; where half of all around is silent, some way into the open hall.
  BearingProfile heard_m{0.0};
  /// As far as silence tells: up to a known wall, where nothing nearer answered. Not nearer than
  /// what echoes tell.
  BearingProfile silent_m{0.0};
};

/// How far the floor reaches from one stop, all around. In the direction of something that stops
/// agree on it reaches there, where no reading in that direction was nearer. Anywhere else it ends
/// before the nearest echo about, and at the outline of the surfaces that the stop itself has
/// heard: what one stop alone has heard is there until others say what it is. Where there are none
/// on that side, it is a hall whose walls are out of range.
class StopFloor {
 public:
  StopFloor(const ScanSurfaces& scan,
            const SonarSurfaceParams& beam,
            const StopFloorParams& params);

  const Eigen::Vector2d& center_m() const { return center_m_; }
  /// From the centre, given what stands about; 0 where nothing is known.
  FloorReach reach(const SonarFeatures& features) const;

 private:
  StopFloorParams params_;
  double nearer_by_slant_ = 1.0;
  double depth_tolerance_m_ = 0.0;
  Eigen::Vector2d center_m_;
  /// The nearest that was heard about a direction: infinity for silence, 0 where nobody has
  /// listened.
  BearingProfile heard_m_;
  /// How far the floor is known without what others have seen.
  BearingProfile alone_m_;
};

}  // namespace echomap::mapping
