// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/lockstep_server.hpp"
#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// A robot's host in a run in lockstep: what it grants and how its robot's bytes come and go.
class LockstepSeat {
 public:
  /// All must outlive this.
  LockstepSeat(RobotSimulation& simulation, ByteEndpoint& endpoint, LockstepServer& server)
      : simulation_(&simulation), endpoint_(&endpoint), server_(&server) {}

  std::optional<LockstepRequest> take_request() { return server_->take_request(); }
  /// From now on `answer` tells where the robot truly is.
  void tell_truth() { tells_truth_ = true; }

  /// Waits for the bytes that a grant counts and gives them to the board. False where the stream
  /// has swallowed them or a stop signal has come.
  bool accept(const Grant& grant);
  /// How far the host lets time pass, in nanoseconds; empty where it has not said since `answer`.
  std::optional<std::int64_t> granted_ns() const;
  /// The grant is reached: sends what the robot has said, and tells the host.
  void answer();

  /// Takes in what the host has sent and pushes on what is on its way to it.
  void collect_bytes();
  /// What the robot says is for nobody.
  void discard_sent() { simulation_->take_sent(); }

  RobotSimulation& simulation() const { return *simulation_; }
  const ByteEndpoint& endpoint() const { return *endpoint_; }
  /// Readable when `take_request` has something to do.
  int descriptor() const { return server_->descriptor(); }

 private:
  bool wait_for_bytes(std::uint64_t host_bytes);

  RobotSimulation* simulation_;
  ByteEndpoint* endpoint_;
  LockstepServer* server_;
  std::optional<Grant> grant_;
  /// Received from the host, not yet handed to the board.
  std::deque<std::uint8_t> waiting_;
  std::uint64_t handed_bytes_ = 0;
  std::uint64_t device_bytes_ = 0;
  bool tells_truth_ = false;
};

}  // namespace echomap::runner
