// SPDX-License-Identifier: MIT
#include "host/exploration/atlas_explorer.hpp"

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "host/slam/slam_methods.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::exploration {
namespace {

/// Says what it is told to.
class Puppet final : public Explorer {
 public:
  explicit Puppet(Motion& motion, std::vector<std::size_t>& stops)
      : motion_(motion), stops_(stops) {}
  Motion next(const pipeline::Snapshot& snapshot, MotionResult /*last*/) override {
    stops_.push_back(snapshot.stops);
    return std::exchange(motion_, Drive{0.5});
  }

 private:
  Motion& motion_;
  std::vector<std::size_t>& stops_;
};

class AtlasExplorerTest : public ::testing::Test {
 protected:
  AtlasExplorer explorer(bool begins_new_map = true) {
    return {[this](std::size_t stops) -> std::unique_ptr<Explorer> {
              made_at.push_back(stops);
              return stops < 5 ? std::make_unique<Puppet>(says, told_stops) : nullptr;
            },
            atlas.pipeline().snapshot().stops,
            begins_new_map};
  }
  void stop() {
    atlas.begin_scan();
    atlas.end_scan();
  }
  /// The next motion of the robot, behind what is decided about its maps.
  Motion next(AtlasExplorer& explorer) {
    Motion motion = explorer.next(atlas.pipeline().snapshot(), MotionResult::kReached);
    while (const auto changed = change_maps(atlas, motion)) {
      motion = explorer.next(atlas.pipeline().snapshot(), *changed);
    }
    return motion;
  }

  /// What it asks for where the robot is lost.
  Motion lose(AtlasExplorer& explorer, const pipeline::Snapshot& here) {
    says = Finished{FinishReason::kLost, 1};
    return explorer.next(here, MotionResult::kReached);
  }
  /// Loses the robot in so many maps, and begins another one behind each.
  void lose_maps(AtlasExplorer& explorer, const pipeline::Snapshot& here, int maps) {
    for (int map = 0; map < maps; ++map) {
      ASSERT_TRUE(std::holds_alternative<BeginNewMap>(lose(explorer, here))) << map;
      ASSERT_TRUE(std::holds_alternative<Drive>(explorer.next(here, MotionResult::kReached)))
          << map;
    }
  }

  pipeline::RobotAtlas atlas{[] { return pipeline::RobotPipeline(sensors::RobotGeometry{}); }};
  Motion says = Drive{0.5};
  std::vector<std::size_t> made_at;
  std::vector<std::size_t> told_stops;
};

TEST_F(AtlasExplorerTest, ALostRobotGoesOnInAnotherMapWithAStrategyThatBeginsAnew) {
  stop();
  AtlasExplorer explorer = this->explorer();
  for (int i = 0; i < 3; ++i) {
    stop();
    EXPECT_TRUE(std::holds_alternative<Drive>(next(explorer)));
  }
  says = Finished{FinishReason::kLost, 2};
  EXPECT_TRUE(std::holds_alternative<Drive>(next(explorer)));
  EXPECT_EQ(atlas.previous_maps().size(), 1U);
  EXPECT_EQ(explorer.stops_made(), 3U) << "in both maps";
  EXPECT_EQ(made_at, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(told_stops, (std::vector<std::size_t>{1, 2, 3, 3, 0})) << "its own";
}

TEST_F(AtlasExplorerTest, ALiftedRobotDoesSo) {
  AtlasExplorer explorer = this->explorer();
  stop();
  atlas.on_hazards({.stamp = {}, .lifted = true});
  EXPECT_TRUE(std::holds_alternative<Drive>(next(explorer)));
  EXPECT_EQ(atlas.previous_maps().size(), 1U);
  EXPECT_EQ(atlas.pipeline().snapshot().times_lifted, 0U);
}

TEST_F(AtlasExplorerTest, LeavesTheMapsToWhoeverDrives) {
  AtlasExplorer explorer = this->explorer();
  stop();
  const pipeline::Snapshot one_stop = atlas.pipeline().snapshot();
  says = Turn{1.0};
  EXPECT_TRUE(std::holds_alternative<JoinMaps>(explorer.next(one_stop, MotionResult::kReached)));
  const Motion put_off = explorer.next(one_stop, MotionResult::kRefused);
  ASSERT_TRUE(std::holds_alternative<Turn>(put_off)) << "no previous map: the strategy goes on";
  EXPECT_EQ(std::get<Turn>(put_off).angle_rad, 1.0);
  says = Finished{FinishReason::kLost, 2};
  const Motion change = explorer.next(one_stop, MotionResult::kReached);
  ASSERT_TRUE(std::holds_alternative<BeginNewMap>(change));
  EXPECT_EQ(std::get<BeginNewMap>(change).stops_elsewhere, 2U);
  EXPECT_EQ(atlas.changes(), 0U);
}

TEST_F(AtlasExplorerTest, EndsWhereNoStopIsLeft) {
  AtlasExplorer explorer = this->explorer();
  for (int i = 0; i < 5; ++i) {
    stop();
  }
  says = Finished{FinishReason::kLost, 2};
  const Motion motion = next(explorer);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kStopLimit);
  EXPECT_TRUE(explorer.products().outline_m.empty());
}

TEST_F(AtlasExplorerTest, EndsWithAStrategyThatCannotBeginAnew) {
  AtlasExplorer explorer = this->explorer(false);
  stop();
  atlas.on_hazards({.stamp = {}, .lifted = true});
  says = Finished{FinishReason::kLost, 1};
  const Motion motion = next(explorer);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kLost);
  EXPECT_TRUE(atlas.previous_maps().empty());
}

