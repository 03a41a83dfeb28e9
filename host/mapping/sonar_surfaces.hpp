// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

/// A wider beam tells nothing of where in it the echo came from.
constexpr double kMaxBeamHalfAngleRad = 0.7853981633974483;

/// When readings of a scan are taken for one surface.
struct SonarSurfaceParams {
  /// Half the opening angle of the beam: 13 to 16 degrees for HC-SR04 and NXT (robot profile).
  double beam_half_angle_rad = 0.2269;
  /// Readings of one surface differ from its depth by at most this: 2.7 sigma of the 3 cm that
  /// Singh and Bedi 2013, section 2.4, give for their sonar.
  double depth_tolerance_m = 0.08;
  /// Those beyond the beam's edge are longer than that by at most so much in the mean, with a
  /// standard deviation of 1.3 cm for five readings: what stands half a door beside the foot of a
  /// perpendicular of 1 m is 6 cm farther off.
  double max_longer_m = 0.04;
  /// A strong echo is still heard at this many half angles off the axis (simulated beam).
  double beam_edge = 1.3;
  /// A region of fewer readings is a ghost or a mishap (two looks at each of two bearings).
  std::size_t min_readings = 4;
  /// So is one in which a smaller share of the readings agrees (double bounces are heard now and
  /// then, surfaces nearly always).
  double min_agreement = 0.5;
};

/// Something solid as one stop has seen it: a region of constant depth (Leonard and Durrant-Whyte
/// 1992). A wide beam hears a smooth wall at one and the same range for as long as the foot of the
/// perpendicular lies within the beam; so the wall stands at the middle of the region.
struct SonarSurface {
  /// From the scan's centre to the surface's nearest point; the bearing in the map frame.
  double bearing_rad = 0.0;
  double range_m = 0.0;
  /// How far the surface reaches to both sides of that point, at right angles to the bearing: a
  /// region wider than the beam has heard a wall, else it is a corner or a pole and this is 0.
  double half_length_m = 0.0;
  /// Readings that agree.
  std::size_t readings = 0;
  /// How far it reaches for sure to the right and to the left: 0 on a side that may as well end in
  /// another thing about as far off, as in the other side of a door's frame.
  double right_m = 0.0;
  double left_m = 0.0;
  /// The outermost of them, from `bearing_rad` to the left.
  double rightmost_rad = 0.0;
  double leftmost_rad = 0.0;

  /// Whether the direction lies among those in which the surface was heard.
  bool is_heard_towards(double towards_rad) const;
  bool operator==(const SonarSurface&) const = default;
};

/// The surfaces around one stop.
struct ScanSurfaces {
  /// Where the sonar was, on average over the scan.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  std::vector<SonarSurface> surfaces;
  /// All of its readings, as seen from there; bearings in the map frame.
  std::vector<sensors::Beam> looks;
};

/// Resolves the readings of one scan together into surfaces, the best supported first. A reading
/// that supports none of them, as ghosts do, is dropped.
ScanSurfaces find_surfaces(const Scan& scan, const SonarSurfaceParams& params);

/// The same scan, had it been taken from elsewhere.
ScanSurfaces moved(ScanSurfaces scan, const geometry::Pose2& T_to_from);

}  // namespace echomap::mapping
