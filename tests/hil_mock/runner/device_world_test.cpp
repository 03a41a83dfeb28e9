// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_world.hpp"

#include <gtest/gtest.h>

#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

DeviceOptions in_office(std::size_t robots) {
  DeviceOptions options;
  options.world = "office";
  options.robots = robots;
  return options;
}

TEST(DeviceWorld, OneRobotStartsWhereTheRoomOrTheCommandLineSays) {
  const DeviceOptions usual = in_office(1);
  const auto starts = device_starts(usual);
  ASSERT_EQ(starts.size(), 1U);
  EXPECT_EQ(starts[0].position_m(), load_world(usual)->T_world_robot().position_m());
  DeviceOptions elsewhere = in_office(1);
  elsewhere.T_world_start = geometry::Pose2(1.5, 1.7, 0.5);
  EXPECT_EQ(device_starts(elsewhere)[0].position_m(), Eigen::Vector2d(1.5, 1.7));
  EXPECT_EQ(load_world(elsewhere)->T_world_robot().heading_rad(), 0.5);
}

TEST(DeviceWorld, OfSeveralTheFirstKeepsItsStartAndTheOthersAreDrawnBySeed) {
  DeviceOptions options = in_office(3);
  const auto starts = device_starts(options);
  ASSERT_EQ(starts.size(), 3U);
  EXPECT_EQ(starts[0].position_m(), device_starts(in_office(1))[0].position_m());
  EXPECT_EQ(device_starts(options)[2].position_m(), starts[2].position_m());
  options.seed = 2;
  EXPECT_NE(device_starts(options)[2].position_m(), starts[2].position_m());
  options.draws_starts = true;
  EXPECT_NE(device_starts(options)[0].position_m(), starts[0].position_m());
}

TEST(DeviceWorld, StartsThatAreGivenAreTaken) {
  DeviceOptions options = in_office(2);
  options.starts = {{1.6, 1.6, 0.0}, {3.0, 1.6, 1.0}};
  EXPECT_EQ(device_starts(options)[1].position_m(), Eigen::Vector2d(3.0, 1.6));
  options.starts[1] = {1.7, 1.6, 0.0};
  EXPECT_THROW(device_starts(options), files::ConfigError) << "in one another";
}

TEST(DeviceWorld, WhatDoesNotFitIsRefused) {
  DeviceOptions options = in_office(1);
  options.T_world_start = geometry::Pose2(-1.0, 0.0, 0.0);
  EXPECT_THROW(load_world(options), files::ConfigError);
  DeviceOptions crowd = in_office(16);
  EXPECT_THROW(device_starts(crowd), files::ConfigError);
  DeviceOptions nowhere = in_office(1);
  nowhere.world = "offise";
  EXPECT_THROW(device_starts(nowhere), files::ConfigError);
}

}  // namespace
}  // namespace echomap::runner
