// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

#include "host/geometry/angle.hpp"
#include "host/slam/slam_methods.hpp"
#include "tests/support/offline_exploration.hpp"

namespace {

using echomap::tests::OfflineRun;
using echomap::tests::OfflineSettings;
using echomap::tests::OfflineStrategy;

constexpr double kSoonestS = 20.0;
constexpr double kLatestS = 140.0;
/// A map that was joined wrongly is off by more.
constexpr double kRightM = 0.4;
constexpr double kRightRad = 0.25;

/// So many times, each within two minutes after the one before, to anywhere in the room.
void plan_carries(OfflineSettings& settings,
                  const echomap::world::FloorPlan& room,
                  const echomap::world::RobotParams& robot,
                  std::mt19937& random,
                  int count) {
  double at_s = 0.0;
  for (int i = 0; i < count; ++i) {
    at_s += std::uniform_real_distribution<double>(kSoonestS, kLatestS)(random);
    echomap::world::RobotWorld world(room, robot, static_cast<std::uint32_t>(random()));
    settings.carries.push_back({at_s, world.somewhere_else()});
  }
}

const char* outcome_of(const OfflineRun& run) {
  const bool is_right =
      run.trajectory.final_error_m < kRightM && run.trajectory.final_heading_error_rad < kRightRad;
  if (run.joins > 0) {
    return is_right ? "joined right" : "joined wrong";
  }
  return run.previous_maps > 0 ? "not joined" : "one map";
}

}  // namespace

/// carry_off_offline nxt-farthest|frontier ROOM ROBOT FIRST LAST COUNT: seeds FIRST .. LAST of a
/// robot that explores by SLAM and is carried off COUNT times, one line each, then how often its
/// maps were joined.
int main(int argc, char** argv) {
  if (argc != 7) {
    std::fprintf(stderr,
                 "usage: carry_off_offline nxt-farthest|frontier ROOM ROBOT FIRST LAST COUNT\n");
    return 2;
  }
  OfflineSettings settings;
  settings.slam = echomap::slam::slam_by_name("multiscan").make;
  settings.is_watched = true;
  settings.strategy = std::string(argv[1]) == "frontier" ? OfflineStrategy::kFrontier
                                                         : OfflineStrategy::kNxtFarthest;
  const auto room = echomap::tests::bundled_room(argv[2]);
  const auto robot = echomap::tests::bundled_robot(argv[3]);
  std::map<std::string, int> outcomes;
  for (int seed = std::atoi(argv[4]); seed <= std::atoi(argv[5]); ++seed) {
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    settings.carries.clear();
    plan_carries(settings, room, robot, random, std::atoi(argv[6]));
    const OfflineRun run =
        echomap::tests::explore_offline(room, robot, static_cast<std::uint32_t>(seed), settings);
    std::printf(
        "seed %3d  %-12s  previous %zu  stops %2zu  %4.0f s  iou %.3f  final %.2f m %3.0f deg\n",
        seed,
        outcome_of(run),
        run.previous_maps,
        run.snapshot.stops,
        run.sim_seconds,
        run.agreement.free_iou,
        run.trajectory.final_error_m,
        echomap::geometry::degrees(run.trajectory.final_heading_error_rad));
    ++outcomes[outcome_of(run)];
  }
  for (const auto& [outcome, count] : outcomes) {
    std::printf("%s: %d\n", outcome.c_str(), count);
  }
}
