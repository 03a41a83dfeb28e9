// SPDX-License-Identifier: MIT
#include "host/diagnosis/self_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echomap::diagnosis {
namespace {

/// What a fault has to explain in addition: robots that stay, or go twice as far, hear less that
/// contradicts them, all the more in a room with right angles; one wheel of another size bends the
/// way as curved walls do.
double cost_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::kNotMoving:
      return 8.0;
    case FaultKind::kLeftCounts:
    case FaultKind::kRightCounts:
    case FaultKind::kCounts:
      return 4.0;
    case FaultKind::kLeftWheelSize:
    case FaultKind::kRightWheelSize:
      return 1.5;
    default:
      return 0.0;
  }
}

/// A contact stops the wheels within some millimetres; whatever else ends a motion early has let
/// them turn on.
bool has_held(exploration::MotionResult result) {
  return result != exploration::MotionResult::kReached &&
         result != exploration::MotionResult::kBumped &&
         result != exploration::MotionResult::kHazard;
}

bool is_large(const Fault& fault, const SelfCheckParams& params) {
  switch (fault.kind) {
    case FaultKind::kLeftWheelSize:
    case FaultKind::kRightWheelSize:
    case FaultKind::kWheelSize:
      return std::abs(fault.value - 1.0) >= params.min_wheel_error;
    case FaultKind::kRangeScale:
      return std::abs(fault.value - 1.0) >= params.min_range_error;
    case FaultKind::kPanOffset:
      return std::abs(fault.value) >= params.min_pan_error_rad;
    default:
      return true;
  }
}

double min_log_odds_of(FaultKind kind, const SelfCheckParams& params) {
  const bool is_subtle = kind == FaultKind::kWheelSize || kind == FaultKind::kLeftWheelSize ||
                         kind == FaultKind::kRightWheelSize || kind == FaultKind::kPanOffset;
  return is_subtle ? params.min_subtle_log_odds : params.min_log_odds;
}

}  // namespace

SelfCheck::SelfCheck(const sensors::RobotGeometry& robot,
                     const mapping::SonarSurfaceParams& surfaces,
                     const SelfCheckParams& params)
    : params_(params), log_(robot, surfaces) {}

void SelfCheck::on_odometry(const sensors::OdometryObservation& observation) {
  wheels_.follow(observation.travel);
  if (!is_over_) {
    log_.follow(observation.travel);
  }
}

void SelfCheck::on_sonar(const sensors::SonarObservation& observation) {
  wheels_.follow(observation.travel);
  if (!is_over_) {
    log_.add(observation);
  }
}

void SelfCheck::on_hazards(const sensors::HazardObservation& observation) {
  if (observation.is_in_the_air()) {
    wheels_.lift();
    is_over_ = true;
  }
}

void SelfCheck::on_carried(const sensors::CarriedObservation& /*observation*/) { is_over_ = true; }

void SelfCheck::begin_scan() {
  if (!is_over_) {
    log_.begin_stop();
  }
}

void SelfCheck::end_scan() {
  if (is_over_) {
    return;
  }
  const std::size_t before = log_.stops();
  log_.end_stop();
  if (log_.stops() != before && log_.stops() >= params_.first_stop &&
      log_.travelled_m() >= params_.min_travelled_m) {
    diagnosis_ = diagnosis_of(explain(log_, params_.search), params_);
    if (diagnosis_) {
      diagnosis_->stops = log_.stops();
    }
  }
  is_over_ = diagnosis_.has_value() || log_.stops() >= params_.last_stop;
}

void SelfCheck::end_motion(exploration::MotionResult result) {
  wheels_.end(result);
  if (has_held(result)) {
    log_.break_way();
  }
  const bool is_worse = !diagnosis_ || !forbids_a_map(diagnosis_->fault.kind);
  if (const auto& against = wheels_.turned_against(); against && is_worse) {
    is_over_ = true;
    diagnosis_ = Diagnosis{{*against, 0.0}, std::numeric_limits<double>::infinity(), log_.stops()};
  }
}

std::optional<Diagnosis> diagnosis_of(const std::vector<Explanation>& explanations,
                                      const SelfCheckParams& params) {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  double sound = 0.0;
  const Explanation* best = nullptr;
  double best_score = kNever;
  double next_score = kNever;
  for (const Explanation& one : explanations) {
    const double score = one.log_posterior - cost_of(one.fault.kind);
    if (one.fault.kind == FaultKind::kNone) {
      sound = score;
    } else if (score > best_score) {
      next_score = best_score;
      best_score = score;
      best = &one;
    } else {
      next_score = std::max(next_score, score);
    }
  }
  const bool is_sure = best != nullptr &&
                       best_score - sound >= min_log_odds_of(best->fault.kind, params) &&
                       best_score - next_score >= params.min_lead && is_large(best->fault, params);
  return is_sure ? std::optional(Diagnosis{best->fault, best_score - sound, 0}) : std::nullopt;
}

}  // namespace echomap::diagnosis
