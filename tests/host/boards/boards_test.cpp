// SPDX-License-Identifier: MIT
#include "host/boards/boards.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/transport/usb_table.hpp"

namespace echomap::boards {
namespace {

using protocol::MotorBridgeKind;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Boards, AreFoundByName) {
  EXPECT_EQ(board_named("mega").part, "m2560");
  EXPECT_EQ(board_named("nano").bauds, (std::vector<int>{115200, 57600}));
  for (const std::string& name : board_names()) {
    EXPECT_EQ(board_named(name).name, name);
  }
}

TEST(Boards, OfAnotherNameAreAUsageError) {
  try {
    board_named("nanno");
    FAIL() << "no error";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kUsage);
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'nano'"));
  }
}

TEST(Boards, HaveAnEmulatorEachSaveTheNanoThatIsAnUno) {
  EXPECT_THAT(emulated_board_names(), ElementsAre("uno", "mega", "stm32f103", "ev3", "pico"));
  EXPECT_THAT(emulator_names(), ElementsAre("simavr", "unicorn", "ev3", "rp2040"));
  EXPECT_EQ(usual_board_of("simavr")->name, "uno");
  EXPECT_EQ(usual_board_of("rp2040")->name, "pico");
  EXPECT_EQ(usual_board_of("mock"), nullptr);
  EXPECT_EQ(usual_board_of(""), nullptr) << "the Nano has no emulator, but is not that of none";
}

TEST(Boards, SayHowTheirEmulatorIsBuilt) {
  EXPECT_EQ(way_to_build("rp2040", "pico"),
            "./run setup --all && ./run build echomap-rp2040 firmware_pico");
  EXPECT_EQ(way_to_build("ev3", ""), "./run setup --all && ./run build echomap-ev3 firmware_ev3");
  EXPECT_EQ(way_to_build("simavr", "mega"),
            "./run setup --all && ./run build echomap-simavr firmware_mega");
  EXPECT_EQ(way_to_build("mock", ""), "./run build echomap-mock");
}

TEST(Boards, NameABundledProfileAndABodyForTheDemo) {
  for (const Board& board : all_boards()) {
    for (const char* folder : {"/host/profiles/", "/hil_mock/robots/"}) {
      const auto file = ECHOMAP_SOURCE_DIR + std::string(folder) + std::string(board.robot);
      EXPECT_TRUE(std::filesystem::exists(file + ".toml")) << file << " of " << board.name;
    }
  }
}

TEST(Boards, SayWhichMotorDriversTheyCarry) {
  EXPECT_FALSE(carries(board_named("uno"), MotorBridgeKind::kServo)) << "no timer is left";
  EXPECT_TRUE(carries(board_named("mega"), MotorBridgeKind::kServo));
  EXPECT_TRUE(carries(board_named("pico"), MotorBridgeKind::kTwoPwm));
  EXPECT_FALSE(carries(board_named("ev3"), MotorBridgeKind::kTwoPwm));
  EXPECT_EQ(boards_that_carry(MotorBridgeKind::kServo),
            "Arduino Mega 2560, STM32F103 board or Raspberry Pi Pico");
  EXPECT_THAT(emulated_boards_that_carry(MotorBridgeKind::kServo),
              ElementsAre("mega", "stm32f103", "pico"));
  EXPECT_THAT(emulated_boards_that_carry(MotorBridgeKind::kTwoPwm),
              ElementsAre("uno", "mega", "stm32f103", "pico"))
      << "a Nano could, but has no emulator";
  EXPECT_EQ(bridges_of(board_named("uno")),
            "phase/enable (DRV8835), PWM and two direction inputs (TB6612FNG, L298N) and two PWM "
            "inputs (DRV8833, MX1508)");
  EXPECT_THAT(bridges_of(board_named("ev3")), HasSubstr("no driver but its own"));
  for (const Board& board : all_boards()) {
    EXPECT_TRUE(carries(board, MotorBridgeKind::kPhaseEnable))
        << board.name << ": profiles without 'driver' have this kind";
  }
}

TEST(Boards, AreOnThePageThatComparesThem) {
  const std::string page = files::read_text_file(ECHOMAP_SOURCE_DIR "/docs/hardware/boards.md");
  for (const Board& board : all_boards()) {
    EXPECT_THAT(page, HasSubstr("`" + std::string(board.name) + "`"));
    if (!board.emulator.empty()) {
      EXPECT_THAT(page, HasSubstr("`echomap-" + std::string(board.emulator) + "`"));
    }
  }
}

TEST(Boards, NameTheirUsualRobots) {
  const std::string robots = robots_of_boards();
  EXPECT_THAT(robots, ::testing::StartsWith("uno_2wd (uno, nano, mega, stm32f103)"));
  EXPECT_THAT(robots, HasSubstr("ev3 (ev3)"));
  EXPECT_THAT(robots, HasSubstr("pico_2wd (pico)"));
}

TEST(KnownUsbIds, NameBoardsThatThereAre) {
  for (const transport::KnownUsbId& known : transport::known_usb_ids()) {
    if (!known.board.empty()) {
      EXPECT_EQ(board_named(known.board).name, known.board);
    }
  }
}

TEST(KnownUsbIds, StandInTheGuide) {
  const std::string guide = files::read_text_file(ECHOMAP_SOURCE_DIR "/docs/guides/flashing.md");
  for (const transport::KnownUsbId& known : transport::known_usb_ids()) {
    EXPECT_THAT(guide, HasSubstr(to_string(known.id)));
  }
}

}  // namespace
}  // namespace echomap::boards
