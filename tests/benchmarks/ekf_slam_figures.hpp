// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What EKF-SLAM reaches on MRCLAM 6, Victoria Park, Brenner's cylinders and Edmonton. With
/// `verbose` also what each robot and the book's filter do. A log that is not there is said to be
/// left out.
std::vector<Figure> ekf_slam_figures(bool verbose);

/// What a step costs as the landmarks grow.
std::vector<Figure> ekf_slam_cost_figures(bool verbose);

}  // namespace echomap::bench
