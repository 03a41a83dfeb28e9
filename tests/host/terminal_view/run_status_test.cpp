// SPDX-License-Identifier: MIT
#include "host/terminal_view/run_status.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::terminal_view {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

RunStatus full_status() {
  RunStatus status;
  status.mode = "exploring by frontier";
  status.doing = "drives 0.80 m";
  status.why = "to see new floor";
  status.T_map_robot = geometry::Pose2(1.25, -0.4, 1.5707963);
  status.position_95_m = 0.052;
  status.stops = 7;
  status.floor_m2 = 12.34;
  status.coverage_share = 0.819;
  status.travelled_m = 14.2;
  status.elapsed_s = 204.0;
  status.max_left_s = 70.0;
  status.link = LinkHealth{3.14, 2, 1, 0};
  status.battery_v = 7.4;
  status.page_url = "http://127.0.0.1:8080/";
  return status;
}

TEST(StatusFacts, SayAllThatIsKnown) {
  EXPECT_THAT(status_facts(full_status(), Glyphs::kHalfBlocks),
              ElementsAre("exploring by frontier",
                          "drives 0.80 m: to see new floor",
                          "at 1.25, -0.40 m, 90°, ±6 cm (95 %)",
                          "7 stops, 12.3 m² mapped",
                          "81 % of the floor in reach",
                          "14.2 m driven in 3:24",
                          "1:10 left at most",
                          "link 3.1 ms, 2 lost, 1 bad, 0 resets",
                          "battery 7.4 V",
                          "http://127.0.0.1:8080/"));
}

TEST(StatusFacts, AreAsciiWhereTheTerminalIs) {
  EXPECT_THAT(status_facts(full_status(), Glyphs::kAscii),
              Contains("at 1.25, -0.40 m, 90 deg, +-6 cm (95 %)"));
}

TEST(StatusFacts, LeaveOutWhatIsNotKnownButSayWhereThePlaceIsUnsure) {
  EXPECT_THAT(status_facts({}, Glyphs::kHalfBlocks),
              ElementsAre("position unsure", "0 stops", "0:00 elapsed"));
  RunStatus status;
  status.T_map_robot = geometry::Pose2();
  EXPECT_THAT(status_facts(status, Glyphs::kHalfBlocks), Contains("at 0.00, 0.00 m, 0°, unsure"));
}

TEST(StatusFacts, DoNotRoundAnUnfinishedMapUp) {
  RunStatus status;
  status.coverage_share = 0.9999;
  EXPECT_THAT(status_facts(status, Glyphs::kHalfBlocks), Contains("99 % of the floor in reach"));
}

TEST(StatusFacts, LetNoWordsMoveTheCursor) {
  RunStatus status;
  status.doing = "\033[2J";
  EXPECT_THAT(status_facts(status, Glyphs::kHalfBlocks), Contains("?[2J"));
}

TEST(MinutesText, CountsMinutesAndSeconds) {
  EXPECT_EQ(minutes_text(0.2), "0:00");
  EXPECT_EQ(minutes_text(64.6), "1:05");
}

}  // namespace
}  // namespace echomap::terminal_view
