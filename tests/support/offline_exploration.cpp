// SPDX-License-Identifier: MIT
#include "tests/support/offline_exploration.hpp"

#include <memory>
#include <random>

#include "hil_mock/runner/truth_map.hpp"
#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "host/evaluation/floor_seen.hpp"
#include "host/exploration/atlas_explorer.hpp"
#include "host/exploration/coverage.hpp"
#include "host/exploration/fault_watch.hpp"
#include "host/exploration/frontier.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/files/toml_reader.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::tests {

namespace {

constexpr double kTruthResolutionM = 0.01;
constexpr std::size_t kManyStops = 500;

std::string bundled(const std::string& folder, const std::string& name) {
  return std::string(ECHOMAP_SOURCE_DIR) + "/hil_mock/" + folder + "/" + name + ".toml";
}

std::unique_ptr<exploration::Explorer> explorer_for(const world::RobotParams& robot,
                                                    OfflineStrategy strategy,
                                                    std::mt19937& random) {
  if (strategy == OfflineStrategy::kFrontier) {
    exploration::FrontierParams params;
    params.navigator.costs.robot_radius_m = robot.body.radius_m;
    params.max_stops = kManyStops;
    return std::make_unique<exploration::Frontier>(params);
  }
  exploration::NxtFarthestParams params;
  params.robot_radius_m = robot.body.radius_m;
  return std::make_unique<exploration::NxtFarthest>(params, random);
}

exploration::FinishReason explore(exploration::Explorer& explorer,
                                  OfflineRobot& robot,
                                  pipeline::RobotAtlas& atlas,
                                  int& bumps) {
  auto last = exploration::MotionResult::kReached;
  for (;;) {
    const auto motion = explorer.next(atlas.pipeline().snapshot(), last);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      return finished->reason;
    }
    if (const auto changed = exploration::change_maps(atlas, motion)) {
      last = *changed;
      continue;
    }
    last = robot.execute(motion);
    bumps += last == exploration::MotionResult::kBumped ? 1 : 0;
  }
}

std::unique_ptr<exploration::Explorer> watched(const world::RobotParams& robot,
                                               const OfflineSettings& settings,
                                               std::mt19937& random) {
  if (!settings.is_watched) {
    return explorer_for(robot, settings.strategy, random);
  }
  const auto make = [&](std::size_t /*stops_made*/) {
    return std::make_unique<exploration::FaultWatch>(
        explorer_for(robot, settings.strategy, random));
  };
  return std::make_unique<exploration::AtlasExplorer>(make, 0);
}

}  // namespace

evaluation::MapTruth truth_of(const world::FloorPlan& plan) {
  const auto drawn = runner::draw_truth_map(plan, kTruthResolutionM);
  mapping::RasterMap cells(
      drawn.width, drawn.height, drawn.resolution_m, {drawn.origin_x_m, drawn.origin_y_m});
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      if (drawn.at(x, y) == runner::TruthCell::kFree) {
        cells.set({x, y}, mapping::CellState::kFree);
      }
    }
  }
  evaluation::MapTruth truth{cells, {}};
  for (const auto& wall : plan.walls()) {
    truth.walls.push_back({wall.segment.from_m, wall.segment.to_m});
  }
  return truth;
}

mapping::SonarMapperParams mapper_for(const world::RobotParams& robot) {
  mapping::SonarMapperParams params;
  params.surfaces.beam_half_angle_rad = robot.sonar.beam_half_angle_rad;
  return params;
}

world::FloorPlan bundled_room(const std::string& room) {
  return world::read_floor_plan(files::TomlReader::load(bundled("worlds", room)));
}

world::RobotParams bundled_robot(const std::string& robot) {
  return world::read_robot(files::TomlReader::load(bundled("robots", robot)));
}

OfflineRun explore_offline(const world::FloorPlan& room,
                           const world::RobotParams& robot,
                           std::uint32_t seed,
                           const OfflineSettings& settings) {
  world::RobotWorld world(room, robot, seed);
  const auto geometry = assumed_geometry(robot);
  pipeline::RobotAtlas atlas([&] {
    return pipeline::RobotPipeline(
        geometry, mapper_for(robot), {}, settings.slam ? settings.slam() : nullptr);
  });
  OfflineRobot offline_robot(world, geometry, atlas, settings.carries);
  if (settings.slam) {
    offline_robot.look_around_on_the_way();
  }
  std::mt19937 random(seed);
  const auto explorer = watched(robot, settings, random);

  OfflineRun run;
  run.reason = explore(*explorer, offline_robot, atlas, run.bumps);
  run.snapshot = atlas.pipeline().snapshot();
  run.previous_maps = atlas.previous_maps().size();
  run.joins = atlas.joins();
  run.sim_seconds = offline_robot.now_s();
  run.trajectory =
      evaluation::score_trajectory(*run.snapshot.trajectory, offline_robot.true_path());
  run.odometry =
      evaluation::score_trajectory(offline_robot.odometry_path(), offline_robot.true_path());
  const auto map = mapping::rasterize(*run.snapshot.grid);
  const auto truth = truth_of(world.plan());
  const auto& T_world_start = world.plan().T_world_start();
  run.agreement = evaluation::score_map(map, T_world_start, truth);
  run.floor_seen = evaluation::floor_seen(
      map, T_world_start, truth.cells, T_world_start.position_m(), robot.body.radius_m);
  exploration::CoverageParams coverage;
  coverage.costs.robot_radius_m = robot.body.radius_m;
  run.claimed_share = exploration::coverage_of(run.snapshot, coverage).share();
  return run;
}

}  // namespace echomap::tests
