// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/sensor_reading.hpp"

namespace echomap::models {

/// A small sonar in a room: HC-SR04, NXT, EV3. Settings are ours, chosen on four logs and
/// checked on three others (docs/algorithms/sonar_cone.md).
struct SonarConeParams {
  /// Half the cone: 15 degrees of HC-SR04's data sheet; Hennessey et al. measured 16.4 +- 4.8.
  double beam_half_angle_rad = 0.2618;
  /// What the sonar hears at its edge beside what it hears on its axis.
  double edge_weight = 0.45;
  /// Echoes from farther away do not count.
  double max_range_m = 3.0;
  /// Silence says nothing of what is farther: none of them hears that reliably.
  double silent_to_m = 3.0;
  /// An obstacle is this far nearer or farther than its echo says, at most: noise and pose, and
  /// what is not quite a wall.
  double arc_half_thickness_m = 0.1;
  /// Floor nearer to the echo than this is not called free.
  double free_margin_m = 0.045;
  /// Chance that an obstacle on the axis is missed by a reading with an echo from farther off.
  double overheard_chance = 0.03;
  /// The same where nothing answered at all: a smooth wall throws the sound aside.
  double silent_chance = 0.2;
  /// Evidence, in log-odds, that one echo has to give to all of its arc together, and at most to a
  /// cell of it.
  double arc_evidence = 3.0;
  double cell_evidence = 1.1;
};

/// Our inverse model of one sonar reading. The whole cone is spoken of, weighted by the angle off
/// its axis (equation 1); an obstacle is somewhere on the arc. On its own it knows nothing of other
/// readings: mapping::SonarConeMapper shares the arc's evidence by what they say.
class SonarCone {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SonarCone(const SonarConeParams& params = {});

  const SonarConeParams& params() const { return params_; }

  /// (1) w(phi) = 1 - (1 - w_edge) (phi / half angle)^2; 0 outside of the cone.
  double weight(double off_axis_rad) const;
  /// (2) Chance that an obstacle at the point goes with this reading although it is nearer than the
  /// echo: 1 - w (1 - miss); 1 where the reading says nothing of the point.
  double miss_chance(const SensorReading& reading, const PolarPoint& point) const;
  /// The range from which on the reading says nothing more of free floor.
  double free_to_m(const SensorReading& reading) const;
  bool on_arc(const SensorReading& reading, const PolarPoint& point) const;

  /// Natural log-odds; an arc's cells of `cell_m` share the arc's evidence evenly.
  double evidence(const SensorReading& reading, const PolarPoint& point) const;
  double reach_m(const SensorReading& reading) const;

 private:
  SonarConeParams params_;
};

}  // namespace echomap::models
