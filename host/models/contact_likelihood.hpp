// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::models {

/// What a robot that only feels its walls says at one moment.
struct ContactReading {
  bool bump_left = false;
  bool bump_right = false;
  /// Infra-red light of an emitter on the robot comes back from a wall ahead.
  bool virtual_wall = false;
};

/// What a map lets it expect.
struct WallAhead {
  /// From the body's edge to the nearest wall in front of the robot's axle, and where that wall
  /// is, counter-clockwise from straight ahead.
  double gap_m = 0.0;
  double bearing_rad = 0.0;
  /// From the body's edge straight ahead to a wall.
  double ahead_m = 0.0;
};

/// An iRobot Create, as Mukherjee et al. have it.
struct ContactParams {
  /// Of the place of a wall that is felt: what the outline of its map is right to; ours.
  double contact_stddev_m = 0.05;
  /// The light comes back from up to there, and that is as sharp; ours. The paper's 0.8 for the
  /// light (section V-B) has no unit and is called both variance and sigma.
  double light_reach_m = 0.375;
  double light_stddev_m = 0.05;
  /// Chance that a sensor says something else; ours. It bounds what one contact can do.
  double wrong_chance = 0.02;
  /// A bumper reaches so far over to the other side.
  double overlap_rad = 0.35;
};

/// The sensor model of Mukherjee et al., section V-B: bumper and virtual wall tell that a wall is
/// here, with a normal error of its place. What does not touch says so too: there is no wall where
/// the body is.
class ContactLikelihood {
 public:
  /// Throws std::invalid_argument for a parameter out of its range.
  explicit ContactLikelihood(const ContactParams& params = {});

  /// Relative to a contact at the very place, within (0, 1].
  double likelihood(const ContactReading& reading, const WallAhead& wall) const;

 private:
  double of_bumper(const ContactReading& reading, const WallAhead& wall) const;
  double of_light(bool is_seen, double ahead_m) const;

  ContactParams params_;
};

}  // namespace echomap::models
