// SPDX-License-Identifier: MIT
#include "tests/benchmarks/joining_figures.hpp"

#include <limits>
#include <random>
#include <variant>

#include <fmt/format.h>

#include "hil_mock/world/robot_world.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::bench {
namespace {

constexpr std::size_t kStops = 8;

pipeline::RobotAtlas empty_atlas(const sensors::RobotGeometry& geometry) {
  pipeline::RobotAtlasParams params;
  params.agreeing_stops = std::numeric_limits<std::size_t>::max();  // Looks, and never joins.
  return pipeline::RobotAtlas([=] { return pipeline::RobotPipeline(geometry); }, params);
}

/// Of a robot that starts somewhere in the room and makes eight stops.
pipeline::ObservationLog record_of_stops(const world::RobotParams& robot, std::uint32_t seed) {
  const world::FloorPlan room = tests::bundled_room("living_room");
  world::RobotWorld world(room, robot, seed);
  world.place(world.somewhere_else());
  const auto geometry = tests::assumed_geometry(robot);
  pipeline::RobotAtlas atlas = empty_atlas(geometry);
  tests::OfflineRobot offline_robot(world, geometry, atlas);
  exploration::NxtFarthestParams params;
  params.max_stops = kStops;
  params.stops_without_new_ground = kStops;
  std::mt19937 random(seed);
  exploration::NxtFarthest explorer(params, random);
  auto motion = explorer.next(atlas.pipeline().snapshot(), exploration::MotionResult::kReached);
  while (!std::holds_alternative<exploration::Finished>(motion)) {
    const auto result = offline_robot.execute(motion);
    motion = explorer.next(atlas.pipeline().snapshot(), result);
  }
  return atlas.record();
}

/// As RobotAtlas::join looks, with every map made anew.
void look_anew(const pipeline::RobotAtlas& atlas) {
  for (const pipeline::PreviousMap& previous : atlas.previous_maps()) {
    mapping::find_placements(
        mapping::PlaceableMap(mapping::rasterize(*previous.pipeline.snapshot().grid)),
        mapping::PlaceableMap(mapping::rasterize(*atlas.pipeline().snapshot().grid)));
  }
}

Figure attempt(std::size_t previous_maps, std::size_t repetitions) {
  const auto robot = tests::bundled_robot("uno_2wd");
  pipeline::RobotAtlas atlas = empty_atlas(tests::assumed_geometry(robot));
  record_of_stops(robot, 1).replay(atlas);
  for (std::uint32_t seed = 2; seed < 2 + previous_maps; ++seed) {
    atlas.set_aside(record_of_stops(robot, seed));
  }
  std::vector<double> kept_ms;
  std::vector<double> anew_ms;
  for (std::size_t i = 0; i < repetitions; ++i) {
    kept_ms.push_back(1e3 * processor_seconds([&] { atlas.join(); }));
    anew_ms.push_back(1e3 * processor_seconds([&] { look_anew(atlas); }));
  }
  return {fmt::format("look_for_map_in_{}_previous", previous_maps),
          tests::median(kept_ms),
          "ms",
          repetitions,
          {{"made_anew", tests::median(anew_ms)}}};
}

}  // namespace

std::vector<Figure> joining_figures(std::size_t repetitions) {
  return {attempt(1, repetitions), attempt(3, repetitions)};
}

}  // namespace echomap::bench
