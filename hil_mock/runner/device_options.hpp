// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hil_mock/runner/device_main.hpp"
#include "hil_mock/runner/faulty_board.hpp"
#include "hil_mock/runner/overhead_camera.hpp"
#include "hil_mock/runner/robot_simulation.hpp"
#include "hil_mock/world/part_faults.hpp"
#include "hil_mock/world/source_field.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::runner {

/// What the command line of a device program asks for.
struct DeviceOptions {
  std::string world = "living_room";
  std::string robot = "uno_2wd";
  /// Instead of the robot file's motor driver; empty for that one.
  std::string driver;
  BoardOptions board;
  /// Symbolic link to the pty; unused with `tcp_port`.
  std::filesystem::path link;
  std::optional<std::uint16_t> tcp_port;
  /// Socket of the lockstep channel; empty for paced time.
  std::filesystem::path lockstep;
  /// Simulated seconds in a second; infinite for "max".
  double speed = 1.0;
  std::uint32_t seed = 1;
  /// What the line between board and host does; by default it is a good one without delays.
  LineModel line;
  std::vector<world::PartFault> part_faults;
  /// Folder of the truth files; empty for none.
  std::filesystem::path truth;
  /// Where a DutyLog goes; empty for none.
  std::filesystem::path duty_log;
  /// Where a PinLog goes; empty for none.
  std::filesystem::path pin_log;
  /// Boards in one world.
  std::size_t robots = 1;
  /// The first robot's start; empty for the room's.
  std::optional<geometry::Pose2> T_world_start;
  /// Sources of radiation in place of the world's.
  std::optional<std::vector<world::Source>> sources;
  /// One for each robot; empty where those of all but the first, or with `draws_starts` of all, are
  /// drawn.
  std::vector<geometry::Pose2> starts;
  bool draws_starts = false;
  /// Shortest way over the floor between two starts that are drawn.
  double apart_m = 2.0;
  /// Where the overhead camera's fixes go (FixSender); empty for no camera.
  std::string camera;
  CameraParams camera_params;
  /// In the order of their times.
  std::vector<Kidnap> kidnaps;
  /// Simulated seconds; infinite without an end.
  double duration_s = 0.0;
};

/// What the command line of several robots asks for one of them: its own seed, and ports and files
/// that end in its number. Its start is not in it. One robot alone has what stands there.
DeviceOptions options_of_robot(const DeviceOptions& options, std::size_t robot);

/// Reads the command line. An int is the exit code of a program that has nothing more to do: 0
/// after help or version on stdout, 2 after a usage error on stderr.
std::variant<DeviceOptions, int> read_device_options(int argc,
                                                     char** argv,
                                                     const DeviceProgram& program);

}  // namespace echomap::runner
