// SPDX-License-Identifier: MIT
/// The host's session and the release image: a hundred breaks of the link of each kind.
#include <cstdio>

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "tests/sessions/recoveries.hpp"

namespace echomap::tests {
namespace {

constexpr int kBreaks = 100;

struct Case {
  Break kind;
  const char* name;
  double max_s;  ///< From the break's end until the robot is ready.
};

class Recovery : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Breaks,
                         Recovery,
                         ::testing::Values(Case{Break::kUnplugged, "Unplugged", 0.5},
                                           Case{Break::kReplugged, "Replugged", 0.5},
                                           Case{Break::kResetPin, "ResetPin", 0.5},
                                           Case{Break::kWatchdogReset, "WatchdogReset", 1.0}),
                         [](const auto& test) { return test.param.name; });

TEST_P(Recovery, OfAHundredOutOfAHundredWithNobodysHelp) {
  spdlog::set_level(spdlog::level::err);  // it says of each reset that it has seen it
  const Case& breaks = GetParam();
  const Recoveries result =
      measure_recoveries(ECHOMAP_BINARY_DIR "/firmware/echomap-uno.elf", breaks.kind, kBreaks);
  std::printf(
      "%s: %d of %d, ready %.2f s behind the break's end at most, pose off by %.3f m more\n",
      breaks.name,
      result.recovered,
      result.breaks,
      result.longest_s,
      result.worst_position_m);
  EXPECT_EQ(result.recovered, kBreaks);
  EXPECT_LE(result.longest_s, breaks.max_s);
  EXPECT_TRUE(breaks.kind == Break::kUnplugged || result.longest_s > 0.0) << "nothing broke";
  EXPECT_LE(result.worst_position_m, 0.10) << "keeping the pose";
}

}  // namespace
}  // namespace echomap::tests
