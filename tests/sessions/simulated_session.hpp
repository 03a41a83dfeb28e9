// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/runner/robot_simulation.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_session.hpp"

namespace echomap::tests {

/// What stands between host and robot, and what may happen to it.
struct Cable {
  bool plugged = true;
  /// A boot loader has the board: nothing that passes is heard or said by the firmware.
  bool boot_loader = false;
};

/// The host's session, as `echomap explore` has it, with a simulated board in a room, both in one
/// program and in simulated time. While the cable is out the stream is away, as a
/// transport::ReconnectingStream is.
class SimulatedSession {
 public:
  /// `board` outlives this.
  SimulatedSession(runner::SimulatedBoard& board, const std::string& world, std::uint32_t seed);
  ~SimulatedSession();
  SimulatedSession(const SimulatedSession&) = delete;
  SimulatedSession& operator=(const SimulatedSession&) = delete;

  session::RobotSession& session() { return *session_; }
  const session::RobotSession& session() const { return *session_; }
  const runner::RobotSimulation& simulation() const { return simulation_; }
  Cable& cable() { return cable_; }
  /// Another program writes to the same board.
  void intrude(std::span<const std::uint8_t> bytes) { simulation_.receive(bytes); }
  double now_s() const { return double(simulation_.now_ns()) * 1e-9; }
  /// Before every step of 5 ms.
  std::function<void()> each_step;

  /// From where the host believes the robot to be to where it is, both since the start; metres.
  double position_error_m() const;

 private:
  class Stream;
  class Pace;

  world::RobotWorld world_;
  runner::RobotSimulation simulation_;
  geometry::Pose2 T_world_start_;
  Cable cable_;
  std::vector<std::uint8_t> to_host_;
  pipeline::RobotPipeline pipeline_;
  std::unique_ptr<session::RobotSession> session_;
};

}  // namespace echomap::tests
