// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/fleet_connection.hpp"
#include "host/apps/fleet_watch.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/fleet_messages/content_hash.hpp"

namespace echomap::apps {
namespace {

using nlohmann::ordered_json;

/// A robot that is here has said so within the time that is listened.
const char* words_of(const fleet::FleetRobot& robot) {
  switch (robot.attendance) {
    case fleet::Attendance::kLeft:
      return "left";
    case fleet::Attendance::kGone:
      return "gone";
    case fleet::Attendance::kAlive:
      break;
  }
  return robot.has_reported ? "alive" : "silent";
}

std::string words_of_map(const fleet::FleetRobot& robot, const team_map::TeamComponent* component) {
  if (robot.maps.empty()) {
    return "no map yet";
  }
  return component != nullptr && component->robots.size() > 1
             ? fmt::format("one map with {} others", component->robots.size() - 1)
             : "a map of its own";
}

std::size_t submaps_of(const fleet::FleetRobot& robot) {
  std::size_t submaps = 0;
  for (const fleet::FleetMap& map : robot.maps) {
    submaps += map.record->submaps.size();
  }
  return submaps;
}

/// Whether a robot has all objects that are known of.
bool is_up_to_date(const fleet::FleetRobot& robot, const fleet::FleetState& state) {
  return robot.known_set == state.object_set;
}

ordered_json json_of(const fleet::FleetRobot& robot,
                     const fleet::FleetState& state,
                     const fleet_member::TeamPicture& picture) {
  const auto* component =
      picture.team().component_of(fleet_member::map_name(robot.name, robot.map_number));
  return {{"robot", robot.name},
          {"presence", words_of(robot)},
          {"heard_s_ago", robot.age_s},
          {"submaps", submaps_of(robot)},
          {"up_to_date", is_up_to_date(robot, state)},
          {"joined_to", component != nullptr ? ordered_json(component->robots) : ordered_json()}};
}

}  // namespace

ExitCode run_fleet_status(const FleetStatusOptions& options) {
  FleetWatch watch(options.as);
  watch.listen_for(options.listen_s);
  watch.require_own_account();
  const fleet::FleetState state = watch.state();
  fleet_member::TeamPicture picture;
  picture.take_with_joins(state);

  auto robots = ordered_json::array();
  for (const fleet::FleetRobot& robot : state.robots) {
    robots.push_back(json_of(robot, state, picture));
    const auto* component =
        picture.team().component_of(fleet_member::map_name(robot.name, robot.map_number));
    console::print(fmt::format("{:<16} {:<6} {:>3} submaps  {}  {}",
                               robot.name,
                               words_of(robot),
                               submaps_of(robot),
                               is_up_to_date(robot, state) ? "has all" : "misses some",
                               words_of_map(robot, component)));
  }
  const bool is_empty = state.robots.empty();
  console::print(is_empty ? fmt::format("nobody is in the fleet '{}'\n  next: echomap fleet join "
                                        "--as {}",
                                        watch.fleet(),
                                        options.as.string())
                          : fmt::format("{} robots, {} objects, set {}",
                                        state.robots.size(),
                                        state.objects,
                                        fleet_messages::hex(state.object_set)));
  warn_of_refused(watch.statistics());
  write_report(options.json,
               {{"fleet", watch.fleet()},
                {"robots", robots},
                {"objects", state.objects},
                {"object_set", fleet_messages::hex(state.object_set)},
                {"messages_heard", watch.statistics().messages},
                {"messages_refused", refused_by_reason(watch.statistics())}});
  return is_empty ? ExitCode::kUnfinished : ExitCode::kOk;
}

}  // namespace echomap::apps
