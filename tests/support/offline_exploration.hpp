// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "host/evaluation/map_agreement.hpp"
#include "host/evaluation/trajectory_error.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::tests {

struct OfflineRun {
  pipeline::Snapshot snapshot;
  std::size_t previous_maps = 0;  ///< That were not joined.
  std::size_t joins = 0;
  evaluation::MapAgreement agreement;
  double floor_seen = 0.0;     ///< Share of the floor in reach, in truth.
  double claimed_share = 0.0;  ///< The same as the map itself tells it.
  exploration::FinishReason reason = exploration::FinishReason::kStopLimit;
  double sim_seconds = 0.0;
  int bumps = 0;
  evaluation::TrajectoryError trajectory;
  evaluation::TrajectoryError odometry;  ///< Alone.
};

/// Strategies that explore offline, with their default parameters.
enum class OfflineStrategy : std::uint8_t { kNxtFarthest, kFrontier };

struct OfflineSettings {
  OfflineStrategy strategy = OfflineStrategy::kNxtFarthest;
  /// Makes what tells the pose; empty: odometry.
  std::function<std::unique_ptr<slam::SlamMethod>()> slam;
  /// A robot that is lost goes on in another map.
  bool is_watched = false;
  std::vector<OfflineCarry> carries;
};

OfflineRun explore_offline(const world::FloorPlan& room,
                           const world::RobotParams& robot,
                           std::uint32_t seed,
                           const OfflineSettings& settings = {});

/// The truth as the mock writes it, and as its reader understands it.
evaluation::MapTruth truth_of(const world::FloorPlan& plan);

/// How a robot's sonar maps.
mapping::SonarMapperParams mapper_for(const world::RobotParams& robot);

/// A room and a robot that come with the programs.
world::FloorPlan bundled_room(const std::string& room);
world::RobotParams bundled_robot(const std::string& robot);

}  // namespace echomap::tests
