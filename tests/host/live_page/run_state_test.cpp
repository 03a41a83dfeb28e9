// SPDX-License-Identifier: MIT
#include "host/live_page/run_state.hpp"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using exploration::IntentKind;
using nlohmann::json;
using Phase = RunState::Phase;
using robot_link::LinkState;
using session::OperatorMode;
using session::StandReason;

RunState running_state() {
  RunState state;
  state.phase = Phase::kRunning;
  return state;
}

std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& entry : object.items()) {
    keys.push_back(entry.key());
  }
  return keys;
}

TEST(RunState, HasTheEntriesOfTheProtocol) {
  EXPECT_THAT(keys_of(to_json(RunState{})),
              testing::ElementsAre("mode",
                                   "driver",
                                   "clients",
                                   "speed",
                                   "why",
                                   "stops",
                                   "floor_m2",
                                   "coverage",
                                   "unseen_m2",
                                   "travelled_m",
                                   "left_s",
                                   "link",
                                   "localization",
                                   "stopped",
                                   "score",
                                   "result"));
}

TEST(RunState, IsNullWhereNothingIsKnown) {
  const json state = to_json(running_state());
  for (const char* key : {"driver",
                          "coverage",
                          "unseen_m2",
                          "left_s",
                          "link",
                          "localization",
                          "stopped",
                          "score",
                          "result"}) {
    EXPECT_TRUE(state.at(key).is_null()) << key;
  }
}

TEST(RunState, NamesWhatTheRunIsInWhateverAPersonWants) {
  const std::vector<std::pair<Phase, std::string>> modes{{Phase::kConnecting, "connecting"},
                                                         {Phase::kLostLink, "lost-link"},
                                                         {Phase::kEnded, "ended"},
                                                         {Phase::kRecording, "recording"}};
  for (const auto& [phase, mode] : modes) {
    RunState state;
    state.phase = phase;
    state.person = OperatorMode::kDriving;
    EXPECT_EQ(to_json(state).at("mode"), mode);
  }
}

TEST(RunState, NamesWhoHasARobotThatRuns) {
  const std::vector<std::pair<OperatorMode, std::string>> modes{
      {OperatorMode::kStrategy, "explore"},
      {OperatorMode::kStopped, "stopped"},
      {OperatorMode::kDriving, "drive"},
      {OperatorMode::kGoing, "go"}};
  for (const auto& [person, mode] : modes) {
    RunState state = running_state();
    state.person = person;
    EXPECT_EQ(to_json(state).at("mode"), mode);
  }
}

TEST(RunState, NamesWhyItGoesThere) {
  const std::vector<std::pair<IntentKind, std::string>> codes{
      {IntentKind::kStrategy, "strategy"},
      {IntentKind::kSweep, "sweep"},
      {IntentKind::kFrontier, "frontier"},
      {IntentKind::kKnownWalls, "known-walls"},
      {IntentKind::kOpening, "opening"},
      {IntentKind::kPerson, "operator"},
      {IntentKind::kTellApart, "tell-apart"}};
  for (const auto& [kind, code] : codes) {
    RunState state = running_state();
    state.intent.kind = kind;
    const json why = to_json(state).at("why");
    EXPECT_EQ(why.at("code"), code);
    EXPECT_TRUE(why.at("goal").is_null());
    EXPECT_TRUE(why.at("gain_m2").is_null());
    EXPECT_EQ(why.at("choices"), json::array());
  }
}

TEST(RunState, TellsThePlacesThatWereWeighedAndWhichWasChosen) {
  RunState state = running_state();
  state.intent = {IntentKind::kFrontier,
                  exploration::WeighedPlace{{1.0, 2.0}, 1.75, 1.25},
                  {{{1.0, 2.0}, 1.75, 1.25}, {{3.0, 4.0}, 0.5, 2.0}}};
  EXPECT_EQ(json(to_json(state).at("why")), json::parse(R"({
    "code": "frontier", "goal": [1.0, 2.0], "gain_m2": 1.75,
    "choices": [{"at": [1.0, 2.0], "gain_m2": 1.75, "cost_m": 1.25, "chosen": true},
                {"at": [3.0, 4.0], "gain_m2": 0.5, "cost_m": 2.0, "chosen": false}]})"));
}

TEST(RunState, HasNoStrategysReasonsOfARecording) {
  RunState state;
  state.phase = Phase::kRecording;
  EXPECT_TRUE(to_json(state).at("why").is_null());
}

