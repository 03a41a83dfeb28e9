// SPDX-License-Identifier: MIT
#include "host/session/observation_feed.hpp"

#include <gtest/gtest.h>

#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::session {
namespace {

class ObservationFeedTest : public testing::Test {
 protected:
  double travelled_m() const { return pipeline.snapshot().latest.T_map_robot.x_m(); }

  const RobotProfile profile = load_robot_profile("uno_2wd");
  pipeline::RobotPipeline pipeline{profile.geometry};
  ObservationFeed feed{profile, pipeline};
};

TEST_F(ObservationFeedTest, MovesThePipelineByTheProfilesTicks) {
  feed.take(protocol::Odometry{0, 0, 0, 0});
  const auto ticks = profile.geometry.straight(0.1);
  feed.take(protocol::Odometry{
      20'000, static_cast<std::int16_t>(ticks.left), static_cast<std::int16_t>(ticks.right), 0});
  EXPECT_NEAR(travelled_m(), 0.1, 0.001);
}

TEST_F(ObservationFeedTest, KeepsThePoseThroughAReset) {
  feed.take(protocol::Odometry{0, 0, 0, 0});
  const auto ticks = profile.geometry.straight(0.1);
  feed.take(protocol::Odometry{
      20'000, static_cast<std::int16_t>(ticks.left), static_cast<std::int16_t>(ticks.right), 0});
  feed.restart(std::chrono::seconds(2));
  feed.take(protocol::Odometry{10'000, 0, 0, 0});
  EXPECT_NEAR(travelled_m(), 0.1, 0.001);
  EXPECT_EQ(pipeline.snapshot().latest.stamp.time_since_epoch(), std::chrono::milliseconds(2020));
}

TEST_F(ObservationFeedTest, TakesASonarThatDoesNotAnswerForSilent) {
  pipeline.begin_scan();
  feed.take(protocol::Echo{0, 0, protocol::kNoSonar, 0, 0});
  feed.take(protocol::Echo{50'000, 0, protocol::kNoEcho, 0, 0});
  pipeline.end_scan();
  const mapping::Scan scan = *pipeline.snapshot().last_scan;
  ASSERT_EQ(scan.size(), 2U);
  EXPECT_FALSE(scan[0].has_answered);
  EXPECT_TRUE(scan[1].has_answered);
}

TEST_F(ObservationFeedTest, KeepsTheDangersThatItHandsOn) {
  protocol::Status status{};
  status.hazards = protocol::kHazardWheelDrop;
  feed.take(status);
  EXPECT_TRUE(feed.hazards().lifted);
  EXPECT_TRUE(pipeline.snapshot().hazards.lifted);
}

TEST_F(ObservationFeedTest, TellsABumpWithTheOdometryAndForgetsNoDanger) {
  protocol::Status status{};
  status.hazards = protocol::kHazardWall;
  feed.take(status);
  feed.take(protocol::Odometry{20'000, 0, 0, protocol::kFlagArmed | protocol::kFlagBumpRight});
  const auto hazards = pipeline.snapshot().hazards;
  EXPECT_TRUE(hazards.bump_right);
  EXPECT_FALSE(hazards.bump_left);
  EXPECT_TRUE(hazards.wall);
  feed.take(protocol::Odometry{40'000, 0, 0, 0});
  EXPECT_FALSE(pipeline.snapshot().hazards.is_touching());
}

}  // namespace
}  // namespace echomap::session
