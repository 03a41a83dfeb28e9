// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_options.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/hil_mock/runner/arguments.hpp"

namespace echomap::runner {
namespace {

std::variant<DeviceOptions, int> read(Arguments arguments,
                                      const std::vector<std::string>& boards = {}) {
  return read_device_options(arguments.argc(), arguments.argv(), {"echomap-fake", boards, {}});
}

TEST(DeviceOptions, DefaultsAreARealTimeRobotInTheLivingRoom) {
  const auto options = std::get<DeviceOptions>(read({}));
  EXPECT_EQ(options.world, "living_room");
  EXPECT_EQ(options.robot, "uno_2wd");
  EXPECT_EQ(options.speed, 1.0);
  EXPECT_EQ(options.link.string().rfind("/tmp/echomap-", 0), 0U);
  EXPECT_FALSE(options.tcp_port);
  EXPECT_TRUE(std::isinf(options.duration_s));
}

TEST(DeviceOptions, UnderstandsEveryOption) {
  const auto options = std::get<DeviceOptions>(read({"--world=l_room",
                                                     "--robot=nxt_tribot",
                                                     "--tcp=4000",
                                                     "--speed=max",
                                                     "--seed=9",
                                                     "--faults=flip=1e-4,loss=0.01,seed=3",
                                                     "--line=ftdi",
                                                     "--truth=out",
                                                     "--duty-log=duty.csv",
                                                     "--start=1.5,-2,90",
                                                     "--duration=2.5"}));
  EXPECT_EQ(options.world, "l_room");
  EXPECT_EQ(options.robot, "nxt_tribot");
  EXPECT_EQ(options.tcp_port, 4000);
  EXPECT_TRUE(std::isinf(options.speed));
  EXPECT_EQ(options.seed, 9U);
  EXPECT_EQ(options.line.faults.rates.flip, 1e-4);
  EXPECT_EQ(options.line.faults.loss, 0.01);
  EXPECT_EQ(options.line.faults.seed, 3U);
  EXPECT_EQ(options.line.delays->to_host.poll_us, 16'000);
  EXPECT_EQ(options.truth, "out");
  EXPECT_EQ(options.duty_log, "duty.csv");
  EXPECT_EQ(options.T_world_start->y_m(), -2.0);
  EXPECT_NEAR(options.T_world_start->heading_rad(), geometry::radians(90.0), 1e-12);
  EXPECT_EQ(options.duration_s, 2.5);
}

TEST(DeviceOptions, SourcesTakeThePlaceOfTheWorlds) {
  EXPECT_FALSE(std::get<DeviceOptions>(read({})).sources);
  const auto none = std::get<DeviceOptions>(read({"--source=none"}));
  ASSERT_TRUE(none.sources);
  EXPECT_TRUE(none.sources->empty());
  const auto two = std::get<DeviceOptions>(read({"--source=1,2,20", "--source=3,4,5"}));
  ASSERT_EQ(two.sources.value().size(), 2U);
  EXPECT_EQ(two.sources->at(1).position_m, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(std::get<int>(read({"--source=1,2"})), 2);
  EXPECT_EQ(std::get<int>(read({"--source=1,2,3", "--source=none"})), 2);
}

TEST(DeviceOptions, KidnapsComeOneAfterTheOther) {
  const auto options =
      std::get<DeviceOptions>(read({"--kidnap=10,2,1.5,1,90", "--kidnap=20.5,0.5,2,1,-90"}));
  ASSERT_EQ(options.kidnaps.size(), 2U);
  EXPECT_EQ(options.kidnaps[0].lift_ns, 10'000'000'000);
  EXPECT_EQ(options.kidnaps[0].place_ns, 12'000'000'000);
  EXPECT_EQ(options.kidnaps[1].lift_ns, 20'500'000'000);
  EXPECT_EQ(options.kidnaps[1].T_world_robot.x_m(), 2.0);
  EXPECT_NEAR(options.kidnaps[1].T_world_robot.heading_rad(), geometry::radians(-90.0), 1e-12);
  EXPECT_EQ(std::get<int>(read({"--kidnap=10,2,1,1,0", "--kidnap=11,2,1,1,0"})), 2);
}

TEST(DeviceOptions, ACameraHasAnAddressAndParameters) {
  const auto options =
      std::get<DeviceOptions>(read({"--camera=udp:7001", "--camera-params=delay=0.25,drop=0.5"}));
  EXPECT_EQ(options.camera, "udp:7001");
  EXPECT_EQ(options.camera_params.delay_s, 0.25);
  EXPECT_EQ(options.camera_params.drop, 0.5);
  EXPECT_TRUE(std::get<DeviceOptions>(read({})).camera.empty());
  EXPECT_EQ(std::get<int>(read({"--camera=udp:7001", "--camera-params=speed=1"})), 2);
}

TEST(DeviceOptions, TheLineIsSeededLikeTheRest) {
  const auto options = std::get<DeviceOptions>(read({"--seed=9", "--faults=loss=0.01"}));
  EXPECT_EQ(options.line.faults.seed, 9U);
  EXPECT_FALSE(options.line.delays);
  EXPECT_EQ(std::get<DeviceOptions>(read({"--seed=9"})).line.faults.seed, 9U);
}

TEST(DeviceOptions, TheMotorDriverMayBeAnotherThanTheRobotFiles) {
  EXPECT_EQ(std::get<DeviceOptions>(read({"--driver=l298n"})).driver, "l298n");
  EXPECT_TRUE(std::get<DeviceOptions>(read({})).driver.empty());
  EXPECT_EQ(std::get<int>(read({"--driver=l298"})), 2);
}

TEST(DeviceOptions, PartsMayFail) {
  const auto options =
      std::get<DeviceOptions>(read({"--part-faults=sonar-dead@30,slip-left@20:2:0.3"}));
  ASSERT_EQ(options.part_faults.size(), 2U);
  EXPECT_EQ(options.part_faults[1].at_s, 20.0);
  EXPECT_TRUE(std::get<DeviceOptions>(read({})).part_faults.empty());
}

TEST(DeviceOptions, SeveralRobotsHaveStartsOrDrawThem) {
  const auto drawn = std::get<DeviceOptions>(read({"--robots=4", "--starts=drawn", "--apart=3"}));
  EXPECT_EQ(drawn.robots, 4U);
  EXPECT_TRUE(drawn.draws_starts);
  EXPECT_TRUE(drawn.starts.empty());
  EXPECT_EQ(drawn.apart_m, 3.0);
  const auto given = std::get<DeviceOptions>(read({"--robots=2", "--starts=1,2,90;-3,4.5,0"}));
  ASSERT_EQ(given.starts.size(), 2U);
  EXPECT_NEAR(given.starts[0].heading_rad(), geometry::radians(90.0), 1e-12);
  EXPECT_EQ(given.starts[1].position_m(), Eigen::Vector2d(-3.0, 4.5));
  EXPECT_FALSE(given.draws_starts);
  const auto alone = std::get<DeviceOptions>(read({}));
  EXPECT_EQ(alone.robots, 1U);
  EXPECT_EQ(alone.apart_m, 2.0);
}

TEST(DeviceOptions, EachOfSeveralRobotsHasItsOwnSeedPortsAndFiles) {
  const auto options = std::get<DeviceOptions>(read({"--robots=3",
                                                     "--link=/tmp/bot",
                                                     "--lockstep=/tmp/clock",
                                                     "--truth=out",
                                                     "--seed=9",
                                                     "--faults=loss=0.1"}));
  const DeviceOptions first = options_of_robot(options, 0);
  const DeviceOptions last = options_of_robot(options, 2);
  EXPECT_EQ(first.link, "/tmp/bot.0");
  EXPECT_EQ(last.link, "/tmp/bot.2");
  EXPECT_EQ(last.lockstep, "/tmp/clock.2");
  EXPECT_EQ(last.truth, "out/robot2");
  EXPECT_EQ(first.seed, 9U);
  EXPECT_EQ(first.line.faults.seed, 9U);
  EXPECT_NE(last.seed, 9U);
  EXPECT_NE(last.seed, options_of_robot(options, 1).seed);
  EXPECT_EQ(last.line.faults.seed, last.seed);
  const auto tcp = std::get<DeviceOptions>(read({"--robots=3", "--tcp=4000"}));
  EXPECT_EQ(options_of_robot(tcp, 2).tcp_port, 4002);
  EXPECT_TRUE(options_of_robot(tcp, 2).truth.empty());
  EXPECT_TRUE(options_of_robot(tcp, 2).lockstep.empty());
  const auto free = std::get<DeviceOptions>(read({"--robots=3", "--tcp=0"}));
  EXPECT_EQ(options_of_robot(free, 2).tcp_port, 0);
}

TEST(DeviceOptions, OneRobotAloneHasWhatIsAskedFor) {
  const auto options = std::get<DeviceOptions>(read({"--lockstep=s", "--truth=out", "--seed=9"}));
  const DeviceOptions own = options_of_robot(options, 0);
  EXPECT_EQ(own.link, options.link);
  EXPECT_EQ(own.lockstep, "s");
  EXPECT_EQ(own.truth, "out");
  EXPECT_EQ(own.seed, 9U);
}

TEST(DeviceOptions, WhatOnlyOneRobotCanHaveIsRefusedToSeveral) {
  for (const std::string wrong : {"--kidnap=10,2,1,1,0",
                                  "--camera=udp:7001",
                                  "--duty-log=d.csv",
                                  "--pin-log=p.csv",
                                  "--starts=1,1,0",
                                  "--tcp=65535"}) {
    EXPECT_EQ(std::get<int>(read({"--robots=2", wrong})), 2) << wrong;
  }
  EXPECT_EQ(std::get<int>(read({"--start=1,1,0", "--starts=drawn"})), 2);
}

TEST(DeviceOptions, UsageErrorsAreCodeTwo) {
  for (const std::string wrong : {"--speed=0",
                                  "--speed=fast",
                                  "--speed=inf",
                                  "--speed=1e12",
                                  "--start=1,2",
                                  "--start=1,1,nan",
                                  "--tcp=70000",
                                  "--duration=-1",
                                  "--camera-params=rate=10",
                                  "--kidnap=10,2,1,1",
                                  "--kidnap=10,2,1,1,0,20",
                                  "--kidnap=10,0,1,1,0",
                                  "--kidnap=-1,2,1,1,0",
                                  "--faults=flop=1",
                                  "--line=pigeon",
                                  "--faults=loss=1.5",
                                  "--robots=0",
                                  "--robots=17",
                                  "--starts=1,1",
                                  "--starts=1,1,0;1,1,west",
                                  "--starts=somewhere",
                                  "--apart=0",
                                  "--part-faults=sonar-dead",
                                  "--part-faults=leg-broken@3",
                                  "--nonsense",
                                  "--firmware=x.elf"}) {
    EXPECT_EQ(std::get<int>(read({wrong})), 2) << wrong;
  }
  EXPECT_EQ(std::get<int>(read({"--lockstep=s", "--speed=2"})), 2);
}

TEST(DeviceOptions, FirmwareIsThatOfABoardOrOnesOwn) {
  const std::vector<std::string> boards{"big", "small"};
  EXPECT_EQ(std::get<DeviceOptions>(read({}, boards)).board.board, "big");
  EXPECT_EQ(std::get<DeviceOptions>(read({"--board=small"}, boards)).board.board, "small");
  const std::string any_file = "--firmware=" ECHOMAP_SOURCE_DIR "/LICENSE";
  EXPECT_EQ(std::get<DeviceOptions>(read({any_file}, boards)).board.firmware,
            ECHOMAP_SOURCE_DIR "/LICENSE");
  EXPECT_EQ(std::get<int>(read({"--board=huge"}, boards)), 2);
  EXPECT_EQ(std::get<int>(read({"--firmware=/no/such.elf"}, boards)), 2);
  EXPECT_EQ(std::get<int>(read({"--board=small", any_file}, boards)), 2);
  EXPECT_EQ(std::get<int>(read({"--board=big"})), 2) << "a program without boards";
}

TEST(DeviceOptions, HelpAndVersionGoToStdout) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(std::get<int>(read({"--version"})), 0);
  EXPECT_EQ(std::get<int>(read({"--help"})), 0);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(text.rfind("echomap-fake ", 0), 0U);
  EXPECT_THAT(text, testing::HasSubstr("--lockstep"));
}

}  // namespace
}  // namespace echomap::runner
