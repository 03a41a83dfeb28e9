// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_main.hpp"

#include <filesystem>
#include <future>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/hil_mock/runner/arguments.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

using testing::HasSubstr;

const DeviceProgram fake_program{
    "echomap-fake", {}, [](const BoardOptions&) { return std::make_unique<FakeBoard>(); }};

struct Outcome {
  int exit_code;
  std::string out;
  std::string error;
};

Outcome run(Arguments arguments, const DeviceProgram& program = fake_program) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = run_device(arguments.argc(), arguments.argv(), program);
  return {
      exit_code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

TEST(DeviceMain, RunsPacedSaysWhereItListensAndLeavesTheTruth) {
  const tests::ScratchFolder folder;
  const std::string link = folder / "robot";
  const Outcome outcome = run({"--link=" + link,
                               "--speed=max",
                               "--duration=0.5",
                               "--seed=4",
                               "--truth=" + (folder / "truth").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out, "echomap-fake: uno_2wd in living_room listens on " + link + "\n");
  const auto truth = nlohmann::json::parse(files::read_text_file(folder / "truth/truth.json"));
  EXPECT_EQ(truth["seed"], 4);
  EXPECT_DOUBLE_EQ(truth["sim_seconds"].get<double>(), 0.5);
}

TEST(DeviceMain, UsualRobotIsTheOneOfItsBoards) {
  const tests::ScratchFolder folder;
  const DeviceProgram brick{"echomap-fake",
                            {"ev3"},
                            [](const BoardOptions&) { return std::make_unique<FakeBoard>(); },
                            "ev3"};
  const std::string link = folder / "robot";
  const Outcome outcome = run({"--link=" + link, "--speed=max", "--duration=0.1"}, brick);
  EXPECT_EQ(outcome.out, "echomap-fake: ev3 in living_room listens on " + link + "\n");
}

TEST(DeviceMain, LogsDutiesInPacedTime) {
  const tests::ScratchFolder folder;
  const DeviceProgram driven{"echomap-fake", {}, [](const BoardOptions&) {
                               auto board = std::make_unique<FakeBoard>();
                               board->duty = {0.5, 0.5};
                               board->stop_at_ns = 100'000'000;
                               return board;
                             }};
  const Outcome outcome = run({"--link=" + (folder / "robot").string(),
                               "--speed=max",
                               "--duration=0.2",
                               "--duty-log=" + (folder / "duty.csv").string()},
                              driven);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string log = files::read_text_file(folder / "duty.csv");
  EXPECT_EQ(log.rfind("sim_us,monotonic_us,left_duty,right_duty\n1000,", 0), 0U) << log;
  EXPECT_THAT(log, HasSubstr("\n100000,"));
}

TEST(DeviceMain, SaysByeInLockstepWhenTheTruthIsOnDisk) {
  const tests::ScratchFolder folder;
  Arguments arguments{"--link=" + (folder / "robot").string(),
                      "--lockstep=" + (folder / "lockstep").string(),
                      "--truth=" + (folder / "truth").string()};
  auto exit_code = std::async(std::launch::async, [&] {
    return run_device(arguments.argc(), arguments.argv(), fake_program);
  });
  ASSERT_TRUE(tests::eventually([&] { return std::filesystem::exists(folder / "lockstep"); }));
  TestHost channel = TestHost::connect_local(folder / "lockstep");
  EXPECT_EQ(channel.read_line(), R"({"lockstep":1,"firmware":"fake 1.0","emulator":"none"})");
  channel.write("grant 30000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 30000 0");
  channel.write("quit\n");
  EXPECT_EQ(channel.read_line(), "bye");
  EXPECT_TRUE(std::filesystem::exists(folder / "truth/truth.json"));
  EXPECT_EQ(exit_code.get(), 0);
}

TEST(DeviceMain, TheTruthOfTheRoomIsThereFromTheStartAndAfterABox) {
  const tests::ScratchFolder folder;
  Arguments arguments{"--link=" + (folder / "robot").string(),
                      "--lockstep=" + (folder / "lockstep").string(),
                      "--truth=" + (folder / "truth").string()};
  testing::internal::CaptureStderr();
  auto exit_code = std::async(std::launch::async, [&] {
    return run_device(arguments.argc(), arguments.argv(), fake_program);
  });
  ASSERT_TRUE(tests::eventually([&] { return std::filesystem::exists(folder / "lockstep"); }));
  const std::string map = files::read_text_file(folder / "truth/truth_map.pgm");
  EXPECT_FALSE(std::filesystem::exists(folder / "truth/truth.json"));
  TestHost channel = TestHost::connect_local(folder / "lockstep");
  channel.read_line();
  channel.write("box 500 500 200\nbox 0 0 200\ngrant 30000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 30000 0");
  EXPECT_NE(files::read_text_file(folder / "truth/truth_map.pgm"), map);
  channel.write("quit\n");
  EXPECT_EQ(exit_code.get(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "echomap-fake: a box of 200 mm at 500, 500 mm\n"
            "echomap-fake: there is no place for a box of 200 mm at 0, 0 mm\n");
}

TEST(DeviceMain, SeveralRobotsRunPacedAndLeaveATruthEach) {
  const tests::ScratchFolder folder;
  const std::string link = folder / "robot";
  const Outcome outcome = run({"--robots=2",
                               "--starts=0.5,0.5,0;3.5,0.4,90",
                               "--link=" + link,
                               "--speed=max",
                               "--duration=0.5",
                               "--seed=4",
                               "--truth=" + (folder / "truth").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out,
            "echomap-fake: uno_2wd in living_room listens on " + link +
                ".0\n"
                "echomap-fake: uno_2wd in living_room listens on " +
                link + ".1\n");
  const auto first =
      nlohmann::json::parse(files::read_text_file(folder / "truth/robot0/truth.json"));
  const auto second =
      nlohmann::json::parse(files::read_text_file(folder / "truth/robot1/truth.json"));
  EXPECT_EQ(first["seed"], 4);
  EXPECT_NE(second["seed"], 4);
  EXPECT_EQ(files::read_text_file(folder / "truth/robot1/truth.tum").substr(0, 26),
            "0.000000 3.500000 0.400000");
}

TEST(DeviceMain, EachRobotOfATeamHasItsChannel) {
  const tests::ScratchFolder folder;
  Arguments arguments{"--robots=2",
                      "--link=" + (folder / "robot").string(),
                      "--lockstep=" + (folder / "lockstep").string(),
                      "--truth=" + (folder / "truth").string()};
  testing::internal::CaptureStderr();
  auto exit_code = std::async(std::launch::async, [&] {
    return run_device(arguments.argc(), arguments.argv(), fake_program);
  });
  ASSERT_TRUE(tests::eventually([&] { return std::filesystem::exists(folder / "lockstep.1"); }));
  TestHost first = TestHost::connect_local(folder / "lockstep.0");
  TestHost second = TestHost::connect_local(folder / "lockstep.1");
  first.read_line();
  second.read_line();
  first.write("grant 30000 0\n");
  second.write("box 0 0 200\ngrant 30000 0\n");
  EXPECT_EQ(first.read_line(), "reached 30000 0");
  EXPECT_EQ(second.read_line(), "reached 30000 0");
  first.write("quit\n");
  EXPECT_EQ(first.read_line(), "bye");
  EXPECT_TRUE(std::filesystem::exists(folder / "truth/robot0/truth.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "truth/robot1/truth.json"));
  second.close();
  EXPECT_EQ(exit_code.get(), 0);
  const auto truth =
      nlohmann::json::parse(files::read_text_file(folder / "truth/robot1/truth.json"));
  EXPECT_EQ(truth["stop"]["last_grant_ns"], 30'000'000);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("robot 1: there is no place for a box of 200 mm at 0, 0 mm\n"));
  EXPECT_THAT(said, HasSubstr("echomap-fake: robot 1: the host vanished"));
}

TEST(DeviceMain, ABrokenWorldIsNamedWithItsPlaceAndCodeSix) {
  const tests::ScratchFolder folder;
  const std::string world = folder / "broken.toml";
  files::write_text_file(world, "name = \"broken\"\n[start]\nx_m = \"left\"\n");
  const Outcome outcome = run({"--world=" + world});
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_THAT(outcome.error, HasSubstr(world + ":"));
}

TEST(DeviceMain, WhatDoesNotFitIsCodeSix) {
  EXPECT_EQ(run({"--start=2.0,1.2,0"}).exit_code, 6) << "in the table";
  EXPECT_EQ(run({"--start=0.05,1.0,0"}).exit_code, 6) << "too near to the wall";
  EXPECT_EQ(run({"--kidnap=1,1,2.0,1.2,0"}).exit_code, 6) << "put into the table";
  const Outcome crowd = run({"--robots=16"});
  EXPECT_EQ(crowd.exit_code, 6);
  EXPECT_THAT(crowd.error, HasSubstr("no place for 16 robots"));
  const Outcome unknown = run({"--world=living_rom"});
  EXPECT_EQ(unknown.exit_code, 6);
  EXPECT_THAT(unknown.error, HasSubstr("living_room"));
}

TEST(DeviceMain, ARobotForOtherBoardsIsCodeSix) {
  const Outcome outcome = run({"--robot=create"});
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_THAT(outcome.error, HasSubstr("create is not wired for the board fake"));
}

TEST(DeviceMain, AFaultOfTheBoardIsCodeOne) {
  const DeviceProgram broken{
      "echomap-fake", {}, [](const BoardOptions&) -> std::unique_ptr<SimulatedBoard> {
        throw std::runtime_error("no such chip");
      }};
  const Outcome outcome = run({}, broken);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.error, "echomap-fake: no such chip\n");
}

}  // namespace
}  // namespace echomap::runner
