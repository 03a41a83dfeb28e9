// SPDX-License-Identifier: MIT
#include "host/fleet_member/source_recorder.hpp"

#include <utility>
#include <variant>

#include "host/geometry/parameter_validator.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::fleet_member {

SourceRecorder::SourceRecorder(const team_map::SubmapRecorder& submaps,
                               const source_search::SourceReadingsParams& params,
                               double batch_s)
    : submaps_(submaps), params_(params), batch_s_(batch_s) {
  source_search::validate(params);
  geometry::ParameterValidator("source recorder").positive_finite("batch_s", batch_s);
}

void SourceRecorder::on(const sensors::Observation& observation) {
  if (const auto* scalar = std::get_if<sensors::ScalarObservation>(&observation)) {
    add(*scalar);
  } else if (std::holds_alternative<sensors::CarriedObservation>(observation)) {
    end_row();
    has_last_ = false;
  }
}

void SourceRecorder::add(const sensors::ScalarObservation& observation) {
  if (observation.dwell_s <= 0.0) {
    return;
  }
  const Eigen::Vector2d here_m = submaps_.T_odom_robot().position_m();
  const Eigen::Vector2d at_m = has_last_ ? Eigen::Vector2d(0.5 * (last_m_ + here_m)) : here_m;
  last_m_ = here_m;
  has_last_ = true;
  const double live_s =
      source_search::live_time_s(observation.count, observation.dwell_s, params_.dead_time_s);
  if (row_.dwell_s > 0.0 && ((at_m - row_first_m_).norm() > params_.together_m ||
                             row_.dwell_s + live_s > params_.together_s)) {
    end_row();
  }
  if (row_.dwell_s == 0.0) {
    row_first_m_ = at_m;
    row_.stamp_s = time::robot_seconds(observation.stamp);
    batch_begin_s_ = rows_.empty() ? row_.stamp_s : batch_begin_s_;
  }
  row_.value += observation.count;
  row_.dwell_s += live_s;
  row_sum_m_s_ += live_s * at_m;
}

void SourceRecorder::end_row() {
  if (row_.dwell_s > 0.0) {
    const Eigen::Vector2d at_m = row_sum_m_s_ / row_.dwell_s;
    row_.T_odom_robot = geometry::Pose2(at_m.x(), at_m.y(), 0.0);
    rows_.push_back(row_);
  }
  row_ = {};
  row_sum_m_s_.setZero();
}

std::optional<fleet_messages::SourceBatch> SourceRecorder::take() {
  const bool is_due =
      !rows_.empty() && rows_.back().stamp_s - batch_begin_s_ + rows_.back().dwell_s >= batch_s_;
  return is_due ? batch() : std::nullopt;
}

std::optional<fleet_messages::SourceBatch> SourceRecorder::take_rest() {
  end_row();
  return batch();
}

std::optional<fleet_messages::SourceBatch> SourceRecorder::batch() {
  if (rows_.empty() || submaps_.submaps().empty()) {
    return std::nullopt;
  }
  return fleet_messages::SourceBatch{submaps_.submaps().back().index, std::exchange(rows_, {})};
}

}  // namespace echomap::fleet_member
