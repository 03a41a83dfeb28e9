// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_world.hpp"

#include <stdexcept>
#include <string>

#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/start_places.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

world::FloorPlan load_plan(const DeviceOptions& options) {
  const auto path = files::bundled_file(options.world, "hil_mock/worlds", "world");
  const world::FloorPlan plan = world::read_floor_plan(files::TomlReader::load(path));
  return options.sources ? plan.with_radiation(*options.sources) : plan;
}

/// Puts another driver between board and motors.
void fit_driver(world::DriverChip driver, world::DriveParams& drive) {
  drive.driver = driver;
  if (driver == world::DriverChip::kServo) {
    drive.dead_zone_duty = 0.0;
  }
}

world::RobotParams load_robot(const DeviceOptions& options) {
  const auto path = files::bundled_file(options.robot, "hil_mock/robots", "robot");
  world::RobotParams robot = world::read_robot(files::TomlReader::load(path));
  if (!options.driver.empty()) {
    fit_driver(world::driver_named(options.driver), robot.drive);
  }
  return robot;
}

void check_apart(const std::vector<geometry::Pose2>& starts, double radius_m) {
  for (std::size_t i = 0; i < starts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((starts[i].position_m() - starts[k].position_m()).norm() < 2.0 * radius_m) {
        throw files::ConfigError("--starts: the robots " + std::to_string(k) + " and " +
                                 std::to_string(i) + " stand in one another");
      }
    }
  }
}

}  // namespace

std::unique_ptr<world::RobotWorld> load_world(const DeviceOptions& options) {
  const world::RobotParams robot = load_robot(options);
  try {
    const world::FloorPlan plan = load_plan(options);
    return std::make_unique<world::RobotWorld>(
        options.T_world_start ? plan.starting_at(*options.T_world_start) : plan,
        robot,
        options.seed,
        options.part_faults);
  } catch (const std::invalid_argument& fault) {
    throw files::ConfigError(options.robot + " in " + options.world + ": " + fault.what());
  }
}

std::vector<geometry::Pose2> device_starts(const DeviceOptions& options) {
  const double radius_m = load_robot(options).body.radius_m;
  if (!options.starts.empty()) {
    check_apart(options.starts, radius_m);
    return options.starts;
  }
  const world::FloorPlan plan = load_plan(options);
  const geometry::Pose2 T_world_first = options.T_world_start.value_or(plan.T_world_start());
  if (options.robots == 1 && !options.draws_starts) {
    return {T_world_first};
  }
  world::StartRules rules;
  rules.robots = options.robots;
  rules.apart_m = options.apart_m;
  rules.radius_m = radius_m;
  try {
    return world::draw_starts(plan,
                              rules,
                              options.draws_starts ? std::nullopt : std::optional(T_world_first),
                              options.seed);
  } catch (const std::invalid_argument& fault) {
    throw files::ConfigError(options.world + ": " + fault.what() +
                             "\n  next: fewer --robots, less --apart or a larger --world");
  }
}

}  // namespace echomap::runner
