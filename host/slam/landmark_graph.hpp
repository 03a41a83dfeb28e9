// SPDX-License-Identifier: MIT
#pragma once

#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/factor_graph.hpp"

namespace echomap::slam {

/// What a filter knows of each by itself (its marginals; that errors of two are alike is lost):
/// edges from the first pose it keeps, which is taken as known, to the other ones, to where its
/// first robot is and to all landmarks that are points. Walls have no edge.
FactorGraph landmark_graph(const EkfSlamFilter& filter);

}  // namespace echomap::slam
