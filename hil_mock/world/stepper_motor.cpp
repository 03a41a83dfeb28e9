// SPDX-License-Identifier: MIT
#include "hil_mock/world/stepper_motor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace echomap::world {
namespace {

constexpr double kPattern = 8.0;

/// Where the coils pull to, within the pattern of eight half steps A, AB, B, BC, C, CD, D, DA;
/// none for coils that pull nowhere or against each other.
std::optional<double> pulled_to(const Coils& coils) {
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t i = 0; i < coils.size(); ++i) {
    if (coils[i]) {
      const double angle_rad = 0.5 * std::numbers::pi * static_cast<double>(i);
      sine += std::sin(angle_rad);
      cosine += std::cos(angle_rad);
    }
  }
  if (std::hypot(sine, cosine) < 0.5) {
    return std::nullopt;
  }
  return std::atan2(sine, cosine) * kPattern / (2.0 * std::numbers::pi);
}

}  // namespace

StepperMotor::StepperMotor(const StepperParams& params) : params_(params) {
  if (params.half_steps_per_turn == 0.0 || !(params.max_half_steps_per_s > 0.0)) {
    throw std::invalid_argument("stepper: half steps per turn or speed is zero");
  }
}

void StepperMotor::step(double dt_s, const Coils& coils) {
  const auto goal = pulled_to(coils);
  if (!goal) {
    return;
  }
  const double direction = std::remainder(*goal - half_steps_, kPattern);
  const double reach = params_.max_half_steps_per_s * dt_s;
  half_steps_ += std::clamp(direction, -reach, reach);
}

double StepperMotor::pan_rad() const {
  return 2.0 * std::numbers::pi * half_steps_ / params_.half_steps_per_turn;
}

}  // namespace echomap::world
