// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/exports/run_directory.hpp"
#include "host/geometry/angle.hpp"
#include "host/slam/slam_methods.hpp"
#include "tests/support/median.hpp"
#include "tests/support/offline_exploration.hpp"

namespace {

using echomap::tests::OfflineRun;
using echomap::tests::OfflineStrategy;

template <class Figure>
double median_of(const std::vector<OfflineRun>& runs, Figure figure) {
  std::vector<double> values;
  for (const auto& run : runs) {
    values.push_back(figure(run));
  }
  return echomap::tests::median(values);
}

void print_row(const char* name, const OfflineRun& run) {
  std::printf(
      "%-12s iou %.3f  seen %.3f (claimed %.3f)  wall_rmse %.3f m  recall %.3f  stops %2zu  %4.0f "
      "s  bumps %d  ate %.3f m "
      "%4.1f deg (odometry %.3f m %4.1f deg)  %s\n",
      name,
      run.agreement.free_iou,
      run.floor_seen,
      run.claimed_share,
      run.agreement.wall_rmse_m.value_or(-1.0),
      run.agreement.wall_recall,
      run.snapshot.stops,
      run.sim_seconds,
      run.bumps,
      run.trajectory.ate_rmse_m,
      echomap::geometry::degrees(run.trajectory.ate_heading_rmse_rad),
      run.odometry.ate_rmse_m,
      echomap::geometry::degrees(run.odometry.ate_heading_rmse_rad),
      echomap::exploration::name_of(run.reason));
}

void print_medians(const std::vector<OfflineRun>& runs) {
  std::printf(
      "median       iou %.3f  seen %.3f  wall_rmse %.3f m  recall %.3f  stops %2.0f  %4.0f s  ate "
      "%.3f m "
      "(odometry %.3f m)\n",
      median_of(runs, [](const auto& run) { return run.agreement.free_iou; }),
      median_of(runs, [](const auto& run) { return run.floor_seen; }),
      median_of(runs, [](const auto& run) { return run.agreement.wall_rmse_m.value_or(1.0); }),
      median_of(runs, [](const auto& run) { return run.agreement.wall_recall; }),
      median_of(runs, [](const auto& run) { return static_cast<double>(run.snapshot.stops); }),
      median_of(runs, [](const auto& run) { return run.sim_seconds; }),
      median_of(runs, [](const auto& run) { return run.trajectory.ate_rmse_m; }),
      median_of(runs, [](const auto& run) { return run.odometry.ate_rmse_m; }));
}

}  // namespace

/// explore_offline STRATEGY[+slam|+ekf] ROOM ROBOT FIRST LAST [DIRECTORY]: seeds FIRST .. LAST, one
/// line each, then the medians; with a directory the run directory of each seed as well.
int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: explore_offline nxt-farthest|frontier[+slam|+ekf] ROOM ROBOT FIRST LAST "
                 "[DIRECTORY]\n");
    return 2;
  }
  const std::string strategy = argv[1];
  echomap::tests::OfflineSettings settings;
  if (strategy.ends_with("+slam")) {
    settings.slam = echomap::slam::slam_by_name("multiscan").make;
  } else if (strategy.ends_with("+ekf")) {
    settings.slam = echomap::slam::slam_by_name("ekf").make;
  }
  settings.strategy =
      strategy.starts_with("frontier") ? OfflineStrategy::kFrontier : OfflineStrategy::kNxtFarthest;
  const auto room = echomap::tests::bundled_room(argv[2]);
  const auto robot = echomap::tests::bundled_robot(argv[3]);
  std::vector<OfflineRun> runs;
  const auto first = static_cast<std::uint32_t>(std::strtoul(argv[4], nullptr, 10));
  const auto last = static_cast<std::uint32_t>(std::strtoul(argv[5], nullptr, 10));
  for (std::uint32_t seed = first; seed <= last; ++seed) {
    runs.push_back(echomap::tests::explore_offline(room, robot, seed, settings));
    const std::string name = std::string("seed ") + std::to_string(seed);
    print_row(name.c_str(), runs.back());
    std::fflush(stdout);
    if (argc > 6) {
      echomap::exports::RunSummary summary;
      echomap::exports::describe_snapshot(runs.back().snapshot, summary);
      const std::filesystem::path directory = std::filesystem::path(argv[6]) / std::to_string(seed);
      echomap::exports::write_run_directory(directory, runs.back().snapshot, summary);
    }
  }
  print_medians(runs);
}
