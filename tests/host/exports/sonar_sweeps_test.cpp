// SPDX-License-Identifier: MIT
#include "host/exports/sonar_sweeps.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exports {
namespace {

using geometry::Pose2;
using geometry::radians;

/// A robot whose sonar pans around a point ahead of its middle, its face ahead of that point.
mapping::PlacedReading reading_at(const Pose2& T_map_robot,
                                  double pan_deg,
                                  std::optional<double> range_m) {
  const Pose2 T_robot_axis(0.03, 0.01, radians(pan_deg));
  return {T_map_robot, T_map_robot * T_robot_axis * Pose2(0.02, 0.0, 0.0), range_m};
}

mapping::Scan panned(const Pose2& T_map_robot, const std::vector<double>& pans_deg) {
  mapping::Scan scan;
  for (const double pan_deg : pans_deg) {
    scan.push_back(reading_at(T_map_robot, pan_deg, 1.0 + 0.01 * pan_deg));
  }
  return scan;
}

std::vector<std::size_t> sizes_of(const std::vector<SonarSweep>& sweeps) {
  std::vector<std::size_t> sizes;
  for (const SonarSweep& sweep : sweeps) {
    sizes.push_back(sweep.readings.size());
  }
  return sizes;
}

TEST(SonarSweeps, LeaveEveryEchoWhereItIs) {
  const Pose2 T_map_robot(1.0, 2.0, 3.0);
  const mapping::Scan scan = panned(T_map_robot, {-40.0, -20.0, 0.0, 20.0, 40.0});
  const auto sweeps = sweeps_of(scan);
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{5});
  const SonarSweep& sweep = sweeps.front();
  EXPECT_NEAR(sweep.step_rad, radians(20.0), 1e-9);
  EXPECT_NEAR(sweep.first_rad, radians(-40.0), 1e-9);
  EXPECT_EQ(sweep.T_map_robot.position_m(), T_map_robot.position_m());
  EXPECT_TRUE(sweep.T_map_sensor.position_m().isApprox(T_map_robot * Eigen::Vector2d(0.03, 0.01)))
      << "the axis of the pan";
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Pose2 T_sensor_beam(0.0, 0.0, sweep.bearing_rad(i));
    const Eigen::Vector2d echo_m = sweep.T_map_sensor * T_sensor_beam *
                                   Eigen::Vector2d(sweep.readings[i].range_m.value_or(0.0), 0.0);
    EXPECT_LT((echo_m - mapping::echo_point_m(scan[i]).value()).norm(), 1e-9) << i;
  }
}

TEST(SonarSweeps, RunCounterClockwiseHoweverTheSonarTurned) {
  const auto sweeps = sweeps_of(panned({}, {30.0, 20.0, 10.0, 0.0}));
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{4});
  EXPECT_NEAR(sweeps[0].step_rad, radians(10.0), 1e-9);
  EXPECT_NEAR(sweeps[0].T_map_sensor.heading_rad(), radians(15.0), 1e-9);
  EXPECT_LT(sweeps[0].readings.front().range_m.value_or(9.0),
            sweeps[0].readings.back().range_m.value_or(0.0));
}

TEST(SonarSweeps, EndWhereTheSonarTurnsBackAndWhereTheRobotMovesOn) {
  EXPECT_EQ(sizes_of(sweeps_of(panned({}, {0.0, 10.0, 20.0, 10.0, 0.0}))),
            (std::vector<std::size_t>{3, 2}));
  mapping::Scan scan = panned({}, {0.0, 10.0, 20.0});
  const mapping::Scan elsewhere = panned({0.5, 0.0, 0.0}, {30.0, 40.0});
  scan.insert(scan.end(), elsewhere.begin(), elsewhere.end());
  EXPECT_EQ(sizes_of(sweeps_of(scan)), (std::vector<std::size_t>{3, 2}));
}

TEST(SonarSweeps, EndWhereReadingsAreNotEven) {
  EXPECT_EQ(sizes_of(sweeps_of(panned({}, {0.0, 20.0, 40.4}))), std::vector<std::size_t>{3});
  EXPECT_EQ(sizes_of(sweeps_of(panned({}, {0.0, 20.0, 42.0, 62.0}))),
            (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(sizes_of(sweeps_of(panned({}, {0.0, 0.0}))), (std::vector<std::size_t>{1, 1}));
}

TEST(SonarSweeps, HoldADirectionThatWasLeftOutWithoutAnAnswer) {
  const auto sweeps = sweeps_of(panned({}, {0.0, 5.0, 10.0, 25.0}));
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{6});
  EXPECT_EQ(sweeps[0].readings[3], SweepReading{});
  EXPECT_EQ(sweeps[0].readings[4], SweepReading{});
  EXPECT_TRUE(sweeps[0].readings[5].has_answered);
}

TEST(SonarSweeps, TellSilenceFromASonarThatDoesNotAnswer) {
  mapping::Scan scan{reading_at({}, 0.0, std::nullopt), reading_at({}, 10.0, std::nullopt)};
  scan[1].has_answered = false;
  const auto sweeps = sweeps_of(scan);
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{2});
  EXPECT_EQ(sweeps[0].readings[0], (SweepReading{std::nullopt, true}));
  EXPECT_EQ(sweeps[0].readings[1], (SweepReading{std::nullopt, false}));
}

TEST(SonarSweeps, OfARobotThatTurnsUnderItsSonarAreAroundItsMiddle) {
  mapping::Scan scan;
  for (int i = 0; i < 8; ++i) {
    const Pose2 T_map_robot(1.0, 1.0, radians(30.0 * i));
    scan.push_back({T_map_robot, T_map_robot * Pose2(0.08, 0.0, 0.0), 0.5});
  }
  const auto sweeps = sweeps_of(scan);
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{8});
  EXPECT_TRUE(sweeps[0].T_map_sensor.position_m().isApprox(Eigen::Vector2d(1.0, 1.0)));
  EXPECT_NEAR(sweeps[0].readings[3].range_m.value_or(0.0), 0.58, 1e-9);
}

TEST(SonarSweeps, GoOnceAroundAtMost) {
  std::vector<double> pans_deg;
  for (int i = 0; i < 40; ++i) {
    pans_deg.push_back(10.0 * i);
  }
  EXPECT_EQ(sizes_of(sweeps_of(panned({}, pans_deg))), (std::vector<std::size_t>{36, 4}));
}

TEST(SonarSweeps, OfASingleReadingHaveNoStep) {
  const auto sweeps = sweeps_of({reading_at({}, 20.0, 1.0)});
  ASSERT_EQ(sizes_of(sweeps), std::vector<std::size_t>{1});
  EXPECT_EQ(sweeps[0].step_rad, 0.0);
  EXPECT_EQ(sweeps[0].readings[0].range_m, 1.0);
  EXPECT_NEAR(sweeps[0].T_map_sensor.heading_rad(), radians(20.0), 1e-9);
}

TEST(SonarSweeps, OfNothingAreNone) { EXPECT_TRUE(sweeps_of({}).empty()); }

}  // namespace
}  // namespace echomap::exports
