// SPDX-License-Identifier: MIT
#include "host/session/child_process.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

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

TEST(ChildProcess, SaysWhatProcessorTimeItUsedWithThoseThatItStarted) {
  ChildProcess child({"/bin/sh", "-c", "sh -c 'while :; do :; done' & sleep 0.3; kill $!; wait"},
                     "/dev/null");
  EXPECT_EQ(child.cpu_s(), 0.0);
  ASSERT_TRUE(child.wait_for(kLong));
  EXPECT_GT(child.cpu_s(), 0.0);
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

/// A process that has a child, and never comes to its own end.
[[noreturn]] void own_a_child_and_wait(const std::filesystem::path& log) {
  const ChildProcess child({"/bin/sh", "-c", "echo $$; exec sleep 100"}, log);
  while (true) {
    ::pause();
  }
}

TEST(ChildProcess, EndsWithAnOwnerThatIsKilled) {
  const tests::ScratchFolder folder;
  const auto log = folder / "pid.log";
  ASSERT_EQ(::prctl(PR_SET_CHILD_SUBREAPER, 1), 0) << "so that this process is told of orphans";
  const pid_t owner = ::fork();
  if (owner == 0) {
    own_a_child_and_wait(log);
  }
  const auto written = [&] {
    return std::filesystem::exists(log) && files::read_text_file(log).ends_with('\n');
  };
  EXPECT_TRUE(tests::eventually(written));
  ::kill(owner, SIGKILL);
  ASSERT_EQ(::waitpid(owner, nullptr, 0), owner);
  const int child = std::stoi(files::read_text_file(log));
  int status = 0;
  EXPECT_TRUE(tests::eventually([&] { return ::waitpid(child, &status, WNOHANG) == child; }));
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
  ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(ChildProcess, CannotStartWhatIsNotThere) {
  EXPECT_THROW(ChildProcess({"/nowhere/program"}, "/dev/null"), std::runtime_error);
  EXPECT_THROW(ChildProcess({"/bin/true"}, "/nowhere/log"), std::runtime_error);
}

}  // namespace
}  // namespace echomap::session
