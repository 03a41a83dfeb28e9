// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/session/child_process.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::session {

/// Which simulated robot is started, and in which room.
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
};

/// A simulated robot in its room, started as a program of its own and run in lockstep.
class SimulatedRobot {
 public:
  /// `body` is the TOML file of what is true of the robot, `out` an existing folder: the robot
  /// writes its truth to `out`/truth and what it says to `out`/robot.log. Throws
  /// CommandError: 1 where its program is missing or does not start, 6 where world or robot are
  /// invalid.
  SimulatedRobot(const SimulatedRobotOptions& options,
                 const Seed& seed,
                 const std::filesystem::path& body,
                 const std::filesystem::path& out);

  /// The way to it.
  ConnectionOptions connection() const;
  const std::filesystem::path& truth() const { return truth_; }

 private:
  std::string port() const { return folder_ / "robot"; }
  std::string socket() const { return folder_ / "lockstep"; }
  void wait_until_it_listens();

  bool is_radio_;
  std::filesystem::path truth_;
  std::filesystem::path log_;
  TemporaryFolder folder_;
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace echomap::session
