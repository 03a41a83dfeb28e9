// SPDX-License-Identifier: MIT
#include "host/apps/observation_feed.hpp"

#include <gtest/gtest.h>

#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::apps {
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
  feed.restart();
  feed.take(protocol::Odometry{10'000, 0, 0, 0});
  EXPECT_NEAR(travelled_m(), 0.1, 0.001);
}

TEST_F(ObservationFeedTest, AnswersTheDangersThatItHandsOn) {
  protocol::Status status{};
  status.hazards = protocol::kHazardWheelDrop;
  EXPECT_TRUE(feed.take(status).lifted);
  EXPECT_TRUE(pipeline.snapshot().hazards.lifted);
}

}  // namespace
}  // namespace echomap::apps
