// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_device.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "host/files/toml_reader.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

const DeviceProgram device_program{
    "echomap-fake", {}, [](const BoardOptions&) { return std::make_unique<FakeBoard>(); }};

class RobotDeviceTest : public testing::Test {
 protected:
  RobotDeviceTest() {
    options.link = folder / "robot";
    options.truth = folder / "truth";
  }

  tests::ScratchFolder folder;
  DeviceOptions options;
};

TEST_F(RobotDeviceTest, SaysWhatItIsAndWhereItListens) {
  const RobotDevice device(device_program, options);
  EXPECT_EQ(device.hello(), R"({"lockstep":1,"firmware":"fake 1.0","emulator":"none"})");
  EXPECT_EQ(device.whereabouts(),
            "uno_2wd in living_room listens on " + (folder / "robot").string());
  EXPECT_TRUE(std::filesystem::exists(folder / "robot"));
}

TEST_F(RobotDeviceTest, ListensOnATcpPortOfItsOwn) {
  options.tcp_port = 0;
  const RobotDevice first(device_program, options);
  const RobotDevice second(device_program, options);
  EXPECT_NE(first.whereabouts(), second.whereabouts());
}

TEST_F(RobotDeviceTest, WritesItsTruthWhereItIsWanted) {
  const RobotDevice device(device_program, options);
  device.write_truth_so_far();
  EXPECT_TRUE(std::filesystem::exists(folder / "truth/truth.tum"));
  EXPECT_FALSE(std::filesystem::exists(folder / "truth/truth.json"));
  device.write_truth(std::nullopt);
  EXPECT_TRUE(std::filesystem::exists(folder / "truth/truth.json"));
}

TEST_F(RobotDeviceTest, RefusesAKidnapIntoAWall) {
  options.kidnaps = {{0, 1, {-1.0, 0.0, 0.0}}};
  EXPECT_THROW(RobotDevice(device_program, options), files::ConfigError);
}

}  // namespace
}  // namespace echomap::runner
