// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hil_mock/world/floor_plan.hpp"
#include "host/evaluation/map_agreement.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::tests {

struct OfflineRun {
  pipeline::Snapshot snapshot;
  evaluation::MapAgreement agreement;
  exploration::FinishReason reason = exploration::FinishReason::kStopLimit;
  double sim_seconds = 0.0;
  int bumps = 0;
  /// Between where the robot is and where it believes to be.
  double final_error_m = 0.0;
  double final_heading_error_rad = 0.0;
};

/// Strategies that explore offline, with their default parameters.
enum class OfflineStrategy : std::uint8_t { kNxtFarthest, kFrontier };

/// Explores a bundled room with a bundled robot.
OfflineRun explore_offline(const std::string& room,
                           const std::string& robot,
                           std::uint32_t seed,
                           OfflineStrategy strategy = OfflineStrategy::kNxtFarthest);
OfflineRun explore_offline(const world::FloorPlan& room,
                           const std::string& robot,
                           std::uint32_t seed,
                           OfflineStrategy strategy = OfflineStrategy::kNxtFarthest);

/// A room that comes with the programs.
world::FloorPlan bundled_room(const std::string& room);

}  // namespace echomap::tests
