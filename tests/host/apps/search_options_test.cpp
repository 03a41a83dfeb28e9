// SPDX-License-Identifier: MIT
#include "host/apps/search_options.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(SearchOptions, AreOfOneRobotAtAPortOrSimulated) {
  EXPECT_EQ(run({"search", "--port", "x", "--world", "hall"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"search", "--source", "none"}).code, console::ExitCode::kUsage) << "needs --world";
  EXPECT_EQ(run({"search", "--emulator", "mock"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"search", "--world", "hall", "--seconds", "0"}).code, console::ExitCode::kUsage);
}

TEST(SearchOptions, TheHelpNamesARobotThatCanSearch) {
  EXPECT_THAT(run({"search", "--help"}).out, HasSubstr("uno_geiger"));
}

TEST(SearchOptions, ARobotWithoutATubeIsRefusedBeforeAnythingStarts) {
  const tests::ScratchFolder scratch;
  const auto refused = run({"search", "--robot", "uno_2wd", "--out", (scratch / "run").string()});
  EXPECT_EQ(refused.code, console::ExitCode::kConfigInvalid);
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("'uno_2wd' has no [scalar] sensor"),
                    HasSubstr("next: "),
                    HasSubstr("--robot uno_geiger")));
  EXPECT_FALSE(std::filesystem::exists(scratch / "run"));
}

}  // namespace
}  // namespace echomap::apps
