// SPDX-License-Identifier: MIT
#include "host/apps/live_options.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

/// What a command makes of its words.
LiveOptions live_options_of(std::vector<std::string> words, bool is_asked_for = true) {
  CLI::App command;
  LiveOptions options;
  add_live_options(command, options, is_asked_for);
  std::reverse(words.begin(), words.end());
  command.parse(std::move(words));
  return options;
}

double speed_of(const std::string& word) {
  CLI::App command;
  double factor = 8.0;
  add_speed_option(command, factor);
  command.parse(std::vector<std::string>{"--speed=" + word});
  return factor;
}

TEST(LiveOptions, ServeNothingUnasked) {
  const LiveOptions options = live_options_of({});
  EXPECT_FALSE(options.serves);
  EXPECT_EQ(options.listen, "127.0.0.1");
  EXPECT_TRUE(options.opens_browser);
}

TEST(LiveOptions, TellWhereAndWhetherABrowserOpens) {
  const LiveOptions options =
      live_options_of({"--live", "--listen", "0.0.0.0:8000", "--no-browser"});
  EXPECT_TRUE(options.serves);
  EXPECT_EQ(options.listen, "0.0.0.0:8000");
  EXPECT_FALSE(options.opens_browser);
}

TEST(LiveOptions, OfACommandThatServesAnywayHaveNoLive) {
  EXPECT_EQ(live_options_of({"--listen", "127.0.0.1:0"}, false).listen, "127.0.0.1:0");
  EXPECT_THROW(live_options_of({"--live"}, false), CLI::ParseError);
}

TEST(SpeedOption, IsTimesRealTimeOrMax) {
  EXPECT_EQ(speed_of("8"), 8.0);
  EXPECT_EQ(speed_of("0.5"), 0.5);
  EXPECT_EQ(speed_of("max"), 0.0);
  EXPECT_EQ(speed_of("0"), 0.0);
}

TEST(SpeedOption, IsNoOtherWordAndNotTooMuch) {
  for (const char* word : {"fast", "MAX", "-1", "8x", "1e9", "inf", "nan", ""}) {
    EXPECT_THROW(speed_of(word), CLI::ParseError) << word;
  }
}

TEST(SpeedOption, ThatIsBadIsAMistakeOfTheCommandLine) {
  const Said said = run({"demo", "--speed", "fast"});
  EXPECT_EQ(said.code, ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("--speed"));
  EXPECT_THAT(said.err, HasSubstr("echomap demo --help"));
}

TEST(AddServe, IsACommandWithOptionsOfItsPage) {
  const Said help = run({"serve", "--help"});
  EXPECT_EQ(help.code, ExitCode::kOk);
  EXPECT_THAT(help.out, HasSubstr("--listen"));
  EXPECT_THAT(help.out, HasSubstr("--no-browser"));
  EXPECT_THAT(help.out, HasSubstr("Example: echomap serve"));
  EXPECT_THAT(help.out, testing::Not(HasSubstr("--live")));
}

}  // namespace
}  // namespace echomap::apps
