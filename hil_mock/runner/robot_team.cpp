// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_team.hpp"

#include <algorithm>
#include <utility>

namespace echomap::runner {
namespace {

constexpr std::int64_t kTeamStepNs = 1'000'000;

}  // namespace

RobotTeam::RobotTeam(std::vector<RobotSimulation*> robots) : robots_(std::move(robots)) {
  if (robots_.size() < 2) {
    return;
  }
  for (RobotSimulation* const robot : robots_) {
    robot->before_step = [this, robot] { tell_peers(*robot); };
    tell_peers(*robot);
  }
}

void RobotTeam::advance_to(std::int64_t until_ns) {
  if (robots_.size() == 1) {
    robots_.front()->advance_to(until_ns);
    return;
  }
  while (now_ns() < until_ns) {
    const std::int64_t next_ns = std::min(until_ns, (now_ns() / kTeamStepNs + 1) * kTeamStepNs);
    for (RobotSimulation* const robot : robots_) {
      robot->advance_to(next_ns);
    }
  }
}

bool RobotTeam::put_box(std::size_t robot, const Eigen::Vector2d& middle_m, double side_m) {
  const world::Polygon box_m = robots_[robot]->box_at(middle_m, side_m);
  const auto has_place = [&](const RobotSimulation* one) { return one->has_place_for(box_m); };
  if (!std::ranges::all_of(robots_, has_place)) {
    return false;
  }
  for (RobotSimulation* const one : robots_) {
    one->put_box(box_m);
  }
  return true;
}

void RobotTeam::tell_peers(RobotSimulation& robot) {
  peers_.clear();
  for (const RobotSimulation* const other : robots_) {
    const auto hull = other->world().hull();
    if (other != &robot && hull) {
      peers_.push_back(*hull);
    }
  }
  robot.set_peers(peers_);
}

}  // namespace echomap::runner
