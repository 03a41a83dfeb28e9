// SPDX-License-Identifier: MIT
// How often, how fast and at what cost a robot is found in a map.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/building_figures.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/landmark_figures.hpp"
#include "tests/benchmarks/localization_soak.hpp"
#include "tests/benchmarks/localization_speed.hpp"
#include "tests/benchmarks/room_figures.hpp"
#include "tests/benchmarks/wean_figures.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  std::uint32_t seed = 1;
  int starts = 20;
  std::size_t repetitions = 25;
  bool verbose = false;
  double hours = 10.0;
  bool holds = true;
  std::vector<std::string> parts;
  std::filesystem::path json;
  std::filesystem::path picture;
  const std::vector<std::pair<std::string, std::function<std::vector<bench::Figure>()>>> all{
      {"speed", [&] { return bench::localization_speed_figures(repetitions); }},
      {"building", [&] { return bench::building_figures(seed); }},
      {"rooms", [&] { return bench::room_figures(starts, seed, picture); }},
      {"landmarks", [&] { return bench::landmark_figures(verbose); }},
      {"wean", [&] { return bench::wean_figures(seed, verbose); }},
      {"soak", [&] {
         const bench::SoakScore score = bench::soak_localizer(hours, seed);
         holds = score.holds();
         return bench::soak_figures(score);
       }}};
  CLI::App app("How often, how fast and at what cost a robot is found in a map");
  app.add_option("--seed", seed, "First seed of robots and filters")->capture_default_str();
  app.add_option("--starts", starts, "Robots in each room")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--repetitions", repetitions, "Median of so many")->capture_default_str();
  app.add_option("--part", parts, "Only these: speed, building, rooms, landmarks, wean, soak");
  app.add_option("--hours", hours, "Simulated time that a robot is followed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--verbose", verbose, "A line for each robot that is followed");
  app.add_option("--picture", picture, "Draw how far the probability of being lost holds, as SVG");
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  std::vector<bench::Figure> figures;
  for (const auto& [name, measure] : all) {
    if (parts.empty() || std::count(parts.begin(), parts.end(), name) > 0) {
      const auto more = measure();
      figures.insert(figures.end(), more.begin(), more.end());
    }
  }
  bench::report(figures, json);
  return holds ? 0 : 1;
}
