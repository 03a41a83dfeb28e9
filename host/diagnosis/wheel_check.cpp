// SPDX-License-Identifier: MIT
#include "host/diagnosis/wheel_check.hpp"

#include <cmath>
#include <variant>

namespace echomap::diagnosis {
namespace {

using exploration::Drive;
using exploration::MotionResult;
using exploration::Turn;

/// A wheel that has rolled so far the wrong way did not just swing out.
constexpr double kAgainstM = 0.02;
constexpr double kStillM = 0.005;

int sign_of(double value) { return value > 0.0 ? 1 : -1; }

std::optional<FaultKind> which(bool left, bool right, FaultKind one, FaultKind other) {
  if (left == right) {
    return std::nullopt;
  }
  return left ? one : other;
}

}  // namespace

void WheelCheck::begin(const exploration::Motion& motion) {
  told_.reset();
  stood_still_.reset();
  before_ = travel_;
  if (const auto* turn = std::get_if<Turn>(&motion)) {
    told_ = {-sign_of(turn->angle_rad), sign_of(turn->angle_rad)};
  } else if (const auto* drive = std::get_if<Drive>(&motion)) {
    told_ = {sign_of(drive->distance_m), sign_of(drive->distance_m)};
  }
}

void WheelCheck::end(MotionResult result) {
  const bool is_by_the_wheels = result == MotionResult::kStalled ||
                                result == MotionResult::kTimedOut ||
                                result == MotionResult::kInterrupted;
  if (!told_ || is_in_the_air_ || !is_by_the_wheels) {
    return;
  }
  const double left_m = told_->left * (travel_.left_m - before_.left_m);
  const double right_m = told_->right * (travel_.right_m - before_.right_m);
  const bool left_against = left_m < -kAgainstM;
  const bool right_against = right_m < -kAgainstM;
  if (left_against && right_against) {
    turned_against_ = FaultKind::kBothAgainst;
  } else if (const auto against = which(
                 left_against, right_against, FaultKind::kLeftAgainst, FaultKind::kRightAgainst)) {
    turned_against_ = against;
  }
  if (result == MotionResult::kStalled) {
    stood_still_ = which(std::abs(left_m) < kStillM,
                         std::abs(right_m) < kStillM,
                         FaultKind::kLeftStands,
                         FaultKind::kRightStands);
  }
}

}  // namespace echomap::diagnosis
