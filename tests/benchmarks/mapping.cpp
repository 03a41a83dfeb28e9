// SPDX-License-Identifier: MIT
// What the mapping kernels do a second beside MRPT and OpenCV, how fast a log becomes a grid, how
// right sonar maps are beside those of the papers and of MRPT, and what the occupancy grid of a run
// costs, by the number of its stops.
#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/mapping_kernels.hpp"
#include "tests/benchmarks/replay_figures.hpp"
#include "tests/benchmarks/sonar_figures.hpp"
#include "tests/support/median.hpp"
#include "tests/support/offline_robot.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

files::TomlReader bundled(const std::string& name, const char* folder) {
  return files::TomlReader::load(files::bundled_file(name, folder, "file"));
}

/// The scans of a robot that goes about the living room whether it sees new ground or not.
std::vector<mapping::Scan> scans_of(std::size_t stops, std::uint32_t seed) {
  const auto robot = world::read_robot(bundled("uno_2wd", "hil_mock/robots"));
  world::RobotWorld world(
      world::read_floor_plan(bundled("living_room", "hil_mock/worlds")), robot, seed);
  const auto geometry = tests::assumed_geometry(robot);
  pipeline::RobotPipeline pipeline(geometry);
  tests::OfflineRobot offline_robot(world, geometry, pipeline);
  exploration::NxtFarthestParams params;
  params.max_stops = stops;
  params.stops_without_new_ground = stops;
  std::mt19937 random(seed);
  exploration::NxtFarthest explorer(params, random);

  std::vector<mapping::Scan> scans;
  auto last = exploration::MotionResult::kReached;
  while (true) {
    const auto motion = explorer.next(pipeline.snapshot(), last);
    if (std::holds_alternative<exploration::Finished>(motion)) {
      return scans;
    }
    last = offline_robot.execute(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      scans.push_back(*pipeline.snapshot().last_scan);
    }
  }
}

double seconds_for_grid(const std::vector<mapping::Scan>& scans, std::size_t stops) {
  mapping::SonarMapper mapper;
  const auto end = scans.begin() + static_cast<std::ptrdiff_t>(std::min(stops, scans.size()));
  const auto start = std::chrono::steady_clock::now();
  mapper.take({scans.begin(), end}, {});
  const auto grid = mapper.grid();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return grid.bounds().empty() ? 0.0 : took.count();
}

std::vector<Figure> stop_figures(std::uint32_t runs, std::size_t max_stops) {
  std::vector<std::vector<mapping::Scan>> explored;
  for (std::uint32_t seed = 1; seed <= runs; ++seed) {
    explored.push_back(scans_of(max_stops, seed));
  }
  std::vector<Figure> figures;
  for (const std::size_t stops : {10U, 20U, 50U, 100U}) {
    std::vector<double> seconds;
    for (const auto& scans : explored) {
      if (scans.size() >= stops) {
        seconds.push_back(seconds_for_grid(scans, stops));
      }
    }
    if (!seconds.empty()) {
      figures.push_back({fmt::format("grid_of_{}_stops", stops),
                         tests::median(seconds),
                         "s",
                         seconds.size(),
                         {}});
    }
  }
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::uint32_t runs = 3;
  std::size_t stops = 20;
  std::size_t repetitions = 9;
  std::size_t sonar_seeds = 1;
  std::filesystem::path json;
  CLI::App app("Rates of mapping kernels and replay, scores of sonar maps, time to make a grid");
  app.add_option("--seeds", runs, "Run seeds 1 to this")->capture_default_str();
  app.add_option("--stops", stops, "Stop there at the latest")->capture_default_str();
  app.add_option("--repetitions", repetitions, "Median of so many")->capture_default_str();
  app.add_option("--sonar-seeds", sonar_seeds, "Of the sonars' noise; a minute and more each")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  std::vector<echomap::bench::Figure> figures = echomap::bench::kernel_figures(repetitions);
  for (const auto& more :
       {echomap::bench::replay_figures(5),
        echomap::bench::sonar_figures(echomap::tests::real_data(""), sonar_seeds),
        echomap::bench::stop_figures(runs, stops)}) {
    figures.insert(figures.end(), more.begin(), more.end());
  }
  echomap::bench::report(figures, json);
}
