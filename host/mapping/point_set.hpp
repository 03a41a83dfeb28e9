// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace echomap::mapping {

/// So many of the points, spread over their order; all where there are no more.
std::vector<Eigen::Vector2d> some_of(const std::vector<Eigen::Vector2d>& points, std::size_t count);

/// Of one point at least.
Eigen::Vector2d mean_of(const std::vector<Eigen::Vector2d>& points_m);

}  // namespace echomap::mapping
