// SPDX-License-Identifier: MIT
#pragma once

#include "host/fleet_member/search_view.hpp"
#include "host/fleet_messages/conversions.hpp"
#include "host/team_exploration/team_board.hpp"

namespace echomap::fleet_member {

/// Interface through which a robot that searches a source reads what the others of its fleet have
/// published, and publishes its own result.
class SearchBoard : public team_exploration::TeamBoard {
 public:
  /// What the others have published of a source, in this robot's map frame.
  virtual SearchView search_view() const = 0;
  /// Publishes what the robot has found, and is about to read.
  virtual void publish_search(const fleet_messages::SearchReport& report) = 0;
};

}  // namespace echomap::fleet_member
