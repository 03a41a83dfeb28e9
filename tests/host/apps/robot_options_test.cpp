// SPDX-License-Identifier: MIT
#include "host/apps/robot_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/apps/said_by_command_line.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RobotOptions, TheHelpOfTheDemoTellsBodyFromProfile) {
  EXPECT_THAT(run({"demo", "--help"}).out, HasSubstr("--body"));
}

TEST(RobotOptions, AreCheckedBeforeARobotIsAsked) {
  EXPECT_EQ(run({"explore", "--port", "x", "--baud", "1234"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "0"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "1001"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--board", "due"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--emulator", "mock", "--board", "uno"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, ABoardNamesItsEmulatorAndIsOneOfThoseThatHaveOne) {
  EXPECT_THAT(run({"demo", "--help"}).out,
              HasSubstr("uno or mega by simavr, stm32f103 by unicorn, ev3 by ev3, pico by rp2040"));
  EXPECT_THAT(run({"demo", "--help"}).out, HasSubstr("{uno,mega,stm32f103,ev3,pico}"));
  EXPECT_EQ(run({"demo", "--board", "nano"}).code, console::ExitCode::kUsage) << "use the Uno's";
  const auto refused = run({"demo", "--board", "pico", "--emulator", "simavr"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("pico is emulated by rp2040, not by simavr"));
}

TEST(RobotOptions, AMisspeltBoardIsAnsweredWithTheOneThatIsMeant) {
  for (const char* command : {"demo", "flash"}) {
    const auto refused = run({command, "--board", "pcio"});
    EXPECT_EQ(refused.code, console::ExitCode::kUsage);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("unknown board 'pcio'; did you mean 'pico'?"),
                      HasSubstr("next: echomap " + std::string(command) + " --help")));
  }
}

TEST(RobotOptions, ABoardThatCannotCarryTheMotorDriverIsRefusedBeforeTheStart) {
  const tests::ScratchFolder folder;
  const std::string out = "--out=" + (folder / "run").string();
  const auto refused = run({"demo", "--board", "ev3", "--driver", "drv8833", "--headless", out});
  EXPECT_EQ(refused.code, console::ExitCode::kConfigInvalid);
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("LEGO EV3 with ev3dev cannot carry the motor driver"),
                    HasSubstr("no driver but its own"),
                    HasSubstr("next: another driver, or another --board: uno, mega, stm32f103, "
                              "pico")));
  EXPECT_THAT(refused.err, HasSubstr("profile 'ev3'")) << "the board's robot";
  const auto named = run({"demo",
                          "--emulator",
                          "ev3",
                          "--robot",
                          "uno_2wd",
                          "--driver",
                          "drv8833",
                          "--headless",
                          out});
  EXPECT_THAT(named.err, AllOf(HasSubstr("LEGO EV3"), HasSubstr("profile 'uno_2wd'")));
  const auto servos = run({"demo", "--board", "uno", "--driver", "servo", "--headless", out});
  EXPECT_EQ(servos.code, console::ExitCode::kConfigInvalid);
  EXPECT_THAT(servos.err, HasSubstr("another --board: mega, stm32f103, pico"));
}

TEST(RobotOptions, ABoardThatTheRobotIsNotWiredForIsRefusedBeforeTheStart) {
  const tests::ScratchFolder folder;
  const std::string out = "--out=" + (folder / "run").string();
  const auto error = [&](const std::string& board, const std::string& robot) {
    const auto refused = run({"demo", "--board", board, "--robot", robot, "--headless", out});
    EXPECT_EQ(refused.code, console::ExitCode::kConfigInvalid);
    return refused.err;
  };
  const std::string of_the_ev3 = error("ev3", "ev3_mega");
  EXPECT_THAT(of_the_ev3,
              AllOf(HasSubstr("echomap: error: the robot 'ev3_mega' is not wired for --board ev3"),
                    HasSubstr("but for mega, pico\n"),
                    HasSubstr("\n  next: echomap demo --world living_room --board mega --robot "
                              "ev3_mega\n")));
  EXPECT_THAT(of_the_ev3, Not(HasSubstr("native"))) << "that is no --board";
  EXPECT_THAT(of_the_ev3, Not(HasSubstr("\n\n")));
  EXPECT_THAT(error("uno", "ev3_mega"), HasSubstr("--board mega --robot ev3_mega\n"));
  EXPECT_THAT(error("ev3", "nxt_tribot"), HasSubstr("--board uno --robot nxt_tribot\n"));
}

