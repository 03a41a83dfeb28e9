// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Where one robot reads what its team knows, and tells what it is about to do.
class TeamBoard {
 public:
  virtual ~TeamBoard() = default;

  /// As it is now. Asked for before every motion: what is large in it is shared.
  virtual TeamView view() = 0;
  /// From now on this is what the robot claims, in its own map frame; empty for nothing.
  virtual void claim(const std::optional<Claim>& claim) = 0;
};

}  // namespace echomap::team_exploration
