// SPDX-License-Identifier: MIT
#include "host/apps/source_setup.hpp"

#include <gtest/gtest.h>

#include "host/apps/commands.hpp"

namespace echomap::apps {
namespace {

TEST(SourceSetup, NeedsASensorThatCountsPulses) {
  EXPECT_NO_THROW(validate_searcher(session::load_robot_profile("uno_geiger")));
  EXPECT_THROW(validate_searcher(session::load_robot_profile("uno_2wd")), CommandError);
  auto level = session::load_robot_profile("uno_geiger");
  level.sensors.scalar->kind = sensors::ScalarKind::kLevel;
  EXPECT_THROW(validate_searcher(level), CommandError);
}

TEST(SourceSetup, IsThatOfTheRobot) {
  const auto profile = session::load_robot_profile("uno_geiger");
  EXPECT_DOUBLE_EQ(source_readings_params(profile).dead_time_s, 190e-6);
  EXPECT_DOUBLE_EQ(source_search_params(profile).choice.speed_m_per_s, profile.speed_m_per_s);
}

}  // namespace
}  // namespace echomap::apps
