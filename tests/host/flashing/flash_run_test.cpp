// SPDX-License-Identifier: MIT
#include "host/flashing/flash_run.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/host/flashing/pico_image.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A stand-in for avrdude goes before the real one in PATH. It writes its arguments to a file.
class FlashRun : public testing::Test {
 protected:
  FlashRun() {
    const std::string path = folder_.path().string() + ":" + saved_path_;
    ::setenv("PATH", path.c_str(), 1);
  }
  ~FlashRun() override { ::setenv("PATH", saved_path_.c_str(), 1); }

  void avrdude(const std::string& script) {
    std::ofstream(folder_ / "avrdude")
        << "#!/bin/sh\necho \"avrdude $*\" >> '" << (folder_ / "ran").string() << "'\n"
        << script << "\n";
    std::filesystem::permissions(folder_ / "avrdude", std::filesystem::perms::owner_all);
  }
  std::string ran() const {
    return std::filesystem::exists(folder_ / "ran") ? files::read_text_file(folder_ / "ran") : "";
  }
  /// A Nano's plan, run or only printed: the exit code, and stdout.
  console::ExitCode carry_out_for_nano(bool dry_run = false) {
    const transport::PortInfo port{"/dev/ttyUSB0", "", "", transport::UsbId{0x1a86, 0x7523}};
    const auto target = choose_flash_target({"nano", port.name}, {{port}, {}});
    testing::internal::CaptureStdout();
    const auto at_end = [this](int*) { printed = testing::internal::GetCapturedStdout(); };
    int anything = 0;
    const std::unique_ptr<int, decltype(at_end)> capture(&anything, at_end);
    return carry_out(flash_plan(target, "x.hex"), dry_run);
  }

  const std::string first =
      "avrdude -p m328p -c arduino -P /dev/ttyUSB0 -b 115200 -D -U flash:w:x.hex:i\n";
  const std::string second =
      "avrdude -p m328p -c arduino -P /dev/ttyUSB0 -b 57600 -D -U flash:w:x.hex:i\n";
  std::string printed;

 private:
  const tests::ScratchFolder folder_;
  const std::string saved_path_ = std::getenv("PATH");
};

TEST_F(FlashRun, RunsTheCommandThatItPrints) {
  avrdude("echo chatter");
  EXPECT_EQ(carry_out_for_nano(), console::ExitCode::kOk);
  EXPECT_EQ(ran(), first);
  EXPECT_EQ(printed, first) << "stdout is for data: what avrdude says goes to stderr";
}

TEST_F(FlashRun, TriesTheOldBootLoaderWhenTheNewOneIsSilent) {
  avrdude("case $* in *115200*) exit 1 ;; esac");
  testing::internal::CaptureStderr();
  EXPECT_EQ(carry_out_for_nano(), console::ExitCode::kOk);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("old boot loader, which does not switch the watchdog off"),
                    HasSubstr("next: nothing, or write the new boot loader")));
  EXPECT_EQ(ran(), first + second);
  EXPECT_EQ(printed, first + second);
}

TEST_F(FlashRun, SaysWhereItFailedAndWhatToDo) {
  avrdude("exit 3");
  try {
    carry_out_for_nano();
    FAIL() << "no error";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kRuntimeError);
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("avrdude could not flash /dev/ttyUSB0 (1a86:7523, CH340)"),
                      HasSubstr("exit code 3"),
                      HasSubstr("\n  next: ")));
  }
  EXPECT_EQ(ran(), first + second);
}

TEST_F(FlashRun, StopsAtCtrlCInsteadOfTryingOn) {
  avrdude("kill -INT $$");
  EXPECT_EQ(carry_out_for_nano(), console::ExitCode::kInterrupted);
  EXPECT_EQ(ran(), first);
}

TEST_F(FlashRun, OnlyPrintsInADryRun) {
  avrdude("");
  EXPECT_EQ(carry_out_for_nano(true), console::ExitCode::kOk);
  EXPECT_EQ(ran(), "");
  EXPECT_EQ(printed, first + second);
}

