// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fault_runs.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "hil_mock/world/part_faults.hpp"

namespace echomap::bench {
namespace {

TEST(FaultRuns, EveryBuiltFaultIsOneOfTheSimulatedRobot) {
  for (const BuiltFault& fault : built_faults()) {
    EXPECT_NO_THROW(world::parse_part_faults(fault.part_faults)) << fault.part_faults;
    EXPECT_FALSE(fault.name.empty());
  }
}

TEST(FaultRuns, DrawsAsManySoundRobotsAsOthers) {
  const auto robots = draw_robots({"office", "studio"}, 40, 7);
  ASSERT_EQ(robots.size(), 80U);
  const auto rough = std::count_if(robots.begin(), robots.end(), [](const DrawnRobot& robot) {
    return robot.body == "uno_2wd_rough" && robot.fault.name.empty();
  });
  const auto sound = std::count_if(robots.begin(), robots.end(), [](const DrawnRobot& robot) {
    return robot.fault.name.empty() && robot.fault.part_faults.empty();
  });
  EXPECT_EQ(sound, 40);
  EXPECT_EQ(rough, 20);
  const auto again = draw_robots({"office", "studio"}, 40, 7);
  EXPECT_EQ(robots[10].fault.part_faults, again[10].fault.part_faults);
}

TEST(FaultRuns, CountsWhatWasNamedRightWronglyAndNotAtAll) {
  const DrawnRobot counts{{"counts@0:inf:0.5", "counts"}, "office", "uno_2wd", 1};
  const DrawnRobot fine{{}, "office", "uno_2wd", 1};
  const DrawnRobot rough{{}, "office", "uno_2wd_rough", 1};
  const auto figures = fault_figures({{counts, true, "counts", 3},
                                      {counts, true, "counts", 4},
                                      {counts, true, "not-moving", 2},
                                      {counts, true, "", 0},
                                      {fine, true, "", 0},
                                      {fine, false, "", 0},
                                      {rough, true, "wheel-size", 5}});
  const auto value = [&](const std::string& name) {
    return std::find_if(figures.begin(),
                        figures.end(),
                        [&](const Figure& figure) { return figure.name == name; })
        ->value;
  };
  EXPECT_EQ(value("faults_named_percent"), 50.0);
  EXPECT_EQ(value("faults_named_wrongly_percent"), 25.0);
  EXPECT_EQ(value("faults_named_in_3_stops_percent"), 25.0);
  EXPECT_EQ(value("healthy_accused_of_200"), 1.0);
  EXPECT_EQ(value("healthy_accused_rough"), 1.0);
}

}  // namespace
}  // namespace echomap::bench
