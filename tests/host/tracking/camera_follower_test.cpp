// SPDX-License-Identifier: MIT
#include "host/tracking/camera_follower.hpp"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/host/tracking/told_stream.hpp"

namespace echomap::tracking {
namespace {

/// A robot that stands under a camera.
class CameraFollowerTest : public session::SessionOnACable {
 protected:
  CameraFollowerTest() {
    follower = std::make_unique<CameraFollower>(
        profile.geometry, FixStream(std::make_unique<tests::ToldStream>(bytes)), atlas, fork);
    fork.add(follower->sink());
    fork.add(atlas);
    session = std::make_unique<session::RobotSession>(new_connection(), profile, fork);
    session->connect();
    session->on_step = [this] { follower->poll(*session); };
  }
  void tell(double stamp_s, double x_m, double heading_rad) {
    bytes = "{\"stamp_s\": " + std::to_string(stamp_s) +
            ", \"sent_s\": " + std::to_string(stamp_s + 0.1) + ", \"x_m\": " + std::to_string(x_m) +
            ", \"y_m\": 1.0, \"heading_rad\": " + std::to_string(heading_rad) + "}\n";
  }
  void let_pass(int ms) {
    session->wait_until([] { return false; }, std::chrono::milliseconds(ms));
  }

  std::string bytes;
  pipeline::ObservationFork fork;
  pipeline::RobotAtlas atlas = session::atlas_for(profile, session::kNoSlam);
  std::unique_ptr<CameraFollower> follower;
};

TEST_F(CameraFollowerTest, BeginsTheMapWhereTheRobotStandsAndMovesItWithTheFixes) {
  tell(70.0, 2.0, 1.5707963);
  follower->begin(*session);
  EXPECT_NEAR(atlas.pipeline().snapshot().latest.T_map_robot.position_m().norm(), 0.0, 1e-6);
  for (int i = 0; i < 20; ++i) {
    tell(73.1 + 0.1 * i, 1.97, 1.5707963);
    let_pass(100);
  }
  // The camera's -x is the map's y, as the robot looked along the camera's y.
  const auto& pose = atlas.pipeline().snapshot().latest.T_map_robot;
  EXPECT_NEAR(pose.x_m(), 0.0, 0.005);
  EXPECT_NEAR(pose.y_m(), 0.03, 0.01);
}

TEST_F(CameraFollowerTest, ContinuesInTheFrameOfAMapThatThereIs) {
  atlas.on_pose_fix({time::RobotTime{}, {1.0, 0.5, 0.0}});
  tell(70.0, 2.0, 1.5707963);
  follower->begin(*session);
  tell(73.1, 2.0, 1.5707963);
  let_pass(200);
  const auto& pose = atlas.pipeline().snapshot().latest.T_map_robot;
  EXPECT_NEAR(pose.x_m(), 1.0, 0.005);
  EXPECT_NEAR(pose.y_m(), 0.5, 0.005);
}

TEST_F(CameraFollowerTest, ItsFixesAreInTheRecord) {
  tell(70.0, 2.0, 1.5707963);
  follower->begin(*session);
  tell(73.1, 1.97, 1.5707963);
  let_pass(200);
  pipeline::RobotAtlas again = session::atlas_for(profile, session::kNoSlam);
  atlas.record().replay(again);
  const auto live = atlas.pipeline().snapshot().latest;
  const auto replayed = again.pipeline().snapshot().latest;
  EXPECT_NE(live.T_map_robot.y_m(), 0.0);
  EXPECT_EQ(replayed.T_map_robot.position_m(), live.T_map_robot.position_m());
  EXPECT_EQ(replayed.T_map_robot.heading_rad(), live.T_map_robot.heading_rad());
}

TEST_F(CameraFollowerTest, EndsWithoutAFix) {
  EXPECT_THROW(follower->begin(*session), console::CommandError);
}

TEST(CameraAt, IsNoneWithoutAnAddress) {
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  pipeline::RobotAtlas atlas = session::atlas_for(profile, session::kNoSlam);
  EXPECT_FALSE(camera_at("", profile, atlas, atlas));
  EXPECT_THROW(camera_at("nowhere", profile, atlas, atlas), console::CommandError);
}

}  // namespace
}  // namespace echomap::tracking
