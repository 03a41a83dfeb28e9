// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/wheel_motion.hpp"
#include "firmware/drivers/contacts.hpp"
#include "firmware/tasks/sensors.hpp"
#include "protocol/configuration.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace tasks {

/// What may move, and for how long. Disarmed at the start; a motion ends when its time to live is
/// over, when a contact is pressed or a hazard comes up. A wheel-drop disarms too: somebody has the
/// robot in hand, or it hangs over an edge.
class Safety {
 public:
  /// `settings` and `wiring` are where the active ones stand.
  constexpr Safety(control::WheelMotion& motion,
                   const Sensors& sensors,
                   protocol::ConfigureSafety& settings,
                   const protocol::ConfigureWiring& wiring)
      : motion_(motion), sensors_(sensors), settings_(settings), wiring_(wiring) {}

  /// True when every field is in range.
  static bool accepts(const protocol::ConfigureSafety& settings);
  /// Takes settings that `accepts` has granted; only while not moving.
  void configure(const protocol::ConfigureSafety& settings) { settings_ = settings; }

  /// The contacts are wired otherwise from now on: what was read of them means nothing more.
  void restart_contacts() { contacts_.restart(); }

  bool armed() const { return armed_; }
  /// False, and remains disarmed, while a wheel hangs. Set-points count again after a stall.
  bool arm();
  /// Stops the wheels too.
  void disarm() { disarm(protocol::MotionOutcome::kStopped); }

  static bool accepts_time_to_live(uint16_t time_to_live_ms) {
    return time_to_live_ms <= protocol::kMaxTimeToLiveMs;
  }
  /// Whatever moves may go on for this long; 0 stands for the default.
  void renew(uint16_t time_to_live_ms);

  /// True when a pressed contact or a hazard forbids a motion that goes forward as a whole.
  bool blocks(int32_t left, int32_t right) const {
    return (contacts_.pressed() != 0 || stopping_hazards() != 0) && left + right > 0;
  }
  /// Bits of protocol::Hazard that are active and stop the wheels.
  uint8_t stopping_hazards() const;
  const drivers::Contacts& contacts() const { return contacts_; }

  /// Once a millisecond.
  void tick();
  /// One control period; disarms when a wheel is out of control.
  void control();

 private:
  void disarm(protocol::MotionOutcome reason);
  bool lifted() const;
  bool must_stop(uint8_t active, uint8_t fresh) const;

  control::WheelMotion& motion_;
  const Sensors& sensors_;
  protocol::ConfigureSafety& settings_;
  const protocol::ConfigureWiring& wiring_;
  drivers::Contacts contacts_;
  uint16_t left_to_live_ms_ = 0;
  bool armed_ = false;
};

}  // namespace tasks
}  // namespace echomap
