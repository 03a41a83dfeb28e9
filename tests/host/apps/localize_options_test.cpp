// SPDX-License-Identifier: MIT
#include "host/apps/localize_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

const std::string kLog = ECHOMAP_SOURCE_DIR "/tests/data/small_room.clf";

TEST(LocalizeOptions, TellLogsFromRobots) {
  const Said help = run({"localize", "--help"});
  EXPECT_EQ(help.code, console::ExitCode::kOk);
  EXPECT_THAT(help.out, HasSubstr("Example: echomap localize"));
  EXPECT_THAT(help.out, HasSubstr("--port"));
  const Said both = run({"localize", kLog, "--map", ".", "--port", "x"});
  EXPECT_EQ(both.code, console::ExitCode::kUsage);
  EXPECT_THAT(both.err, HasSubstr("--port"));
}

TEST(LocalizeOptions, SuggestThePresetThatWasMeant) {
  const Said said = run({"localize", kLog, "--map", ".", "--preset", "epuk"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("did you mean 'epuck'?"));
}

TEST(LocalizeOptions, TellFiltersApart) {
  const Said no_fixes = run({"localize", "--filter", "ekf"});
  EXPECT_EQ(no_fixes.code, console::ExitCode::kUsage);
  EXPECT_THAT(no_fixes.err, HasSubstr("--fixes"));
  EXPECT_EQ(run({"localize", kLog, "--filter", "ekf", "--fixes", "udp:1:1"}).code,
            console::ExitCode::kUsage);
  EXPECT_EQ(run({"localize", "--map", ".", "--fixes", "udp:127.0.0.1:7001"}).code,
            console::ExitCode::kUsage);
  EXPECT_EQ(run({"localize", "--map", ".", "--filter", "ukf"}).code, console::ExitCode::kUsage);
}

TEST(LocalizeOptions, RefuseWhatWouldDoNothing) {
  const std::vector<std::vector<std::string>> useless = {
      {"localize", "--filter", "ekf", "--fixes", "udp:1:1", "--map", "."},
      {"localize", "--filter", "ekf", "--fixes", "udp:1:1", "--preset", "nxt"},
      {"localize", "--map", ".", "--camera-at", "0", "0", "0"},
      {"localize", "--map", ".", "--port", "x", "--format", "carmen"},
      {"localize", kLog, "--map", ".", "--lockstep", "x"},
      {"localize", kLog, "--map", ".", "--baud", "9600"},
      {"localize", kLog, "--map", ".", "--take-over"},
      {"localize", kLog, "--map", ".", "--stops", "3"}};
  for (const auto& arguments : useless) {
    const Said said = run(arguments);
    EXPECT_EQ(said.code, console::ExitCode::kUsage) << said.err;
    EXPECT_THAT(said.err, HasSubstr("--")) << said.err;
  }
}

TEST(LocalizeOptions, RefuseAPoseThatIsNoNumber) {
  const Said nan = run({"localize", "--map", ".", "--port", "x", "--at", "nan", "0", "0"});
  EXPECT_EQ(nan.code, console::ExitCode::kUsage);
  EXPECT_THAT(nan.err, HasSubstr("--at"));
  const Said inf =
      run({"localize", "--filter", "ekf", "--fixes", "udp:1:1", "--camera-at", "inf", "0", "0"});
  EXPECT_EQ(inf.code, console::ExitCode::kUsage);
  EXPECT_THAT(inf.err, HasSubstr("--camera-at"));
}

TEST(LocalizeOptions, NameWhatIsMissing) {
  const Said missing = run({"localize", kLog, "--map", "/no/such/map"});
  EXPECT_EQ(missing.code, console::ExitCode::kUsage);
  EXPECT_THAT(missing.err, HasSubstr("/no/such/map"));
  EXPECT_EQ(run({"localize", kLog}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"localize", kLog, "--map", ".", "--at", "1", "2"}).code,
            console::ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
