// SPDX-License-Identifier: MIT
#include "host/session/child_process.hpp"

#include <chrono>
#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

constexpr std::chrono::seconds kLong(20);

TEST(ChildProcess, KeepsExitStatusAndOutput) {
  const tests::ScratchFolder folder;
  const auto log = folder / "child.log";
  ChildProcess child({"/bin/sh", "-c", "echo out; echo err >&2; exit 6"}, log);
  EXPECT_EQ(child.wait_for(kLong), 6);
  EXPECT_EQ(files::read_text_file(log), "out\nerr\n");
}

TEST(ChildProcess, SaysWhichSignalEndedIt) {
  ChildProcess child({"/bin/sleep", "100"}, "/dev/null");
  EXPECT_FALSE(child.exit_status());
  child.send(SIGKILL);
  EXPECT_EQ(child.wait_for(kLong), 128 + SIGKILL);
}

TEST(ChildProcess, EndsWithItsOwner) {
  const tests::ScratchFolder folder;
  const auto log = folder / "pid.log";
  {
    ChildProcess child({"/bin/sh", "-c", "echo $$; exec sleep 100"}, log);
    ASSERT_TRUE(tests::eventually([&] { return !files::read_text_file(log).empty(); }));
  }
  const int pid = std::stoi(files::read_text_file(log));
  EXPECT_EQ(::kill(pid, 0), -1);
}

TEST(ChildProcess, CannotStartWhatIsNotThere) {
  EXPECT_THROW(ChildProcess({"/nowhere/program"}, "/dev/null"), std::runtime_error);
}

}  // namespace
}  // namespace echomap::session
