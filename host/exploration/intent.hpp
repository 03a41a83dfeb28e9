// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace echomap::exploration {

/// What a strategy is about.
enum class IntentKind : std::uint8_t {
  kStrategy,    ///< It does not say.
  kSweep,       ///< To look around where it stands.
  kFrontier,    ///< To look from where most unknown floor would be seen for the time.
  kKnownWalls,  ///< Back to walls that it knows, before its position gets unsure.
  kOpening,     ///< To step into an opening that no look from afar has shown.
  kPerson,      ///< To where a person has sent it.
  kTellApart,   ///< To where a look tells apart the places where it may be.
};

/// A place that was weighed, in the map frame.
struct WeighedPlace {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double gain_m2 = 0.0;  ///< Unknown floor that a look from there is expected to show.
  double cost_m = 0.0;   ///< Of the way there, in metres of open floor.
};

/// Where a strategy goes and why, for people.
struct Intent {
  IntentKind kind = IntentKind::kStrategy;
  std::optional<WeighedPlace> goal;
  std::vector<WeighedPlace> weighed;  ///< The best first.
};

}  // namespace echomap::exploration
