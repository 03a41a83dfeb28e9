// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/robot_link/command.hpp"
#include "host/session/configuration_check.hpp"
#include "host/session/robot_line.hpp"
#include "host/session/robot_profile.hpp"
#include "protocol/configuration.hpp"

namespace echomap::session {

/// Brings a robot to its profile and arms it.
class RobotSetup {
 public:
  /// Both outlive the setup.
  RobotSetup(RobotLine& line, const RobotProfile& profile) : line_(line), profile_(profile) {}

  /// Until the board has taken all of the profile since one and the same start. It is tried a few
  /// times, each time when the link is ready; what the last try failed at ends the session, and
  /// the answer is false.
  bool set_up();

 private:
  bool try_to_set_up();
  /// Reads the configuration back; false where the board was reset, or the link lost, in between.
  bool configure();
  /// False, with the session's end, for a robot that would drive other bridges than the profile's
  /// or lacks its scalar sensor, because its firmware is too old.
  bool knows_what_is_wanted(ConfigurationExtent extent);
  bool arm();
  bool send(const robot_link::Command& command);
  /// What a board does not take that answers kOutOfRange, and what to do.
  std::string words_of_refusal(const robot_link::Command& command) const;
  /// Notes what the board did instead.
  bool is_accepted(const robot_link::Command& command,
                   const std::optional<robot_link::CommandResult>& result);
  std::optional<protocol::Configuration> read_configuration(ConfigurationExtent extent);
  std::string reason_of_failure(std::uint64_t resets) const;

  RobotLine& line_;
  const RobotProfile& profile_;
  std::string failure_;  ///< What the last try failed at.
};

}  // namespace echomap::session
