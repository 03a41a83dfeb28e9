// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "host/exploration/intent.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/robot_link/link_state.hpp"
#include "host/robot_link/link_statistics.hpp"
#include "host/session/operator_control.hpp"

namespace echomap::live_page {

/// How the line to the robot is.
struct LinkHealth {
  robot_link::LinkState state = robot_link::LinkState::kConnecting;
  robot_link::LinkStatistics statistics;
  std::optional<double> frames_per_s;
  std::optional<double> battery_v;
};

/// What a run has come to, in words.
struct RunResult {
  bool finished = false;
  std::string outcome;
  std::string why;
  std::string next;
};

/// What a run is about, for a page that looks at it (docs/live_protocol.md, state).
struct RunState {
  /// Of a run that has ended, or whose robot is not connected yet or any more: none of a person's.
  enum class Phase : std::uint8_t { kConnecting, kRunning, kLostLink, kEnded, kRecording };
  Phase phase = Phase::kConnecting;
  session::OperatorMode person = session::OperatorMode::kStrategy;
  session::StandReason stands = session::StandReason::kNone;
  exploration::Intent intent;
  double speed = 0.0;  ///< Times real time, 0: as fast as it can.
  std::size_t clients = 0;
  std::optional<std::uint64_t> driver;
  std::string driver_name;
  std::size_t stops = 0;
  double floor_m2 = 0.0;
  std::optional<double> coverage;  ///< Of 1.
  std::optional<double> unseen_m2;
  double travelled_m = 0.0;
  std::optional<double> left_s;
  std::optional<LinkHealth> link;
  std::optional<localization::PoseBelief> belief;
  nlohmann::ordered_json score;  ///< Null without a truth.
  std::optional<RunResult> result;
};

/// The body of a message of kind state; what is not known is null.
nlohmann::ordered_json to_json(const RunState& state);

}  // namespace echomap::live_page
