// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace echomap::source_search {

/// What a scalar sensor measures: pulses that it counts, or a level.
enum class SensorKind : std::uint8_t { kPulses, kLevel };

/// One reading of the sensor, where the robot's map has it. Readings of other robots are the same,
/// at their places in this map.
struct FieldReading {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double value = 0.0;              ///< Pulses counted, or the level.
  double dwell_s = 0.0;            ///< Over which pulses were counted; a level needs none.
  double position_stddev_m = 0.0;  ///< Of `at_m`, along each axis.
};

/// The field of one source. Strengths are what the source adds one metre away: pulses a second, or
/// levels in the sensor's unit. Values without another source are ours, chosen in simulation.
struct FieldParams {
  SensorKind kind = SensorKind::kPulses;
  /// Height of the sensor over a source right below it, or of the source over the sensor.
  double standoff_m = 0.1;
  /// The weakest and the strongest source considered; the prior of the logarithm is uniform in
  /// between.
  double min_strength = 1.0;
  double max_strength = 50.0;
  /// The same for the background.
  double min_background = 0.02;
  double max_background = 10.0;
  /// Attenuations of a metre of solid, as a factor exp(-attenuation), equally likely: none, that of
  /// brick for hard gamma rays, and one that stops most.
  std::vector<double> attenuations_per_m = {0.0, 6.0, 20.0};
  /// Standard deviation of one reading of a level.
  double level_stddev = 1.0;
  /// Relative error of the source's share of a rate, from the distance law and the sensor.
  double rate_error = 0.05;
  /// Relative error of the exponent of the shielding, from the thickness of walls in the map and
  /// the attenuation.
  double shield_error = 0.3;
  /// Relative variation of the background from place to place.
  double background_error = 0.1;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const FieldParams& params);

/// Response to a source of strength 1 at that distance, behind that much solid: inverse square of
/// the distance, and Beer and Lambert's law.
double response(double distance_m,
                double solid_m,
                double attenuation_per_m,
                const FieldParams& params);

/// Relative variance of that response for a variance of the position: first and second order of the
/// inverse square, and the error of the shielding.
double response_variance(double distance_m,
                         double solid_m,
                         double attenuation_per_m,
                         double position_variance_m2,
                         const FieldParams& params);

}  // namespace echomap::source_search
