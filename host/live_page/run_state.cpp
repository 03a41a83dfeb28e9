// SPDX-License-Identifier: MIT
#include "host/live_page/run_state.hpp"

#include <chrono>

#include "host/tracking/pose_report.hpp"

namespace echomap::live_page {
namespace {

using exploration::IntentKind;
using nlohmann::ordered_json;
using robot_link::LinkState;
using session::OperatorMode;
using session::StandReason;

template <class Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

const char* mode_of(const RunState& state) {
  switch (state.phase) {
    case RunState::Phase::kConnecting:
      return "connecting";
    case RunState::Phase::kLostLink:
      return "lost-link";
    case RunState::Phase::kEnded:
      return "ended";
    case RunState::Phase::kRecording:
      return "recording";
    case RunState::Phase::kRunning:
      break;
  }
  switch (state.person) {
    case OperatorMode::kStopped:
      return "stopped";
    case OperatorMode::kDriving:
      return "drive";
    case OperatorMode::kGoing:
      return "go";
    case OperatorMode::kStrategy:
      break;
  }
  return "explore";
}

const char* code_of(IntentKind kind) {
  switch (kind) {
    case IntentKind::kSweep:
      return "sweep";
    case IntentKind::kFrontier:
      return "frontier";
    case IntentKind::kKnownWalls:
      return "known-walls";
    case IntentKind::kOpening:
      return "opening";
    case IntentKind::kPerson:
      return "operator";
    case IntentKind::kTellApart:
      return "tell-apart";
    case IntentKind::kStrategy:
      break;
  }
  return "strategy";
}

/// A code, and the sentence of a page that does not know it.
struct StandText {
  const char* code;
  const char* text;
};

StandText text_of(StandReason reason) {
  switch (reason) {
    case StandReason::kStopPressed:
      return {"stop", "STOP was pressed"};
    case StandReason::kDriverGone:
      return {"driver-gone", "the page that drove it was closed or lost its connection"};
    case StandReason::kDriverSilent:
      return {"driver-silent", "nothing was heard from the page that drove it for 0.25 s"};
    case StandReason::kBumped:
      return {"bumped", "it touched something"};
    case StandReason::kHazard:
      return {"hazard", "a sensor saw an edge or another hazard"};
    case StandReason::kStalled:
      return {"stalled", "its wheels do not turn"};
    case StandReason::kLifted:
      return {"lifted", "somebody has picked it up"};
    case StandReason::kNoWay:
      return {"no-way", "no known floor leads there"};
    case StandReason::kArrived:
      return {"arrived", "it is where it was sent"};
    case StandReason::kNone:
      break;
  }
  return {"", ""};
}

ordered_json json_of(const exploration::WeighedPlace& place, bool chosen) {
  return {{"at", {place.at_m.x(), place.at_m.y()}},
          {"gain_m2", place.gain_m2},
          {"cost_m", place.cost_m},
          {"chosen", chosen}};
}

ordered_json why_of(const exploration::Intent& intent) {
  ordered_json why{{"code", code_of(intent.kind)}, {"goal", nullptr}, {"gain_m2", nullptr}};
  const auto& goal = intent.goal;
  if (goal) {
    why["goal"] = {goal->at_m.x(), goal->at_m.y()};
    if (intent.kind == IntentKind::kFrontier) {
      why["gain_m2"] = goal->gain_m2;
    }
  }
  why["choices"] = ordered_json::array();
  for (const exploration::WeighedPlace& place : intent.weighed) {
    why["choices"].push_back(json_of(place, goal && place.at_m == goal->at_m));
  }
  return why;
}

const char* name_of(LinkState state) {
  switch (state) {
    case LinkState::kReady:
      return "ready";
    case LinkState::kDescribing:
      return "describing";
    case LinkState::kSilent:
      return "silent";
    case LinkState::kGarbage:
      return "garbage";
    case LinkState::kUnheard:
      return "unheard";
    case LinkState::kBusy:
      return "busy";
    case LinkState::kMismatch:
      return "mismatch";
    case LinkState::kLost:
      return "lost";
    case LinkState::kConnecting:
      break;
  }
  return "connecting";
}

ordered_json json_of(const LinkHealth& link) {
  const robot_link::LinkStatistics& counts = link.statistics;
  ordered_json json{{"state", name_of(link.state)},
                    {"round_trip_ms", nullptr},
                    {"frames_lost", counts.frames_lost},
                    {"frames_bad", counts.frames_bad},
                    {"resets", counts.resets_seen},
                    {"outages", counts.outages},
                    {"frames_per_s", or_null(link.frames_per_s)},
                    {"battery_v", or_null(link.battery_v)}};
  if (counts.round_trip) {
    json["round_trip_ms"] = std::chrono::duration<double, std::milli>(*counts.round_trip).count();
  }
  return json;
}

ordered_json json_of(const localization::PoseBelief& belief) {
  ordered_json json{{"status", tracking::name_of(belief.status)},
                    {"lost_probability", belief.lost_probability},
                    {"hypotheses", ordered_json::array()}};
  for (const localization::PoseHypothesis& place : belief.hypotheses) {
    json["hypotheses"].push_back({{"x", place.T_map_robot.x_m()},
                                  {"y", place.T_map_robot.y_m()},
                                  {"heading", place.T_map_robot.heading_rad()},
                                  {"probability", place.probability},
                                  {"xx", place.covariance(0, 0)},
                                  {"xy", place.covariance(0, 1)},
                                  {"yy", place.covariance(1, 1)}});
  }
  return json;
}

ordered_json driver_of(const RunState& state) {
  return state.driver ? ordered_json{{"client", *state.driver}, {"name", state.driver_name}}
                      : ordered_json();
}

ordered_json stopped_of(StandReason reason) {
  const StandText text = text_of(reason);
  return reason == StandReason::kNone ? ordered_json()
                                      : ordered_json{{"code", text.code}, {"text", text.text}};
}

ordered_json json_of(const RunResult& result) {
  return {{"finished", result.finished},
          {"outcome", result.outcome},
          {"why", result.why},
          {"next", result.next}};
}

}  // namespace

ordered_json to_json(const RunState& state) {
  ordered_json json{{"mode", mode_of(state)},
                    {"driver", driver_of(state)},
                    {"clients", state.clients},
                    {"speed", state.speed},
                    {"why", nullptr},
                    {"stops", state.stops},
                    {"floor_m2", state.floor_m2},
                    {"coverage", or_null(state.coverage)},
                    {"unseen_m2", or_null(state.unseen_m2)},
                    {"travelled_m", state.travelled_m},
                    {"left_s", or_null(state.left_s)},
                    {"link", nullptr},
                    {"localization", nullptr},
                    {"stopped", stopped_of(state.stands)},
                    {"score", state.score},
                    {"result", nullptr}};
  if (state.phase != RunState::Phase::kRecording) {
    json["why"] = why_of(state.intent);
  }
  if (state.link) {
    json["link"] = json_of(*state.link);
  }
  if (state.belief) {
    json["localization"] = json_of(*state.belief);
  }
  if (state.result) {
    json["result"] = json_of(*state.result);
  }
  return json;
}

}  // namespace echomap::live_page
