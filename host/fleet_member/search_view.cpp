// SPDX-License-Identifier: MIT
#include "host/fleet_member/search_view.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::fleet_member {
namespace {

using fleet::FleetMap;
using fleet::FleetRobot;
using geometry::Pose2;
using source_search::SourceVerdict;

/// Transform from a robot's odometry frame to the requested map, by one submap.
Pose2 T_own_odom(const team_map::Submap& submap,
                 const Pose2& T_team_submap,
                 const Pose2& T_team_own) {
  return T_team_own.inverse() * T_team_submap * submap.readings.front().mark.T_odom_robot.inverse();
}

/// Batches whose submap is not placed yet are left out.
void add_readings(const FleetMap& map,
                  const SharedReading& like,
                  const std::vector<Pose2>& T_team_submaps,
                  const Pose2& T_team_own,
                  std::vector<SharedReading>& readings) {
  if (map.source_batches == nullptr) {
    return;
  }
  const auto first = static_cast<std::ptrdiff_t>(readings.size());
  for (const fleet_messages::SourceBatch& batch : *map.source_batches) {
    const std::size_t index = batch.submap_index;
    if (index >= std::min(T_team_submaps.size(), map.record->submaps.size())) {
      continue;
    }
    const Pose2 T_own = T_own_odom(map.record->submaps[index], T_team_submaps[index], T_team_own);
    for (const fleet_messages::SourceReading& reading : batch.readings) {
      SharedReading shared = like;
      shared.stamp_s = reading.stamp_s;
      shared.reading.at_m = T_own * reading.T_odom_robot.position_m();
      shared.reading.value = reading.value;
      shared.reading.dwell_s = reading.dwell_s;
      readings.push_back(shared);
    }
  }
  std::stable_sort(readings.begin() + first,
                   readings.end(),
                   [](const auto& one, const auto& other) { return one.stamp_s < other.stamp_s; });
}

void add_robot(const FleetRobot& robot,
               const TeamPicture& picture,
               const std::string& own_map,
               double place_stddev_m,
               SearchView& view) {
  const team_map::TeamComponent* component = picture.team().component_of(own_map);
  if (component == nullptr) {
    return;
  }
  const auto place_of = [&](const std::string& name) {
    return std::find(component->robots.begin(), component->robots.end(), name) -
           component->robots.begin();
  };
  const Pose2& T_team_own = component->T_team_maps[static_cast<std::size_t>(place_of(own_map))];
  for (const FleetMap& map : robot.maps) {
    const std::string name = map_name(robot.name, map.number);
    const auto at = static_cast<std::size_t>(place_of(name));
    if (at == component->robots.size()) {
      continue;
    }
    SharedReading like;
    like.map = name;
    const auto relative = picture.team().relative_pose(own_map, name);
    like.reading.position_stddev_m =
        std::hypot(place_stddev_m, relative ? relative->position_stddev_m : 0.0);
    add_readings(map, like, component->T_team_submaps[at], T_team_own, view.readings);
  }
}

}  // namespace

SearchView search_view(const fleet::FleetState& state,
                       const TeamPicture& picture,
                       const std::string& map,
                       const std::string& without,
                       double place_stddev_m) {
  SearchView view;
  for (const FleetRobot& other : state.robots) {
    if (other.name == without) {
      continue;
    }
    add_robot(other, picture, map, place_stddev_m, view);
    if (!other.search) {
      continue;
    }
    const auto relative =
        picture.team().relative_pose(map, map_name(other.name, other.search_map_number));
    for (const source_search::PlannedDwell& dwell : other.search->plan) {
      if (relative) {
        view.plans.push_back({relative->T_own_peer * dwell.at_m, dwell.dwell_s});
      }
    }
    // A retained report of a robot that is not here may be of another search.
    const bool is_of_now = other.has_reported && other.search->verdict != SourceVerdict::kUndecided;
    if (is_of_now && !view.finding) {
      view.finding = TeamFinding{other.name, *other.search, std::nullopt};
      if (relative && other.search->verdict == SourceVerdict::kFound) {
        view.finding->at_m = relative->T_own_peer * other.search->at_m;
      }
    }
  }
  return view;
}

}  // namespace echomap::fleet_member
