// SPDX-License-Identifier: MIT
// How often, how fast and at what cost a robot is found in a map.
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "tests/benchmarks/building_runs.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

constexpr int kRuns = 25;
constexpr std::size_t kJudgedStep = 20;

/// Within 0.30 m and 15 degrees of the truth.
bool is_found(const localization::PoseBelief& belief, const geometry::Pose2& truth) {
  if (belief.hypotheses.empty()) {
    return false;
  }
  const geometry::Pose2& pose = belief.hypotheses.front().T_map_robot;
  const double off_m = (pose.position_m() - truth.position_m()).norm();
  const double off_rad = std::abs(geometry::angle_between(pose.heading_rad(), truth.heading_rad()));
  return off_m < 0.30 && off_rad < geometry::radians(15.0);
}

struct BuildingScore {
  double found = 0.0;
  double steps = 0.0;
  double seconds = 0.0;
};

void follow(const BuildingRun& run,
            localization::MonteCarloLocalizer& localizer,
            BuildingScore& score) {
  for (std::size_t i = 0; i <= kJudgedStep; ++i) {
    score.seconds += processor_seconds(
        [&] { localizer.update(run.steps[i].T_odom_robot, run.steps[i].readings); });
    score.steps += 1.0;
  }
  score.found += is_found(localizer.belief(), run.steps[kJudgedStep].T_map_robot) ? 1.0 : 0.0;
}

std::vector<Figure> building_figures(std::uint32_t seed,
                                     const localization::LocalizerParams& params) {
  const auto folder = tests::real_data("global_localization");
  if (!std::filesystem::exists(folder)) {
    fmt::print("building: not there, skipped\n");
    return {};
  }
  const mapping::RasterMap map = read_building(folder / "map.pgm");
  std::vector<Figure> figures;
  BuildingScore all;
  for (const std::string kind : {"cone8", "cone16", "cone24", "pencil16"}) {
    const double half_opening_rad = kind.starts_with("cone") ? geometry::radians(12.5) : 0.0;
    BuildingScore score;
    localization::RangeTable table(map, {half_opening_rad, 4.0});
    const double took_s = processor_seconds([&] {
      for (std::int32_t y = 0; y < table.rows(); y += 16)
        for (std::int32_t x = 0; x < table.columns(); x += 16)
          table.fill_tile(table.tile_of({x, y}));
    });
    fmt::print("{} table {:.2f} s {} MB\n", kind, took_s, table.memory_bytes() / 1000000);
    const localization::LikelihoodCodes likelihoods(
        table, models::BeamModel(models::sonar_cone_returns()));
    for (int i = 0; i < kRuns; ++i) {
      const BuildingRun run = read_building_run(folder / fmt::format("gl_{}_{}.txt.gz", kind, i));
      localization::MonteCarloLocalizer localizer(
          table, likelihoods, params, std::mt19937(seed + static_cast<std::uint32_t>(i)));
      follow(run, localizer, score);
    }
    figures.push_back({fmt::format("building_{}_of_25", kind), score.found, "runs", kRuns, {}});
    all.steps += score.steps;
    all.seconds += score.seconds;
  }
  figures.push_back({"building_ms_per_step", 1e3 * all.seconds / all.steps, "ms", 4 * kRuns, {}});
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::uint32_t seed = 1;
  std::filesystem::path json;
  echomap::localization::LocalizerParams params;
  CLI::App app("How often, how fast and at what cost a robot is found in a map");
  app.add_option("--seed", seed, "First seed of the filters")->capture_default_str();
  app.add_option("--most", params.filter.most_particles, "")->capture_default_str();
  app.add_option("--least", params.filter.least_particles, "")->capture_default_str();
  app.add_option("--temper", params.filter.temper, "")->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::building_figures(seed, params), json);
}
