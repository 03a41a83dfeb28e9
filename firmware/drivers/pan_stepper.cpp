// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_stepper.hpp"

#include "firmware/hal/flash_table.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace drivers {
namespace {

constexpr uint16_t kOneStep = 1000;
constexpr uint16_t kTurnDeg = 360;
constexpr int32_t kTurnCdeg = 36000;

/// Phases A .. D in bits 0 .. 3.
constexpr uint8_t kHalfSteps[8] ECHOMAP_FLASH = {1, 3, 2, 6, 4, 12, 8, 9};

uint16_t steps_of_a_turn(const protocol::ConfigurePan& settings) {
  const int16_t steps = settings.steps_per_turn;
  return static_cast<uint16_t>(steps < 0 ? -steps : steps);
}

uint32_t steps_per_s(const protocol::ConfigurePan& settings) {
  return uint32_t{settings.deg_per_s} * steps_of_a_turn(settings) / kTurnDeg;
}

}  // namespace

bool PanStepper::accepts(const protocol::ConfigurePan& settings) {
  const uint32_t speed = steps_per_s(settings);
  return steps_of_a_turn(settings) <= protocol::kMaxStepsPerTurn && speed != 0 && speed <= kOneStep;
}

void PanStepper::turn_to(const protocol::ConfigurePan& settings, int32_t pan_cdeg) {
  steps_per_s_ = static_cast<uint16_t>(steps_per_s(settings));
  target_steps_ = static_cast<int16_t>(pan_cdeg * settings.steps_per_turn / kTurnCdeg);
}

bool PanStepper::tick(const SparePins& pins) {
  if (position_steps_ == target_steps_) {
    return true;
  }
  progress_ = static_cast<uint16_t>(progress_ + steps_per_s_);
  if (progress_ >= kOneStep) {
    progress_ = static_cast<uint16_t>(progress_ - kOneStep);
    position_steps_ =
        static_cast<int16_t>(position_steps_ + (position_steps_ < target_steps_ ? 1 : -1));
    pins.set_stepper_phases(hal::read_flash(&kHalfSteps[position_steps_ & 7]));
  }
  return false;
}

void PanStepper::rest(const SparePins& pins) {
  target_steps_ = position_steps_;
  pins.set_stepper_phases(0);
}

}  // namespace drivers
}  // namespace echomap
