// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// echomap flash, with an avrdude before the real one in PATH that would leave a trace.
class Flash : public ::testing::Test {
 protected:
  Flash() {
    std::ofstream(scratch / "avrdude") << "#!/bin/sh\necho avrdude ran\n";
    fs::permissions(scratch / "avrdude", fs::perms::owner_all);
    ::setenv("PATH", (scratch.path().string() + ":" + program_path).c_str(), 1);
  }
  ~Flash() override { ::setenv("PATH", program_path.c_str(), 1); }

  Ended flash(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "flash");
    return Program("echomap", std::move(arguments), scratch / "log").wait();
  }

  const tests::ScratchFolder scratch;
  const std::string program_path = std::getenv("PATH");
};

/// Even where a robot answers at it: it hangs on no USB.
TEST_F(Flash, LeavesThePtyOfAnEmulatedRobotAlone) {
  const std::string link = (scratch / "robot").string();
  Program mock("echomap-mock", {"--link=" + link}, scratch / "mock.log");
  ASSERT_TRUE(eventually([&] { return fs::exists(link); }));
  for (const std::string& port : {link, fs::canonical(link).string()}) {
    const Ended ended = flash({"--board=uno", "--port=" + port});
    EXPECT_EQ(ended.status, 3) << ended.said;
    EXPECT_THAT(ended.said,
                AllOf(HasSubstr("will not flash " + port + " (no USB id)"),
                      HasSubstr("next: "),
                      Not(HasSubstr("avrdude ran"))));
  }
  mock.send(SIGTERM);
}

TEST_F(Flash, RefusesABoardThatItDoesNotKnow) {
  const Ended ended = flash({"--board=due"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.said, HasSubstr("uno,nano,mega"));
}

TEST_F(Flash, TakesThePortFromTheEnvironment) {
  ::setenv("ECHOMAP_PORT", "/dev/null", 1);
  const Ended ended = flash({"--board=nano"});
  ::unsetenv("ECHOMAP_PORT");
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, HasSubstr("will not flash /dev/null"));
}

}  // namespace
}  // namespace echomap::test
