// SPDX-License-Identifier: MIT
#include "tests/benchmarks/slam_run_figures.hpp"

#include <algorithm>

#include "tests/support/median.hpp"

namespace echomap::bench {

std::vector<Figure> slam_run_figures(const std::string& name, const std::vector<SlamRun>& runs) {
  constexpr double kHarm = 1.05;
  if (runs.empty()) {
    return {};
  }
  std::vector<double> ate_ratios;
  std::vector<double> heading_ratios;
  std::vector<double> odometry_ate_m;
  std::vector<double> free_ious;
  for (const SlamRun& run : runs) {
    ate_ratios.push_back(run.slam.ate_rmse_m / run.odometry.ate_rmse_m);
    heading_ratios.push_back(run.slam.ate_heading_rmse_rad / run.odometry.ate_heading_rmse_rad);
    odometry_ate_m.push_back(run.odometry.ate_rmse_m);
    free_ious.push_back(run.free_iou);
  }
  const auto harmed = std::count_if(
      ate_ratios.begin(), ate_ratios.end(), [](double ratio) { return ratio > kHarm; });
  const double worst = *std::max_element(ate_ratios.begin(), ate_ratios.end());
  return {{name + "_odometry_ate_m", tests::median(odometry_ate_m), "m", runs.size(), {}},
          {name + "_ate_ratio", tests::median(ate_ratios), "", runs.size(), {}},
          {name + "_ate_ratio_worst", worst, "", runs.size(), {}},
          {name + "_harmed_runs", static_cast<double>(harmed), "", runs.size(), {}},
          {name + "_heading_ratio", tests::median(heading_ratios), "", runs.size(), {}},
          {name + "_free_iou", tests::median(free_ious), "", runs.size(), {}}};
}

}  // namespace echomap::bench