TEST_F(FlashRun, NamesThePackageOfAMissingProgram) {
  try {
    carry_out({"the ST-Link", {{"echomap-no-such-program"}}, "stlink-tools", ""}, false);
    FAIL() << "no error";
  } catch (const console::CommandError& error) {
    EXPECT_THAT(error.what(), HasSubstr("next: apt-get install stlink-tools"));
  }
}

/// Stand-ins for ssh and scp: no real host is ever asked.
class FlashBrick : public testing::Test {
 protected:
  FlashBrick() {
    ::setenv("PATH", (folder_.path().string() + ":" + saved_path_).c_str(), 1);
    program("ssh", "");
    program("scp", "");
  }
  ~FlashBrick() override { ::setenv("PATH", saved_path_.c_str(), 1); }

  void program(const std::string& name, const std::string& script) {
    std::ofstream(folder_ / name) << "#!/bin/sh\necho " << name << " >> '"
                                  << (folder_ / "ran").string() << "'\n"
                                  << script << "\n";
    std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
  }
  std::string ran() const {
    return std::filesystem::exists(folder_ / "ran") ? files::read_text_file(folder_ / "ran") : "";
  }
  /// Flashes it; the exit code, and what was printed.
  console::ExitCode flash(bool dry_run = false) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    try {
      const auto code = carry_out(brick_plan("robot@brick", "x.elf"), dry_run);
      printed = testing::internal::GetCapturedStdout();
      said = testing::internal::GetCapturedStderr();
      return code;
    } catch (const console::CommandError& error) {
      printed = testing::internal::GetCapturedStdout();
      said = testing::internal::GetCapturedStderr() + error.what();
      return error.code();
    }
  }

  std::string printed;
  std::string said;

 private:
  const tests::ScratchFolder folder_;
  const std::string saved_path_ = std::getenv("PATH");
};

TEST_F(FlashBrick, RunsItsThreeCommandsInTurnAndSaysHowToGoOn) {
  EXPECT_EQ(flash(), console::ExitCode::kOk);
  EXPECT_EQ(ran(), "ssh\nscp\nssh\n");
  EXPECT_THAT(printed, AllOf(HasSubstr("uname -m"), HasSubstr("scp "), HasSubstr("systemctl")));
  EXPECT_THAT(said, HasSubstr("next: echomap explore --robot ev3 --port tcp://brick:8375"));
}

TEST_F(FlashBrick, PrintsInADryRunAllThatItWouldRun) {
  EXPECT_EQ(flash(), console::ExitCode::kOk);
  const std::string of_the_run = printed;
  EXPECT_EQ(flash(true), console::ExitCode::kOk);
  EXPECT_EQ(printed, of_the_run);
  EXPECT_EQ(ran(), "ssh\nscp\nssh\n") << "the dry run ran something";
  EXPECT_EQ(said, "");
}

TEST_F(FlashBrick, SaysWhenTheBrickIsNotReached) {
  program("ssh", "echo 'ssh: connect to host brick port 22: No route to host' >&2; exit 255");
  EXPECT_EQ(flash(), console::ExitCode::kNoRobot);
  EXPECT_EQ(ran(), "ssh\n");
  EXPECT_THAT(said,
              AllOf(HasSubstr("No route to host"),
                    HasSubstr("ssh cannot reach robot@brick"),
                    HasSubstr("next: is the brick on"),
                    HasSubstr("ssh robot@brick")));
}

TEST_F(FlashBrick, CopiesNothingToAnotherMachine) {
  // What ssh would do on this machine, which is no ARMv5.
  program("ssh", "while [ $# -gt 1 ]; do shift; done; uname() { echo x86_64; }; eval \"$1\"");
  EXPECT_EQ(flash(), console::ExitCode::kNoRobot);
  EXPECT_EQ(ran(), "ssh\n");
  EXPECT_THAT(said, AllOf(HasSubstr("x86_64"), HasSubstr("robot@brick is no EV3")));
}

