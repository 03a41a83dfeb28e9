// SPDX-License-Identifier: MIT
#include "host/apps/command_line.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

TEST(CommandLine, HelpAndVersionGoToStdout) {
  EXPECT_EQ(run({"--version"}).out, "echomap " ECHOMAP_VERSION "\n");
  const Said help = run({"explore", "--help"});
  EXPECT_EQ(help.code, console::ExitCode::kOk);
  EXPECT_THAT(help.out, HasSubstr("--port"));
  EXPECT_THAT(help.out, HasSubstr("Example: echomap explore"));
}

TEST(CommandLine, TheHelpNamesEveryCommand) {
  const std::string help = run({"--help"}).out;
  for (const char* command : {"demo", "explore", "eval", "replay", "export", "diff", "flash"}) {
    EXPECT_THAT(help, ContainsRegex(std::string("\n  ") + command + "[ ,]")) << command;
    const Said said = run({command, "--help"});
    EXPECT_EQ(said.code, console::ExitCode::kOk) << command;
    EXPECT_THAT(said.out, HasSubstr(std::string("Example: echomap ") + command)) << command;
  }
}

TEST(CommandLine, SuggestsTheCommandThatWasMeant) {
  const Said said = run({"explroe", "--port", "x"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("did you mean 'explore'?"));
  EXPECT_EQ(said.out, "");
}

TEST(CommandLine, PointsToTheHelpOfTheCommandThatWasMisused) {
  const Said said = run({"explore", "--prot=x"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("--prot"));
  EXPECT_THAT(said.err, HasSubstr("echomap explore --help"));
  EXPECT_EQ(run({}).code, console::ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
