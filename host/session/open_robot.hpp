// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/session/robot_connection.hpp"
#include "host/session/seed.hpp"
#include "host/transport/lockstep_channel.hpp"

namespace echomap::session {

/// Where a robot is and how to speak to it.
struct ConnectionOptions {
  std::vector<std::string> ports;  ///< Empty: the one that can be a robot.
  int baud = 0;  ///< Of a serial device, bits per second; 0: whichever the robot answers at.
  bool take_over = false;     ///< Takes the robot from a program that holds it.
  bool no_reset = false;      ///< End where opening the port has reset the robot.
  double reconnect_s = 10.0;  ///< How long to wait for a robot that is away; 0: not at all.
  std::string lockstep;       ///< Socket of a simulated robot's clock; empty for a real one.
  bool is_radio = false;      ///< What carries the bytes of a simulated robot is a radio.
  /// From which the number of a session with a real robot is made: another one every time.
  std::uint32_t session_number = 0;
};

/// A session's number from any other: never 0, which a robot that has just started stands for.
std::uint16_t session_id_from(std::uint32_t number);

/// A robot whose port is open.
struct OpenedRobot {
  RobotConnection connection;
  /// That of a simulated robot, which outlives the connection; null for one on a desk.
  std::unique_ptr<transport::LockstepChannel> lockstep;
  /// Done once the robot has answered: keeps in mind that its port has a robot.
  std::function<void()> remember_port = {};
};

/// Opens the one port where the robot is. In lockstep a session is a function of `seed`. Throws
/// CommandError 3 and transport::TransportError.
OpenedRobot open_robot(const ConnectionOptions& options, const Seed& seed);

}  // namespace echomap::session
