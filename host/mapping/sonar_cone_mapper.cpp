// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_cone_mapper.hpp"

#include <stdexcept>

#include "host/mapping/sonar_evidence.hpp"

namespace echomap::mapping {

SonarConeMapper::SonarConeMapper(const SonarConeMapperParams& params)
    : params_(params), cone_(params.cone) {
  const auto& walls = params.walls;
  const bool walls_ok = walls.range_tolerance_m > 0.0 && walls.least_baseline_m > 0.0 &&
                        walls.most_baseline_m > walls.least_baseline_m &&
                        walls.longest_piece_m > 0.0;
  const bool evidence_ok = params.wall_evidence > 0.0 && params.most_wall_evidence > 0.0 &&
                           params.wall_opacity >= 0.0 && params.wall_opacity < 1.0 &&
                           params.wall_trust >= 0.0 && params.wall_trust < 1.0;
  const bool robot_ok = params.robot_radius_m >= 0.0 && params.under_robot_chance > 0.0 &&
                        params.under_robot_chance <= 1.0;
  if (!walls_ok || !evidence_ok || !robot_ok || params.same_place_m < 0.0 || params.rounds < 1) {
    throw std::invalid_argument("sonar cone mapper: a parameter is outside of its range");
  }
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
        views, cone_.params().half_angle_rad, cone_.params().max_range_m, params_.walls);
  }
  SonarEvidence evidence(views, walls, cone_, params_);
  evidence.find();
  return {evidence.grid(), evidence.counts(), walls.size()};
}

}  // namespace echomap::mapping
