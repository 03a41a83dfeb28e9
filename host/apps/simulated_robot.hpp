// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "host/apps/child_process.hpp"
#include "host/apps/commands.hpp"
#include "host/apps/temporary_folder.hpp"
#include "host/transport/lockstep_channel.hpp"

namespace echomap::apps {

/// A simulated robot in its room, started as a program of its own and run in lockstep.
class SimulatedRobot {
 public:
  /// `body` is the TOML file of what is true of the robot, `out` an existing folder: the robot
  /// writes its truth to `out`/truth and what it says to `out`/robot.log. Throws
  /// CommandError: 1 where its program is missing or does not start, 6 where world or robot are
  /// invalid.
  SimulatedRobot(const DemoOptions& options,
                 const std::filesystem::path& body,
                 const std::filesystem::path& out);

  std::string port() const { return folder_ / "robot"; }
  transport::LockstepChannel& lockstep() { return *lockstep_; }
  const std::filesystem::path& truth() const { return truth_; }

 private:
  void wait_until_it_listens(const std::filesystem::path& socket);

  std::filesystem::path truth_;
  std::filesystem::path log_;
  TemporaryFolder folder_;
  std::unique_ptr<ChildProcess> process_;
  std::unique_ptr<transport::LockstepChannel> lockstep_;
};

}  // namespace echomap::apps
