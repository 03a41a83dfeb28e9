// SPDX-License-Identifier: MIT
#include "host/apps/live_source.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/live_page/read_messages.hpp"
#include "tests/host/pipeline/plain_robot.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::apps {
namespace {

using live_page::MessageKind;
using live_page::of_kind;
using mapping::CellState;

class IntendingExplorer final : public exploration::Explorer {
 public:
  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/,
                           exploration::MotionResult /*last*/) override {
    return exploration::Finished{};
  }
  exploration::Intent intent() const override {
    return {exploration::IntentKind::kOpening, std::nullopt, {}};
  }
};

class LiveSourceTest : public testing::Test {
 protected:
  std::size_t sent(MessageKind kind) const { return of_kind(*history, kind).size(); }

  std::shared_ptr<live_page::History> history = std::make_shared<live_page::History>();
  live_page::RunPublisher publisher{
      history, live_page::RunFacts(), session::load_robot_profile("uno_2wd")};
};

class AtlasSourceTest : public LiveSourceTest {
 protected:
  /// Of a robot that has driven on for 10 cm and hears a wall 1 m ahead of it.
  void stop() {
    travel_m += 0.1;
    const sensors::WheelTravel travel{travel_m, travel_m};
    atlas.on_odometry({stamp += std::chrono::milliseconds(20), travel});
    atlas.begin_scan();
    for (const double pan_rad : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
      stamp += std::chrono::milliseconds(50);
      atlas.on_sonar({stamp, travel, pan_rad, 1.0 / std::cos(pan_rad), true});
    }
    atlas.end_scan();
  }
  static live_page::RunState state(const AtlasSource& source) {
    live_page::RunState state;
    source.describe(state);
    return state;
  }
  static live_page::EventFacts facts(const AtlasSource& source) {
    live_page::EventFacts facts;
    source.describe(facts);
    return facts;
  }
  AtlasSource new_source(const exploration::Explorer* explorer = nullptr) {
    return {atlas, explorer, [this] { return progress; }};
  }

  pipeline::RobotAtlas atlas{[] { return pipeline::RobotPipeline(pipeline::wide_robot()); }};
  time::RobotTime stamp;
  double travel_m = 0.0;
  LiveProgress progress;
};

TEST_F(AtlasSourceTest, ShowsTheMapAndThePoseOfTheRobot) {
  AtlasSource source = new_source();
  stop();
  source.publish(1.0, publisher);
  EXPECT_GE(sent(MessageKind::kTile), 1U);
  EXPECT_EQ(sent(MessageKind::kTrail), 1U);
  EXPECT_EQ(sent(MessageKind::kNewMap), 0U);
  ASSERT_TRUE(source.pose());
  EXPECT_NEAR(source.pose()->T_map_robot.x_m(), 0.1, 1e-9);
}

TEST_F(AtlasSourceTest, BeginsANewMapOnThePageWithThatOfTheAtlas) {
  AtlasSource source = new_source();
  stop();
  source.publish(1.0, publisher);
  atlas.begin_new_map(0);
  source.publish(2.0, publisher);
  source.publish(3.0, publisher);
  const auto begins = of_kind(*history, MessageKind::kNewMap);
  ASSERT_EQ(begins.size(), 1U);
  EXPECT_EQ(begins.front()->time_s, 2.0);
}

TEST_F(AtlasSourceTest, CountsTheNewMapsSinceItIsThere) {
  stop();
  atlas.begin_new_map(0);
  AtlasSource source = new_source();
  source.publish(1.0, publisher);
  EXPECT_EQ(sent(MessageKind::kNewMap), 0U);
  EXPECT_EQ(facts(source).maps_changed, 0U) << "those of a run that is resumed are no event";
  EXPECT_EQ(facts(source).maps_joined, 0U);
  stop();
  atlas.begin_new_map(0);
  EXPECT_GT(facts(source).maps_changed, 0U);
}

TEST_F(AtlasSourceTest, TellsHowFarTheRunHasCome) {
  progress = {3, 4.5, 6.0, 60.0, std::nullopt, std::nullopt};
  const live_page::RunState told = state(new_source());
  EXPECT_EQ(told.stops, 3U);
  EXPECT_EQ(told.floor_m2, 4.5);
  EXPECT_EQ(told.travelled_m, 6.0);
  EXPECT_FALSE(told.coverage);
  EXPECT_FALSE(told.left_s);
}

