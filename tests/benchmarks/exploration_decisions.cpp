// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_decisions.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <variant>

#include "host/exploration/frontier.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::bench {
namespace {

using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;

constexpr int kFree = -300;
constexpr int kOccupied = 300;

/// A walled hall of so many cells with a box in about each square of 40, known but for the farther
/// third. The robot's start, cell (0, 0), is in its middle and free.
mapping::OccupancyGrid hall(int edge) {
  std::mt19937 random(7);
  mapping::OccupancyGrid grid;
  const int low = -edge / 2;
  const int known = low + 2 * edge / 3;
  for (int y = low; y < low + edge; ++y) {
    for (int x = low; x < known; ++x) {
      const bool wall = y == low || y == low + edge - 1 || x == low;
      grid.add({x, y}, wall ? kOccupied : kFree);
    }
  }
  grid.add({low + edge - 1, 0}, kOccupied);
  for (int box = 0; box < edge / 40 * (edge / 40); ++box) {
    const auto at = [&] { return low + static_cast<int>(random() % static_cast<unsigned>(edge)); };
    const int x = at();
    const int y = at();
    const int size = 4 + static_cast<int>(random() % 12);
    const bool near_the_robot = std::max(std::abs(x), std::abs(y)) < 30;
    for (int i = 0; i < size * size && !near_the_robot; ++i) {
      if (x + i % size < known) {
        grid.add({x + i % size, y + i / size}, 2 * kOccupied);
      }
    }
  }
  return grid;
}

/// Where a motion of perfect wheels leads.
Pose2 moved(const Pose2& from, const Motion& motion) {
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return from * Pose2(0.0, 0.0, turn->angle_rad);
  }
  if (const auto* roll = std::get_if<exploration::Roll>(&motion)) {
    return from *
           Pose2(roll->forward_m_per_s * roll->for_s, 0.0, roll->turn_rad_per_s * roll->for_s);
  }
  return from;
}

/// What each decision of a drive through the hall took.
std::vector<double> decisions_ms(int edge, std::size_t decisions) {
  auto snapshot = tests::snapshot_of(hall(edge), {tests::pose_at(1.0, {})});
  snapshot.stops = 1;
  exploration::FrontierParams params;
  params.most_stops = decisions + 2;
  exploration::Frontier explorer(params);
  std::vector<double> took_ms;
  bool decides = false;
  while (took_ms.size() < decisions) {
    Motion motion;
    const double took_s =
        processor_seconds([&] { motion = explorer.next(snapshot, MotionResult::kReached); });
    if (decides) {
      took_ms.push_back(1e3 * took_s);
    }
    if (std::holds_alternative<exploration::Finished>(motion)) {
      break;
    }
    decides = std::holds_alternative<exploration::EndScan>(motion);
    snapshot.latest.T_map_robot = moved(snapshot.latest.T_map_robot, motion);
  }
  return took_ms;
}

}  // namespace

std::vector<Figure> decision_figures(std::size_t decisions) {
  std::vector<Figure> figures;
  for (const int edge : {400, 2000}) {
    const auto took_ms = decisions_ms(edge, decisions);
    const std::string name = "decision_ms_" + std::to_string(edge);
    figures.push_back({name, tests::median(took_ms), "ms", took_ms.size(), {}});
    figures.push_back({name + "_most",
                       *std::max_element(took_ms.begin(), took_ms.end()),
                       "ms",
                       took_ms.size(),
                       {}});
  }
  return figures;
}

}  // namespace echomap::bench
