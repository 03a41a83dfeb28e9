// SPDX-License-Identifier: MIT
#include "host/flashing/flash_run.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::HasSubstr;

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

}  // namespace
}  // namespace echomap::flashing
