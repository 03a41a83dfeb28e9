// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/device_options.hpp"
#include "hil_mock/runner/duty_log.hpp"
#include "hil_mock/runner/faulty_board.hpp"
#include "hil_mock/runner/fix_sender.hpp"
#include "hil_mock/runner/lockstep_run.hpp"
#include "hil_mock/runner/overhead_camera.hpp"
#include "hil_mock/runner/pin_log.hpp"
#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// One robot of a device program: its board in its world, its port, its logs and its truth files.
class RobotDevice {
 public:
  /// `options` are this robot's own. Throws files::ConfigError where they do not fit and
  /// std::exception where the board or the port cannot be had.
  RobotDevice(const DeviceProgram& program, DeviceOptions options);
  RobotDevice(const RobotDevice&) = delete;
  RobotDevice& operator=(const RobotDevice&) = delete;

  RobotSimulation& simulation() { return simulation_; }
  ByteEndpoint& endpoint() { return *endpoint_; }
  FaultyBoard& board() { return board_; }
  const DeviceOptions& options() const { return options_; }

  /// As its host gets it first on the lockstep channel.
  std::string hello() const;
  /// Which robot in which room listens where.
  std::string whereabouts() const;

  /// For who watches; throws files::FileError.
  void write_truth_so_far() const;
  /// At the end, with what became of a robot whose host has vanished. Throws files::FileError.
  void write_truth(const std::optional<StopReport>& stop) const;

 private:
  void schedule_kidnaps();
  void put_up_camera();
  void open_logs();

  DeviceOptions options_;
  std::unique_ptr<world::RobotWorld> world_;
  FaultyBoard board_;
  RobotSimulation simulation_;
  std::unique_ptr<ByteEndpoint> endpoint_;
  std::optional<OverheadCamera> camera_;
  std::unique_ptr<FixSender> fixes_;
  std::optional<DutyLog> duty_log_;
  std::optional<PinLog> pin_log_;
};

}  // namespace echomap::runner
