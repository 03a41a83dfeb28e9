// SPDX-License-Identifier: MIT
#include "host/apps/link_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(LinkReport, TakesWhatTheLinkHasCounted) {
  robot_link::LinkStatistics statistics;
  statistics.frames_lost = 3;
  statistics.round_trip = std::chrono::microseconds(4100);
  statistics.outages = 2;
  statistics.outage_time = std::chrono::milliseconds(2500);
  statistics.robot_encoder_errors = 5;
  statistics.robot_stack_free_bytes = 612;
  const exports::LinkSummary link = summary_of(statistics, 7);
  EXPECT_EQ(link.frames_lost, 3U);
  EXPECT_EQ(link.round_trip_us, 4100.0);
  EXPECT_EQ(link.outages, 2U);
  EXPECT_EQ(link.outage_seconds, 2.5);
  EXPECT_EQ(link.reconnects, 7U);
  EXPECT_EQ(link.robot_stack_free_bytes, 612);
  EXPECT_THAT(line_of(link),
              AllOf(HasSubstr("3 lost"),
                    HasSubstr("2 outages of 2.5 s, 7 reconnects"),
                    HasSubstr("5 encoder errors"),
                    HasSubstr("612 bytes of stack")));
}

TEST(LinkReport, CallsNoEncoderCleanThatTheBoardCannotSee) {
  robot_link::LinkStatistics statistics;
  EXPECT_THAT(line_of(summary_of(statistics, 0)), HasSubstr("0 encoder errors (0 left, 0 right)"));
  statistics.robot_encoder_errors = std::nullopt;
  EXPECT_THAT(line_of(summary_of(statistics, 0)),
              AllOf(HasSubstr("encoder errors unknown"), Not(HasSubstr("0 encoder errors"))));
}

TEST(LinkReport, TellsALossOnceAndOnlyWhereItRises) {
  exports::LinkSummary before;
  before.robot_receive_overruns = 10;
  exports::LinkSummary now = before;
  EXPECT_EQ(losses_between(before, now), "");
  now.robot_receive_overruns = 13;
  EXPECT_THAT(losses_between(before, now),
              AllOf(HasSubstr("3 receiver overruns"), Not(HasSubstr("dropped"))));
  now.robot_telemetry_dropped = 2;
  EXPECT_THAT(losses_between(before, now),
              AllOf(HasSubstr("3 receiver overruns"), HasSubstr("2 telemetry")));
  EXPECT_EQ(losses_between(now, now), "");
}

}  // namespace
}  // namespace echomap::apps
