// SPDX-License-Identifier: MIT
#include "host/live_page/event_watch.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using robot_link::LinkState;
using session::StandReason;
using testing::ElementsAre;
using testing::IsEmpty;

class EventWatchTest : public testing::Test {
 protected:
  /// Codes of what has happened since the look before.
  std::vector<std::string> look() {
    std::vector<std::string> codes;
    for (const RunEvent& event : watch.look_at(facts)) {
      codes.push_back(event.code);
    }
    return codes;
  }
  RunEvent only_event() {
    const std::vector<RunEvent> events = watch.look_at(facts);
    EXPECT_EQ(events.size(), 1U);
    return events.empty() ? RunEvent() : events.front();
  }

  EventWatch watch;
  EventFacts facts;
};

TEST_F(EventWatchTest, TellsNothingOfARunThatBegins) { EXPECT_THAT(look(), IsEmpty()); }

TEST_F(EventWatchTest, TellsEachTurnOfTheLinkOnce) {
  facts.link = LinkState::kReady;
  EXPECT_THAT(look(), ElementsAre("link-ready"));
  EXPECT_THAT(look(), IsEmpty());
  facts.link = LinkState::kLost;
  EXPECT_THAT(look(), ElementsAre("link-lost"));
  facts.link = LinkState::kSilent;
  EXPECT_THAT(look(), IsEmpty()) << "it is as lost as before";
  facts.link = LinkState::kReady;
  EXPECT_THAT(look(), ElementsAre("link-ready"));
}

TEST_F(EventWatchTest, TellsADeadSonarAndThatItAnswersAgain) {
  facts.sonar_is_dead = true;
  EXPECT_THAT(look(), ElementsAre("sonar-dead"));
  EXPECT_THAT(look(), IsEmpty());
  facts.sonar_is_dead = false;
  EXPECT_THAT(look(), ElementsAre("sonar-answers"));
}

TEST_F(EventWatchTest, TellsADirtyEncoderByItsWheel) {
  facts.left_encoder_is_dirty = true;
  EXPECT_THAT(look(), ElementsAre("encoder-left-dirty"));
  facts.right_encoder_is_dirty = true;
  EXPECT_THAT(look(), ElementsAre("encoder-right-dirty"));
  EXPECT_THAT(look(), IsEmpty());
}

TEST_F(EventWatchTest, TellsEveryResetOfTheRobot) {
  facts.link = LinkState::kReady;
  look();
  facts.resets = 1;
  EXPECT_THAT(look(), ElementsAre("reset"));
  EXPECT_THAT(look(), IsEmpty());
  facts.resets = 2;
  EXPECT_THAT(look(), ElementsAre("reset"));
}

TEST_F(EventWatchTest, TellsThatItTouchesSomethingOnceATouch) {
  facts.is_touching = true;
  EXPECT_THAT(look(), ElementsAre("bumped"));
  EXPECT_THAT(look(), IsEmpty());
  facts.is_touching = false;
  EXPECT_THAT(look(), IsEmpty());
  facts.is_touching = true;
  EXPECT_THAT(look(), ElementsAre("bumped"));
}

TEST_F(EventWatchTest, TellsALiftAndNotTheTouchOfTheHandThatLifts) {
  facts.is_lifted = true;
  facts.is_touching = true;
  EXPECT_THAT(look(), ElementsAre("lifted"));
  EXPECT_THAT(look(), IsEmpty());
}

TEST_F(EventWatchTest, TellsNewMapsAndThatTheyAreOneAgain) {
  facts.maps_changed = 1;
  EXPECT_THAT(look(), ElementsAre("new-map"));
  EXPECT_THAT(look(), IsEmpty());
  facts.maps_changed = 2;
  facts.maps_joined = 1;
  EXPECT_THAT(look(), ElementsAre("maps-joined")) << "a map that is joined is no new one";
}

TEST_F(EventWatchTest, TellsWhyARobotStandsThatAPersonHas) {
  const auto code_of = [&](StandReason reason) {
    facts.stands = StandReason::kNone;
    look();
    facts.stands = reason;
    return look();
  };
  EXPECT_THAT(code_of(StandReason::kStopPressed), ElementsAre("stop"));
  EXPECT_THAT(code_of(StandReason::kDriverGone), ElementsAre("driver-gone"));
  EXPECT_THAT(code_of(StandReason::kDriverSilent), ElementsAre("driver-gone"));
  EXPECT_THAT(code_of(StandReason::kNoWay), ElementsAre("no-way"));
  EXPECT_THAT(code_of(StandReason::kStalled), ElementsAre("stalled"));
  EXPECT_THAT(code_of(StandReason::kArrived), IsEmpty()) << "the state says it";
  EXPECT_THAT(code_of(StandReason::kBumped), IsEmpty()) << "told by its bumper";
  EXPECT_THAT(code_of(StandReason::kLifted), IsEmpty()) << "told by its wheels";
}

TEST_F(EventWatchTest, TellsAReasonOnce) {
  facts.stands = StandReason::kStopPressed;
  EXPECT_THAT(look(), ElementsAre("stop"));
  EXPECT_THAT(look(), IsEmpty());
}

TEST_F(EventWatchTest, TellsAllThatHappenedBetweenTwoLooks) {
  facts.link = LinkState::kReady;
  facts.resets = 1;
  facts.is_touching = true;
  facts.maps_changed = 1;
  facts.stands = StandReason::kStopPressed;
  EXPECT_THAT(look(), ElementsAre("reset", "link-ready", "bumped", "new-map", "stop"));
}

TEST_F(EventWatchTest, SaysWhyATroubleIsAndWhatHelps) {
  facts.link = LinkState::kReady;
  EXPECT_EQ(only_event().level, RunEvent::Level::kInfo);
  facts.link = LinkState::kLost;
  const RunEvent lost = only_event();
  EXPECT_EQ(lost.level, RunEvent::Level::kError);
  EXPECT_THAT(lost.cause, testing::HasSubstr("cable"));
  EXPECT_THAT(lost.remedy, testing::HasSubstr("plug it in"));
  facts.stands = StandReason::kStalled;
  EXPECT_EQ(only_event().level, RunEvent::Level::kError);
  for (const StandReason reason : {StandReason::kDriverGone, StandReason::kNoWay}) {
    facts.stands = reason;
    const RunEvent trouble = only_event();
    EXPECT_EQ(trouble.level, RunEvent::Level::kWarning) << trouble.code;
    EXPECT_NE(trouble.text, "") << trouble.code;
    EXPECT_NE(trouble.cause, "") << trouble.code;
    EXPECT_NE(trouble.remedy, "") << trouble.code;
  }
}

}  // namespace
}  // namespace echomap::live_page
