// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "host/exploration/explorer.hpp"
#include "host/pipeline/robot_atlas.hpp"

namespace echomap::exploration {

/// Continues exploring when the robot is carried off: asks for a new map, begins there with a new
/// strategy, and after every stop asks whether the two maps can be joined. Whoever drives the robot
/// carries this out by `change_maps`.
class AtlasExplorer final : public Explorer {
 public:
  /// Makes a strategy that begins where the robot is, behind so many stops of all before it; null
  /// where none is left.
  using MakeExplorer = std::function<std::unique_ptr<Explorer>(std::size_t stops_made)>;

  /// `stops` are in the map when the exploration begins. A strategy that cannot begin in a new map
  /// ends where the robot is lost or was lifted.
  AtlasExplorer(MakeExplorer make, std::size_t stops, bool begins_new_map = true);

  /// A strategy is told of the stops since it began.
  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  StrategyProducts products() const override;
  Intent intent() const override;
  /// Somebody says that the robot was moved: it is not where its map has it.
  void report_moved() { was_moved_ = true; }

  /// Since it began, in whichever map.
  std::size_t stops_made() const { return stops_made_; }

 private:
  void begin_strategy(std::size_t stops);
  /// Asks for a change of the maps, and remembers what to do where they stay as they are.
  Motion ask_for(const Motion& change, const Motion& otherwise);
  Motion next_of_strategy(pipeline::Snapshot snapshot, MotionResult last);

  MakeExplorer make_;
  bool begins_new_map_;
  std::unique_ptr<Explorer> strategy_;
  std::optional<Motion> otherwise_;  ///< Set where a change of the maps was asked for.
  std::size_t stops_before_ = 0;     ///< In the map when the strategy began.
  std::size_t stops_made_ = 0;       ///< Since the first strategy began.
  std::size_t stops_ = 0;            ///< In the map.
  bool was_moved_ = false;           ///< Somebody says so.
  bool is_lost_ = false;             ///< A new map was asked for because of that.
  std::size_t maps_lost_ = 0;        ///< In a row, that the robot was lost in.
};

/// Carries out what an explorer decides about the maps; empty for a motion of the robot.
std::optional<MotionResult> change_maps(pipeline::RobotAtlas& atlas, const Motion& motion);

}  // namespace echomap::exploration
