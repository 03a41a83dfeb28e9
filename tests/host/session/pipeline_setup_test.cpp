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

TEST(PipelineSetup, MapsWhatIsOnlyFeltInTheCellsThatAreAskedFor) {
  const auto cell_m = [](const char* robot, double near_cell_m) {
    return pipeline_for(load_robot_profile(robot), "none", near_cell_m)
        .snapshot()
        .grid->resolution_m();
  };
  EXPECT_EQ(cell_m("epuck", 0.001), 0.001);
  EXPECT_EQ(cell_m("epuck", kNearCellM), 0.01);
  EXPECT_NE(cell_m("uno_2wd", 0.001), 0.001) << "it has a sonar";
}

}  // namespace
}  // namespace echomap::session
