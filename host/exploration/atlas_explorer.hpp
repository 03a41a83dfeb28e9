// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "host/exploration/explorer.hpp"
#include "host/pipeline/robot_atlas.hpp"

namespace echomap::exploration {

/// Goes on exploring when the robot is carried off: sets the map so far aside, begins another one
/// with a strategy that begins anew, and after every stop looks whether the two can be joined.
class AtlasExplorer final : public Explorer {
 public:
  /// Makes a strategy that begins where the robot is, behind so many stops of all before it; null
  /// where none is left.
  using MakeExplorer = std::function<std::unique_ptr<Explorer>(std::size_t stops_made)>;

  /// `atlas`, which makes the snapshots, outlives this. A strategy that cannot begin anew ends
  /// where the robot is lost or was lifted.
  AtlasExplorer(pipeline::RobotAtlas& atlas, MakeExplorer make, bool begins_anew = true);

  /// A strategy is told of the stops since it began.
  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  StrategyProducts products() const override;

  /// Since it began, in whichever map.
  std::size_t stops_made() const { return stops_made_; }

 private:
  void begin_strategy();
  /// In another map, with a strategy that knows nothing of the one before.
  Motion go_on();
  Motion next_of_strategy(pipeline::Snapshot snapshot, MotionResult last);

  pipeline::RobotAtlas& atlas_;
  MakeExplorer make_;
  bool begins_anew_;
  std::unique_ptr<Explorer> strategy_;
  std::size_t stops_before_ = 0;  ///< In the map when the strategy began.
  std::size_t stops_made_ = 0;    ///< Since the first strategy began.
  std::size_t stops_ = 0;         ///< In the map.
};

}  // namespace echomap::exploration
