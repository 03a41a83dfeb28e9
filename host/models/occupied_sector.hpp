// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/sensor_reading.hpp"

namespace echomap::models {

/// Mahmood and Ridao 2017, section 3.2. The paper names alpha and beta and gives no numbers.
struct OccupiedSectorParams {
  /// alpha: an obstacle is as thick as this.
  double thickness_m = 0.1;
  /// beta: the whole opening of the beam.
  double beam_width_rad = 0.5236;
  /// z_max.
  double max_range_m = 3.0;
  /// l_occ and l_free with the prior l_0 = 0: the log-odds of 0.7 and of 0.3.
  double occupied_log_odds = 0.8473;
  double free_log_odds = -0.8473;
};

/// Inverse range sensor model of Mahmood and Ridao 2017, Algorithm 3, after Thrun et al. 2005,
/// table 9.2: all of the sector at the measured range is occupied, all before it free. What the map
/// adds, l - l_0 of their Algorithm 2, is `evidence`, in natural log-odds.
///
/// Line 8 of the paper compares the range of a cell with z_max, which would put every obstacle at
/// the sensor's end of range; Thrun et al. compare it with the measurement, and so does this.
class OccupiedSector {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit OccupiedSector(const OccupiedSectorParams& params = {});

  double evidence(const SensorReading& reading, const PolarPoint& point) const;
  double reach_m(const SensorReading& reading) const;

 private:
  OccupiedSectorParams params_;
};

}  // namespace echomap::models
