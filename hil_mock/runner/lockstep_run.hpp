// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/lockstep_server.hpp"
#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// How the wheels came to rest after the host had vanished.
struct StopReport {
  /// The end of the host's last grant.
  std::int64_t last_grant_ns = 0;
  /// From there until both duties stayed at zero; empty where they did not in two seconds.
  std::optional<std::int64_t> stopped_after_ns;
};

/// Why a run in lockstep has ended.
enum class LockstepEnd : std::uint8_t { kQuit, kHostGone, kStopSignal };

/// Serves one host in lockstep: simulated time passes only as granted, and only after every byte
/// of the host has come.
class LockstepRun {
 public:
  /// All must outlive this.
  LockstepRun(RobotSimulation& simulation, ByteEndpoint& endpoint, LockstepServer& server);

  /// Until the host quits or vanishes or a stop signal comes. Throws std::runtime_error for a line
  /// that is none of the protocol's.
  LockstepEnd run();

  /// Called when somebody has put a box down, or could not: it `stands` there or it does not.
  std::function<void(const PutBox& box, bool stands)> on_box;

  /// Called when the cable is pulled: for so long of simulated time nothing is to pass.
  std::function<void(std::int64_t for_ns)> on_cut_cable;

  /// Lets time pass for two more simulated seconds without a host and watches the wheels.
  StopReport run_without_host();

 private:
  /// What a request leads to; the end of the run, or empty where it goes on.
  std::optional<LockstepEnd> serve(const Grant& grant);
  std::optional<LockstepEnd> serve(const CarryOff& carry);
  std::optional<LockstepEnd> serve(const PutBox& box);
  std::optional<LockstepEnd> serve(const CutCable& cut);
  std::optional<LockstepEnd> serve(const TellTruth&);
  static std::optional<LockstepEnd> serve(const Quit&) { return LockstepEnd::kQuit; }
  static std::optional<LockstepEnd> serve(const HostGone&) { return LockstepEnd::kHostGone; }
  static std::optional<LockstepEnd> serve(const BadRequest& bad);

  void collect_bytes();
  bool wait_for_bytes(std::uint64_t host_bytes);
  void fulfil(const Grant& grant);

  RobotSimulation& simulation_;
  ByteEndpoint& endpoint_;
  LockstepServer& server_;
  /// Received from the host, not yet handed to the board.
  std::deque<std::uint8_t> waiting_;
  std::uint64_t handed_bytes_ = 0;
  std::uint64_t device_bytes_ = 0;
  bool tells_truth_ = false;
};

}  // namespace echomap::runner
