// SPDX-License-Identifier: MIT
#include "tests/benchmarks/building_figures.hpp"

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/range_table_model.hpp"
#include "tests/benchmarks/building_runs.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/expect_pose_estimate.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

constexpr int kRuns = 25;
constexpr std::size_t kJudgedStep = 20;
constexpr double kMaxRangeM = 4.0;
constexpr double kBeamHalfAngleRad = geometry::radians(12.5);

struct Score {
  int found = 0;
  std::size_t steps = 0;
  double seconds = 0.0;
};

void follow(const BuildingRun& run, localization::MonteCarloLocalizer& localizer, Score& score) {
  for (std::size_t i = 0; i <= kJudgedStep; ++i) {
    score.seconds += processor_seconds(
        [&] { localizer.update(run.steps[i].T_odom_robot, run.steps[i].readings); });
  }
  score.steps += kJudgedStep + 1;
  const geometry::Pose2& truth = run.steps[kJudgedStep].T_map_robot;
  score.found +=
      tests::is_estimated_near(localizer.belief(), truth, 0.30, geometry::radians(15.0)) ? 1 : 0;
}

/// All tiles, so that a step does not pay for them.
void fill(localization::RangeTable& table) {
  for (std::int32_t y = 0; y < table.rows(); y += localization::RangeTable::kTileSide) {
    for (std::int32_t x = 0; x < table.columns(); x += localization::RangeTable::kTileSide) {
      table.fill_tile(table.tile_of({x, y}));
    }
  }
}

Score score_of(const std::filesystem::path& folder,
               const std::string& kind,
               std::uint32_t seed,
               localization::RangeTableModel& model) {
  Score score;
  for (int i = 0; i < kRuns; ++i) {
    const BuildingRun run = read_building_run(folder / fmt::format("gl_{}_{}.txt.gz", kind, i));
    localization::MonteCarloLocalizer localizer(
        model, {}, std::mt19937(seed + static_cast<std::uint32_t>(i)));
    follow(run, localizer, score);
  }
  return score;
}

}  // namespace

std::vector<Figure> building_figures(std::uint32_t seed) {
  const auto folder = tests::real_data("global_localization");
  if (!std::filesystem::exists(folder)) {
    fmt::print("building: not there, skipped\n");
    return {};
  }
  const mapping::RasterMap map = read_building(folder / "map.pgm");
  std::vector<Figure> figures;
  Score all;
  double table_s = 0.0;
  double table_mb = 0.0;
  for (const std::string kind : {"cone8", "cone16", "cone24", "pencil16"}) {
    const bool is_cone = kind.starts_with("cone");
    localization::RangeTableModel model(
        localization::RangeTable(map, {is_cone ? kBeamHalfAngleRad : 0.0, kMaxRangeM}),
        models::BeamModel(models::sonar_cone_returns()));
    table_s = std::max(table_s, processor_seconds([&] { fill(model.table()); }));
    table_mb = static_cast<double>(model.table().memory_bytes()) / 1e6;
    const Score score = score_of(folder, kind, seed, model);
    figures.push_back({fmt::format("building_{}_of_25", kind),
                       static_cast<double>(score.found),
                       "runs",
                       kRuns,
                       {}});
    all.steps += score.steps;
    all.seconds += score.seconds;
  }
  const double ms = 1e3 * all.seconds / static_cast<double>(all.steps);
  figures.push_back({"building_ms_per_step", ms, "ms", 4 * kRuns, {}});
  figures.push_back({"building_table_s", table_s, "s", 4, {}});
  figures.push_back({"building_table_mb", table_mb, "MB", 4, {}});
  return figures;
}

}  // namespace echomap::bench
