// SPDX-License-Identifier: MIT
#include "host/flashing/brick_plan.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/flashing/brick_program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

using testing::AllOf;
using testing::HasSubstr;

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

TEST(BrickPlan, TakesHostsButNoOptionsOfSsh) {
  for (const char* host : {"robot@ev3dev.local", "ev3dev", "robot@10.42.0.3", "a-b@c_d.e"}) {
    EXPECT_EQ(fault_of_host(host), "") << host;
  }
  for (const char* host :
       {"", "-oProxyCommand=touch", "robot@", "@ev3dev", "a@b@c", "ev3 dev", "x;reboot", "$(id)"}) {
    EXPECT_THAT(fault_of_host(host), HasSubstr("is no host")) << host;
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
  shared[52] = 3;
  EXPECT_THAT(fault_of(shared), HasSubstr("shared libraries"));
}

}  // namespace
}  // namespace echomap::flashing
