// SPDX-License-Identifier: MIT
#include "host/localization/contact_model.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "host/geometry/parameter_validator.hpp"
#include "host/localization/view_model.hpp"

namespace echomap::localization {

namespace {

constexpr double kFloorCellM = 0.05;

double checked_radius(double radius_m) {
  geometry::ParameterValidator("contact model").positive("radius_m", radius_m);
  return radius_m;
}

mapping::RasterMap floor_of(const mapping::PolygonMap& map) {
  mapping::RasterMap floor = rasterize(map, kFloorCellM);
  for (std::int32_t y = 0; y < floor.rows(); ++y) {
    for (std::int32_t x = 0; x < floor.columns(); ++x) {
      if (floor.state({x, y}) == mapping::CellState::kFree) {
        return floor;
      }
    }
  }
  throw std::invalid_argument("contact model: no cell of the map is floor");
}

}  // namespace

ContactModel::ContactModel(const mapping::PolygonMap& map,
                           double radius_m,
                           const models::ContactParams& params)
    : view_(map), floor_(floor_of(map)), radius_m_(checked_radius(radius_m)), likelihood_(params) {}

void ContactModel::update_weights(float likelihood_exponent,
                                  ParticleRange range,
                                  Particles& particles) const {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const geometry::Pose2 T_map_robot = particles.pose(i);
    if (!view_.is_floor(T_map_robot.position_m())) {
      particles.log_weight[i] += kRejectedLog;
      continue;
    }
    const models::WallAhead wall = view_.wall_ahead(T_map_robot, radius_m_);
    particles.log_weight[i] +=
        likelihood_exponent * static_cast<float>(std::log(likelihood_.likelihood(reading_, wall)));
  }
}

}  // namespace echomap::localization
