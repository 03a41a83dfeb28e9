// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <random>

#include "tests/hil/measure/every_sensor.hpp"
#include "tests/hil/robot_session.hpp"
#include "tests/hil/turning_wheel.hpp"

namespace echomap::tests {

/// What a robot under load has to bear.
struct Load {
  /// Encoder edges of each wheel; the right one's are 0.27 % more frequent, so that edges of both
  /// fall together, right behind each other and apart.
  double edges_per_s = 20'000;
  /// Part of its period by which each edge comes early or late at most.
  double edge_jitter = 0.0;
  /// Shortest and longest echo pulse.
  double min_echo_us = 150.0;
  double max_echo_us = 23'500.0;
  std::uint8_t odometry_period_ms = 3;
  /// The host's frames fill two thirds of the line; else it says what a host that drives says: 20
  /// times KeepAlive and 10 set-points a second.
  bool full_line = true;
  /// The sonar sweeps all the time; else a sweep of eleven echoes every 2.5 s.
  bool sweeps_on = false;
  /// All that EverySensor switches on, on boards that it knows.
  bool every_sensor = false;
};

/// How reports of the robot compare with what went into its pins.
struct LoadResult {
  double seconds = 0.0;
  std::int64_t edges = 0;
  int comparisons = 0;         ///< Reports that stand for wheels at rest, both counts each.
  std::int64_t miscounts = 0;  ///< Largest difference of a count among them.
  std::uint16_t encoder_errors = 0;
  int echoes = 0;
  double worst_echo_error_us = 0.0;
  double host_bytes_per_s = 0.0;
  double robot_bytes_per_s = 0.0;
  bool under_control = false;    ///< Until the end.
  std::uint16_t frames_bad = 0;  ///< By robot and host.
  std::uint16_t frames_lost = 0;
  std::uint16_t receive_overruns = 0;
  std::uint16_t min_stack_bytes = UINT16_MAX;
  std::uint32_t resets = 0;  ///< Of the chip, since it was ready.
};

/// The release firmware with all that it can be asked for at once: both wheels turn under speed
/// control, frames go both ways without a pause, the servo sweeps and the sonar pings. Every half a
/// second the wheels rest for 10 ms, and what the robot reports then is compared with the pins.
class LoadedRobot {
 public:
  LoadedRobot(const std::filesystem::path& elf, const Load& load);

  /// Throws std::runtime_error where the robot does not answer.
  void connect();
  void run_s(double seconds);
  /// Lets the wheels rest, and tells.
  LoadResult finish();

  RobotSession& session() { return robot_; }

 private:
  void run_one_ms();
  void turn_wheels();
  void talk();
  void keep_sweeping();
  void answer_ping(std::int64_t at_ns);
  void take_heard();
  void rest();
  void compare(const protocol::Odometry& odometry, std::int64_t heard_us);

  template <class M>
  void send(const M& message) {
    robot_.send(message);
    host_bytes_ += protocol::kFrameOverhead + protocol::MessageFacts<M>::kSize;
  }

  Load load_;
  RobotSession robot_;
  std::optional<EverySensor> sensors_;
  TurningWheel left_{robot_.board(), runner::Wheel::kLeft, {load_.edge_jitter, 1}};
  TurningWheel right_{robot_.board(), runner::Wheel::kRight, {load_.edge_jitter, 2}};
  std::mt19937 generator_{4711};
  std::deque<double> widths_us_;
  std::int64_t ms_ = 0;
  std::optional<std::int64_t> resting_since_us_;
  std::int64_t min_delay_us_ = INT64_MAX;
  double speed_ = 0.0;       ///< That the robot's ramp has reached, edges/s.
  double told_ticks_ = 0.0;  ///< Its integral: where the left wheel should be.
  std::uint8_t sweep_id_ = 100;
  bool sweeping_ = false;
  std::uint64_t host_bytes_ = 0;
  std::size_t bytes_before_ = 0;
  std::uint32_t resets_before_ = 0;
  LoadResult result_;
};

}  // namespace echomap::tests
