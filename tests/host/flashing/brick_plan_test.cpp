// SPDX-License-Identifier: MIT
#include "host/flashing/brick_plan.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/flashing/brick_program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

TEST(BrickPlan, AsksTheMachineCopiesAndStartsByThreeCommands) {
  const BrickPlan plan = brick_plan("robot@ev3dev.local", "echomap-ev3.elf");
  ASSERT_EQ(plan.steps.size(), 3U);
  EXPECT_EQ(console::shell_line(plan.steps[0].command),
            "ssh -o ConnectTimeout=10 robot@ev3dev.local "
            "'case $(uname -m) in armv5*) ;; *) uname -m; exit 64;; esac'");
  EXPECT_EQ(console::shell_line(plan.steps[1].command),
            "scp -o ConnectTimeout=10 echomap-ev3.elf robot@ev3dev.local:echomap-ev3.new");
  EXPECT_THAT(plan.steps[2].command.back(),
              AllOf(HasSubstr("chmod +x echomap-ev3.new && mv -f echomap-ev3.new echomap-ev3.elf"),
                    HasSubstr("'ExecStart=%h/echomap-ev3.elf --line tcp:8375'"),
                    HasSubstr("systemctl --user enable echomap"),
                    HasSubstr("systemctl --user restart echomap")));
  EXPECT_EQ(plan.address, "tcp://ev3dev.local:8375");
  EXPECT_EQ(brick_plan("10.0.0.7", "x").address, "tcp://10.0.0.7:8375");
}

/// The unit that the last step writes on a brick whose home is that folder.
std::string written_unit(const tests::ScratchFolder& home) {
  files::write_text_file(home / "echomap-ev3.new", "");
  const std::string script = "cd " + home.path().string() + "; systemctl() { true; }; " +
                             brick_plan("x", "y").steps.back().command.back();
  EXPECT_EQ(std::system(console::shell_line({"sh", "-c", script}).c_str()), 0);
  return files::read_text_file(home / ".config/systemd/user/echomap.service");
}

TEST(BrickPlan, ProgramStartsAgainHoweverOftenItEnds) {
  const tests::ScratchFolder home;
  EXPECT_THAT(written_unit(home),
              AllOf(HasSubstr("[Unit]\nDescription=echomap\nStartLimitIntervalSec=0\n[Service]\n"),
                    HasSubstr("\nRestart=always\n"),
                    HasSubstr("\nTimeoutStopSec=5\n")));
}

TEST(BrickPlan, EveryMotorIsStoppedAfterTheProgram) {
  const tests::ScratchFolder home;
  const std::string unit = written_unit(home);
  const std::string key = "\nExecStopPost=-/bin/sh -c \"";
  ASSERT_THAT(unit, HasSubstr(key));
  const std::size_t start = unit.find(key) + key.size();
  std::string script = unit.substr(start, unit.find("\"\n", start) - start);
  EXPECT_THAT(script, Not(AnyOf(HasSubstr("$"), HasSubstr("%")))) << "systemd would replace it";
  for (std::size_t at = 0; (at = script.find("/sys/", at)) != std::string::npos;) {
    script.replace(at, 1, home.path().string() + "/");
    at += home.path().string().size() + 1;
  }
  const auto motors = home / "sys/class/tacho-motor";
  for (const char* motor : {"motor0", "motor7"}) {
    std::filesystem::create_directories(motors / motor);
    files::write_text_file(motors / motor / "command", "");
    files::write_text_file(motors / motor / "stop_action", "hold");
  }
  EXPECT_EQ(std::system((console::shell_line({"sh", "-c", script}) + " > /dev/null").c_str()), 0);
  for (const char* motor : {"motor0", "motor7"}) {
    EXPECT_EQ(files::read_text_file(motors / motor / "command"), "stop\n");
    EXPECT_EQ(files::read_text_file(motors / motor / "stop_action"), "coast\n");
  }
}

TEST(BrickPlan, TakesHostsButNoOptionsOfSsh) {
  for (const char* host : {"robot@ev3dev.local", "ev3dev", "robot@10.42.0.3", "a-b@c_d.e"}) {
    EXPECT_EQ(fault_of_host(host), "") << host;
  }
  for (const char* host :
       {"", "-oProxyCommand=touch", "robot@", "@ev3dev", "a@b@c", "ev3 dev", "x;reboot", "$(id)"}) {
    EXPECT_THAT(fault_of_host(host), AllOf(HasSubstr("is no host"), HasSubstr("\n  next: ")))
        << host;
  }
}

TEST(BrickPlan, TakesStaticProgramsOfA32BitArmOnly) {
  const tests::ScratchFolder folder;
  const auto fault_of = [&](const std::string& program) {
    files::write_text_file(folder / "x.elf", program);
    return fault_of_brick_program(folder / "x.elf");
  };
  EXPECT_EQ(fault_of(brick_program()), "");
  EXPECT_THAT(fault_of(""), HasSubstr("no program for the EV3"));
  EXPECT_THAT(fault_of(brick_program().substr(0, 40)), HasSubstr("no program for the EV3"));
  EXPECT_THAT(fault_of(files::read_text_file("/proc/self/exe")),
              HasSubstr("no program for the EV3"))
      << "this test, of a PC";
  std::string of_another = brick_program();
  of_another[18] = 3;
  EXPECT_THAT(fault_of(of_another), HasSubstr("a 32-bit ARM"));
  std::string shared = brick_program();
  shared[kFirstSegment] = 3;
  EXPECT_THAT(fault_of(shared), HasSubstr("shared libraries"));
}

TEST(BrickPlan, TakesProgramsForLinuxWithoutAFloatingPointUnitOnly) {
  const tests::ScratchFolder folder;
  const auto fault_with = [&](std::size_t at, char value) {
    std::string program = brick_program();
    program[at] = value;
    files::write_text_file(folder / "x.elf", program);
    return fault_of_brick_program(folder / "x.elf");
  };
  const auto no_linux = HasSubstr("no program for Linux");
  EXPECT_EQ(fault_with(kFirstSegment, 1), "") << "that is what it has anyway";
  EXPECT_THAT(fault_with(kFirstSegment + 32, 1), no_linux) << "the firmware of a board";
  EXPECT_THAT(fault_with(kLinuxNote + 8, 3), no_linux) << "a note about something else";
  EXPECT_THAT(fault_with(kLinuxNote + 12, 'X'), no_linux) << "a note of somebody else";
  EXPECT_THAT(fault_with(kLinuxNote + 16, 3), no_linux) << "FreeBSD";
  EXPECT_THAT(fault_with(kFirstSegment + 37, 127), no_linux) << "its notes are cut off";
  EXPECT_THAT(fault_with(kFirstSegment + 48, 16), no_linux) << "only the first note";
  EXPECT_THAT(fault_with(37, 4), HasSubstr("needs a floating-point unit"));
}

TEST(BrickPlan, TellsForEachStepWhatToLookAtWhereItFails) {
  const BrickPlan plan = brick_plan("robot@brick", "x.elf");
  EXPECT_THAT(plan.steps[0].advice, HasSubstr("ssh robot@brick uname -a"));
  EXPECT_THAT(plan.steps[1].advice, HasSubstr("ssh robot@brick df -h"));
  EXPECT_THAT(plan.steps[2].advice, HasSubstr("ssh robot@brick systemctl --user status echomap"));
}

}  // namespace
}  // namespace echomap::flashing
