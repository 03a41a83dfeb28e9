// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Grid SLAM on the firmware's release image in the emulator: an Uno explores by nxt-farthest, on a
/// body whose wheels and track are off by 3 % and slip (uno_2wd_rough), seeds 1 to `seeds` of
/// living_room, office and corridor, as slam_run_figures under emulated_ROOM. Runs that do not end
/// well or have no score are left out, and named on stderr.
std::vector<Figure> emulated_slam_figures(std::uint32_t seeds);

}  // namespace echomap::bench
