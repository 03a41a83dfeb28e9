// SPDX-License-Identifier: MIT
#include "host/strategies/coastal_setup.hpp"

#include <gtest/gtest.h>

namespace echomap::strategies {
namespace {

using exploration::Hand;

TEST(CoastalSetup, NeedsTheWallSensorOnTheSideOfTheHand) {
  const auto create = session::load_robot_profile("create");
  const auto create_left = session::load_robot_profile("create_left");
  EXPECT_EQ(lack_for_coastal(create, Hand::kRight), "");
  EXPECT_EQ(lack_for_coastal(create, Hand::kLeft), "its wall sensor on the left");
  EXPECT_EQ(lack_for_coastal(create_left, Hand::kLeft), "");
  EXPECT_EQ(lack_for_coastal(create_left, Hand::kRight), "its wall sensor on the right");
  EXPECT_EQ(lack_for_coastal(session::load_robot_profile("epuck"), Hand::kRight),
            "a wall sensor on a pin named 'wall'");
}

TEST(CoastalSetup, TakesTheRobotFromItsProfile) {
  auto profile = session::load_robot_profile("create");
  profile.distance_correction = {1.02, 0.004};
  const auto params = coastal_params(profile, Hand::kRight);
  EXPECT_EQ(params.robot_radius_m, profile.body_radius_m);
  EXPECT_EQ(params.T_robot_sensor.y_m(), -0.10);
  EXPECT_EQ(params.correction.slope, 1.02);
  EXPECT_EQ(params.correction.offset_m, 0.0);
  EXPECT_NO_THROW(exploration::Coastal{params});
}

TEST(CoastalSetup, FollowsThePaperToTheLetterWhereThatIsAskedFor) {
  const auto profile = session::load_robot_profile("create");
  const auto ours = coastal_params(profile, Hand::kRight);
  const auto told = as_told(ours);
  EXPECT_EQ(told.rule, exploration::TraversalRule::kAngleAboutStart);
  EXPECT_EQ(told.min_gap_m, 0.0);
  EXPECT_EQ(told.robot_radius_m, ours.robot_radius_m);
}

}  // namespace
}  // namespace echomap::strategies
