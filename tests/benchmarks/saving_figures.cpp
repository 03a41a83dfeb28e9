// SPDX-License-Identifier: MIT
#include "tests/benchmarks/saving_figures.hpp"

#include <chrono>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <variant>

#include "hil_mock/world/robot_world.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/slam/slam_methods.hpp"
#include "tests/support/median.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

constexpr double kLongS = 1200.0;

/// A record, and that of the same robot a stop before.
struct Records {
  pipeline::ObservationLog before;
  pipeline::ObservationLog now;
};

/// Of a robot that goes about the living room whether it sees new ground or not, into `atlas`.
Records explore(pipeline::RobotAtlas& atlas, const world::RobotParams& params) {
  world::RobotWorld world(tests::bundled_room("living_room"), params, 1);
  tests::OfflineRobot robot(world, tests::assumed_geometry(params), atlas);
  robot.look_around_on_the_way();
  exploration::NxtFarthestParams endless;
  endless.max_stops = std::numeric_limits<std::size_t>::max();
  endless.stops_without_new_ground = endless.max_stops;
  std::mt19937 random(1);
  exploration::NxtFarthest explorer(endless, random);
  Records records;
  auto result = exploration::MotionResult::kReached;
  while (robot.now_s() < kLongS) {
    const auto motion = explorer.next(atlas.pipeline().snapshot(), result);
    if (std::holds_alternative<exploration::Finished>(motion)) {
      break;
    }
    result = robot.execute(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      records.before = std::exchange(records.now, atlas.record());
    }
  }
  return records;
}

template <class Work>
double milliseconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Figure size_of(const std::string& name, const std::filesystem::path& file) {
  return {name, 1e-3 * static_cast<double>(std::filesystem::file_size(file)), "kB", 1, {}};
}

}  // namespace

std::vector<Figure> saving_figures(std::size_t repetitions) {
  const auto params = tests::bundled_robot("uno_2wd");
  const auto geometry = tests::assumed_geometry(params);
  pipeline::RobotAtlas atlas([&] {
    return pipeline::RobotPipeline(geometry, {}, {}, slam::slam_by_name("multiscan").make());
  });
  const Records records = explore(atlas, params);
  const tests::ScratchFolder folder;
  std::vector<double> graph_ms;
  graph_ms.reserve(repetitions);
  for (std::size_t i = 0; i < repetitions; ++i) {
    graph_ms.push_back(milliseconds_of([&] {
      exports::write_pose_graph_g2o(folder / "pose_graph.g2o",
                                    atlas.pipeline().slam()->factor_graph());
    }));
  }
  return {{"stops_of_20_minutes", static_cast<double>(records.now.scans()), "stops", 1, {}},
          size_of("pose_graph_of_20_minutes", folder / "pose_graph.g2o"),
          {"save_pose_graph", tests::median(graph_ms), "ms", repetitions, {}}};
}

}  // namespace echomap::bench
