// SPDX-License-Identifier: MIT
#include "host/source_search/source_readings.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::source_search {

namespace {

using pipeline::StampedPose;
using Seconds = std::chrono::duration<double>;

/// The trajectory at increasing stamps, and the latest pose behind it: while a robot stands, its
/// trajectory does not grow.
class PlaceAtStamp {
 public:
  explicit PlaceAtStamp(const pipeline::Snapshot& snapshot)
      : trajectory_(*snapshot.trajectory),
        latest_(snapshot.latest),
        carried_to_(snapshot.carried_to) {}

  /// Empty before the trajectory, and where the robot was carried meanwhile.
  std::optional<Eigen::Vector2d> at(time::RobotTime stamp) {
    while (next_ < trajectory_.size() && trajectory_[next_].stamp < stamp) {
      ++next_;
    }
    if (next_ == trajectory_.size()) {
      return latest_.T_map_robot.position_m();
    }
    if (next_ == 0 ||
        std::find(carried_to_.begin(), carried_to_.end(), next_) != carried_to_.end()) {
      return std::nullopt;
    }
    const StampedPose& before = trajectory_[next_ - 1];
    const StampedPose& after = trajectory_[next_];
    const double share =
        Seconds(stamp - before.stamp).count() / Seconds(after.stamp - before.stamp).count();
    return (1.0 - share) * before.T_map_robot.position_m() + share * after.T_map_robot.position_m();
  }

 private:
  const std::vector<StampedPose>& trajectory_;
  const StampedPose& latest_;
  const std::vector<std::size_t>& carried_to_;
  std::size_t next_ = 0;  ///< The first pose that is not before the last stamp.
};

time::RobotTime middle_of(const sensors::ScalarObservation& observation) {
  return observation.stamp -
         std::chrono::duration_cast<time::RobotClock::duration>(Seconds(0.5 * observation.dwell_s));
}

/// Readings of pulses in a row that are made one.
class ReadingsInARow {
 public:
  explicit ReadingsInARow(const SourceReadingsParams& params) : params_(params) {}

  void add(const FieldReading& reading) {
    if (sum_.dwell_s > 0.0 && ((reading.at_m - first_m_).norm() > params_.together_m ||
                               sum_.dwell_s + reading.dwell_s > params_.together_s)) {
      end_row();
    }
    if (sum_.dwell_s == 0.0) {
      first_m_ = reading.at_m;
    }
    sum_.value += reading.value;
    sum_.at_m += reading.dwell_s * reading.at_m;
    sum_.dwell_s += reading.dwell_s;
  }
  void end_row() {
    if (sum_.dwell_s > 0.0) {
      sum_.at_m /= sum_.dwell_s;
      sum_.position_stddev_m = params_.position_stddev_m;
      readings_.push_back(sum_);
    }
    sum_ = {};
  }
  std::vector<FieldReading> readings() && { return std::move(readings_); }

 private:
  const SourceReadingsParams& params_;
  std::vector<FieldReading> readings_;
  FieldReading sum_;
  Eigen::Vector2d first_m_ = Eigen::Vector2d::Zero();
};

}  // namespace

void validate(const SourceReadingsParams& params) {
  geometry::ParameterValidator("source readings")
      .nonnegative_finite("dead_time_s", params.dead_time_s)
      .nonnegative_finite("together_m", params.together_m)
      .positive_finite("together_s", params.together_s)
      .nonnegative_finite("position_stddev_m", params.position_stddev_m);
}

double live_time_s(double count, double dwell_s, double dead_time_s) {
  constexpr double kMinLiveShare = 0.05;
  return std::max(dwell_s - count * dead_time_s, kMinLiveShare * dwell_s);
}

SourceReadings::SourceReadings(const SourceReadingsParams& params) : params_(params) {
  validate(params);
}

void SourceReadings::on_scalar(const sensors::ScalarObservation& observation) {
  if (observation.dwell_s > 0.0) {
    observations_.push_back(observation);
  }
}

std::vector<FieldReading> SourceReadings::placed(const pipeline::Snapshot& snapshot) const {
  PlaceAtStamp place(snapshot);
  ReadingsInARow row(params_);
  for (const sensors::ScalarObservation& observation : observations_) {
    if (const auto at_m = place.at(middle_of(observation))) {
      const double live_s =
          live_time_s(observation.count, observation.dwell_s, params_.dead_time_s);
      row.add({*at_m, observation.count, live_s, 0.0});
    } else {
      row.end_row();
    }
  }
  return std::move(row).readings();
}

double SourceReadings::elapsed_s() const {
  return observations_.empty()
             ? 0.0
             : Seconds(observations_.back().stamp - observations_.front().stamp).count();
}

}  // namespace echomap::source_search
