// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host/slam/slam_methods.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// A way of SLAM as the pose source of a simulated robot with one panned sonar that explores by
/// nxt-farthest, over seeds 1 to `seeds` of each room: living_room, office, corridor. As
/// slam_run_figures under ROOM for odometry with wheels and track off by 3 % (uno_2wd_rough) and
/// under ROOM_fine for the bundled uno_2wd. Also sonar_cpu_percent of one core at 25 pings a
/// second, and the longest time that one ping took, sonar_longest_ms.
std::vector<Figure> room_slam_figures(const slam::NamedSlam& method, std::uint32_t seeds);

}  // namespace echomap::bench
