// SPDX-License-Identifier: MIT
#include "host/session/pipeline_setup.hpp"

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

TEST(PipelineSetup, BeginsEmpty) {
  EXPECT_EQ(pipeline_for(load_robot_profile("uno_2wd"), "none").snapshot().stops, 0U);
}

TEST(PipelineSetup, PlacesARobotWithASonarBySlam) {
  EXPECT_NE(pipeline_for(load_robot_profile("uno_2wd"), "multiscan").slam(), nullptr);
  EXPECT_EQ(pipeline_for(load_robot_profile("uno_2wd"), "none").slam(), nullptr);
  EXPECT_EQ(pipeline_for(load_robot_profile("create"), "multiscan").slam(), nullptr);
}

}  // namespace
}  // namespace echomap::session