TEST_F(AtlasSourceTest, PassesTheCoverageOnAndGuessesByItWhatIsLeft) {
  const AtlasSource source = new_source();
  progress.elapsed_s = 60.0;
  progress.coverage.emplace();
  progress.coverage->seen_m2 = 9.0;
  progress.coverage->unseen_m2 = 3.0;
  EXPECT_DOUBLE_EQ(state(source).coverage.value(), 0.75);
  EXPECT_EQ(state(source).unseen_m2, 3.0);
  EXPECT_DOUBLE_EQ(state(source).left_s.value(), 20.0);
  progress.coverage->seen_m2 = 0.0;
  EXPECT_FALSE(state(source).left_s) << "nothing to guess by";
}

TEST_F(AtlasSourceTest, ALimitOfTimeCountsBeforeAGuess) {
  const AtlasSource source = new_source();
  progress.elapsed_s = 60.0;
  progress.longest_left_s = 5.0;
  EXPECT_EQ(state(source).left_s, 5.0);
  progress.coverage = exploration::Coverage{9.0, 3.0, {}, {}};
  EXPECT_EQ(state(source).left_s, 5.0);
}

TEST_F(AtlasSourceTest, TellsWhatTheExplorerIsAbout) {
  const IntendingExplorer explorer;
  EXPECT_EQ(state(new_source(&explorer)).intent.kind, exploration::IntentKind::kOpening);
  EXPECT_EQ(state(new_source()).intent.kind, exploration::IntentKind::kStrategy);
}

/// Knows so many poses, and itself to be at the first of them.
class KnowingFilter final : public tracking::LiveFilter, public pipeline::ObservationSink {
 public:
  pipeline::ObservationSink& sink() override { return *this; }
  void poll(const session::RobotSession& /*session*/) override {}
  void begin(session::RobotSession& /*session*/) override {}
  void on_odometry(const sensors::OdometryObservation& /*observation*/) override {}
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void begin_scan() override {}
  void end_scan() override {}
  bool has_lost_it() override { return false; }
  double telling(const geometry::Pose2& /*T_robot_goal*/) const override { return 0.0; }
  std::optional<localization::PoseGaussian> estimate() const override {
    return poses.empty() ? std::nullopt
                         : std::optional(localization::PoseGaussian{
                               poses.front(), 0.25 * Eigen::Matrix3d::Identity()});
  }
  const localization::PoseBelief* hypotheses() const override {
    return belief ? &*belief : nullptr;
  }
  std::vector<geometry::Pose2> sampled_poses(std::size_t count) const override {
    return {poses.begin(), poses.begin() + static_cast<int>(std::min(count, poses.size()))};
  }
  std::string line() const override { return {}; }
  nlohmann::ordered_json report() const override { return {}; }
  const std::vector<pipeline::StampedPose>& trajectory() const override { return stops; }

  std::vector<geometry::Pose2> poses;
  std::optional<localization::PoseBelief> belief;
  std::vector<pipeline::StampedPose> stops;
};

class FilterSourceTest : public LiveSourceTest {
 protected:
  /// The newest set of particles.
  std::string particles() const {
    const auto sets = of_kind(*history, MessageKind::kParticles);
    return sets.empty() ? std::string() : body_of(*sets.back());
  }

  KnowingFilter filter;
};

TEST_F(FilterSourceTest, SendsTheMapOnce) {
  FilterSource source(filter, as_grid(tests::map_from({"###", "#.#", "###"})));
  source.publish(1.0, publisher);
  source.publish(2.0, publisher);
  EXPECT_EQ(sent(MessageKind::kTile), 1U);
}

TEST_F(FilterSourceTest, SendsParticlesWhoseWeightsSumToOne) {
  filter.poses = {{1.0, 2.0, 0.5}, {3.0, 4.0, 0.25}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  FilterSource source(filter, std::nullopt);
  source.publish(1.0, publisher);
  const std::string set = particles();
  ASSERT_EQ(live_page::u32_at(set, 0), 4U);
  EXPECT_EQ(live_page::f32_at(set, 8), 1.0F);
  EXPECT_EQ(live_page::f32_at(set, 24), 3.0F);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(live_page::f32_at(set, 8 + 16 * i + 12), 0.25F);
  }
}

