// SPDX-License-Identifier: MIT
#include "host/pipeline/slam_track.hpp"

#include <gtest/gtest.h>

#include "tests/host/pipeline/moved_aside.hpp"

namespace echomap::pipeline {
namespace {

TEST(SlamTrack, StaysWithTheOdometryBeforeAnyScan) {
  MovedAside method;
  SlamTrack track(method);
  track.follow({1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(track.T_map_odom().y_m(), 0.0);
  EXPECT_DOUBLE_EQ(track.trajectory().front().x_m(), 1.0);
  EXPECT_EQ(method.followed, 1U) << "it is told of the way between scans";
}

TEST(SlamTrack, GoesOnFromTheLastScan) {
  MovedAside method;
  SlamTrack track(method);
  track.follow({1.0, 0.0, 0.0});
  track.add({1.1, 0.0, 0.0}, {});
  track.follow({2.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(track.T_map_odom().y_m(), 1.0);
  const auto trajectory = track.trajectory();
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_DOUBLE_EQ(trajectory[0].y_m(), 1.0) << "a scan belongs to the instant before it";
  EXPECT_DOUBLE_EQ(trajectory[1].x_m(), 2.0);
  EXPECT_DOUBLE_EQ(trajectory[1].y_m(), 1.0);
}

TEST(SlamTrack, MovesThePastWithWhatIsLearntLater) {
  MovedAside method;
  SlamTrack track(method);
  track.follow({});
  track.follow({1.0, 0.0, 0.0});
  track.add({1.0, 0.0, 0.0}, {});
  method.T_map_odom = {0.0, 2.0, 0.0};
  const std::size_t instants[] = {0, 1, 7};
  const auto T_map_odom = track.T_map_odom_at(instants);
  EXPECT_DOUBLE_EQ(T_map_odom[0].y_m(), 0.0) << "before any scan";
  EXPECT_DOUBLE_EQ(T_map_odom[1].y_m(), 2.0);
  EXPECT_DOUBLE_EQ(T_map_odom[2].y_m(), 1.0) << "to come: as of the last scan";
}

}  // namespace
}  // namespace echomap::pipeline
