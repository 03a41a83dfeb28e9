// SPDX-License-Identifier: MIT
#include "host/localization/pose_ekf.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::localization {

namespace {

double stamp_of(const PoseMeasurement& measurement) {
  return std::visit([](const auto& kind) { return kind.stamp_s; }, measurement);
}

/// Between two poses of the odometry, on the straight line.
geometry::Pose2 between(const geometry::Pose2& T_odom_a,
                        const geometry::Pose2& T_odom_b,
                        double share) {
  const geometry::Pose2 T_a_b = T_odom_a.inverse() * T_odom_b;
  return T_odom_a *
         geometry::Pose2(share * T_a_b.x_m(), share * T_a_b.y_m(), share * T_a_b.heading_rad());
}

}  // namespace

PoseEkf::PoseEkf(const PoseGaussian& start, const PoseEkfParams& params)
    : params_(params), motion_(params.motion), start_(start) {
  if (!is_finite(start.T_map_robot) || !is_covariance(start.covariance)) {
    throw std::invalid_argument("pose ekf: a start is finite, its covariance positive definite");
  }
  geometry::ParameterValidator("pose ekf")
      .positive("whole_step.drive_m", params.whole_step.drive_m)
      .positive("whole_step.turn_rad", params.whole_step.turn_rad)
      .positive("gate_of_two", params.gate_of_two)
      .positive("gate_of_three", params.gate_of_three)
      .at_least("history_s", params.history_s, 0.0);
}

EkfOutcome PoseEkf::move(double stamp_s, const geometry::Pose2& T_odom_robot) {
  if (!std::isfinite(stamp_s) || !is_finite(T_odom_robot)) {
    return counted(EkfOutcome::kNotFinite);
  }
  if (!history_.empty() && stamp_s <= history_.back().stamp_s) {
    return counted(EkfOutcome::kTimeRanBack);
  }
  const PoseGaussian belief = history_.empty() ? start_ : predicted(history_.back(), T_odom_robot);
  history_.push_back({stamp_s, T_odom_robot, std::nullopt, belief});
  release_held();
  forget();
  return counted(EkfOutcome::kApplied);
}

EkfOutcome PoseEkf::update(const PoseMeasurement& measurement) {
  if (const auto fault = fault_of(measurement)) {
    return counted(outcome_of(*fault));
  }
  const bool is_ahead = history_.empty() || stamp_of(measurement) > history_.back().stamp_s;
  if (!is_ahead) {
    return counted(insert(measurement));
  }
  if (held_.size() == params_.max_held) {
    return counted(EkfOutcome::kTooManyHeld);
  }
  held_.push_back(measurement);
  return counted(EkfOutcome::kHeld);
}

EkfOutcome PoseEkf::counted(EkfOutcome outcome) {
  ++counts_[static_cast<std::size_t>(outcome)];
  return outcome;
}

/// The odometry has reached the measurement's time.
EkfOutcome PoseEkf::insert(const PoseMeasurement& measurement) {
  const double stamp_s = stamp_of(measurement);
  if (stamp_s < history_.front().stamp_s) {
    return EkfOutcome::kTooOld;
  }
  const auto after = std::upper_bound(
      history_.begin(), history_.end(), stamp_s, [](double stamp, const Node& node) {
        return stamp < node.stamp_s;
      });
  const Node& before = *std::prev(after);
  geometry::Pose2 T_odom_robot = before.T_odom_robot;
  if (after != history_.end()) {
    const double share = (stamp_s - before.stamp_s) / (after->stamp_s - before.stamp_s);
    T_odom_robot = between(before.T_odom_robot, after->T_odom_robot, share);
  }
  const auto inserted =
      history_.insert(after, Node{stamp_s, T_odom_robot, measurement, PoseGaussian{}});
  inserted->belief = predicted(*std::prev(inserted), T_odom_robot);
  const EkfOutcome outcome = correct(*inserted);
  for (auto node = std::next(inserted); node != history_.end(); ++node) {
    node->belief = predicted(*std::prev(node), node->T_odom_robot);
    correct(*node);
  }
  return outcome;
}

EkfOutcome PoseEkf::correct(Node& node) const {
  if (!node.measurement) {
    return EkfOutcome::kApplied;
  }
  const auto linear = linearized(*node.measurement, node.belief.T_map_robot);
  if (!linear) {
    return EkfOutcome::kAtLandmark;
  }
  const double gate = linear->innovation.size() == 2 ? params_.gate_of_two : params_.gate_of_three;
  if (!(squared_distance(node.belief, *linear) <= gate)) {
    return EkfOutcome::kGated;
  }
  node.belief = corrected(node.belief, *linear);
  return EkfOutcome::kApplied;
}

PoseGaussian PoseEkf::predicted(const Node& from, const geometry::Pose2& T_odom_robot) const {
  const models::OdometryStep step = models::odometry_step(from.T_odom_robot, T_odom_robot);
  return moved(from.belief,
               from.T_odom_robot.inverse() * T_odom_robot,
               step,
               models::cut_step_spread(motion_, step, params_.whole_step));
}

void PoseEkf::release_held() {
  const auto waits = [&](const PoseMeasurement& measurement) {
    return stamp_of(measurement) > history_.back().stamp_s;
  };
  const auto first_due = std::stable_partition(held_.begin(), held_.end(), waits);
  const std::vector<PoseMeasurement> due(first_due, held_.end());
  held_.erase(first_due, held_.end());
  for (const PoseMeasurement& measurement : due) {
    counted(insert(measurement));
  }
}

/// The last node that is as old as the history is long stays, for others to follow it.
void PoseEkf::forget() {
  const double oldest_s = history_.back().stamp_s - params_.history_s;
  while (history_.size() > 1 && history_[1].stamp_s <= oldest_s) {
    history_.pop_front();
  }
}

}  // namespace echomap::localization
