// SPDX-License-Identifier: MIT
#include "host/localization/contact_model.hpp"

#include <cmath>

#include "host/localization/view_model.hpp"

namespace echomap::localization {

namespace {

constexpr double kFloorCellM = 0.05;

}  // namespace

ContactModel::ContactModel(const mapping::PolygonMap& map,
                           double radius_m,
                           const models::ContactParams& params)
    : view_(map), floor_(rasterize(map, kFloorCellM)), radius_m_(radius_m), likelihood_(params) {}

void ContactModel::weigh(float temper, ParticleRange range, Particles& particles) const {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const geometry::Pose2 T_map_robot = particles.pose(i);
    if (!view_.is_floor(T_map_robot.position_m())) {
      particles.log_weight[i] += kRejectedLog;
      continue;
    }
    const models::WallAhead wall = view_.wall_ahead(T_map_robot, radius_m_);
    particles.log_weight[i] +=
        temper * static_cast<float>(std::log(likelihood_.likelihood(reading_, wall)));
  }
}

}  // namespace echomap::localization
