// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/exploration/explorer.hpp"
#include "host/geometry/pose2.hpp"
#include "host/team_exploration/avoidance.hpp"

namespace echomap::tests {

/// How robots explore together offline.
struct OfflineTeamSettings {
  /// From then on every robot knows where the others' maps lie, as they truly began.
  double frames_known_s = 0.0;
  /// What a robot tells is known to the others so much later; it tells its pose so often.
  double delay_s = 0.2;
  double pose_period_s = 1.0;
  double position_stddev_m = 0.05;  ///< Said of the others' poses.
  /// The run ends where a map has this share of the floor, when all have finished, or then.
  double enough_share = 0.9;
  double max_s = 7200.0;
};

/// What became of one of them.
struct OfflineMember {
  std::optional<exploration::FinishReason> reason;  ///< Empty where it had not finished.
  double now_s = 0.0;
  std::size_t stops = 0;
  team_exploration::Encounters encounters;
  std::size_t lost_bids = 0;
  std::size_t echoes_of_peers = 0;
};

struct OfflineTeamRun {
  /// When a robot's map of all had settings.enough_share of the floor in reach.
  std::optional<double> covered_s;
  double share = 0.0;           ///< Of the floor in reach, in the best map at the end.
  std::size_t touches = 0;      ///< Times that two hulls met, in truth.
  double longest_wait_s = 0.0;  ///< That a robot stood in others' way, or they in its.
  std::vector<OfflineMember> members;
};

/// Lets robots explore a room together by `frontier` with SLAM, without firmware, in lockstep: the
/// robot whose clock is behind moves next, and the others stand meanwhile. Its motions are short
/// but for the sweeps of stops, at which it stands.
OfflineTeamRun explore_as_team(const world::FloorPlan& room,
                               const world::RobotParams& robot,
                               const std::vector<geometry::Pose2>& starts,
                               std::uint32_t seed,
                               const OfflineTeamSettings& settings = {});

}  // namespace echomap::tests
