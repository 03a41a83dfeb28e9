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

/// Closed files of a motor that is absent.
struct TachoFiles {
  Attribute command;
  Attribute duty_cycle_sp;
  Attribute position;
  Attribute position_sp;
  Attribute speed_sp;
  Attribute stop_action;
};

/// `run-direct` is commanded once; from then on each duty acts at once, until `stop`. What is noted
/// of the motor is what the kernel has taken.
struct TachoMotor {
  const char* port;
  TachoFiles files;
  int32_t percent;
  bool runs;
  bool brakes;
  bool has_to_stop;   ///< A stop was refused.
  bool has_to_brake;  ///< By the last stop.
};

enum Port : uint8_t { kPan, kLeft, kRight, kPorts };
TachoMotor motors[kPorts] = {{"outA", {}, 0, false, false, false, false},
                             {"outB", {}, 0, false, false, false, false},
                             {"outC", {}, 0, false, false, false, false}};

TachoMotor& motor_of(hal::Motor motor) {
  return motors[motor == hal::Motor::kLeft ? kLeft : kRight];
}

bool open_files(const DeviceFolder& folder, TachoFiles& files) {
  return files.command.open(folder, "command", Access::kWrite) &&
         files.duty_cycle_sp.open(folder, "duty_cycle_sp", Access::kWrite) &&
         files.position.open(folder, "position", Access::kRead) &&
         files.position_sp.open(folder, "position_sp", Access::kWrite) &&
         files.speed_sp.open(folder, "speed_sp", Access::kWrite) &&
         files.stop_action.open(folder, "stop_action", Access::kWrite);
}

void open_motor(const char* sysfs, TachoMotor& motor) {
  motor.files = TachoFiles();
  DeviceFolder folder;
  if (!find_device(sysfs, "tacho-motor", motor.port, folder)) {
    fprintf(stderr, "echomap-ev3: no motor at %s\n", motor.port);
  } else if (!open_files(folder, motor.files)) {
    motor.files = TachoFiles();
    fprintf(stderr,
            "echomap-ev3: the motor at %s may not be driven: is the user in the group ev3dev?\n",
            motor.port);
  }
}

/// Does what a refused write has left to do, and notes what the kernel takes.
void stop(TachoMotor& motor) {
  const bool is_set = motor.brakes == motor.has_to_brake ||
                      motor.files.stop_action.write(motor.has_to_brake ? "brake\n" : "coast\n");
  motor.brakes = is_set ? motor.has_to_brake : motor.brakes;
  const bool is_stopped = motor.files.command.write("stop\n");
  motor.runs = motor.runs && !is_stopped;
  motor.has_to_stop = !is_set || !is_stopped;
}

void write_twice_if_refused(const Attribute& file, const char* text) {
  if (!file.write(text)) {
    file.write(text);
  }
}

/// The kernel reads encoders every 2 ms and does not say when: a reading is 1 ms old, give or
/// take 1.
constexpr uint32_t kMeanAgeUs = 1000;
/// Readings within it are one, so that the two wheels of a control cycle fit together.
constexpr uint32_t kSameReadingUs = 500;

hal::EncoderReading last_reading = {};
uint32_t last_read_us = 0;

int16_t count_of(const TachoMotor& motor, int16_t last) {
  int32_t position = 0;
  return motor.files.position.read(position) ? static_cast<int16_t>(position) : last;
}

}  // namespace

void open_motors(const char* sysfs) {
  for (TachoMotor& motor : motors) {
    open_motor(sysfs, motor);
  }
}

void reset_motors(bool again) {
  for (TachoMotor& motor : motors) {
    const bool keeps_place = again && &motor == &motors[kPan];
    const bool is_reset = motor.files.command.write(keeps_place ? "stop\n" : "reset\n");
    motor.runs = false;
    motor.brakes = !is_reset;  // It may be left so by another program: the stop coasts.
    motor.has_to_brake = false;
    motor.has_to_stop = !is_reset;
  }
}

void repeat_refused_stops() {
  for (TachoMotor& motor : motors) {
    if (motor.has_to_stop) {
      stop(motor);
    }
  }
}

void stop_all_motors() {
  for (const TachoMotor& motor : motors) {
    write_twice_if_refused(motor.files.stop_action, "coast\n");
    write_twice_if_refused(motor.files.command, "stop\n");
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
  tacho.has_to_stop = false;
  if (!tacho.runs || tacho.percent != signed_percent) {
    if (!tacho.files.duty_cycle_sp.write(signed_percent)) {
      return;
    }
    tacho.percent = signed_percent;
  }
  tacho.runs = tacho.runs || tacho.files.command.write("run-direct\n");
}

void stop_motor(Motor motor, bool brake) {
  boards::TachoMotor& tacho = boards::motor_of(motor);
  tacho.has_to_brake = brake;
  if (tacho.runs || tacho.has_to_stop || tacho.brakes != brake) {
    boards::stop(tacho);
  }
}

void set_servo_pulse_us(uint16_t pulse_us) {
  constexpr int32_t kStartPulseUs = 1500;
  constexpr int32_t kDegPerS = 800;  // Above what the profile counts on, below what motors can do.
  boards::TachoMotor& pan = boards::motors[boards::kPan];
  pan.has_to_stop = false;
  pan.files.stop_action.write("hold\n");
  pan.files.speed_sp.write(kDegPerS);
  pan.files.position_sp.write(pulse_us - kStartPulseUs);
  pan.files.command.write("run-to-abs-pos\n");
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
