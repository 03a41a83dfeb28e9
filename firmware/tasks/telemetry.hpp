// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/scan_sweep.hpp"
#include "firmware/control/wheel_motion.hpp"
#include "firmware/tasks/frame_sender.hpp"
#include "firmware/tasks/safety.hpp"
#include "protocol/configuration.hpp"
#include "protocol/link.hpp"

namespace echomap {
namespace tasks {

/// What the telemetry is about.
struct TelemetrySources {
  drivers::WheelEncoders& encoders;
  const drivers::SerialPort& port;
  const control::WheelMotion& motion;
  const control::ScanSweep& sweep;
  const Sensors& sensors;
  const Safety& safety;
  const protocol::ReceiveCounters& received;
  const protocol::Configuration& configuration;
};

/// Samples on time and sends when the line has room: echoes and changes first, then odometry,
/// gyro, ranges and scalar, then Status, Health and EncoderErrors. What waits too long is replaced
/// by what is newer, and counted; all periods are then stretched. Silent until a host has said
/// Hello.
class Telemetry {
 public:
  static constexpr uint8_t kStatusPeriodMs = 200;
  /// Health comes with every fifth Status.
  static constexpr uint8_t kStatusPerHealth = 5;

  constexpr Telemetry(const TelemetrySources& sources, FrameSender& sender)
      : sources_(sources), sender_(sender) {}

  /// A host is there: starts, with a Status first.
  void begin();

  /// A new sonar reading to send.
  void add(const protocol::Echo& echo);
  /// Once a millisecond.
  void tick();

 private:
  static constexpr uint8_t kEchoes = 4;

  /// A period at the rate that the line has room for.
  uint16_t stretched(uint16_t period_ms) const;
  /// Counts what was replaced before it could be sent.
  void drop();
  void sample_odometry();
  /// Has `waits` say so when the period, if any, is over.
  void count(uint16_t period_ms, uint16_t& age_ms, bool& waits);
  void notice_changes();
  void send_what_waits();
  bool send_echo();
  bool send_status();
  void send_health();
  protocol::Status status() const;
  protocol::Health health() const;
  protocol::EncoderErrors encoder_errors() const;
  protocol::Ranges ranges() const;
  protocol::Gyro gyro() const;
  protocol::Scalar scalar() const;
  uint8_t flags() const;

  TelemetrySources sources_;
  FrameSender& sender_;
  protocol::Odometry odometry_ = {};
  control::MotionReport told_move_ = {0, protocol::MotionOutcome::kNone};
  control::MotionReport told_sweep_ = {0, protocol::MotionOutcome::kNone};
  uint16_t dropped_ = 0;
  uint16_t stack_free_bytes_ = 0;
  uint16_t odometry_age_ms_ = 0;
  uint16_t status_age_ms_ = 0;
  uint8_t statuses_since_health_ = 0;
  uint8_t oldest_echo_ = 0;
  uint8_t waiting_echoes_ = 0;
  bool odometry_waits_ = false;
  bool status_waits_ = false;
  bool status_is_urgent_ = false;
  bool ranges_wait_ = false;
  bool gyro_waits_ = false;
  bool scalar_waits_ = false;
  bool encoder_errors_wait_ = false;
  uint16_t ranges_age_ms_ = 0;
  uint16_t scalar_age_ms_ = 0;
  uint8_t told_hazards_ = 0;
  bool on_ = false;
  protocol::Echo echoes_[kEchoes] = {};
};

}  // namespace tasks
}  // namespace echomap
