// SPDX-License-Identifier: MIT
#pragma once

#include "host/fleet_member/search_view.hpp"
#include "host/fleet_messages/conversions.hpp"
#include "host/team_exploration/team_board.hpp"

namespace echomap::fleet_member {

/// Where a robot that searches a source reads what the others of its fleet have told, and tells
/// what it has come to itself.
class SearchBoard : public team_exploration::TeamBoard {
 public:
  /// What the others have told of a source, in this robot's own map's frame.
  virtual SearchView search_view() const = 0;
  /// From now on this is what the robot has come to, and is about to read.
  virtual void tell_search(const fleet_messages::SearchReport& report) = 0;
};

}  // namespace echomap::fleet_member
