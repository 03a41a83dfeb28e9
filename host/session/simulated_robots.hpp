// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/session/child_process.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::session {

/// Which simulated robots are started, and in which room.
struct SimulatedRobotOptions {
  std::string world = "living_room";
  std::string emulator = "simavr";  ///< One of boards::emulator_names(), or "mock".
  std::string board;                ///< One of that emulator; empty: its usual one.
  std::string driver;               ///< Of its motors; empty: that of its body's file.
  std::string line = "direct";      ///< What carries the bytes: direct, usb, ftdi or bluetooth.
  std::string faults;       ///< Of the line, as the robot's program takes them; empty: none.
  std::string part_faults;  ///< As the robot's program takes them; empty: none.
  /// Sources of radiation in place of the world's, each "X,Y,STRENGTH", or "none"; empty: the
  /// world's.
  std::vector<std::string> sources;
  /// What is true of the robot (docs/decisions/0002); empty: the bundled body of the profile's
  /// name.
  std::string body;
  /// udp:127.0.0.1:PORT where the simulated camera over the room sends its fixes; empty: no camera.
  std::string fixes;
  std::string camera_params;  ///< What that camera is like; empty: as the robot's program has it.
  /// So many of that kind in the room, which hear and bump each other; a camera sees only one
  /// alone.
  std::size_t robots = 1;
  /// Of all of them, as the robots' program takes them: "x,y,degrees;..", or drawn. Empty: the
  /// first one's is the room's, and those of the others are drawn by the seed.
  std::string starts;
  std::optional<double> apart_m;  ///< Way between two drawn starts; empty: as that program has it.
};

/// Simulated robots in their room, started as one program of its own and run in lockstep: time goes
/// as far as all hosts grant it, and a robot without a host yet holds it at its start.
class SimulatedRobots {
 public:
  /// `body` is the TOML file of what is true of each robot, `out` an existing folder: one robot
  /// writes its truth to `out`/truth, several to `out`/truth/robot0 and on, and what they say is in
  /// `out`/robot.log. Throws CommandError: 1 where their program is missing or does not start, 6
  /// where world, robots or starts are invalid.
  SimulatedRobots(const SimulatedRobotOptions& options,
                  const Seed& seed,
                  const std::filesystem::path& body,
                  const std::filesystem::path& out);

  std::size_t size() const { return robots_; }
  /// The way to one of them, numbered from 0.
  ConnectionOptions connection(std::size_t robot = 0) const;
  /// The folder of its truth files.
  std::filesystem::path truth(std::size_t robot = 0) const;

 private:
  std::string port(std::size_t robot) const { return folder_ / ("robot" + end_of(robot)); }
  std::string socket(std::size_t robot) const { return folder_ / ("lockstep" + end_of(robot)); }
  std::string end_of(std::size_t robot) const;
  bool listens() const;
  void wait_until_they_listen();

  std::size_t robots_;
  bool is_radio_;
  std::filesystem::path truth_;
  std::filesystem::path log_;
  TemporaryFolder folder_;
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace echomap::session
