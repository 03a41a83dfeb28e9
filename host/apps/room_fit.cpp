// SPDX-License-Identifier: MIT
#include "host/apps/room_fit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "host/evaluation/floor_seen.hpp"

namespace echomap::apps {

double share_in_reach(const evaluation::Truth& truth, double robot_radius_m) {
  const mapping::RasterMap& floor = truth.map.cells;
  const Eigen::Vector2d start_m = truth.trajectory.front().T_world_robot.position_m();
  const auto size_of = [&](double radius_m) {
    return static_cast<double>(evaluation::floor_in_reach_m(floor, start_m, radius_m).size());
  };
  return size_of(robot_radius_m) / std::max(1.0, size_of(floor.resolution_m()));
}

RunEnding with_narrow_room(RunEnding ending,
                           const evaluation::Truth& truth,
                           const session::RobotProfile& profile,
                           const std::string& next) {
  // The bundled robots get over 99 % of each bundled room but for one that is made for an e-puck.
  constexpr double kFittingShare = 0.9;
  if (!ending.finished() || truth.trajectory.empty()) {
    return ending;
  }
  const double share = share_in_reach(truth, profile.body_radius_m);
  if (share < kFittingShare) {
    ending.code = console::ExitCode::kUnfinished;
    ending.why = fmt::format(
        "{}; but robot '{}', {:.0f} cm wide, does not fit through the room: from its start it can "
        "get over {:.0f} % of the floor",
        ending.why,
        profile.name,
        200.0 * profile.body_radius_m,
        100.0 * share);
    ending.next = "a larger room: " + next;
  }
  return ending;
}

}  // namespace echomap::apps
