// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hil_mock/world/pin_signal.hpp"

namespace echomap::world {

/// Which wires go from a board to one half of a motor driver; protocol::MotorBridgeKind has the
/// same four.
enum class DriverInterface : std::uint8_t { kPhaseEnable, kIn1In2Pwm, kTwoPwm, kServo };

/// The wires to one half of a driver. Those that an interface lacks are not looked at.
struct DriverInputs {
  PinSignal pwm;  ///< PWM or EN; of a servo its pulses. Two-PWM has none.
  PinSignal in1;  ///< IN1; with phase/enable PH.
  PinSignal in2;

  friend bool operator==(const DriverInputs&, const DriverInputs&) = default;
};

/// The same three of a level each.
struct InputLevels {
  bool pwm = false;
  bool in1 = false;
  bool in2 = false;
};

/// What one half of a driver does with its motor at an instant.
enum class BridgeState : std::uint8_t { kForward, kReverse, kBrake, kCoast };

/// What a motor gets from its driver, as the mean over a period of the PWM.
struct MotorDrive {
  /// Time driven forward minus time driven backward, -1 .. 1.
  double duty = 0.0;
  /// Share of the time that the motor is disconnected. In the rest it is driven or short-circuited.
  double coasting = 0.0;
};

/// The same of both motors, as seen from behind the robot.
struct WheelDuty {
  double left = 0.0;
  double right = 0.0;
  double left_coasting = 0.0;
  double right_coasting = 0.0;
};

/// Chips and boards that drive motors, by their data sheets.
enum class DriverChip : std::uint8_t {
  kPhaseEnable,  ///< Any with a direction and an enable input that brakes when it is low.
  kDrv8835,      ///< TI DRV8835 in MODE H: phase/enable.
  kDrv8835InIn,  ///< The same in MODE L.
  kTb6612fng,    ///< Toshiba TB6612FNG with STBY high.
  kL298n,        ///< ST L298N.
  kL293d,        ///< TI or ST L293D.
  kDrv8833,      ///< TI DRV8833 with nSLEEP high.
  kMx1508,       ///< MX1508 and its likes, as TC1508A.
  kMdd3a,        ///< Cytron MDD3A; that both low brakes is not confirmed by its sheet.
  kServo,        ///< A continuous-rotation servo.
};

/// One half of a motor driver: inputs in, what its motor gets out.
class MotorDriver {
 public:
  explicit constexpr MotorDriver(DriverChip chip = DriverChip::kPhaseEnable, bool pull_downs = true)
      : chip_(chip), pull_downs_(pull_downs) {}

  DriverChip chip() const { return chip_; }
  DriverInterface interface() const;

  /// The data sheet's truth table; a servo has none. Throws std::logic_error then.
  BridgeState state(const InputLevels& levels) const;
  /// The mean over a period, of pins that all begin their periods at once. Pulses that are too fast
  /// for the chip do not turn the motor.
  MotorDrive drive(const DriverInputs& inputs) const;

 private:
  bool floats_high(bool is_enable) const;
  bool pull_up_wins() const;
  PinSignal seen(const PinSignal& pin, bool is_enable) const;
  double min_period_us() const;

  DriverChip chip_;
  bool pull_downs_;
};

/// What a board puts on these wires for a duty of -1 .. 1, forward positive; with `brake` a duty of
/// 0 short-circuits the motor where the interface can, else it lets go of it. `period_us` is that
/// of its PWM.
DriverInputs inputs_for(DriverInterface interface, double duty, bool brake, double period_us);

/// "tb6612fng", .. as in robot files, profiles and on the command line.
std::string_view name_of(DriverChip chip);
/// Throws std::invalid_argument with the nearest of those that there are.
DriverChip driver_named(const std::string& name);
std::vector<std::string> driver_names();

}  // namespace echomap::world
