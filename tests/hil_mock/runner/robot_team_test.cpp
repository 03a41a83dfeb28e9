// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_team.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::runner {
namespace {

using tests::kMs;

/// Robots in the box room, each driven straight ahead by its board.
class Team {
 public:
  explicit Team(const std::vector<geometry::Pose2>& starts, double duty = 0.4) {
    std::vector<RobotSimulation*> simulations;
    for (const geometry::Pose2& start : starts) {
      boards.push_back(std::make_unique<FakeBoard>());
      boards.back()->duty = {duty, duty};
      worlds.push_back(
          std::make_unique<world::RobotWorld>(world::box_room({}, start), world::RobotParams{}, 7));
      robots.push_back(std::make_unique<RobotSimulation>(*boards.back(), *worlds.back()));
      simulations.push_back(robots.back().get());
    }
    team = std::make_unique<RobotTeam>(simulations);
  }

  double apart_m() const {
    return (worlds[0]->T_world_robot().position_m() - worlds[1]->T_world_robot().position_m())
        .norm();
  }

  std::vector<std::unique_ptr<FakeBoard>> boards;
  std::vector<std::unique_ptr<world::RobotWorld>> worlds;
  std::vector<std::unique_ptr<RobotSimulation>> robots;
  std::unique_ptr<RobotTeam> team;
};

const std::vector<geometry::Pose2> kHeadOn{{1.0, 1.5, 0.0}, {3.0, 1.5, std::numbers::pi}};

TEST(RobotTeam, AllReachTheSameTimeAlsoBetweenTwoMilliseconds) {
  Team team(kHeadOn);
  for (const std::int64_t until_ns : {1'500'000, 1'700'000, 4'000'000}) {
    team.team->advance_to(until_ns);
    EXPECT_EQ(team.robots[0]->now_ns(), until_ns);
    EXPECT_EQ(team.robots[1]->now_ns(), until_ns);
    EXPECT_EQ(team.boards[1]->time_ns, until_ns);
  }
  team.team->advance_to(kMs);
  EXPECT_EQ(team.team->now_ns(), 4 * kMs) << "that is past";
}

TEST(RobotTeam, RobotsThatMeetBumpAndNeverOverlap) {
  Team team({{1.8, 1.5, 0.0}, {2.2, 1.5, std::numbers::pi}});
  for (int i = 0; i < 6000; ++i) {
    team.team->advance_to((i + 1) * kMs);
    ASSERT_GE(team.apart_m(), 2.0 * 0.09 - 1e-9) << i;
  }
  for (const auto& world : team.worlds) {
    const world::Collisions& met = world->body().collisions();
    EXPECT_EQ(met.bumps + met.hard, 1) << "they drive on and slide past each other";
  }
}

TEST(RobotTeam, TheyHearOneAnotherFromTheFirstPingOn) {
  Team team(kHeadOn, 0.0);
  EXPECT_NEAR(team.worlds[0]->ping(0.0).value_or(0.0) * 343.2 / 2.0, 1.88, 0.15);
  team.worlds[1]->place({3.0, 0.3, 0.0});
  team.team->advance_to(2 * kMs);
  EXPECT_NEAR(team.worlds[0]->ping(0.0).value_or(0.0) * 343.2 / 2.0, 2.97, 0.15);
}

TEST(RobotTeam, HowItsTimeIsCutChangesNothing) {
  Team whole(kHeadOn);
  Team cut(kHeadOn);
  whole.team->advance_to(5000 * kMs);
  for (std::int64_t now_ns = 0; now_ns < 5000 * kMs; now_ns += 333'000) {
    cut.team->advance_to(now_ns);
  }
  cut.team->advance_to(5000 * kMs);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(whole.worlds[i]->T_world_robot().position_m(),
              cut.worlds[i]->T_world_robot().position_m());
  }
}

TEST(RobotTeam, OneAloneIsAsWithoutATeam) {
  Team team({{1.0, 1.5, 0.3}});
  Team other({{1.0, 1.5, 0.3}});
  team.team->advance_to(2000 * kMs);
  other.robots[0]->advance_to(2000 * kMs);
  EXPECT_EQ(team.worlds[0]->T_world_robot().position_m(),
            other.worlds[0]->T_world_robot().position_m());
  EXPECT_FALSE(team.robots[0]->before_step);
}

TEST(RobotTeam, ABoxStandsForAllOrForNone) {
  Team team({{1.0, 1.5, 0.5 * std::numbers::pi}, {3.0, 1.5, 0.0}});
  EXPECT_FALSE(team.team->put_box(0, {0.0, -2.0}, 0.3)) << "where the other one stands";
  EXPECT_TRUE(team.team->put_box(0, {0.0, -1.0}, 0.3));
  for (const auto& world : team.worlds) {
    ASSERT_EQ(world->plan().boxes_m().size(), 1U);
    EXPECT_TRUE(geometry::contains(world->plan().boxes_m()[0], Eigen::Vector2d(2.0, 1.5)));
  }
}

}  // namespace
}  // namespace echomap::runner
