// SPDX-License-Identifier: MIT
#include "host/diagnosis/encoder_check.hpp"

#include <cmath>

namespace echomap::diagnosis {
namespace {

/// Each error is a step of two counts whose direction nobody knows.
constexpr double kCountsPerError = 2.0;

}  // namespace

EncoderCheck::EncoderCheck(const sensors::RobotGeometry& robot, const EncoderCheckParams& params)
    : metres_per_tick_(robot.metres_per_tick()), params_(params) {}

void EncoderCheck::on_odometry(const sensors::OdometryObservation& observation) {
  if (travel_) {
    left_counts_ += std::abs(observation.travel.left_m - travel_->left_m) / metres_per_tick_;
    right_counts_ += std::abs(observation.travel.right_m - travel_->right_m) / metres_per_tick_;
  }
  travel_ = observation.travel;
}

void EncoderCheck::on_encoder_errors(const sensors::EncoderErrorObservation& observation) {
  const Sample now{
      observation.stamp, {observation.left, left_counts_}, {observation.right, right_counts_}};
  samples_.push_back(now);
  while (now.stamp - samples_.front().stamp > params_.window) {
    samples_.pop_front();
  }
  if (fault_) {
    return;
  }
  const double left = lost_share(samples_.front().left, now.left);
  const double right = lost_share(samples_.front().right, now.right);
  if (left > 0.0 && left >= right) {
    fault_ = Fault{FaultKind::kLeftDirty, left};
  } else if (right > 0.0) {
    fault_ = Fault{FaultKind::kRightDirty, right};
  }
}

double EncoderCheck::lost_share(const Wheel& before, const Wheel& now) const {
  const std::int64_t errors = now.errors - before.errors;
  const double lost = kCountsPerError * static_cast<double>(errors);
  const double share = lost / (lost + now.counts - before.counts);
  return errors >= params_.min_errors && share >= params_.min_lost_share ? share : 0.0;
}

bool explains(const Fault& dirt, FaultKind shown) {
  switch (shown) {
    case FaultKind::kNone:
    case FaultKind::kLeftWheelSize:
    case FaultKind::kRightWheelSize:
    case FaultKind::kWheelSize:
    case FaultKind::kCounts:
      return true;
    case FaultKind::kLeftCounts:
    case FaultKind::kLeftStands:
      return dirt.kind == FaultKind::kLeftDirty;
    case FaultKind::kRightCounts:
    case FaultKind::kRightStands:
      return dirt.kind == FaultKind::kRightDirty;
    default:
      return false;
  }
}

}  // namespace echomap::diagnosis
