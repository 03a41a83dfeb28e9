// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "host/geometry/pose2.hpp"

namespace echomap::live_page {

/// Whether a robot of a fleet is there: it tells so, it said that it leaves, or it fell silent.
enum class Presence : std::uint8_t { kAlive, kLeft, kGone };

/// A robot of a fleet, in the frame of the map that is shown.
struct TeamRobot {
  std::string name;
  Presence presence = Presence::kAlive;
  double radius_m = 0.0;
  std::size_t stops = 0;
  /// Empty, as trail and claim, where its map is not joined to the one that is shown.
  std::optional<geometry::Pose2> T_map_robot{};
  std::vector<Eigen::Vector2d> trail_m{};
  std::optional<Eigen::Vector2d> claim_m{};  ///< Where it goes to look.
};

/// A share of each cell, from 0 to 255, as the probability that a source is there.
struct TeamField {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< Lower left corner of the first cell.
  double resolution_m = 0.0;
  std::size_t columns = 0;
  std::vector<std::uint8_t> cells;  ///< Row by row, upwards.
};

/// What is known of a source that a fleet looks for.
struct TeamSource {
  std::string verdict;  ///< "searching", "found" or "none".
  std::optional<Eigen::Vector2d> at_m;
  double radius_m = 0.0;          ///< It is so near to there with 95 %.
  double none_probability = 0.0;  ///< That there is none.
  std::optional<TeamField> field{};
};

/// What a fleet is about (docs/live_protocol.md, team).
struct TeamState {
  std::vector<TeamRobot> robots;  ///< In the order of their names.
  std::optional<TeamSource> source;
};

/// The body of a message of kind team.
nlohmann::ordered_json to_json(const TeamState& team);

}  // namespace echomap::live_page
