// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "protocol/command_messages.hpp"

namespace echomap::robot_link {

/// Everything that the robot acknowledges; `command_id` is filled in when it is submitted.
using Command = std::variant<protocol::Arm,
                             protocol::Stop,
                             protocol::ConfigureDrive,
                             protocol::ConfigureSonar,
                             protocol::ConfigurePan,
                             protocol::ConfigurePins,
                             protocol::ConfigureSensors,
                             protocol::ConfigureSafety,
                             protocol::ConfigureWiring,
                             protocol::ConfigureScalar,
                             protocol::MoveTicks,
                             protocol::StartSweep>;

/// Names one submitted command for the length of a session; never used twice.
enum class CommandTicket : std::uint64_t {};

/// How a command ended. All but the last three are the robot's own word.
enum class CommandOutcome : std::uint8_t {
  kAccepted,
  kDisarmed,
  kBusy,
  kOutOfRange,
  kBlocked,        ///< By a pressed contact, a hazard on the way, or for Arm a hanging wheel.
  kRefused,        ///< A status that this host does not know.
  kNotUnderstood,  ///< The robot's firmware has no such message; it was not sent.
  kLinkLost,    ///< No answer to eight tries, or not connected: it may have been done once, or not.
  kRobotReset,  ///< The robot was reset first: whatever it did is over.
};

/// The outcome in words.
std::string_view to_string(CommandOutcome outcome);

/// What became of one command.
struct CommandResult {
  CommandTicket ticket{};
  std::uint8_t command_id = 0;  ///< As in Status::move_id and sweep_id; 0 if it was never sent.
  CommandOutcome outcome = CommandOutcome::kLinkLost;
};

}  // namespace echomap::robot_link
