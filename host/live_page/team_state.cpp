// SPDX-License-Identifier: MIT
#include "host/live_page/team_state.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace echomap::live_page {
namespace {

using nlohmann::ordered_json;

/// Millimetres are more than a page shows.
double to_millimetres(double metres) { return std::round(metres * 1000.0) / 1000.0; }

ordered_json point(const Eigen::Vector2d& at_m) {
  return ordered_json::array({to_millimetres(at_m.x()), to_millimetres(at_m.y())});
}

ordered_json point(const std::optional<Eigen::Vector2d>& at_m) {
  return at_m ? point(*at_m) : ordered_json();
}

const char* name_of(Presence presence) {
  switch (presence) {
    case Presence::kLeft:
      return "left";
    case Presence::kGone:
      return "gone";
    case Presence::kAlive:
      break;
  }
  return "alive";
}

ordered_json robot_json(const TeamRobot& robot) {
  auto trail = ordered_json::array();
  for (const Eigen::Vector2d& at_m : robot.trail_m) {
    trail.push_back(to_millimetres(at_m.x()));
    trail.push_back(to_millimetres(at_m.y()));
  }
  ordered_json pose;
  if (robot.T_map_robot) {
    pose = {{"x", to_millimetres(robot.T_map_robot->x_m())},
            {"y", to_millimetres(robot.T_map_robot->y_m())},
            {"heading", to_millimetres(robot.T_map_robot->heading_rad())}};
  }
  return {{"name", robot.name},
          {"presence", name_of(robot.presence)},
          {"radius_m", robot.radius_m},
          {"stops", robot.stops},
          {"pose", pose},
          {"trail", trail},
          {"claim", point(robot.claim_m)}};
}

ordered_json field_json(const TeamField& field) {
  return {{"origin", point(field.origin_m)},
          {"resolution_m", field.resolution_m},
          {"columns", field.columns},
          {"cells", field.cells}};
}

ordered_json source_json(const TeamSource& source) {
  return {{"verdict", source.verdict},
          {"at", point(source.at_m)},
          {"radius_m", source.radius_m},
          {"none_probability", source.none_probability},
          {"field", source.field ? field_json(*source.field) : ordered_json()}};
}

}  // namespace

ordered_json to_json(const TeamState& team) {
  auto robots = ordered_json::array();
  for (const TeamRobot& robot : team.robots) {
    robots.push_back(robot_json(robot));
  }
  return {{"robots", robots}, {"source", team.source ? source_json(*team.source) : ordered_json()}};
}

}  // namespace echomap::live_page
