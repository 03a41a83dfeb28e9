// SPDX-License-Identifier: MIT
#include "hil_mock/world/wheel_drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echomap::world {
namespace {

LevelChange level_change(double at_s, std::int64_t counts) {
  const auto phase = static_cast<unsigned>(counts & 3);
  return {at_s, phase == 1U || phase == 2U, phase == 2U || phase == 3U};
}

}  // namespace

WheelDrive::WheelDrive(const DriveParams& params, double diameter_m, double gain)
    : dead_zone_duty_(params.dead_zone_duty),
      time_constant_s_(params.time_constant_s),
      coast_share_(params.time_constant_s / params.coast_time_constant_s),
      no_load_counts_per_s_(gain * params.no_load_speed_m_per_s * params.counts_per_turn /
                            (std::numbers::pi * params.wheel_diameter_m)),
      rubbing_counts_per_s2_(params.dead_zone_duty * no_load_counts_per_s_ /
                             params.time_constant_s),
      metres_per_count_(std::numbers::pi * diameter_m / params.counts_per_turn) {}

/// While the windings are closed, by the battery or by a brake, the motor's own voltage holds it
/// back; for the share of the time that they are open friction alone does, so that the wheel is
/// slower to stop, and faster at the same duty.
double WheelDrive::step(double dt_s, const MotorDrive& drive, std::vector<LevelChange>& changes) {
  const double held_back = 1.0 - drive.coasting + drive.coasting * coast_share_;
  const double follow = 1.0 - std::exp(-dt_s * held_back / time_constant_s_);
  const double before_counts_per_s = counts_per_s_;
  const double target_counts_per_s = target_counts_per_s_of(drive.duty) / held_back;
  counts_per_s_ += follow * (target_counts_per_s - counts_per_s_);
  rub(target_counts_per_s, drive.coasting * rubbing_counts_per_s2_ * dt_s);
  const double mean_counts_per_s = 0.5 * (before_counts_per_s + counts_per_s_);
  const double edges_per_s = counts_scale_ * mean_counts_per_s;

  const double from_counts = position_counts_;
  position_counts_ += edges_per_s * dt_s;
  const auto until = static_cast<std::int64_t>(std::floor(position_counts_));
  while (counts_ != until) {
    const bool forward = counts_ < until;
    const auto edge = static_cast<double>(forward ? counts_ + 1 : counts_);
    counts_ += forward ? 1 : -1;
    changes.push_back(level_change((edge - from_counts) / edges_per_s, counts_));
  }
  return (position_counts_ - from_counts) / counts_scale_ * metres_per_count_;
}

/// Dry friction: what overcomes it takes a duty of the dead zone's.
void WheelDrive::rub(double target_counts_per_s, double max_change_counts_per_s) {
  const double excess = std::abs(counts_per_s_) - std::abs(target_counts_per_s);
  if (excess > 0.0 && max_change_counts_per_s > 0.0) {
    counts_per_s_ -= std::copysign(std::min(excess, max_change_counts_per_s), counts_per_s_);
  }
}

double WheelDrive::target_counts_per_s_of(double duty) const {
  const double size = std::min(std::abs(duty), 1.0);
  if (size <= dead_zone_duty_) {
    return 0.0;
  }
  const double share = (size - dead_zone_duty_) / (1.0 - dead_zone_duty_);
  return std::copysign(share * no_load_counts_per_s_, duty);
}

}  // namespace echomap::world
