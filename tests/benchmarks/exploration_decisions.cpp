// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_decisions.hpp"

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "host/exploration/frontier.hpp"
#include "host/exploration/opening_search.hpp"
#include "host/mapping/raster_map.hpp"
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
  params.max_stops = decisions + 2;
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

/// As many stops as the strategy makes at most, all before the edge of the known floor of the hall,
/// which have heard nothing all round.
std::vector<mapping::Scan> silent_scans(int edge, double resolution_m) {
  constexpr int kReadings = 90;
  const exploration::FrontierParams params;
  const double edge_m = resolution_m * (-edge / 2 + 2 * edge / 3);
  const double side_m = 0.4 * resolution_m * edge;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> before_m(0.5, params.openings.far_m);
  std::uniform_real_distribution<double> aside_m(-side_m, side_m);
  std::vector<mapping::Scan> scans;
  for (std::size_t stop = 0; stop < params.max_stops; ++stop) {
    const Pose2 T_map_robot(edge_m - before_m(random), aside_m(random), 0.0);
    mapping::Scan scan;
    for (int i = 0; i < kReadings; ++i) {
      const Pose2 T_robot_sonar(0.0, 0.0, i * 2.0 * std::numbers::pi / kReadings);
      scan.push_back({T_map_robot, T_map_robot * T_robot_sonar, std::nullopt});
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

/// What the search for openings adds to a decision where no look promises enough.
Figure beam_width_figure(int edge, std::size_t searches) {
  const mapping::OccupancyGrid grid = hall(edge);
  const mapping::RasterMap map = mapping::rasterize(grid);
  const auto scans = silent_scans(edge, grid.resolution_m());
  std::vector<double> took_ms;
  for (std::size_t i = 0; i < searches; ++i) {
    std::vector<exploration::Opening> found;
    took_ms.push_back(1e3 * processor_seconds([&] {
                        found =
                            exploration::find_openings(map, scans, exploration::OpeningParams{});
                      }));
    if (found.empty()) {
      throw std::logic_error("the hall has no openings to search for");
    }
  }
  return {"opening_search_ms_" + std::to_string(edge),
          tests::median(took_ms),
          "ms",
          took_ms.size(),
          {}};
}

}  // namespace

std::vector<Figure> decision_figures(std::size_t decisions) {
  std::vector<Figure> figures;
  for (const int edge : {400, 2000}) {
    const auto took_ms = decisions_ms(edge, decisions);
    const std::string name = "decision_ms_" + std::to_string(edge);
    figures.push_back({name, tests::median(took_ms), "ms", took_ms.size(), {}});
    figures.push_back({name + "_max",
                       *std::max_element(took_ms.begin(), took_ms.end()),
                       "ms",
                       took_ms.size(),
                       {}});
    figures.push_back(beam_width_figure(edge, decisions));
  }
  return figures;
}

}  // namespace echomap::bench
