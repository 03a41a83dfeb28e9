// SPDX-License-Identifier: MIT
#include "tests/benchmarks/team_runs.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json robot_json(const std::string& name, double off_m) {
  return {
      {"robot", name},
      {"outcome", "complete"},
      {"sim_seconds", 300.0},
      {"ate_rmse_m", 0.05},
      {"relative_pose_error", {{"position_m", off_m}, {"heading_rad", 0.1}, {"own_errors_m", 0.1}}},
      {"encounters", {{"deadlocks", 1}, {"ended_in_deadlock", off_m > 0.0}}}};
}

/// What a fleet leaves: each hull met something twice.
void write_fleet(const fs::path& folder, std::size_t robots, double floor_90_s) {
  json fleet{{"robots", json::array()},
             {"exits", json::object()},
             {"course",
              {{"joined_s", 120.0},
               {"wrong_joins", 1},
               {"wrong_joins_left", 0},
               {"floor_90_s", floor_90_s},
               {"floor_seen", 0.97}}},
             {"bytes_per_s_per_robot", 250.0},
             {"map", {{"free_iou", 0.91}, {"solid_called_free", nullptr}}}};
  for (std::size_t i = 0; i < robots; ++i) {
    const std::string name = "robot" + std::to_string(i);
    fleet["robots"].push_back(robot_json(name, i == 0 ? 0.0 : 0.25));
    fleet["exits"][name] = i == 0 ? 0 : 8;
    const fs::path truth = robots == 1 ? folder / "truth" : folder / "truth" / name;
    tests::write_truth_files(truth);
    files::write_text_file(truth / "truth.json", R"({"bumps": 2, "hard_collisions": 1})");
  }
  files::write_text_file(folder / "summary.json",
                         json{{"outcome", "unfinished"}, {"fleet", fleet}}.dump());
}

/// A stand-in for echomap that leaves such a fleet, with the single robot twice as slow, and notes
/// its command line. Of seed 2 it leaves nothing.
class FakeFleets {
 public:
  FakeFleets() {
    write_fleet(folder_ / "two", 2, 200.0);
    write_fleet(folder_ / "one", 1, 400.0);
    std::ofstream(program()) << R"(#!/bin/sh
here=$(dirname "$0")
from=$here/two
echo "$*" >> "$here/calls"
for word; do
  case $word in
    --out=*) out=${word#--out=} ;;
    --robots=1) from=$here/one ;;
    --seed=2) exit 1 ;;
  esac
done
cp -r "$from"/. "$out"
exit 8
)";
    fs::permissions(program(), fs::perms::owner_all);
  }
  fs::path program() const { return folder_ / "echomap"; }
  fs::path runs() const { return folder_ / "runs"; }
  std::string calls() const { return files::read_text_file(folder_ / "calls"); }

 private:
  tests::ScratchFolder folder_;
};

TeamRuns runs_of(const FakeFleets& fleets, int last_seed) {
  TeamRuns runs;
  runs.worlds = {"office"};
  runs.robots = {2};
  runs.last_seed = last_seed;
  runs.jobs = 2;
  runs.folder = fleets.runs();
  runs.program = fleets.program();
  return runs;
}

TEST(TeamRuns, AFleetIsStartedAsByAUserAndItsSingleRobotWhereTheFirstBegan) {
  const FakeFleets fleets;
  testing::internal::CaptureStderr();
  const auto pairs = run_teams(runs_of(fleets, 1));
  testing::internal::GetCapturedStderr();
  EXPECT_THAT(fleets.calls(),
              testing::HasSubstr("fleet start --robots=2 --world=office --headless --seed=1 "
                                 "--emulator=simavr"));
  EXPECT_THAT(fleets.calls(), testing::HasSubstr("--starts=0.500000,0.500000,0.0000"));
  ASSERT_EQ(pairs.size(), 1U);
  const TeamRun& team = pairs[0].team;
  EXPECT_EQ(team.exit, 8);
  EXPECT_EQ(team.outcome, "unfinished");
  EXPECT_THAT(team.endings, testing::ElementsAre("robot0 0 complete", "robot1 8 complete"));
  EXPECT_EQ(team.joined_s, 120.0);
  EXPECT_EQ(team.pose_error_m, 0.25);
  EXPECT_NEAR(team.beyond_own_m.value_or(0.0), 0.15, 1e-12);
  EXPECT_EQ(team.heading_error_rad, 0.1);
  EXPECT_EQ(team.wrong_joins, 1U);
  EXPECT_EQ(team.free_iou, 0.91);
  EXPECT_FALSE(team.solid_called_free);
  EXPECT_EQ(team.bumps, 4);
  EXPECT_EQ(team.hard_collisions, 2);
  EXPECT_EQ(team.deadlocks, 2U);
  EXPECT_EQ(team.deadlocks_left, 1U);
  EXPECT_EQ(team.kbytes_per_s_per_robot, 0.25);
  EXPECT_EQ(team.sim_seconds, 300.0);
  EXPECT_GT(team.wall_s, 0.0);
  EXPECT_EQ(pairs[0].alone.floor_90_s, 400.0);
  EXPECT_EQ(pairs[0].time_ratio(), 0.5);
  EXPECT_TRUE(pairs[0].ideal_ratio);
}

TEST(TeamRuns, ARunThatIsThereIsNotMadeAgain) {
  const FakeFleets fleets;
  testing::internal::CaptureStderr();
  run_teams(runs_of(fleets, 1));
  const std::string calls = fleets.calls();
  const auto again = run_teams(runs_of(fleets, 1));
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(fleets.calls(), calls);
  EXPECT_EQ(again.at(0).team.exit, 8);
  EXPECT_EQ(again.at(0).time_ratio(), 0.5);
}

TEST(TeamRuns, OneThatLeavesNothingIsOneThatFailed) {
  const FakeFleets fleets;
  testing::internal::CaptureStderr();
  const auto pairs = run_teams(runs_of(fleets, 2));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("office_2_2"));
  ASSERT_EQ(pairs.size(), 2U);
  const TeamRun& failed = pairs[1].team;
  EXPECT_EQ(failed.what.seed, 2);
  EXPECT_EQ(failed.exit, 1);
  EXPECT_TRUE(failed.outcome.empty());
  EXPECT_FALSE(failed.is_joined());
  EXPECT_FALSE(pairs[1].time_ratio());
}

TEST(TeamRuns, AProgramThatCannotBeStartedFailsAllRuns) {
  const FakeFleets fleets;
  TeamRuns runs = runs_of(fleets, 1);
  runs.program = "/nowhere/echomap";
  testing::internal::CaptureStderr();
  const auto pairs = run_teams(runs);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("/nowhere/echomap"));
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_FALSE(pairs[0].team.exit);
}

}  // namespace
}  // namespace echomap::bench
