// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/evaluation/trajectory_error.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What SLAM came to in a simulated room, and odometry alone on the same way.
struct SlamRun {
  evaluation::TrajectoryError slam;
  evaluation::TrajectoryError odometry;
  double free_iou = 0.0;
};

/// Of the runs of one room, one a seed, named NAME_..: the median of odometry's absolute trajectory
/// error (odometry_ate_m); the median share of it that is left (ate_ratio), the worst share
/// (ate_ratio_worst) and how many seeds end above 1.05 (harmed_runs); the median share of
/// odometry's error of the heading (heading_ratio); and the median free_iou.
std::vector<Figure> slam_run_figures(const std::string& name, const std::vector<SlamRun>& runs);

}  // namespace echomap::bench
