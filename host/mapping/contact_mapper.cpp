// SPDX-License-Identifier: MIT
#include "host/mapping/contact_mapper.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/disc_insertion.hpp"
#include "host/models/gaussian_patch.hpp"

namespace echomap::mapping {
namespace {

const ContactMapperParams& validated(const ContactMapperParams& params) {
  geometry::ParameterValidator("contact mapper")
      .at_least("body_radius_m", params.body_radius_m, 0)
      .positive("body_step_m", params.body_step_m)
      .require(params.infrared_reach_m > 0.0 || params.T_robot_infrared.empty(),
               "infrared_reach_m is above 0 where there are infra-red sensors")
      .below("body_centilogits", params.body_centilogits, 0)
      .below("silent_centilogits", params.silent_centilogits, 0)
      .at_least("same_wall_rad", params.same_wall_rad, 0);
  return params;
}

}  // namespace

ContactMapper::ContactMapper(const ContactMapperParams& params, const OccupancyGridParams& grid)
    : params_(validated(params)),
      grid_(grid),
      answers_(params.infrared),
      silence_({params.infrared.hit_centilogits, params.silent_centilogits}) {}

void ContactMapper::pass_over(const geometry::Pose2& T_map_robot) {
  const Eigen::Vector2d& here_m = T_map_robot.position_m();
  const bool has_moved = !last_stand_m_ || (here_m - *last_stand_m_).norm() >= params_.body_step_m;
  if (params_.body_radius_m > 0.0 && has_moved) {
    insert_disc(here_m, params_.body_radius_m, params_.body_centilogits, grid_);
    last_stand_m_ = here_m;
  }
}

void ContactMapper::bump(const geometry::Pose2& T_map_robot,
                         bool left,
                         bool right,
                         double bumper_radius_m) {
  const double radius_m = bumper_radius_m > 0.0 ? bumper_radius_m : params_.body_radius_m;
  if (radius_m == 0.0 || (!left && !right)) {
    return;
  }
  const bool both = left && right;
  const double bearing_rad = both ? 0.0 : std::copysign(params_.one_sided_bump_rad, left ? 1 : -1);
  const double width_m = (both ? 1.0 : 0.5) * radius_m;
  insert_bump(T_map_robot * geometry::Pose2(0.0, 0.0, bearing_rad),
              models::bumper_line(radius_m, width_m),
              params_.bump,
              grid_);
}

void ContactMapper::add_ranges(const geometry::Pose2& T_map_robot,
                               std::span<const std::optional<double>> range_m) {
  const std::size_t count = std::min(range_m.size(), params_.T_robot_infrared.size());
  for (std::size_t i = 0; i < count; ++i) {
    const geometry::Pose2 T_map_sensor = T_map_robot * params_.T_robot_infrared[i];
    const bool is_silent = !range_m[i] || sees_an_oblique_wall(range_m.first(count), i);
    const Ray ray{{range_m[i].value_or(params_.infrared_reach_m), 0.0}, !is_silent};
    (is_silent ? silence_ : answers_).insert(T_map_sensor, {&ray, 1}, grid_);
  }
}

bool ContactMapper::sees_an_oblique_wall(std::span<const std::optional<double>> range_m,
                                         std::size_t i) const {
  for (std::size_t j = 0; j < range_m.size(); ++j) {
    const double apart_rad = std::abs(geometry::angle_between(
        params_.T_robot_infrared[i].heading_rad(), params_.T_robot_infrared[j].heading_rad()));
    if (apart_rad <= params_.same_wall_rad && range_m[j] && range_m[j] < range_m[i]) {
      return true;
    }
  }
  return false;
}

OccupancyGrid with_contact_evidence(OccupancyGrid far,
                                    const OccupancyGrid& near,
                                    int max_centilogits) {
  const CellBounds& bounds = near.bounds();
  for (geometry::CellIndex cell = bounds.min; cell.y <= bounds.max.y; ++cell.y) {
    for (cell.x = bounds.min.x; cell.x <= bounds.max.x; ++cell.x) {
      if (const auto evidence = near.centilogits(cell)) {
        const int from_afar = far.centilogits(cell).value_or(0);
        far.add(cell,
                std::clamp(from_afar, -max_centilogits, max_centilogits) - from_afar + *evidence);
      }
    }
  }
  return far;
}

}  // namespace echomap::mapping
