// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <stdio.h>

#include "firmware/boards/ev3/parts.hpp"
#include "firmware/boards/ev3/sysfs.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/servo.hpp"

namespace echomap {
namespace boards {
namespace {

/// `run-direct` is commanded once; from then on each duty acts at once, until `stop`.
struct TachoMotor {
  const char* port;
  Attribute command;
  Attribute duty_cycle_sp;
  Attribute position;
  Attribute position_sp;
  Attribute speed_sp;
  Attribute stop_action;
  int32_t percent;
  bool runs;
  bool brakes;
};

enum Port : uint8_t { kPan, kLeft, kRight, kPorts };
TachoMotor motors[kPorts] = {{"outA", {}, {}, {}, {}, {}, {}, 0, false, false},
                             {"outB", {}, {}, {}, {}, {}, {}, 0, false, false},
                             {"outC", {}, {}, {}, {}, {}, {}, 0, false, false}};

TachoMotor& motor_of(hal::Motor motor) {
  return motors[motor == hal::Motor::kLeft ? kLeft : kRight];
}

void open_motor(const char* sysfs, TachoMotor& motor) {
  DeviceFolder folder;
  if (!find_device(sysfs, "tacho-motor", motor.port, folder)) {
    fprintf(stderr, "echomap-ev3: no motor at %s\n", motor.port);
    return;
  }
  motor.command.open(folder, "command");
  motor.duty_cycle_sp.open(folder, "duty_cycle_sp");
  motor.position.open(folder, "position");
  motor.position_sp.open(folder, "position_sp");
  motor.speed_sp.open(folder, "speed_sp");
  motor.stop_action.open(folder, "stop_action");
}

/// The kernel reads encoders every 2 ms and does not say when: a reading is 1 ms old, give or take 1.
constexpr uint32_t kMeanAgeUs = 1000;
/// Readings within it are one, so that the two wheels of a control cycle fit together.
constexpr uint32_t kSameReadingUs = 500;

hal::EncoderReading last_reading = {};
uint32_t last_read_us = 0;

int16_t count_of(const TachoMotor& motor, int16_t last) {
  int32_t position = 0;
  return motor.position.read(position) ? static_cast<int16_t>(position) : last;
}

}  // namespace

void open_motors(const char* sysfs) {
  for (TachoMotor& motor : motors) {
    open_motor(sysfs, motor);
  }
}

void reset_motors(bool again) {
  for (TachoMotor& motor : motors) {
    motor.command.write(again && &motor == &motors[kPan] ? "stop\n" : "reset\n");
    motor.runs = false;
    motor.brakes = false;
  }
}

void stop_all_motors() {
  for (const TachoMotor& motor : motors) {
    motor.stop_action.write("coast\n");
    motor.command.write("stop\n");
  }
}

}  // namespace boards

namespace hal {

/// The brick has its own bridges. Those of the second kind are the same, and can brake.
bool can_bridge(BridgeKind kind) {
  return kind == BridgeKind::kPhaseEnable || kind == BridgeKind::kIn1In2Pwm;
}

uint16_t bridge_aux_pins(BridgeKind /*kind*/) { return 0; }

void use_bridge(BridgeKind /*kind*/, bool /*slow_pwm*/) {
  stop_motor(Motor::kLeft, false);
  stop_motor(Motor::kRight, false);
}

void set_motor(Motor motor, bool forward, uint8_t duty) {
  boards::TachoMotor& tacho = boards::motor_of(motor);
  constexpr int32_t kFullDuty = 255;
  const int32_t percent = (duty * 100 + kFullDuty / 2) / kFullDuty;
  const int32_t signed_percent = forward ? percent : -percent;
  if (!tacho.runs || tacho.percent != signed_percent) {
    tacho.percent = signed_percent;
    tacho.duty_cycle_sp.write(signed_percent);
  }
  if (!tacho.runs) {
    tacho.runs = true;
    tacho.command.write("run-direct\n");
  }
}

void stop_motor(Motor motor, bool brake) {
  boards::TachoMotor& tacho = boards::motor_of(motor);
  if (!tacho.runs && tacho.brakes == brake) {
    return;
  }
  if (tacho.brakes != brake) {
    tacho.stop_action.write(brake ? "brake\n" : "coast\n");
  }
  tacho.command.write("stop\n");
  tacho.brakes = brake;
  tacho.runs = false;
}

void set_servo_pulse_us(uint16_t pulse_us) {
  constexpr int32_t kStartPulseUs = 1500;
  constexpr int32_t kDegPerS = 800;  // Above what the profile counts on, below what motors can do.
  const boards::TachoMotor& pan = boards::motors[boards::kPan];
  pan.stop_action.write("hold\n");
  pan.speed_sp.write(kDegPerS);
  pan.position_sp.write(pulse_us - kStartPulseUs);
  pan.command.write("run-to-abs-pos\n");
}

EncoderReading read_encoders() {
  using namespace boards;
  static bool has_read = false;
  const uint32_t at_us = now_us();
  if (!has_read || at_us - last_read_us >= kSameReadingUs) {
    has_read = true;
    last_read_us = at_us;
    last_reading.left = count_of(motors[kLeft], last_reading.left);
    last_reading.right = count_of(motors[kRight], last_reading.right);
  }
  return last_reading;
}

uint32_t encoders_read_at_us() { return boards::last_read_us - boards::kMeanAgeUs; }

LostSteps lost_encoder_steps() { return LostSteps{0, 0}; }
bool encoders_tell_lost_steps() { return false; }

}  // namespace hal
}  // namespace echomap
