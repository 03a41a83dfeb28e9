// SPDX-License-Identifier: MIT
#include "host/session/connect_failure.hpp"

#include <fmt/format.h>

#include "host/transport/open_stream.hpp"

namespace echomap::session {

using robot_link::LinkState;

console::ExitCode connect_failure(const robot_link::RobotLink& link) {
  return link.mismatch() ? console::ExitCode::kFirmwareMismatch : console::ExitCode::kNoRobot;
}

std::string reason_of_connect_failure(const robot_link::RobotLink& link, const std::string& port) {
  if (const auto& mismatch = link.mismatch()) {
    return mismatch->message();
  }
  const bool is_not_understood =
      link.state() == LinkState::kGarbage || link.state() == LinkState::kSilent;
  if (is_not_understood && transport::is_radio(port)) {
    return "no echomap frame comes from " + port +
           ": the robot is off, or its radio module is set to another speed than its firmware\n"
           "  next: flash the image for the module's speed, by the USB cable: ./run flash --baud "
           "115200";
  }
  switch (link.state()) {
    case LinkState::kGarbage:
      return "bytes come from " + port +
             ", but no echomap frame is among them: the board runs another program, or the baud "
             "rate is wrong\n  the first bytes were:\n" +
             link.preview().text() + "  next: ./run flash --port " + port +
             ", or name the speed that it was built for: --baud 9600";
    case LinkState::kUnheard:
      return "a robot sends on " + port +
             " but does not receive our frames\n  next: check the wire to the board's RX pin";
    case LinkState::kBusy:
      return fmt::format(
          "another program holds the robot on {} (session {:04x})\n  next: end that program, or "
          "take the robot from it: repeat the command with --take-over",
          port,
          link.holder());
    case LinkState::kDescribing:
      return "the robot on " + port +
             " was built with other messages and does not describe them\n  next: ./run flash "
             "--port " +
             port;
    case LinkState::kConnecting:
      return "the robot on " + port +
             " answers but resets again and again\n  next: give servo and motors their own supply, "
             "or fresh batteries";
    case LinkState::kLost:
      return "the robot on " + port +
             " answered once and then stopped\n  next: check its cable and its supply, then repeat "
             "the command";
    default:
      return "nothing answers on " + port +
             "\n  next: is the robot switched on and flashed? ./run flash --port " + port;
  }
}

std::string reason_of_take_over(const robot_link::RobotLink& link, const std::string& port) {
  return fmt::format(
      "another program has taken the robot on {} over (session {:04x})\n  next: end that program, "
      "then start again",
      port,
      link.holder());
}

std::optional<time::HostTime> start_of_robot(const robot_link::RobotLink& link) {
  const auto stamp_us = link.newest_stamp_us();
  const auto newest = stamp_us ? link.clock().host_time(*stamp_us) : std::nullopt;
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): newest has it
  return newest ? std::optional(newest->instant - std::chrono::microseconds(*stamp_us))
                : std::nullopt;
}

bool was_reset_since(time::HostTime instant, const robot_link::RobotLink& link) {
  const auto start = start_of_robot(link);
  const auto& robot = link.robot();
  const bool by_reset_line = robot && (robot->reset_cause & protocol::kResetExternal) != 0;
  return start && by_reset_line && *start > instant;
}

std::string reset_by_opening(const std::string& port) {
  return "opening " + port +
         " has reset the robot: the kernel raises DTR when a port is first opened\n"
         "  next: repeat the command; DTR stays up from now on";
}

}  // namespace echomap::session