TEST(RobotOptions, ARobotThatIsWiredForNoOtherBoardIsToBeWired) {
  const tests::ScratchFolder folder;
  const std::string body = (folder / "body.toml").string();
  files::write_text_file(body, "[wiring.native]\npin_0 = \"cliff_left\"\n");
  const auto refused = run({"demo",
                            "--board",
                            "uno",
                            "--body",
                            body,
                            "--headless",
                            "--out=" + (folder / "run").string()});
  EXPECT_EQ(refused.code, console::ExitCode::kConfigInvalid);
  EXPECT_THAT(refused.err, HasSubstr("next: wire it in " + body + ": [wiring.uno]"));
}

TEST(RobotOptions, FlashHasOptionsOfOneBoardAlone) {
  const auto error = [](std::vector<std::string> words) {
    words.insert(words.begin(), "flash");
    const auto said = run(words);
    EXPECT_EQ(said.code, console::ExitCode::kUsage) << said.err;
    return said.err;
  };
  EXPECT_THAT(error({"--board", "uno", "--host", "a@b"}),
              AllOf(HasSubstr("--host is only for --board ev3"),
                    HasSubstr("next: leave --host out, or say --board ev3")));
  EXPECT_THAT(error({"--volume", "/mnt"}), HasSubstr("--volume is only for --board pico"));
  EXPECT_THAT(error({"--board", "ev3", "--uf2", "x"}), HasSubstr("--uf2 is only for --board pico"));
  EXPECT_THAT(error({"--board", "ev3", "--port", "x"}), HasSubstr("by ssh, not at --port"));
  EXPECT_THAT(error({"--board", "ev3", "--host", "-oProxyCommand=x"}), HasSubstr("is no host"));
  EXPECT_THAT(error({"--board", "pico", "--port", "x"}), HasSubstr("hold BOOTSEL"));
  EXPECT_THAT(error({"--board", "pico", "--baud", "115200"}), HasSubstr("one image"));
  EXPECT_THAT(error({"--board", "ev3", "--baud", "115200"}), HasSubstr("leave --baud out"));
  EXPECT_THAT(error({"--board", "ev3", "--baud", "250000"}), HasSubstr("leave --baud out"))
      << "the speed that others have by default";
  EXPECT_THAT(error({"--board", "pico", "--volume", "/mnt", "--uf2", "x"}), HasSubstr("excludes"));
}

TEST(RobotOptions, ARobotIsTakenOverByAnyCommandWithAPort) {
  EXPECT_THAT(run({"explore", "--help"}).out, HasSubstr("--take-over"));
  EXPECT_THAT(run({"localize", "--help"}).out, HasSubstr("--take-over"));
}

TEST(RobotOptions, AnImageIsNamedOrOfASpeed) {
  EXPECT_EQ(run({"flash", "--baud", "1234"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"flash", "--baud", "115200", "--image", "x.hex"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, AViewIsAMapALineOrNone) {
  EXPECT_THAT(run({"explore", "--help"}).out, HasSubstr("--view"));
  EXPECT_EQ(run({"demo", "--view", "picture"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"localize", "--view", "map", "--headless"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, SlamIsAnotherNameOfExplore) {
  EXPECT_THAT(run({"slam", "--help"}).out, HasSubstr("echomap explore"));
  const auto refused = run({"slam", "--slam", "scan"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage) << "that is for lasers";
  EXPECT_THAT(refused.err, HasSubstr("--slam"));
}

TEST(RobotOptions, AnOldNameOfASlamMethodAnswersWithTheNewOne) {
  const auto refused = run({"explore", "--slam", "grid"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("now called 'multiscan'"));
}

TEST(RobotOptions, APoseIsOfTheCameraOrOfSlam) {
  const auto refused = run({"explore", "--fixes", "udp:127.0.0.1:5000", "--slam", "multiscan"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("excludes"));
}

TEST(RobotOptions, ARunThatIsResumedIsADirectoryAndHasNoCamera) {
  EXPECT_EQ(run({"explore", "--resume", "no/such/run"}).code, console::ExitCode::kUsage);
  const auto refused = run({"explore", "--resume", ".", "--fixes", "udp:127.0.0.1:5000"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("excludes"));
}

}  // namespace
}  // namespace echomap::apps