TEST(RunState, NamesWhyTheRobotStands) {
  const std::vector<std::pair<StandReason, std::string>> codes{
      {StandReason::kStopPressed, "stop"},
      {StandReason::kDriverGone, "driver-gone"},
      {StandReason::kDriverSilent, "driver-silent"},
      {StandReason::kBumped, "bumped"},
      {StandReason::kHazard, "hazard"},
      {StandReason::kStalled, "stalled"},
      {StandReason::kLifted, "lifted"},
      {StandReason::kNoWay, "no-way"},
      {StandReason::kArrived, "arrived"}};
  for (const auto& [reason, code] : codes) {
    RunState state = running_state();
    state.stands = reason;
    const json stopped = to_json(state).at("stopped");
    EXPECT_EQ(stopped.at("code"), code);
    EXPECT_NE(stopped.at("text"), "") << code;
  }
}

TEST(RunState, TellsHowTheLinkIs) {
  RunState state = running_state();
  state.link.emplace();
  state.link->state = LinkState::kReady;
  EXPECT_TRUE(to_json(state).at("link").at("round_trip_ms").is_null());
  state.link->statistics.round_trip = std::chrono::microseconds(3125);
  state.link->statistics.frames_lost = 1;
  state.link->statistics.frames_bad = 2;
  state.link->statistics.resets_seen = 3;
  state.link->statistics.outages = 4;
  state.link->frames_per_s = 48.0;
  state.link->battery_v = 7.5;
  EXPECT_EQ(json(to_json(state).at("link")), json::parse(R"({
    "state": "ready", "round_trip_ms": 3.125, "frames_lost": 1, "frames_bad": 2, "resets": 3,
    "outages": 4, "frames_per_s": 48.0, "battery_v": 7.5})"));
}

TEST(RunState, NamesEveryStateOfTheLink) {
  const std::vector<std::pair<LinkState, std::string>> names{{LinkState::kConnecting, "connecting"},
                                                             {LinkState::kReady, "ready"},
                                                             {LinkState::kDescribing, "describing"},
                                                             {LinkState::kSilent, "silent"},
                                                             {LinkState::kGarbage, "garbage"},
                                                             {LinkState::kUnheard, "unheard"},
                                                             {LinkState::kBusy, "busy"},
                                                             {LinkState::kMismatch, "mismatch"},
                                                             {LinkState::kLost, "lost"}};
  for (const auto& [link, name] : names) {
    RunState state = running_state();
    state.link.emplace();
    state.link->state = link;
    EXPECT_EQ(to_json(state).at("link").at("state"), name);
  }
}

TEST(RunState, TellsWhereTheRobotMayBe) {
  RunState state = running_state();
  state.belief.emplace();
  state.belief->status = localization::LocalizationStatus::kLocalized;
  state.belief->lost_probability = 0.125;
  state.belief->hypotheses.push_back(
      {{1.0, 2.0, 0.5},
       Eigen::Matrix3d{{0.25, 0.5, 0.0}, {0.5, 0.75, 0.0}, {0.0, 0.0, 1.0}},
       0.875});
  EXPECT_EQ(json(to_json(state).at("localization")), json::parse(R"({
    "status": "localized", "lost_probability": 0.125,
    "hypotheses": [{"x": 1.0, "y": 2.0, "heading": 0.5, "probability": 0.875,
                    "xx": 0.25, "xy": 0.5, "yy": 0.75}]})"));
}

TEST(RunState, TellsWhoDrivesAndWhatTheRunHasComeTo) {
  RunState state = running_state();
  state.phase = Phase::kEnded;
  state.driver = 3;
  state.driver_name = "phone";
  state.clients = 2;
  state.speed = 8.0;
  state.stops = 7;
  state.floor_m2 = 12.25;
  state.coverage = 0.75;
  state.unseen_m2 = 3.0;
  state.travelled_m = 14.5;
  state.left_s = 95.0;
  state.score = {{"free_iou", 0.5}};
  state.result = RunResult{true, "complete", "all is seen", "echomap eval first_map"};
  json expected = json::parse(R"({"mode": "ended", "driver": {"client": 3, "name": "phone"},
    "clients": 2, "speed": 8.0, "stops": 7, "floor_m2": 12.25, "coverage": 0.75, "unseen_m2": 3.0,
    "travelled_m": 14.5, "left_s": 95.0, "score": {"free_iou": 0.5},
    "result": {"finished": true, "outcome": "complete", "why": "all is seen",
               "next": "echomap eval first_map"}})");
  const json told = to_json(state);
  for (const auto& [key, value] : expected.items()) {
    EXPECT_EQ(told.at(key), value) << key;
  }
}

}  // namespace
}  // namespace echomap::live_page
