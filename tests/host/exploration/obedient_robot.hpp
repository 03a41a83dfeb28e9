// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {

/// Carries out what an explorer asks for, on a floor where nothing is in the way.
struct ObedientRobot {
  pipeline::Snapshot snapshot = tests::snapshot_of(mapping::OccupancyGrid(), {});
  std::vector<Eigen::Vector2d> stops_m;
  std::vector<Motion> motions;

  /// Answers why it ended, or nothing after far too many motions. `result_of` says how a
  /// motion ends.
  template <class ResultOf>
  std::optional<FinishReason> drive(Explorer& explorer, const ResultOf& result_of) {
    MotionResult last = MotionResult::kReached;
    for (int i = 0; i < 5000; ++i) {
      motions.push_back(explorer.next(snapshot, last));
      const Motion& motion = motions.back();
      if (const auto* finished = std::get_if<Finished>(&motion)) {
        return finished->reason;
      }
      last = result_of(motion);
      carry_out(motion);
    }
    return std::nullopt;
  }
  std::optional<FinishReason> drive(Explorer& explorer) {
    return drive(explorer, [](const Motion&) { return MotionResult::kReached; });
  }
  void carry_out(const Motion& motion) {
    geometry::Pose2& at = snapshot.latest.T_map_robot;
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      at = at * geometry::Pose2(0.0, 0.0, turn->angle_rad);
    } else if (const auto* drive = std::get_if<Drive>(&motion)) {
      at = at * geometry::Pose2(drive->distance_m, 0.0, 0.0);
    } else if (const auto* roll = std::get_if<Roll>(&motion)) {
      at = at * geometry::Pose2(
                    roll->forward_m_per_s * roll->for_s, 0.0, roll->turn_rad_per_s * roll->for_s);
    } else if (std::holds_alternative<BeginScan>(motion)) {
      stops_m.push_back(at.position_m());
    }
  }
};

}  // namespace echomap::exploration