TEST_F(FlashBrick, SaysWhichStepFailedWithWhat) {
  program("scp", "echo 'scp: write: No space left on device' >&2; exit 1");
  EXPECT_EQ(flash(), console::ExitCode::kRuntimeError);
  EXPECT_EQ(ran(), "ssh\nscp\n");
  EXPECT_THAT(said,
              AllOf(HasSubstr("No space left"),
                    HasSubstr("scp could not copy the program on robot@brick (exit code 1)"),
                    HasSubstr("next: see what it says above; is there space"),
                    HasSubstr("ssh robot@brick df -h")));
}

TEST_F(FlashBrick, AdvisesOfTheStepThatFailed) {
  program("ssh", "case $* in *systemctl*) echo 'Failed to connect to bus' >&2; exit 1 ;; esac");
  EXPECT_EQ(flash(), console::ExitCode::kRuntimeError);
  EXPECT_EQ(ran(), "ssh\nscp\nssh\n");
  EXPECT_THAT(said,
              AllOf(HasSubstr("ssh could not start the program"),
                    HasSubstr("next: see what it says above; what does systemd say?"),
                    Not(HasSubstr("df -h"))));
}

TEST_F(FlashBrick, StopsAtCtrlC) {
  program("scp", "kill -INT $$");
  EXPECT_EQ(flash(), console::ExitCode::kInterrupted);
  EXPECT_EQ(ran(), "ssh\nscp\n");
}

TEST_F(FlashBrick, NamesThePackageOfAMissingSsh) {
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_EQ(flash(), console::ExitCode::kRuntimeError);
  EXPECT_THAT(said, AllOf(HasSubstr("cannot start ssh"), HasSubstr("install openssh-client")));
}

/// What the last command does on a brick whose home is a folder of the test.
TEST_F(FlashBrick, LeavesAProgramAndAUnitThatStartsIt) {
  const tests::ScratchFolder home;
  program("scp", "cp /bin/true '" + (home / "echomap-ev3.new").string() + "'");
  program("systemctl", "echo \"$*\" >> '" + (home / "systemctl").string() + "'");
  program("ssh",
          "while [ $# -gt 1 ]; do shift; done; uname() { echo armv5tejl; }; cd '" +
              home.path().string() + "' && eval \"$1\"");
  EXPECT_EQ(flash(), console::ExitCode::kOk) << said;
  EXPECT_NE(std::filesystem::status(home / "echomap-ev3.elf").permissions() &
                std::filesystem::perms::owner_exec,
            std::filesystem::perms::none);
  EXPECT_FALSE(std::filesystem::exists(home / "echomap-ev3.new"));
  EXPECT_THAT(files::read_text_file(home / ".config/systemd/user/echomap.service"),
              HasSubstr("[Service]\nExecStart=%h/echomap-ev3.elf --line tcp:8375\n"));
  EXPECT_EQ(files::read_text_file(home / "systemctl"),
            "--user daemon-reload\n--user enable echomap\n--user restart echomap\n");
}

TEST(FlashPico, CopiesTheImageToTheDriveUnlessDry) {
  const tests::ScratchFolder drive;
  files::write_text_file(drive / "INFO_UF2.TXT", "Board-ID: RPI-RP2\n");
  const DrivePlan plan{"images/echomap-pico.bin", uf2_of(pico_image(3000)), drive.path()};
  testing::internal::CaptureStdout();
  EXPECT_EQ(carry_out(plan, true), console::ExitCode::kOk);
  EXPECT_FALSE(std::filesystem::exists(drive / "echomap-pico.uf2"));
  testing::internal::CaptureStderr();
  EXPECT_EQ(carry_out(plan, false), console::ExitCode::kOk);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("next: echomap explore --robot pico_2wd --port /dev/ttyACM0"));
  const std::string once =
      "echomap flash --board pico --image images/echomap-pico.bin --uf2 images/echomap-pico.uf2\n"
      "cp images/echomap-pico.uf2 " +
      drive.path().string() + "\n";
  EXPECT_EQ(testing::internal::GetCapturedStdout(), once + once);
  EXPECT_EQ(read_bytes(drive / "echomap-pico.uf2"), plan.uf2);
}

}  // namespace
}  // namespace echomap::flashing
