// SPDX-License-Identifier: MIT
#include "host/sensors/incidence_noise.hpp"

#include <cmath>
#include <map>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::sensors {

namespace {

IncidenceNoise noise_of(const std::vector<double>& residuals_m) {
  IncidenceNoise noise;
  noise.readings = residuals_m.size();
  const auto count = static_cast<double>(residuals_m.size());
  for (const double residual_m : residuals_m) {
    noise.bias_m += residual_m / count;
  }
  double squares_m2 = 0.0;
  for (const double residual_m : residuals_m) {
    squares_m2 += std::pow(residual_m - noise.bias_m, 2);
  }
  noise.stddev_m = residuals_m.size() < 2 ? 0.0 : std::sqrt(squares_m2 / (count - 1.0));
  return noise;
}

}  // namespace

std::vector<IncidenceNoise> noise_by_incidence(std::span<const SweptWall> walls, double step_rad) {
  geometry::ParameterValidator("incidence noise").positive("step_rad", step_rad);
  std::map<int, std::vector<double>> residuals_m;
  for (const SweptWall& wall : walls) {
    for (const WallReading& reading : wall.heard) {
      residuals_m[static_cast<int>(reading.incidence_rad / step_rad)].push_back(reading.residual_m);
    }
  }
  std::vector<IncidenceNoise> rows;
  for (const auto& [step, of_step_m] : residuals_m) {
    rows.push_back(noise_of(of_step_m));
    rows.back().from_rad = step * step_rad;
    rows.back().to_rad = (step + 1) * step_rad;
  }
  return rows;
}

}  // namespace echomap::sensors
