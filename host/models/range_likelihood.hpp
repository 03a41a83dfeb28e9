// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>

namespace echomap::models {

/// The range that a sensor should measure in a map.
struct ExpectedRange {
  /// Range of the nearest surface that the sensor could detect; empty where none is in range.
  std::optional<double> range_m;
  /// The nearest surface is seen at oblique incidence, as at the edge of a cone: a smooth one
  /// reflects sound or light away.
  bool is_oblique = false;
  /// The known floor ends at that range, and not at a surface: what is there, or farther off, has
  /// not been seen.
  bool is_unseen = false;
};

/// How likely a reading is: a density, one over metres, of a range; a probability of no return.
template <typename Model>
concept RangeLikelihood = requires(const Model& model, std::optional<double> range_m) {
  { model.likelihood(range_m, ExpectedRange{}) } -> std::same_as<double>;
};

/// Chances of what becomes of a ping, and the noise of the one that hits.
struct BeamModelParams {
  /// Noise of a range that is what the map says: of the sensor, of the map's cells and of the pose
  /// between particles.
  double hit_stddev_m = 0.1;
  /// Chances; what they leave to 1 is that of a hit.
  double short_chance = 0.05;   ///< Something stands before it that the map does not hold.
  double missed_chance = 0.05;  ///< What the map says is not seen, and something behind it is.
  double silent_chance = 0.05;  ///< Nothing returns although something stands there.
  double random_chance = 0.05;  ///< Any range at all.
  /// Additional chances at oblique incidence.
  double oblique_missed_chance = 0.05;
  double oblique_silent_chance = 0.05;
  /// Where the known floor ends: of silence, and of a surface right there, as floor is known up to
  /// where an echo came from. What is left is spread evenly from there on.
  double unseen_silent_chance = 0.2;
  double unseen_edge_chance = 0.35;
  double unseen_edge_stddev_m = 0.15;
  double max_range_m = 4.0;
};

/// The beam model of range finders (Thrun, Burgard and Fox 2005, equation 6.12) with a chance more:
/// that the nearest thing is not seen, as a smooth wall is not by a sonar, so that what answers
/// stands farther off. Short readings are spread evenly up to the expected range. Where the map
/// does not know what a ray meets, the model says little of the reading, and not that nothing is
/// there.
class BeamModel {
 public:
  /// Throws std::invalid_argument for chances that leave nothing for a hit, and for a noise or
  /// range that is not above 0.
  explicit BeamModel(const BeamModelParams& params);

  double likelihood(std::optional<double> range_m, const ExpectedRange& expected) const;

 private:
  double unseen_likelihood(std::optional<double> range_m, double edge_m) const;

  BeamModelParams params_;
};

/// A small sonar with a wide cone whose expected range is that of the first obstacle in the cone:
/// HC-SR04, NXT, EV3. The chances are between what a room of mirrors and one of cloth would have:
/// in the simulated rooms of smooth walls what is seen at oblique incidence is heard by 25 to 35 of
/// 100 pings, missed by 30 to 36 and silent for 30 to 42; what is not, is heard by 86 to 93.
BeamModelParams sonar_cone_returns();
/// The same in a map that a robot has made of its echoes. There the sonar was silent for 15 of 100
/// pings where the map has a wall that is faced, for 43 where it is seen at oblique incidence and
/// for 37 where the known floor ends; the first two are set a little lower, as above.
BeamModelParams sonar_cone_returns_in_own_map();
/// A laser scanner that sees nearly everything, among people.
BeamModelParams laser_returns();

}  // namespace echomap::models
