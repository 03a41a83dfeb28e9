// SPDX-License-Identifier: MIT
#include "host/flashing/flash_plan.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/flashing/flash_run.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using transport::PortInfo;
using transport::UsbDevice;
using transport::UsbId;

const PortInfo uno{"/dev/ttyACM0", "Arduino Uno", "7583", UsbId{0x2341, 0x0043}};
const PortInfo mega{"/dev/ttyACM1", "Arduino Mega", "9535", UsbId{0x2341, 0x0042}};
const PortInfo ch340{"/dev/ttyUSB0", "USB Serial", "", UsbId{0x1a86, 0x7523}};
const PortInfo ftdi{"/dev/ttyUSB1", "FT232R USB UART", "A9007", UsbId{0x0403, 0x6001}};
const PortInfo modem{"/dev/ttyUSB2", "HUAWEI Mobile", "", UsbId{0x12d1, 0x1506}};
const PortInfo bluetooth{"/dev/rfcomm0", "", ""};
const UsbDevice st_link{{0x0483, 0x3748}, "STM32 STLink", "55FF70"};
const UsbDevice other_st_link{{0x0483, 0x374f}, "STLINK-V3", "003A00"};

/// The commands, one a line.
std::string commands(const FlashRequest& request, const AttachedDevices& attached) {
  std::string lines;
  for (const console::CommandWords& words :
       flash_plan(choose_flash_target(request, attached), "x.hex").tries) {
    lines += console::shell_line(words) + "\n";
  }
  return lines;
}

std::string refusal(const FlashRequest& request, const AttachedDevices& attached) {
  try {
    return "no error, but: " + commands(request, attached);
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kNoRobot);
    return error.what();
  }
}

TEST(FlashPlan, FindsTheOneBoardThatItsUsbIdGivesAway) {
  EXPECT_EQ(commands({}, {{modem, ch340, uno}, {}}),
            "avrdude -p m328p -c arduino -P /dev/ttyACM0 -b 115200 -D -U flash:w:x.hex:i\n");
  EXPECT_EQ(commands({}, {{mega}, {}}),
            "avrdude -p m2560 -c wiring -P /dev/ttyACM1 -b 115200 -D -U flash:w:x.hex:i\n");
  EXPECT_THAT(commands({.board = "mega"}, {{uno, mega}, {}}), HasSubstr("/dev/ttyACM1"));
}

TEST(FlashPlan, TriesTheOldBootLoaderOfANanoAfterTheNewOne) {
  EXPECT_EQ(commands({"nano", "/dev/ttyUSB0"}, {{ch340}, {}}),
            "avrdude -p m328p -c arduino -P /dev/ttyUSB0 -b 115200 -D -U flash:w:x.hex:i\n"
            "avrdude -p m328p -c arduino -P /dev/ttyUSB0 -b 57600 -D -U flash:w:x.hex:i\n");
}

TEST(FlashPlan, NeverGuessesBetweenTwoBoards) {
  EXPECT_THAT(refusal({}, {{uno, mega}, {}}),
              AllOf(HasSubstr("several boards are here"),
                    HasSubstr("/dev/ttyACM0 (2341:0043, Arduino Uno R3)"),
                    HasSubstr("/dev/ttyACM1 (2341:0042, Arduino Mega 2560 R3)"),
                    HasSubstr("next: name one with --port")));
}

TEST(FlashPlan, WantsPortAndBoardSaidForASerialChip) {
  EXPECT_THAT(refusal({}, {{ch340}, {}}), HasSubstr("both said: --port and --board"));
  EXPECT_THAT(refusal({.board = "nano"}, {{ch340}, {}}), HasSubstr("both said"));
  EXPECT_THAT(refusal({.port = "/dev/ttyUSB0"}, {{ch340}, {}}),
              AllOf(HasSubstr("/dev/ttyUSB0 (1a86:7523, CH340)"),
                    HasSubstr("next: say which board it is: --port /dev/ttyUSB0 --board")));
}

TEST(FlashPlan, RefusesAPortThatIsNoBoards) {
  EXPECT_THAT(refusal({"uno", "/dev/ttyUSB2"}, {{modem, uno}, {}}),
              AllOf(HasSubstr("will not flash /dev/ttyUSB2 (12d1:1506, HUAWEI Mobile)"),
                    HasSubstr("no board"),
                    HasSubstr("here: /dev/ttyACM0"),
                    HasSubstr("next: name the port of a board with --port")));
}

TEST(FlashPlan, RefusesAPortWithoutAUsbId) {
  for (const std::string port : {"/dev/rfcomm0", "/dev/pts/0", "/dev/null", "tcp://a:1"}) {
    EXPECT_THAT(refusal({"uno", port}, {{bluetooth, uno}, {}}),
                HasSubstr("will not flash " + port + " (no USB id)"));
  }
}

TEST(FlashPlan, RefusesToWriteAnotherBoardsImage) {
  EXPECT_THAT(refusal({"uno", "/dev/ttyACM1"}, {{mega}, {}}),
              AllOf(HasSubstr("it is no Arduino Uno"), HasSubstr("next: --board mega")));
  EXPECT_THAT(refusal({"stm32f103", "/dev/ttyACM0"}, {{uno}, {}}), HasSubstr("next: --board uno"));
}

TEST(FlashPlan, TakesAPortByItsLinkAndByItsSerialNumber) {
  const tests::ScratchFolder folder;
  const PortInfo port{std::filesystem::canonical("/dev/null"), "", "", UsbId{0x2341, 0x0043}};
  std::filesystem::create_symlink("/dev/null", folder / "by-id");
  EXPECT_THAT(commands({.port = (folder / "by-id").string()}, {{port}, {}}),
              HasSubstr("-P /dev/null"));
  EXPECT_THAT(commands({"nano", "id:A9007"}, {{uno, ftdi}, {}}), HasSubstr("/dev/ttyUSB1"));
  EXPECT_THAT(refusal({"nano", "id:USB"}, {{ch340, ftdi}, {}}), HasSubstr("several ports fit"));
  EXPECT_THAT(refusal({"nano", "id:none"}, {{ch340, ftdi}, {}}), HasSubstr("no ports fit"));
}

TEST(FlashPlan, WritesAnStm32ThroughTheOneStLink) {
  EXPECT_EQ(commands({.board = "stm32f103"}, {{uno}, {st_link}}),
            "st-flash --reset --format ihex write x.hex\n");
  EXPECT_EQ(commands({"stm32f103", "id:003A"}, {{}, {st_link, other_st_link}}),
            "st-flash --reset --format ihex --serial 003A00 write x.hex\n");
  EXPECT_THAT(
      refusal({.board = "stm32f103"}, {{}, {st_link, other_st_link}}),
      AllOf(HasSubstr("several ST-Links"), HasSubstr("0483:3748"), HasSubstr("number 003A00")));
  EXPECT_THAT(refusal({.board = "stm32f103"}, {{ftdi}, {}}), HasSubstr("no ST-Link"));
  EXPECT_THAT(refusal({}, {{}, {st_link}}), HasSubstr("no board is here"));
}

TEST(FlashPlan, WritesAnStm32ThroughASerialPort) {
  EXPECT_EQ(commands({"stm32f103", "/dev/ttyUSB1"}, {{ftdi}, {st_link}}),
            "stm32flash -b 115200 -w x.hex -v -g 0x0 /dev/ttyUSB1\n");
}

}  // namespace
}  // namespace echomap::flashing
