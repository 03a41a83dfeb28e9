// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/terminal_view/terminal_kind.hpp"

namespace echomap::terminal_view {

/// How the link to the robot is.
struct LinkHealth {
  std::optional<double> round_trip_ms{};  ///< Empty before the first answer.
  std::uint64_t frames_lost = 0;
  std::uint64_t frames_bad = 0;
  std::uint64_t resets = 0;
};

/// How far a run has come, and what it does now. What is empty is not shown, but for the position's
/// uncertainty.
struct RunStatus {
  std::string mode{};   ///< "exploring", "localizing".
  std::string doing{};  ///< What the robot does, in words.
  std::string why{};    ///< Why it does that, in words.
  std::optional<geometry::Pose2> T_map_robot{};
  /// The position is within so much of the truth with a probability of 95 %, in the direction in
  /// which it is the least certain; empty where it is unsure.
  std::optional<double> position_95_m{};
  std::size_t stops = 0;
  std::optional<double> floor_m2{};        ///< Known to be free.
  std::optional<double> coverage_share{};  ///< Of the floor in reach, 0 .. 1.
  std::optional<double> travelled_m{};
  double elapsed_s = 0.0;
  std::optional<double> max_left_s{};
  std::optional<LinkHealth> link{};
  std::optional<double> battery_v{};
  std::string page_url{};  ///< Of the live page.
};

/// The status in printable words, a fact each, the most important first.
std::vector<std::string> status_facts(const RunStatus& status, Glyphs glyphs);

/// Minutes and seconds, "1:05".
std::string minutes_text(double duration_s);

}  // namespace echomap::terminal_view
