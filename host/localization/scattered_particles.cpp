// SPDX-License-Identifier: MIT
#include "host/localization/scattered_particles.hpp"

#include <numbers>

#include "host/models/uniform_sample.hpp"

namespace echomap::localization {

Particles scattered_particles(const mapping::RasterMap& map,
                              std::size_t count,
                              std::mt19937& random) {
  const auto floor_m = mapping::centers_m(map, mapping::CellState::kFree);
  Particles particles;
  if (floor_m.empty()) {
    return particles;
  }
  const auto uniform = [&random] { return models::uniform_sample(random); };
  const auto cells = static_cast<double>(floor_m.size());
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& center_m = floor_m[static_cast<std::size_t>(uniform() * cells)];
    const double x_m = center_m.x() + map.resolution_m() * (uniform() - 0.5);
    const double y_m = center_m.y() + map.resolution_m() * (uniform() - 0.5);
    const double heading_rad = (2.0 * uniform() - 1.0) * std::numbers::pi;
    particles.set_pose(i, {x_m, y_m, heading_rad});
  }
  return particles;
}

}  // namespace echomap::localization
