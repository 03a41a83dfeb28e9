// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::tests {

/// One simulated robot that explores one room by one strategy.
struct ExplorationCase {
  std::string room;
  std::string strategy;
  std::string robot;               ///< Name of a bundled profile, or a file.
  std::filesystem::path course{};  ///< What `--waypoints` takes; empty for none.
  bool under_camera = false;       ///< An overhead camera tells the robot's pose.
  std::string board{};             ///< Where it is named, the release image on this board,
  std::string emulator = "mock";   ///< and otherwise the native firmware in this program.
  /// What tells the pose, as `--slam` has it; empty: ours.
  std::string slam{};
  std::filesystem::path body{};  ///< What is true of the robot; empty: as the profile's name says.
};

/// The arguments of `echomap demo` for one seed of a case. Each seed's camera, which errs by 1 mm
/// and 0.6 degrees and is a tenth of a second late, sends to a port of its own.
std::vector<std::string> demo_arguments(const ExplorationCase& what, int seed);

/// The papers' own explorations, by odometry alone as they were, each with the paper's robot on the
/// release image of a board that has the pins for it.
ExplorationCase nxt_in_its_room();
/// A Create in an arena, by name.
ExplorationCase create_in(const std::string& arena);
/// An e-puck on its field, under its camera.
ExplorationCase epuck_on_its_field();
/// An EV3 before the door of its playground.
ExplorationCase ev3_at_its_door();
/// The same with the EV3's own brick, which turns its sonar by a motor.
ExplorationCase brick_at_its_door();
/// The exploration of paper 000 by an EV3, whose sonar turns on a motor as that of its NXT.
ExplorationCase brick_in_the_nxts_room();

/// A Create of which every way is 4 % longer than its encoders say, while turns are as they have
/// them. Writes what is true of it to `folder`; its profile is the plain one.
ExplorationCase stretched_create_in(const std::string& arena, const std::filesystem::path& folder);
/// The same with a profile that holds three measured drives (Mukherjee et al., equations 4 to 8).
ExplorationCase measured_create_in(const std::string& arena, const std::filesystem::path& folder);

}  // namespace echomap::tests
