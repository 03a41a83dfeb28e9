// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace echomap::source_search {

/// What a scalar sensor says: pulses that it counts, or a level that it measures.
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
  /// Between the sensor and a source that lies right under or over it: the height of the one over
  /// the other.
  double standoff_m = 0.1;
  /// The weakest source that counts, and the strongest; its logarithm is uniform in between.
  double min_strength = 1.0;
  double max_strength = 50.0;
  /// The same of the background.
  double min_background = 0.02;
  double max_background = 10.0;
  /// What a metre of solid takes away, as a factor exp(-attenuation): each is as likely. Nothing,
  /// brick for hard gamma rays, and what stops most.
  std::vector<double> attenuations_per_m = {0.0, 6.0, 20.0};
  /// Of one reading of a level.
  double level_stddev = 1.0;
  /// Relative error of the source's share of a rate: of the distance law and the sensor.
  double rate_error = 0.05;
  /// Relative error of the exponent of what is shielded: of the thickness of walls in the map and
  /// of the attenuation.
  double shield_error = 0.3;
  /// How much the background differs from place to place, relatively.
  double background_error = 0.1;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const FieldParams& params);

/// What a source of strength 1 adds in that distance, behind so much solid: inverse square of the
/// distance, and Beer and Lambert's law.
double response(double distance_m,
                double solid_m,
                double attenuation_per_m,
                const FieldParams& params);

/// Relative variance of that response, where the distance is known to so much: first and second
/// order of the inverse square, and what is not known of the shielding.
double response_variance(double distance_m,
                         double solid_m,
                         double attenuation_per_m,
                         double position_variance_m2,
                         const FieldParams& params);

}  // namespace echomap::source_search
