// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hil_mock/world/part_params.hpp"

namespace echomap::world {

/// Which of the coils A, B, C and D carry current.
using Coils = std::array<bool, 4>;

/// A pan turned by a unipolar stepper: its rotor goes to the nearest place that the coils pull it
/// to, no faster than it can; coils that change faster leave it behind, and it loses 8 half steps
/// at a time. Without current the gear holds it.
class StepperMotor {
 public:
  /// Looks straight ahead. Throws std::invalid_argument for a turn or speed of zero.
  explicit StepperMotor(const StepperParams& params);

  void step(double dt_s, const Coils& coils);

  /// Counter-clockwise from straight ahead, not wrapped: it may turn more than once.
  double pan_rad() const;
  /// Turned since the start.
  double half_steps() const { return half_steps_; }

 private:
  StepperParams params_;
  double half_steps_ = 0.0;
};

}  // namespace echomap::world
