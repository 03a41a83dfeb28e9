// SPDX-License-Identifier: MIT
#include "host/team_map/map_join.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/slam/stop_stand.hpp"

namespace echomap::team_map {

using mapping::MapPlacement;

void validate(const MapJoinParams& params) {
  geometry::ParameterValidator("map join")
      .positive("agreeing_stops", params.agreeing_stops)
      .positive("same_m", params.same_m)
      .positive("same_rad", params.same_rad)
      .within("min_kept_share", params.min_kept_share, 0.0, 1.0)
      .positive("undoing_lead_m", params.undoing_lead_m);
}

bool MapJoin::is_same(const geometry::Pose2& one, const geometry::Pose2& other) const {
  return slam::is_near(one, other, params_.same_m, params_.same_rad);
}

void MapJoin::update(const RobotMap& first, const RobotMap& second) {
  const auto placements = mapping::find_placements(first.map(), second.map(), params_.placement);
  joined_ ? check(placements) : look(placements);
}

void MapJoin::look(const std::vector<MapPlacement>& placements) {
  const auto sure = mapping::sure_placement(placements, params_.placement);
  if (!sure) {
    agreeing_stops_ = 0;
    return;
  }
  const bool agrees = agreeing_stops_ > 0 && is_same(*candidate_, sure->T_previous_later);
  agreeing_stops_ = agrees ? agreeing_stops_ + 1 : 1;
  candidate_ = sure->T_previous_later;
  if (agreeing_stops_ >= params_.agreeing_stops) {
    joined_ = candidate_;
    common_m_ = sure->common_m;
    ++joins_;
  }
}

void MapJoin::check(const std::vector<MapPlacement>& placements) {
  const auto same =
      std::find_if(placements.begin(), placements.end(), [&](const MapPlacement& placement) {
        return is_same(*joined_, placement.T_previous_later);
      });
  const bool holds = same != placements.end() &&
                     same->weight_m() >= params_.min_kept_share * same->known_m &&
                     placements.front().weight_m() - same->weight_m() < params_.undoing_lead_m;
  if (holds) {
    joined_ = same->T_previous_later;
    common_m_ = same->common_m;
    return;
  }
  joined_.reset();
  agreeing_stops_ = 0;
  ++undone_;
}

}  // namespace echomap::team_map
