// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/slam/slam_methods.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Relation errors (Kuemmerle et al. 2009) of ScanSlam on Edmonton and Freiburg 79, whole and with
/// few beams: edmonton_m, edmonton_deg, edmonton_b60_m .. edmonton_b12_m, fr079_m, fr079_deg.
/// Odometry stands beside each. Empty where the logs are not there.
std::vector<Figure> laser_slam_figures();

/// What a scan of Edmonton takes on one thread: scan_to_map_ms without loops, scan_slam_ms with
/// all.
std::vector<Figure> laser_slam_cost_figures();

/// Relation errors of a way of SLAM on Edmonton as 24 and as 12 sonars would have heard it, over as
/// many seeds of their noise: the mean, and the worst seed. Odometry stands beside each.
std::vector<Figure> sonar_slam_figures(const slam::NamedSlam& method, std::size_t seeds);

/// Relation errors of ScanSlam on public logs whose odometry was made bad, over so many seeds of it
/// from `first` on (read_spoilt_log): the median, the worst seed, and how many are above 0.1 m.
/// Odometry's median stands beside.
std::vector<Figure> spoilt_slam_figures(std::size_t first, std::size_t seeds);

}  // namespace echomap::bench
