// SPDX-License-Identifier: MIT
// Hennessey et al., sections II and IV: an EV3 enters its playground through a door, visits the
// four corners and comes out again. The share of runs that do is told over 20 seeds by `./run bench
// exploration`; here is one, on the image that a user flashes, two in `./run test --full`, and the
// paper as printed without firmware.
#include <algorithm>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "host/exploration/tangent_bug.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/toml_reader.hpp"
#include "host/papers/confidence_picture.hpp"
#include "host/strategies/course_file.hpp"
#include "tests/papers/demo_run.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/exploration_case.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

const std::filesystem::path picture_path = ECHOMAP_BINARY_DIR "/papers/paper_003_exploration.png";

constexpr std::uint32_t kSeeds = 20;
constexpr double kReachedM = 0.30;

class Paper003Exploration : public ::testing::Test {
 protected:
  nlohmann::json explore(int seed) {
    return run_demo(tests::demo_arguments(tests::ev3_at_its_door(), seed),
                    scratch_ / std::to_string(seed));
  }
  /// Where the robot truly went, in the playground's frame.
  std::vector<Eigen::Vector2d> true_path_m(int seed) const {
    std::vector<Eigen::Vector2d> path_m;
    for (const auto& pose :
         exports::read_trajectory_tum(scratch_ / std::to_string(seed) / "truth" / "truth.tum")) {
      path_m.push_back(pose.T_map_robot.position_m());
    }
    return path_m;
  }

  tests::ScratchFolder scratch_;
};

/// How near the way comes to each waypoint.
double farthest_missed_m(const std::vector<Eigen::Vector2d>& path_m,
                         const exploration::WaypointCourse& course) {
  double max_m = 0.0;
  for (const auto& waypoint : course.waypoints) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& place_m : path_m) {
      nearest_m = std::min(nearest_m, (place_m - waypoint.position_m).norm());
    }
    max_m = std::max(max_m, nearest_m);
  }
  return max_m;
}

TEST_F(Paper003Exploration, GoesThroughTheDoorToTheCornersAndBackOnTheReleaseFirmware) {
  const auto course = strategies::load_course("playground");
  for (int seed = 1; seed <= (tests::runs_every_seed() ? 2 : 1); ++seed) {
    const auto report = explore(seed);
    EXPECT_EQ(report.at("outcome"), "complete") << seed;
    EXPECT_EQ(report.at("phases"), 7);
    EXPECT_EQ(report.at("phases_reached"), 7);
    EXPECT_TRUE(std::filesystem::exists(scratch_ / std::to_string(seed) / "confidence_grid.csv"));
    // The robot believes to be within 30 cm; what it has drifted comes on top.
    const auto offset_m = true_path_m(seed);
    EXPECT_LT(farthest_missed_m(offset_m, course), kReachedM + 0.15) << seed;
    EXPECT_LT((offset_m.back() - offset_m.front()).norm(), kReachedM + 0.05) << seed;
  }
}

/// A run without firmware.
struct Drive {
  exploration::FinishReason reason = exploration::FinishReason::kStopLimit;
  exploration::StrategyProducts products;
  std::vector<Eigen::Vector2d> path_m;  ///< The stops, truly.
  int bumps = 0;
};

const world::RobotParams& ev3() {
  static const world::RobotParams robot = world::read_robot(
      files::TomlReader::load(std::string(ECHOMAP_SOURCE_DIR) + "/hil_mock/robots/ev3.toml"));
  return robot;
}

exploration::TangentBugParams ev3_params() {
  const world::RobotParams& robot = ev3();
  exploration::TangentBugParams params;
  params.robot_radius_m = robot.body.radius_m;
  params.beam_half_angle_rad = robot.sonar.beam_half_angle_rad;
  params.sweep.pan_limit_rad = 2.0 * std::numbers::pi;
  return params;
}

Drive drive(const exploration::TangentBugParams& params, std::uint32_t seed) {
  world::RobotWorld world(tests::bundled_room("playground_door"), ev3(), seed);
  const auto geometry = tests::assumed_geometry(ev3());
  pipeline::RobotPipeline pipeline(geometry);
  tests::OfflineRobot robot(world, geometry, pipeline);
  exploration::TangentBug explorer(params, strategies::load_course("playground"));
  Drive drive{{}, {}, {world.T_world_robot().position_m()}, 0};
  auto last = exploration::MotionResult::kReached;
  for (;;) {
    const auto motion = explorer.next(pipeline.snapshot(), last);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      drive.reason = finished->reason;
      drive.products = explorer.products();
      return drive;
    }
    last = robot.execute(motion);
    drive.bumps += last == exploration::MotionResult::kBumped ? 1 : 0;
    drive.path_m.push_back(world.T_world_robot().position_m());
  }
}

/// Over all seeds.
struct Shares {
  int complete = 0;
  int back = 0;
  int bumps = 0;
};

Shares shares(bool as_printed) {
  const auto params = ev3_params();
  Shares shares;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const Drive run = drive(as_printed ? exploration::as_printed(params) : params, seed);
    shares.complete += run.reason == exploration::FinishReason::kComplete;
    shares.back += run.reason != exploration::FinishReason::kNotBack;
    shares.bumps += run.bumps;
  }
  std::cout << (as_printed ? "as printed" : "with echoes that clear their cones") << ": complete "
            << shares.complete << ", back at the start " << shares.back << " of " << kSeeds
            << ", bumps " << shares.bumps << "\n";
  return shares;
}

// The grid of the paper only fills up: the way through the door closes, and a sum that lets the
// robot out lets it bump, too.
TEST(Paper003Offline, ComesBackAndBumpsLessWhereEchoesClearTheirCones) {
  const Shares ours = shares(false);
  const Shares printed = shares(true);
  EXPECT_GE(ours.complete, 16);
  EXPECT_GE(ours.back, 19);
  EXPECT_GE(printed.back, 17);
  EXPECT_LT(2 * ours.bumps, printed.bumps);
}

TEST(Paper003Offline, IsDrawn) {
  const Drive run = drive(ev3_params(), 2);
  EXPECT_EQ(run.reason, exploration::FinishReason::kComplete);
  draw_confidence(
      picture_path, *run.products.confidence, tests::bundled_room("playground_door"), run.path_m);
  EXPECT_TRUE(std::filesystem::exists(picture_path));
}

}  // namespace
}  // namespace echomap::papers
