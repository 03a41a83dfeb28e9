// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/mapping/map_placement.hpp"
#include "host/team_map/map_evidence.hpp"
#include "host/team_map/robot_map.hpp"
#include "tests/support/team_recording.hpp"

namespace {

using echomap::geometry::Pose2;
using echomap::mapping::CellState;
using echomap::mapping::RasterMap;
using echomap::team_map::RobotMap;
using echomap::tests::TeamRecording;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kRobots = 4;
constexpr std::size_t kJudged = 24;

/// Floor that both maps have where they truly lie.
double shared_m2(const RobotMap& first, const RobotMap& second, const Pose2& T_first_second) {
  const RasterMap& one = first.map().map();
  const RasterMap& other = second.map().map();
  std::size_t cells = 0;
  for (int y = 0; y < other.rows(); ++y) {
    for (int x = 0; x < other.columns(); ++x) {
      cells += other.state({x, y}) == CellState::kFree &&
                       one.state(one.cell_at(T_first_second * other.center_m({x, y}))) ==
                           CellState::kFree
                   ? 1
                   : 0;
    }
  }
  return static_cast<double>(cells) * one.resolution_m() * one.resolution_m();
}

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void look(const std::string& label,
          double now_s,
          const std::vector<TeamRecording>& team,
          const std::vector<RobotMap>& maps,
          std::pair<std::size_t, std::size_t> pair) {
  const auto [a, b] = pair;
  const Pose2 T_true = team[a].T_world_start.inverse() * team[b].T_world_start;
  const double shared = shared_m2(maps[a], maps[b], T_true);
  const double own_m = team[a].error_m(team[a].T_world_start, maps[a].T_map_submaps()) +
                       team[b].error_m(team[b].T_world_start, maps[b].T_map_submaps());
  const auto begin = Clock::now();
  auto found = echomap::mapping::find_placements(maps[a].map(), maps[b].map());
  const double find_ms = ms_since(begin);
  found.resize(std::min(found.size(), kJudged));
  // Truth itself, to see what a look could find.
  auto truth = found.empty() ? echomap::mapping::MapPlacement{} : found.front();
  truth.T_previous_later = T_true;
  found.push_back(truth);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto t0 = Clock::now();
    const Pose2 T =
        echomap::team_map::refined_placement(maps[a], maps[b], found[i].T_previous_later);
    const double refine_ms = ms_since(t0);
    const auto t1 = Clock::now();
    const auto e = echomap::team_map::evidence_for(maps[a], maps[b], T);
    const double evidence_ms = ms_since(t1);
    std::printf(
        "%s %zu%zu %.0f %zu %zu %.2f %s%zu %.2f %.2f %.2f %.3f %.3f %.4f %.3f %.1f %.3f %.0f %.1f "
        "%.1f "
        "%zu %zu %.0f %.0f %.0f\n",
        label.c_str(),
        a,
        b,
        now_s,
        maps[a].submaps().size(),
        maps[b].submaps().size(),
        shared,
        i + 1 == found.size() ? "T" : "",
        i,
        found[i].common_m,
        found[i].contradicting_m,
        found[i].known_m,
        T.x_m(),
        T.y_m(),
        T.heading_rad(),
        team[b].error_m(team[a].T_world_start * T, maps[b].T_map_submaps()),
        std::abs(echomap::geometry::degrees(
            echomap::geometry::angle_between(T_true.heading_rad(), T.heading_rad()))),
        own_m,
        e.readings,
        e.gain,
        e.loss,
        e.surfaces,
        e.matched,
        find_ms,
        refine_ms,
        evidence_ms);
  }
}

}  // namespace

/// join_looks WORLD FIRST LAST FOLDER: judges placements of each two of four robots after each stop
/// of either, and says what is true.
int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: join_looks WORLD FIRST LAST FOLDER\n");
    return 2;
  }
  for (int seed = std::atoi(argv[2]); seed <= std::atoi(argv[3]); ++seed) {
    const auto team = echomap::tests::team_recordings(
        argv[1], kRobots, static_cast<std::uint32_t>(seed), argv[4]);
    std::vector<std::pair<double, std::size_t>> events;
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      for (const auto& stop : team[robot].stops) {
        events.emplace_back(stop.end_s, robot);
      }
    }
    std::sort(events.begin(), events.end());
    std::vector<RobotMap> maps(kRobots, RobotMap(echomap::mapping::SonarMapperParams{}));
    std::vector<std::size_t> stops(kRobots, 0);
    for (const auto& [now_s, robot] : events) {
      maps[robot].take(team[robot].after(++stops[robot]));
      for (std::size_t other = 0; other < kRobots; ++other) {
        if (other != robot && stops[other] >= 2 && stops[robot] >= 2) {
          look(std::string(argv[1]) + " " + std::to_string(seed),
               now_s,
               team,
               maps,
               std::minmax(robot, other));
        }
      }
    }
    std::fflush(stdout);
  }
}
