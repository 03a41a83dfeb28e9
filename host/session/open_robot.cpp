// SPDX-License-Identifier: MIT
#include "host/session/open_robot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "host/files/atomic_file.hpp"
#include "host/session/known_ports.hpp"
#include "host/session/port_choice.hpp"
#include "host/session/speed_search.hpp"
#include "host/transport/open_stream.hpp"
#include "host/transport/port_identity.hpp"
#include "host/transport/reconnecting_stream.hpp"

namespace echomap::session {
namespace {

/// `baud` 0 opens at the usual speed.
OpenPort opener(int baud) {
  return [baud = baud != 0 ? baud : kRobotBauds.front()](const std::string& port) {
    return transport::open_stream(port, baud);
  };
}

/// Remembers a USB or Bluetooth port of this machine; nothing for a pty or an address.
std::function<void()> rememberer_of(const std::string& port) {
  std::error_code ignored;
  const std::string device = std::filesystem::weakly_canonical(port, ignored).string();
  const auto ports = transport::list_ports();
  const auto found = std::ranges::find(ports, device, &transport::PortInfo::name);
  if (found == ports.end()) {
    return {};
  }
  return [info = *found] {
    try {
      KnownPorts().remember(info);
    } catch (const files::FileError& error) {
      spdlog::warn("cannot remember that {} has a robot: {}", info.name, error.what());
    }
  };
}

/// The port where the robot is, open.
std::unique_ptr<transport::ByteStream> open_chosen_port(const ConnectionOptions& options,
                                                        std::uint16_t session) {
  const auto here = options.lockstep.empty() ? surroundings_here() : PortSurroundings();
  return choose_port(
      candidate_ports(options.ports, here), opener(options.baud), session, options.baud == 0);
}

/// A robot that may be unplugged and reset, and is waited for.
RobotConnection connection_on_a_desk(const ConnectionOptions& options) {
  RobotConnection robot;
  robot.no_reset = options.no_reset;
  robot.pace = real_time_pace();
  robot.session_id = session_id_from(options.session_number);
  robot.stream = open_chosen_port(options, robot.session_id);
  const bool is_radio = transport::is_radio(robot.stream->name());
  const int baud = options.baud == 0 && !is_radio
                       ? find_speed(*robot.stream, robot.session_id).value_or(0)
                       : options.baud;
  if (is_radio) {
    robot.link = robot_link::radio_link();
  } else if (baud != 0) {
    robot.link = robot_link::wired_link(baud);
  }
  robot.link.takes_over = options.take_over;
  if (options.reconnect_s > 0.0) {
    const transport::PortIdentity identity(robot.stream->name());
    robot.stream = std::make_unique<transport::ReconnectingStream>(
        std::move(robot.stream),
        [open = opener(baud), identity] { return open(identity.name_now()); });
    robot.patience = std::chrono::milliseconds(std::llround(1e3 * options.reconnect_s));
  }
  return robot;
}

}  // namespace

std::uint16_t session_id_from(std::uint32_t number) {
  return static_cast<std::uint16_t>(1 + number % 0xFFFF);
}

OpenedRobot open_robot(const ConnectionOptions& options, const Seed& seed) {
  if (options.lockstep.empty()) {
    OpenedRobot robot{connection_on_a_desk(options), nullptr, {}};
    robot.remember_port = rememberer_of(robot.connection.stream->name());
    return robot;
  }
  OpenedRobot robot;
  robot.connection.session_id = session_id_from(seed.number());
  robot.connection.stream = open_chosen_port(options, robot.connection.session_id);
  robot.lockstep = std::make_unique<transport::LockstepChannel>(options.lockstep);
  robot.connection.pace = lockstep_pace(*robot.lockstep);
  if (options.is_radio) {
    robot.connection.link = robot_link::radio_link();
  }
  robot.connection.link.takes_over = options.take_over;
  return robot;
}

}  // namespace echomap::session