TEST_F(AtlasExplorerTest, EndsWhereTheRobotIsLostInTheFifthMapInARow) {
  AtlasExplorer explorer = this->explorer();
  const pipeline::Snapshot here = atlas.pipeline().snapshot();
  lose_maps(explorer, here, 4);
  const Motion motion = lose(explorer, here);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion)) << "no sixth map";
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kLost);
  EXPECT_EQ(made_at.size(), 5U);
}

TEST_F(AtlasExplorerTest, CountsTheMapsItIsLostInAnewBehindAJoin) {
  AtlasExplorer explorer = this->explorer();
  pipeline::Snapshot here = atlas.pipeline().snapshot();
  lose_maps(explorer, here, 4);
  ++here.stops;
  ASSERT_TRUE(std::holds_alternative<JoinMaps>(explorer.next(here, MotionResult::kReached)));
  ASSERT_TRUE(std::holds_alternative<Drive>(explorer.next(here, MotionResult::kReached)));
  lose_maps(explorer, here, 4);
  EXPECT_TRUE(std::holds_alternative<Finished>(lose(explorer, here)));
}

/// In a bundled room, by SLAM.
tests::OfflineRun explore(const std::string& room,
                          std::uint32_t seed,
                          const std::vector<tests::OfflineCarry>& carries) {
  tests::OfflineSettings settings;
  settings.slam = slam::slam_by_name("multiscan").make;
  settings.is_watched = true;
  settings.carries = carries;
  return tests::explore_offline(
      tests::bundled_room(room), tests::bundled_robot("uno_2wd"), seed, settings);
}

TEST(AtlasExplorer, ARobotThatIsCarriedOffMapsOnAndFindsItsFormerMapAgain) {
  for (const bool is_felt : {false, true}) {
    const auto run = explore("living_room", 1, {{110.0, {2.2, 2.4, -1.57}, is_felt}});
    EXPECT_GE(run.joins, 1U) << is_felt;
    EXPECT_EQ(run.previous_maps, 0U) << is_felt;
    EXPECT_LT(run.trajectory.final_error_m, 0.25) << is_felt;
    EXPECT_GT(run.agreement.free_iou, 0.75) << is_felt;
    EXPECT_LT(run.agreement.wall_rmse_m.value_or(1.0), 0.12) << is_felt;
  }
}

}  // namespace
}  // namespace echomap::exploration
