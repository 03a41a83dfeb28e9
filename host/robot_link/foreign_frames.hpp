// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/robot_link/robot_schema.hpp"

namespace echomap::robot_link {

/// Tells frames that only the robot understands from damaged ones, after the robot has described
/// its messages.
class ForeignFrames {
 public:
  /// Of the byte stream, each byte.
  void add(std::uint8_t byte);
  /// The sequence number of the frame that has just ended, where `difference` says that it is a
  /// whole one of the robot's own; empty for any other.
  std::optional<std::uint8_t> recognised(const SchemaDifference& difference) const;

 private:
  std::vector<std::uint8_t> stuffed_;  ///< Since the delimiter before; too long ones are cut.
  bool ended_ = false;
};

}  // namespace echomap::robot_link