TEST_F(FilterSourceTest, SendsAThousandParticlesAtMost) {
  filter.poses.resize(5000);
  FilterSource source(filter, std::nullopt);
  source.publish(1.0, publisher);
  EXPECT_EQ(live_page::u32_at(particles(), 0), 1000U);
  EXPECT_FLOAT_EQ(live_page::f32_at(particles(), 8 + 12), 0.001F);
}

TEST_F(FilterSourceTest, SendsThatTheParticlesAreGone) {
  FilterSource source(filter, std::nullopt);
  source.publish(1.0, publisher);
  EXPECT_EQ(live_page::u32_at(particles(), 0), 0U);
}

TEST_F(FilterSourceTest, HasAPoseWhereTheFilterHasOne) {
  FilterSource source(filter, std::nullopt);
  EXPECT_FALSE(source.pose());
  filter.poses = {{1.0, 2.0, 0.5}};
  ASSERT_TRUE(source.pose());
  EXPECT_EQ(source.pose()->T_map_robot.y_m(), 2.0);
  EXPECT_EQ(source.pose()->covariance.value()(0, 0), 0.25);
}

TEST_F(FilterSourceTest, TellsWhatTheFilterBelieves) {
  const FilterSource source(filter, std::nullopt);
  live_page::RunState state;
  source.describe(state);
  EXPECT_FALSE(state.belief);
  filter.belief.emplace();
  filter.belief->lost_probability = 0.5;
  filter.stops.resize(3);
  source.describe(state);
  EXPECT_EQ(state.belief.value().lost_probability, 0.5);
  EXPECT_EQ(state.stops, 3U);
}

/// The grid as it is drawn, without the margin of a raster.
tests::DrawnMap drawing_of_grid(const mapping::RasterMap& map) {
  const mapping::OccupancyGrid grid = as_grid(map);
  return tests::drawing_of(
      cut_out(mapping::rasterize(grid), {{1, 1}, {grid.bounds().columns(), grid.bounds().rows()}}));
}

TEST(AsGrid, IsTheMapCellByCellAtTheSameResolution) {
  const tests::DrawnMap room{"####", "#..#", "#. #", "####"};
  EXPECT_EQ(drawing_of_grid(tests::map_from(room, 0.05, {-0.1, 0.25})), room);
}

TEST(AsGrid, LosesNoColumnWhereTheCellsLieBetweenThoseOfTheGrid) {
  const tests::DrawnMap room{"#.#.#.#.#.#.#.#"};
  const mapping::OccupancyGrid grid = as_grid(tests::map_from(room, 0.05, {0.025, 0.025}));
  int walls = 0;
  for (int x = -1; x < 17; ++x) {
    const auto is_wall = [&](int y) { return grid.state({x, y}) == CellState::kOccupied; };
    walls += is_wall(0) || is_wall(1) ? 1 : 0;
  }
  EXPECT_GE(walls, 8);
}

TEST(AsGrid, HasEveryCellOfACoarserMap) {
  EXPECT_EQ(drawing_of_grid(tests::map_from({"#.", "##"}, 0.1)),
            (tests::DrawnMap{"##..", "##..", "####", "####"}));
}

TEST(AsGrid, KeepsTheWallsOfAFinerMap) {
  const tests::DrawnMap thin(10, ".#...");
  const mapping::OccupancyGrid left = as_grid(tests::map_from(thin, 0.01));
  EXPECT_EQ(left.state({0, 0}), CellState::kOccupied) << "a wall of 1 cm in a cell of 5 cm";
  EXPECT_EQ(left.state({0, 1}), CellState::kOccupied);
  const mapping::OccupancyGrid free = as_grid(tests::map_from(tests::DrawnMap(5, "....."), 0.01));
  EXPECT_EQ(free.state({0, 0}), CellState::kFree);
}

TEST(AsGrid, KeepsUnknownWhatIsUnknown) {
  const mapping::OccupancyGrid grid = as_grid(tests::map_from({"   ", " . ", "   "}));
  EXPECT_EQ(grid.state({1, 1}), CellState::kFree);
  EXPECT_EQ(grid.bounds(), (mapping::CellBounds{{1, 1}, {1, 1}}));
}

}  // namespace
}  // namespace echomap::apps
