// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/fixed_point.hpp"
#include "protocol/command_messages.hpp"

namespace echomap {
namespace control {

/// Makes one wheel follow a reference: duty = feed forward x reference speed + proportional x speed
/// error + integral x lag. The lag is the reference's way minus the wheel's, counted and not summed
/// from speeds, so that no tick is ever lost. Gains as in protocol::ConfigureDrive.
class WheelSpeedController {
 public:
  /// A wheel this near to a standing reference has arrived.
  static constexpr uint8_t kArrivedTicks = 2;
  /// The same of a servo: it takes a duty for a frame of 20 ms, in which the least that turns it
  /// carries it over more than that.
  static constexpr uint8_t kServoArrivedTicks = 4;

  /// For how many periods without a tick it must have stood there: it coasts less than a tick then.
  static constexpr uint8_t kStillPeriods = 12;

  /// Speed is taken over 2 to the power of this many periods: one tick in one would be 250 ticks/s.
  static constexpr uint8_t kSpeedPeriodsLog2 = 2;

  /// From how near to a standing reference on the wheel has arrived.
  void arrive_within(uint8_t ticks);

  /// Forgets the lag: the wheel is where it should be.
  void reset();

  /// First half of a control period, all that can be done before the count is taken: how far the
  /// reference goes in it (1/4000 tick). Expects the wheel to turn as in the last one.
  void prepare(const protocol::ConfigureDrive& gains, int32_t reference_step);
  /// Second half, from a count to a duty in the shortest time: by how many ticks the wheel has
  /// turned since the last one. Returns the duty.
  int16_t update(int16_t turned);

  /// Ticks of the last period, and of the 4 before it.
  int16_t turned() const { return newest_turned_; }
  int16_t turned_sum() const { return turned_sum_; }
  /// The wheel stands as near to its reference as it has to.
  bool arrived() const;
  /// The wheel is farther behind than a turning wheel can be, or does not break away.
  bool stalled(const protocol::ConfigureDrive& limits) const;

 private:
  static constexpr uint8_t kSpeedPeriods = 1U << kSpeedPeriodsLog2;

  void measure();
  void push_off();
  bool near() const;

  /// Kept by a reset; 1/4000 tick.
  int32_t arrived_ = int32_t{kArrivedTicks} * kOneTick;
  int32_t lag_ = 0;             ///< 1/4000 tick.
  int32_t push_ = 0;            ///< Duty x 256 against static friction.
  int32_t prepared_drive_ = 0;  ///< Duty x 256 for a wheel that turns as expected.
  int16_t drive_per_tick_ = 0;  ///< What a tick more takes from it.
  int16_t newest_turned_ = 0;
  int16_t turned_[kSpeedPeriods] = {};
  int16_t turned_sum_ = 0;  ///< Over kSpeedPeriods.
  uint8_t oldest_ = 0;
  uint8_t still_periods_ = kStillPeriods;
  bool reference_moves_ = false;
};

}  // namespace control
}  // namespace echomap
