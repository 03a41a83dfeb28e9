// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Interface through which a robot reads what its team knows, and publishes what it is about to do.
class TeamBoard {
 public:
  virtual ~TeamBoard() = default;

  /// Current view of the team. Called before every motion: its large parts are shared.
  virtual TeamView view() = 0;
  /// Publishes what the robot claims, in its own map frame; empty for nothing.
  virtual void claim(const std::optional<Claim>& claim) = 0;
};

}  // namespace echomap::team_exploration
