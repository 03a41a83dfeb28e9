// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/session/port_choice.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/port_keeper.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/sysfs_tree.hpp"

namespace echomap::tests {

/// A desk with one robot and five devices that must not hear of it: 3D printers with Marlin and
/// Klipper, a modem, a label printer, and a second robot that another process drives. Each is a pty
/// with a place in a folder like /sys.
class StagedDesk {
 public:
  StagedDesk();

  /// The port of the robot.
  static constexpr const char* kRobot = "/dev/ttyUSB0";
  /// The port of the robot that runs.
  static constexpr const char* kRunningRobot = "/dev/ttyACM1";

  /// At these ports a robot has answered before.
  void set_known(std::vector<std::string> names) { known_ = std::move(names); }
  /// What the person types in turn; nobody is there when it is empty.
  void set_answers(std::vector<std::string> answers) { answers_ = std::move(answers); }
  void unplug_robot() { sysfs_.unplug("ttyUSB0"); }

  /// Chooses as `echomap explore` does, and sends a Hello to what was chosen: its port, or why
  /// there is none.
  std::string connect(const std::vector<std::string>& named = {});

  /// What was written so far to all but the robot.
  std::size_t strangers_bytes() const;
  std::size_t robot_bytes() const { return devices_.at(kRobot).unread_bytes(); }
  /// How often another port than the robot's was opened, or was tried to be.
  int strangers_openings() const { return strangers_openings_; }
  /// Whether the settings of all strangers' lines are what they were.
  bool are_lines_as_before() const;

 private:
  void add(const std::string& tty, const SysfsTree::Device& device, const std::string& greeting);
  session::PortSurroundings surroundings();
  std::unique_ptr<transport::ByteStream> open(const std::string& port);

  ScratchFolder folder_;
  SysfsTree sysfs_{folder_.path()};
  std::map<std::string, transport::PtyPair> devices_;  ///< By port.
  std::map<std::string, std::string> settings_;        ///< Of the lines, as they were.
  std::vector<std::string> known_;
  std::vector<std::string> answers_;
  std::size_t answered_ = 0;
  int strangers_openings_ = 0;
  std::optional<PortKeeper> driver_;  ///< Of the robot that runs.
};

/// What strangers were written over every way to choose a port; their openings and changed lines
/// count as a byte each.
std::size_t measure_strangers_bytes();

}  // namespace echomap::tests
