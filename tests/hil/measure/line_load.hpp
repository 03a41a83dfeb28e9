// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "tests/hil/robot_session.hpp"

namespace echomap::tests {

/// What a robot puts on its line, byte by byte, while nobody asks it anything: its wheels rest, and
/// every ping meets a wall.
class LineLoad {
 public:
  /// Connects. Throws std::runtime_error where the robot does not answer or refuses, as all below
  /// do.
  explicit LineLoad(const std::filesystem::path& elf, double wall_m = 0.5);

  void ask_odometry(std::uint8_t period_ms);
  /// Sweeps over the whole half turn with at least `ping_gap_ms` from one ping to the next.
  void sweep(std::uint8_t ping_gap_ms, std::int32_t step_cdeg);

  /// Bytes a second from here on.
  double bytes_per_s(int seconds);
  /// Messages M a second of the same time.
  template <class M>
  double per_s(int seconds) {
    return double(robot.all<M>().size()) / seconds;
  }
  int rate_step() { return robot.last<protocol::Health>().value().rate_step; }
  int dropped() { return robot.last<protocol::Health>().value().telemetry_dropped; }

  RobotSession robot;
};

/// The share of 115200 baud that 100 Hz of odometry, 25 Hz of echoes and 5 Hz of Status take.
struct UsualLine {
  double share = 0.0;
  double odometry_per_s = 0.0;
  double echoes_per_s = 0.0;
  double status_per_s = 0.0;
  int rate_step = 0;
  int dropped = 0;
};
UsualLine measure_usual_line(const std::filesystem::path& elf);

/// Pings a second of a sonar that looks at a wall 4 m away, as fast as it can; its pan hardly
/// turns.
double measure_pings_per_s(const std::filesystem::path& elf);

}  // namespace echomap::tests
