// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/tacho_motor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace echomap::ev3 {
namespace {

constexpr long kFullDutyPercent = 100;

std::filesystem::path made(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

TachoMotorKind large_motor() { return {"lego-ev3-l-motor", 1050}; }

TachoMotorKind medium_motor() { return {"lego-ev3-m-motor", 1560}; }

TachoMotor::TachoMotor(const std::filesystem::path& folder,
                       const std::string& address,
                       const TachoMotorKind& kind)
    : name_(address),
      kind_(kind),
      command_(made(folder) / "command", ""),
      duty_cycle_sp_(folder / "duty_cycle_sp", "0"),
      stop_action_(folder / "stop_action", "coast"),
      polarity_(folder / "polarity", "normal"),
      position_(folder / "position", "0"),
      position_sp_(folder / "position_sp", "0"),
      speed_sp_(folder / "speed_sp", "0"),
      ramp_up_sp_(folder / "ramp_up_sp", "0"),
      ramp_down_sp_(folder / "ramp_down_sp", "0"),
      state_(folder / "state", "") {
  SysfsFile(folder / "address", address);
  SysfsFile(folder / "driver_name", kind.driver_name);
  SysfsFile(folder / "count_per_rot", "360");
  SysfsFile(folder / "max_speed", std::to_string(kind.max_deg_per_s));
}

void TachoMotor::obey() {
  const std::string command = command_.text();
  if (!command.empty()) {
    command_.show("");
    obey(command);
  }
  if (mode_ == Mode::kDirect) {
    read_duty();
  }
}

void TachoMotor::obey(const std::string& command) {
  sign_ = polarity_.text() == "inversed" ? -1 : 1;
  if (command == "run-direct") {
    mode_ = Mode::kDirect;
  } else if (command == "run-to-abs-pos") {
    const long deg_per_s = speed_sp_.number();
    if (std::labs(deg_per_s) > kind_.max_deg_per_s) {
      refuse("speed_sp is beyond max_speed");
    }
    goal_deg_ = static_cast<double>(zero_deg_ + sign_ * position_sp_.number());
    goal_deg_per_s_ = static_cast<double>(std::labs(deg_per_s));
    mode_ = Mode::kToPosition;
  } else if (command == "stop") {
    if (mode_ != Mode::kStopped && ramp_down_sp_.number() != 0) {
      refuse("stop would follow the ramp of ramp_down_sp");
    }
    const std::string action = stop_action_.text();
    if (action != "coast" && action != "brake" && action != "hold") {
      refuse("there is no stop_action '" + action + "'");
    }
    brakes_ = action != "coast";
    mode_ = Mode::kStopped;
  } else if (command == "reset") {
    reset();
  } else {
    refuse("there is no command '" + command + "'");
  }
  state_.show(mode_ == Mode::kStopped ? "" : "running");
}

void TachoMotor::read_duty() {
  const long percent = duty_cycle_sp_.number();
  if (std::labs(percent) > kFullDutyPercent) {
    refuse("duty_cycle_sp of " + std::to_string(percent) + " (EINVAL)");
  }
  duty_share_ = sign_ * static_cast<double>(percent) / kFullDutyPercent;
}

void TachoMotor::show_position(std::int64_t shaft_deg) {
  shaft_deg_ = shaft_deg;
  if (position_.has_changed()) {
    accept_position();
  }
  position_.show(static_cast<long>(sign_ * (shaft_deg_ - zero_deg_)));
}

void TachoMotor::accept_position() {
  if (mode_ != Mode::kStopped) {
    refuse("position was written while the motor runs (EBUSY)");
  }
  zero_deg_ = shaft_deg_ - sign_ * position_.number();
}

void TachoMotor::turn_freely(double dt_s) {
  const double max_deg_per_s = static_cast<double>(kind_.max_deg_per_s);
  if (mode_ == Mode::kToPosition) {
    const double reach_deg = goal_deg_per_s_ * dt_s;
    free_shaft_deg_ += std::clamp(goal_deg_ - free_shaft_deg_, -reach_deg, reach_deg);
  } else {
    free_shaft_deg_ += duty() * max_deg_per_s * dt_s;
  }
}

void TachoMotor::reset() {
  mode_ = Mode::kStopped;
  brakes_ = false;
  sign_ = 1;
  duty_share_ = 0.0;
  zero_deg_ = shaft_deg_;
  command_.show("");
  duty_cycle_sp_.show("0");
  stop_action_.show("coast");
  polarity_.show("normal");
  position_.show("0");
  position_sp_.show("0");
  speed_sp_.show("0");
  ramp_up_sp_.show("0");
  ramp_down_sp_.show("0");
  state_.show("");
}

void TachoMotor::refuse(const std::string& why) const {
  throw std::runtime_error("motor at " + name_ + ": " + why);
}

}  // namespace echomap::ev3
