// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/apps/robot_line.hpp"
#include "host/apps/robot_profile.hpp"
#include "host/robot_link/command.hpp"
#include "protocol/configuration.hpp"

namespace echomap::apps {

/// Brings a robot to its profile and arms it.
class RobotSetup {
 public:
  /// Both outlive the setup.
  RobotSetup(RobotLine& line, const RobotProfile& profile) : line_(line), profile_(profile) {}

  /// Until the board has taken all of the profile since one and the same start; false at the
  /// session's end. Throws CommandError, 6, where the board does not take it.
  bool set_up();

 private:
  bool try_to_set_up();
  /// Reads the configuration back; false where the board was reset, or the link lost, in between.
  bool configure();
  bool send(const robot_link::Command& command);
  std::optional<protocol::Configuration> read_configuration();

  RobotLine& line_;
  const RobotProfile& profile_;
};

}  // namespace echomap::apps
