// SPDX-License-Identifier: MIT
// SLAM on public logs and in simulated rooms, by each of its ways, with one setting for each kind
// of sensor.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/slam/slam_methods.hpp"
#include "tests/benchmarks/ekf_slam_figures.hpp"
#include "tests/benchmarks/emulated_slam_figures.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/joining_figures.hpp"
#include "tests/benchmarks/range_slam_figures.hpp"
#include "tests/benchmarks/room_slam_figures.hpp"
#include "tests/benchmarks/saving_figures.hpp"

namespace echomap::bench {
namespace {

struct Options {
  std::string part = "all";
  std::size_t seeds = 10;
  std::size_t first_seed = 1;
  std::uint32_t room_seeds = 20;
  bool verbose = false;
  std::filesystem::path json;
};

std::vector<Figure> named_after(const slam::NamedSlam& method, std::vector<Figure> figures) {
  for (Figure& figure : figures) {
    figure.name = std::string(method.name) + "_" + figure.name;
  }
  return figures;
}

void run(const Options& options) {
  std::vector<Figure> figures;
  const auto add = [&](const std::string& part, const auto& measure) {
    if (options.part == part || options.part == "all") {
      const std::vector<Figure> some = measure();
      figures.insert(figures.end(), some.begin(), some.end());
    }
  };
  const slam::NamedSlam& multiscan = slam::slam_by_name("multiscan");
  const slam::NamedSlam& ekf = slam::slam_by_name("ekf");
  add("laser", laser_slam_figures);
  add("spoilt", [&] { return spoilt_slam_figures(options.first_seed, options.seeds); });
  add("sonar", [&] { return sonar_slam_figures(multiscan, options.seeds); });
  add("rooms", [&] { return room_slam_figures(multiscan, options.room_seeds); });
  add("ekf_sonar", [&] { return named_after(ekf, sonar_slam_figures(ekf, options.seeds)); });
  add("ekf_rooms", [&] { return named_after(ekf, room_slam_figures(ekf, options.room_seeds)); });
  if (options.part == "emulated") {
    figures = emulated_slam_figures(options.room_seeds);
  }
  add("ekf", [&] { return ekf_slam_figures(options.verbose); });
  add("cost", laser_slam_cost_figures);
  add("joining", [&] { return joining_figures(options.seeds); });
  add("saving", [&] { return saving_figures(options.seeds); });
  add("cost", [&] { return ekf_slam_cost_figures(options.verbose); });
  report(figures, options.json);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app(
      "SLAM on public logs and in rooms: errors of relations, landmarks and paths, and what it "
      "costs");
  app.add_option("--part",
                 options.part,
                 "Of what is measured; emulated, which takes a quarter of an hour, is not in all")
      ->check(CLI::IsMember({"laser",
                             "spoilt",
                             "sonar",
                             "rooms",
                             "emulated",
                             "ekf",
                             "ekf_sonar",
                             "ekf_rooms",
                             "cost",
                             "joining",
                             "saving",
                             "all"}))
      ->capture_default_str();
  app.add_option(
         "--seeds",
         options.seeds,
         "Of the noise of sonars and of bad odometry; how often joining and saving are tried")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-seed", options.first_seed, "Of bad odometry")->capture_default_str();
  app.add_option("--room-seeds", options.room_seeds, "Of each simulated room")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("-v,--verbose", options.verbose, "Say more of each robot");
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run(options);
  return 0;
}
