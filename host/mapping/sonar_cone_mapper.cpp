// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_cone_mapper.hpp"

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/sonar_evidence.hpp"

namespace echomap::mapping {

SonarConeMapper::SonarConeMapper(const SonarConeMapperParams& params)
    : params_(params), cone_(params.cone) {
  const auto& walls = params.walls;
  geometry::ParameterValidator("sonar cone mapper")
      .positive("walls.range_tolerance_m", walls.range_tolerance_m)
      .positive("walls.min_baseline_m", walls.min_baseline_m)
      .above("walls.max_baseline_m", walls.max_baseline_m, walls.min_baseline_m)
      .positive("walls.longest_piece_m", walls.longest_piece_m)
      .positive("wall_evidence", params.wall_evidence)
      .positive("max_wall_evidence", params.max_wall_evidence)
      .at_least("wall_opacity", params.wall_opacity, 0.0)
      .below("wall_opacity", params.wall_opacity, 1.0)
      .at_least("wall_weight", params.wall_weight, 0.0)
      .below("wall_weight", params.wall_weight, 1.0)
      .at_least("robot_radius_m", params.robot_radius_m, 0.0)
      .positive("under_robot_chance", params.under_robot_chance)
      .at_most("under_robot_chance", params.under_robot_chance, 1.0)
      .at_least("same_place_m", params.same_place_m, 0.0)
      .at_least("rounds", params.rounds, 1);
}

void SonarConeMapper::add(const Scan& scan) {
  readings_.insert(readings_.end(), scan.begin(), scan.end());
}

SonarConeMap SonarConeMapper::map() const {
  const auto views = views_of(readings_, params_.same_place_m);
  if (views.empty()) {
    return {OccupancyGrid(params_.grid), {}, 0};
  }
  std::vector<geometry::Segment> walls;
  if (params_.is_sound) {
    walls = find_sonar_walls(
        views, cone_.params().beam_half_angle_rad, cone_.params().max_range_m, params_.walls);
  }
  SonarEvidence evidence(views, walls, cone_, params_);
  evidence.find();
  return {evidence.grid(), evidence.counts(), walls.size()};
}

}  // namespace echomap::mapping
