// SPDX-License-Identifier: MIT
#include "host/apps/command_line.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

struct Said {
  ExitCode code;
  std::string out;
  std::string err;
};

Said run(std::vector<std::string> words) {
  words.insert(words.begin(), "echomap");
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const ExitCode code = run_command_line(static_cast<int>(words.size()), arguments.data());
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, HelpAndVersionGoToStdout) {
  EXPECT_EQ(run({"--version"}).out, "echomap " ECHOMAP_VERSION "\n");
  const Said help = run({"explore", "--help"});
  EXPECT_EQ(help.code, ExitCode::kOk);
  EXPECT_THAT(help.out, HasSubstr("--port"));
  EXPECT_THAT(help.out, HasSubstr("Example: echomap explore"));
}

TEST(CommandLine, TheHelpOfTheDemoTellsBodyFromProfile) {
  EXPECT_THAT(run({"demo", "--help"}).out, HasSubstr("--body"));
}

TEST(CommandLine, TheHelpNamesEveryCommand) {
  const std::string help = run({"--help"}).out;
  for (const char* command : {"demo", "explore", "eval", "replay", "diff", "flash"}) {
    EXPECT_THAT(help, HasSubstr(std::string("\n  ") + command + " ")) << command;
    const Said said = run({command, "--help"});
    EXPECT_EQ(said.code, ExitCode::kOk) << command;
    EXPECT_THAT(said.out, HasSubstr(std::string("Example: echomap ") + command)) << command;
  }
}

TEST(CommandLine, EvalWantsSomethingToCompareWith) {
  EXPECT_EQ(run({"eval", "."}).code, ExitCode::kUsage);
  EXPECT_THAT(run({"eval", "."}).err, HasSubstr("--truth or --relations"));
  EXPECT_EQ(run({"eval", ".", "--picture", "a.png", "--relations", "/dev/null"}).code,
            ExitCode::kUsage);
  EXPECT_EQ(run({"diff", "no_such_folder", "."}).code, ExitCode::kUsage);
}

TEST(CommandLine, SuggestsTheCommandThatWasMeant) {
  const Said said = run({"explroe", "--port", "x"});
  EXPECT_EQ(said.code, ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("did you mean 'explore'?"));
  EXPECT_EQ(said.out, "");
}

TEST(CommandLine, PointsToTheHelpOfTheCommandThatWasMisused) {
  const Said said = run({"explore", "--prot=x"});
  EXPECT_EQ(said.code, ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("--prot"));
  EXPECT_THAT(said.err, HasSubstr("echomap explore --help"));
  EXPECT_EQ(run({"explore", "--port", "x", "--baud", "1234"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "0"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "101"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--board", "due"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--emulator", "mock", "--board", "uno"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({}).code, ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
