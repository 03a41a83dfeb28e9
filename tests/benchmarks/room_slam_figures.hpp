// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Grid SLAM as the pose source of a simulated uno_2wd with one panned sonar that explores by
/// nxt-farthest, over seeds 1 to `seeds` of each room: living_room, office, corridor. For odometry
/// with wheels and track off by 3 % (ROOM_...) and as the bundled robot has it (ROOM_fine_...):
/// medians of the share of odometry's absolute trajectory error that is left (.._ate_ratio) and of
/// its heading's (.._heading_ratio), the worst ratio of a seed, how many seeds end above 1.05, and
/// the median free_iou. Also sonar_cpu_percent of one core at 25 pings a second, and the longest
/// time that one ping took, sonar_longest_ms.
std::vector<Figure> room_slam_figures(std::uint32_t seeds);

}  // namespace echomap::bench
