// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/motion_report.hpp"
#include "firmware/drivers/pan_drive.hpp"
#include "firmware/drivers/sonar.hpp"
#include "firmware/drivers/wheel_encoders.hpp"
#include "protocol/command_messages.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace control {

/// Reads the sonar pan by pan: turns it, waits until it has settled, pings, goes on.
class ScanSweep {
 public:
  /// Longest wait for an echo pin that is stuck high; then the sonar counts as dead.
  static constexpr uint8_t kStuckMs = 250;

  /// `settings` is where the active ones stand.
  constexpr ScanSweep(drivers::WheelEncoders& encoders,
                      drivers::Sonar& sonar,
                      drivers::PanDrive& pan,
                      protocol::ConfigureSonar& settings)
      : encoders_(encoders), sonar_(sonar), pan_(pan), settings_(settings) {}

  /// True when every field is in range.
  static bool accepts(const protocol::ConfigurePan& settings) {
    return drivers::PanDrive::accepts(settings);
  }
  static bool accepts(const protocol::ConfigureSonar& settings);
  /// Takes settings that `accepts` has granted; only while not sweeping.
  void configure(const protocol::ConfigurePan& settings) { pan_.configure(settings); }
  void configure(const protocol::ConfigureSonar& settings) { settings_ = settings; }

  /// True when the pan reaches both ends and the steps lead from one to the other.
  bool accepts(const protocol::StartSweep& sweep) const;
  /// Starts a sweep that `accepts` has granted; only while not sweeping.
  void start(const protocol::StartSweep& sweep);
  /// The host is there: a sweep ends after protocol::kMaxSweepSilenceMs without it.
  void listened() { silence_ms_ = 0; }
  /// Ends it with this outcome; the reading under way is dropped.
  void stop(protocol::MotionOutcome reason);

  /// Once a millisecond; true when `echo` is a new reading.
  bool tick(protocol::Echo& echo);

  bool sweeping() const { return state_ != State::kIdle; }
  MotionReport report() const { return report_; }

 private:
  enum class State : uint8_t { kIdle, kTurning, kAiming, kListening };

  void turn_to(int32_t pan_cdeg);
  bool may_ping();
  void ping();
  void go_on();

  drivers::WheelEncoders& encoders_;
  drivers::Sonar& sonar_;
  drivers::PanDrive& pan_;
  protocol::ConfigureSonar& settings_;
  protocol::StartSweep sweep_ = {};
  protocol::Echo echo_ = {};
  int32_t pan_cdeg_ = 0;
  uint16_t settling_ms_ = 0;
  uint16_t silence_ms_ = 0;
  uint8_t since_ping_ms_ = UINT8_MAX;
  uint8_t stuck_ms_ = 0;
  State state_ = State::kIdle;
  MotionReport report_ = {0, protocol::MotionOutcome::kNone};
};

}  // namespace control
}  // namespace echomap
