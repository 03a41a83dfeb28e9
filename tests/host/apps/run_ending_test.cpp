// SPDX-License-Identifier: MIT
#include "host/apps/run_ending.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echomap::apps {
namespace {

using console::ExitCode;
using exploration::Coverage;
using exploration::FinishReason;
using testing::HasSubstr;
using testing::Not;

const NextCommands kNext{"echomap eval kitchen",
                         "echomap explore --resume kitchen",
                         "echomap localize --map kitchen",
                         "echomap explore"};

Coverage coverage(double seen_m2, double unseen_m2) {
  Coverage coverage;
  coverage.seen_m2 = seen_m2;
  coverage.unseen_m2 = unseen_m2;
  if (unseen_m2 > 0.0) {
    coverage.places.push_back({{2.04, -0.41}, unseen_m2});
  }
  return coverage;
}

TEST(RunEnding, OfARobotThatIsNotAsItsProfileSaysNamesWhatToChange) {
  const RunEnding ending =
      ending_of_fault({"the pan turns the other way", "set us_per_90deg = -900"}, kNext.again);
  EXPECT_EQ(ending.code, ExitCode::kRobotFault);
  EXPECT_EQ(ending.outcome, "robot-fault");
  EXPECT_EQ(ending.next, "set us_per_90deg = -900, then: echomap explore");
}

TEST(RunEnding, KeepsItsCodeWhereTheFaultAllowsAMap) {
  const RunEnding ending =
      with_fault({"complete", ExitCode::kOk, "all is seen", "echomap eval kitchen"},
                 {"the sonar looks left", "set centre_us = 1430"});
  EXPECT_EQ(ending.code, ExitCode::kOk);
  EXPECT_EQ(ending.why, "all is seen; but the sonar looks left: set centre_us = 1430");
}

TEST(RunEnding, OfAMapThatHasWhatTheRobotCanReachIsFinished) {
  const RunEnding ending = ending_of(FinishReason::kComplete, coverage(14.2, 0.2), {}, kNext);
  EXPECT_TRUE(ending.finished());
  EXPECT_EQ(ending.outcome, "complete");
  EXPECT_EQ(ending.why, "the map has 98 % of the floor that the robot can reach, 14.2 m²");
  EXPECT_EQ(ending.next, kNext.use);
}

TEST(RunEnding, TellsWhatIsExpectedOfTheWalls) {
  const RunEnding ending = ending_of(
      FinishReason::kComplete, coverage(14.2, 0.2), mapping::ExpectedWallError{0.04, 0.081}, kNext);
  EXPECT_EQ(ending.why,
            "the map has 98 % of the floor that the robot can reach, 14.2 m², walls off by about 4 "
            "cm (9 in 10 such maps: by less than 8 cm)");
}

TEST(RunEnding, NamesTheGapThatWasTooNarrow) {
  Coverage seen = coverage(10.0, 0.0);
  seen.gaps.push_back({{3.1, 1.2}, 0.15, 4.0});
  EXPECT_EQ(ending_of(FinishReason::kComplete, seen, {}, kNext).why,
            "the map has 100 % of the floor that the robot can reach, 10.0 m²; a gap of 0.15 m at "
            "(3.1, 1.2) was too narrow for it");
}

TEST(RunEnding, NamesTheWallsThatMayBeDoors) {
  Coverage seen = coverage(10.0, 0.0);
  seen.doors.push_back({{2.0, 1.0}, {1.0, 1.0}});
  EXPECT_EQ(ending_of(FinishReason::kComplete, seen, {}, kNext).why,
            "the map has 100 % of the floor that the robot can reach, 10.0 m²; what is drawn as "
            "wall at (1.5, 1.0) may be a door");
  seen.doors.push_back({{4.0, 0.0}, {4.0, 0.5}});
  EXPECT_THAT(ending_of(FinishReason::kComplete, seen, {}, kNext).why,
              testing::EndsWith("may be a door, and 1 more"));
  seen.unseen_m2 = 10.0;
  EXPECT_THAT(ending_of(FinishReason::kComplete, seen, {}, kNext).why, Not(HasSubstr("door")))
      << "it is unfinished anyway";
  const auto told = summary_of(seen);
  ASSERT_EQ(told.possible_doors.size(), 2U);
  EXPECT_EQ(told.possible_doors.front(), (std::array{1.5, 1.0, 1.0}));
}

TEST(RunEnding, IsUnfinishedWhereAnEarlierMapHasMore) {
  const RunEnding last = ending_of(FinishReason::kComplete, coverage(7.0, 0.1), {}, kNext);
  ASSERT_TRUE(last.finished());
  EXPECT_EQ(with_previous_map(last, 0.0, 7.0, kNext).why, last.why);
  EXPECT_TRUE(with_previous_map(last, 6.0, 7.0, kNext).finished()) << "it is all in the last";
  const RunEnding ending = with_previous_map(last, 60.0, 7.0, kNext);
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_THAT(ending.why, HasSubstr("an earlier map, which could not be joined to it, has 60.0"));
  EXPECT_EQ(ending.next, kNext.go_on);
}

TEST(RunEnding, OfAStrategyThatCallsHalfARoomCompleteIsUnfinished) {
  const RunEnding ending = ending_of(FinishReason::kComplete, coverage(6.0, 6.0), {}, kNext);
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_EQ(ending.why,
            "the map has 50 % of the floor that the robot can reach, 6.0 m²; most of what is "
            "unseen is near (2.0, -0.4)");
  EXPECT_EQ(ending.next, kNext.go_on);
}

TEST(RunEnding, AtALimitSaysSoAndIsJudgedByTheMap) {
  const RunEnding cut = ending_of(FinishReason::kStopLimit, coverage(6.0, 2.0), {}, kNext);
  EXPECT_EQ(cut.code, ExitCode::kUnfinished);
  EXPECT_THAT(cut.why, HasSubstr("it came to the limit of its stops; the map has 75 %"));
  EXPECT_TRUE(ending_of(FinishReason::kStopLimit, coverage(6.0, 0.1), {}, kNext).finished());
  EXPECT_TRUE(ending_of(FinishReason::kNoNewGround, coverage(6.0, 0.1), {}, kNext).finished());
}

TEST(RunEnding, WithoutASonarTheStrategyIsBelieved) {
  EXPECT_TRUE(ending_of(FinishReason::kComplete, std::nullopt, {}, kNext).finished());
  const RunEnding ending = ending_of(FinishReason::kNowhereToGo, std::nullopt, {}, kNext);
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_EQ(ending.why, "it found no way on");
}

TEST(RunEnding, OfATroubleIsThatOfTheTroubleWhateverTheMapHas) {
  struct Case {
    FinishReason reason;
    ExitCode code;
    const char* next;
  };
  for (const Case& one : {
           Case{FinishReason::kBatteryLow,
                ExitCode::kSafetyStop,
                "charge it without moving the robot, then: echomap explore --resume kitchen"},
           Case{FinishReason::kStuck, ExitCode::kSafetyStop, "free it and start again"},
           Case{FinishReason::kLifted, ExitCode::kSafetyStop, "put it down and start again"},
           Case{FinishReason::kLost,
                ExitCode::kRuntimeError,
                "start again, or find it in its map: echomap localize --map kitchen"},
           Case{FinishReason::kSonarSilent,
                ExitCode::kRuntimeError,
                "check the sonar's wiring and its supply, then start again"},
       }) {
    const RunEnding ending = ending_of(one.reason, coverage(10.0, 0.0), {}, kNext);
    EXPECT_EQ(ending.outcome, name_of(one.reason));
    EXPECT_EQ(ending.code, one.code) << ending.outcome;
    EXPECT_EQ(ending.next, one.next);
    EXPECT_THAT(ending.why, Not(HasSubstr("next: ")));
  }
}

TEST(RunEnding, TroubleIsOfTheRobotNotOfTheRoom) {
  EXPECT_TRUE(is_trouble(FinishReason::kSonarSilent));
  EXPECT_TRUE(is_trouble(FinishReason::kStuck));
  EXPECT_FALSE(is_trouble(FinishReason::kNowhereToGo));
  EXPECT_FALSE(is_trouble(FinishReason::kStopLimit));
}

TEST(RunEnding, OfASessionHasTheNextStepOfItsReasonOrElseTheOneThatGoesOn) {
  const RunEnding lost =
      ending_of(session::SessionEnd::kLinkLost, "lost robot: unplugged\n  next: plug it in", kNext);
  EXPECT_EQ(lost.outcome, "link-lost");
  EXPECT_EQ(lost.code, ExitCode::kLinkLost);
  EXPECT_EQ(lost.why, "lost robot: unplugged");
  EXPECT_EQ(lost.next, "plug it in");
  const RunEnding interrupted = ending_of(session::SessionEnd::kInterrupted, "interrupted", kNext);
  EXPECT_EQ(interrupted.code, ExitCode::kInterrupted);
  EXPECT_EQ(interrupted.next, kNext.go_on);
}

nlohmann::ordered_json belief(const std::string& status, std::vector<double> probabilities) {
  nlohmann::ordered_json json{{"status", status}, {"hypotheses", nlohmann::ordered_json::array()}};
  for (const double probability : probabilities) {
    json["hypotheses"].push_back(
        {{"x_m", 1.0}, {"y_m", -0.5}, {"heading_rad", 0.0}, {"probability", probability}});
  }
  return json;
}

TEST(RunEnding, OfALocalizationIsFinishedOnlyWhereTheRobotIsLocalized) {
  const console::CommandWords words{"echomap", "localize", "--map", "kitchen"};
  const RunEnding found = ending_of_localization("finished", belief("localized", {1.0}), words);
  EXPECT_TRUE(found.finished());
  EXPECT_EQ(found.next, "echomap localize --map kitchen");
  const RunEnding nowhere = ending_of_localization("finished", belief("recovering", {0.9}), words);
  EXPECT_EQ(nowhere.code, ExitCode::kUnfinished);
  EXPECT_THAT(nowhere.why, HasSubstr("the robot is not localized"));
  EXPECT_THAT(nowhere.next, HasSubstr("echomap localize --map kitchen --at X Y DEGREES"));
  EXPECT_EQ(to_json(nowhere).at("finished"), false);
}

TEST(RunEnding, OfALocalizationNamesThePlacesThatFit) {
  const RunEnding ending =
      ending_of_localization("stop-limit", belief("recovering", {0.55, 0.41, 0.04}), {"echomap"});
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_EQ(
      ending.why,
      "ambiguous: 2 places fit: (1.00, -0.50, 0 degrees) 0.55, (1.00, -0.50, 0 degrees) 0.41");
}

TEST(RunEnding, OfAPapersSettingsIsNoSuccessWhereItsParticlesAgree) {
  using localization::LocalizerPreset;
  const console::CommandWords words{"echomap", "localize", "run"};
  const RunEnding found = ending_of_localization("finished", belief("localized", {1.0}), words);
  EXPECT_TRUE(ending_of_preset(LocalizerPreset::kDefault, found, words).finished());
  for (const auto preset :
       {LocalizerPreset::kNxt, LocalizerPreset::kCreate, LocalizerPreset::kEpuck}) {
    const RunEnding told = ending_of_preset(preset, found, words);
    EXPECT_EQ(told.code, ExitCode::kUnfinished);
    EXPECT_THAT(told.why, HasSubstr("cannot tell whether they are right"));
    EXPECT_THAT(told.why, HasSubstr("simulated runs"));
    EXPECT_THAT(told.next, HasSubstr("echomap localize run"));
  }
  const RunEnding unsure = ending_of_localization("finished", belief("lost", {0.5}), words);
  EXPECT_EQ(ending_of_preset(LocalizerPreset::kNxt, unsure, words).why, unsure.why);
}

TEST(RunEnding, IsInTheSummary) {
  exports::RunSummary summary;
  describe_ending(ending_of(FinishReason::kStopLimit, coverage(6.0, 2.0), {}, kNext), summary);
  EXPECT_EQ(summary.outcome, "stop-limit");
  EXPECT_FALSE(summary.finished);
  EXPECT_FALSE(summary.why.empty());
  EXPECT_EQ(summary.next, kNext.go_on);
  const auto told = summary_of(coverage(6.0, 2.0));
  EXPECT_EQ(told.share, 0.75);
  ASSERT_EQ(told.places.size(), 1U);
  EXPECT_EQ(told.places.front()[2], 2.0);
}

TEST(RunEnding, HasTheDiagnosisInTheSummary) {
  EXPECT_FALSE(summary_of(std::optional<diagnosis::Diagnosis>()));
  const auto told =
      summary_of(diagnosis::Diagnosis{{diagnosis::FaultKind::kRangeScale, 0.9}, 7.5, 3});
  ASSERT_TRUE(told);
  EXPECT_EQ(told->name, "range-scale");
  EXPECT_EQ(told->value, 0.9);
  EXPECT_EQ(told->log_odds, 7.5);
  EXPECT_EQ(told->stops, 3U);
}

}  // namespace
}  // namespace echomap::apps
