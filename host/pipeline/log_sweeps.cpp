// SPDX-License-Identifier: MIT
#include "host/pipeline/log_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

namespace {

using sensors::Beam;

/// Fewer readings have no direction.
constexpr std::size_t kMinReadings = 3;
/// A way farther than this is one: a robot that turns its sonar trembles.
constexpr double kMovedM = 0.005;
constexpr double kMovedRad = 0.01;

double turn_rad(const sensors::Beam& from, const sensors::Beam& to) {
  return geometry::angle_between(from.bearing_rad, to.bearing_rad);
}

/// A log that leaves out what nothing answered has gaps; what is next to one is no neighbour.
std::vector<sensors::Beam> with_silence(const std::vector<sensors::Beam>& sweep) {
  std::vector<double> steps_rad;
  for (std::size_t i = 1; i < sweep.size(); ++i) {
    steps_rad.push_back(std::abs(turn_rad(sweep[i - 1], sweep[i])));
  }
  auto sorted_rad = steps_rad;
  std::sort(sorted_rad.begin(), sorted_rad.end());
  const double usual_rad = sorted_rad[sorted_rad.size() / 2];
  std::vector<sensors::Beam> whole{sweep.front()};
  for (std::size_t i = 1; i < sweep.size(); ++i) {
    if (steps_rad[i - 1] > 1.5 * usual_rad) {
      whole.push_back(
          {sweep[i - 1].bearing_rad + 0.5 * turn_rad(sweep[i - 1], sweep[i]), std::nullopt});
    }
    whole.push_back(sweep[i]);
  }
  return whole;
}

bool is_a_path(const geometry::Pose2& T_last_now) {
  return T_last_now.position_m().norm() > kMovedM || std::abs(T_last_now.heading_rad()) > kMovedRad;
}

}  // namespace

void LogSweeps::add(const datasets::LogRecord& record) {
  if (const auto* scan = std::get_if<sensors::RangeScan>(&record)) {
    add_scan(*scan);
  } else if (const auto* step = std::get_if<datasets::OdometryStep>(&record)) {
    if (is_a_path(step->T_last_now)) {
      end_sweep();
    }
  } else if (const auto* wheels = std::get_if<datasets::WheelIncrement>(&record)) {
    if (std::max(std::abs(wheels->left_m), std::abs(wheels->right_m)) > kMovedM) {
      end_sweep();
    }
  } else if (const auto* pose = std::get_if<datasets::OdometryPose>(&record)) {
    if (is_a_path(T_odom_last_.inverse() * pose->T_odom_robot)) {
      end_sweep();
      T_odom_last_ = pose->T_odom_robot;
    }
  }
}

void LogSweeps::add_scan(const sensors::RangeScan& scan) {
  if (scan.is_light) {
    ++laser_scans_;
    return;
  }
  const bool is_whole = scan.beams.size() >= kMinReadings;
  if (is_whole) {
    end_sweep();
  }
  for (const sensors::Beam& beam : scan.beams) {
    add_reading(
        {geometry::wrap_angle(scan.T_robot_sensor.heading_rad() + beam.bearing_rad), beam.range_m});
  }
  if (is_whole) {
    end_sweep();
  }
}

void LogSweeps::add_reading(const sensors::Beam& reading) {
  if (open_.size() >= 2) {
    const double before_rad = turn_rad(open_[open_.size() - 2], open_.back());
    if (before_rad * turn_rad(open_.back(), reading) <= 0.0) {
      end_sweep();
    }
  }
  open_.push_back(reading);
}

void LogSweeps::end_sweep() {
  auto sweep = std::exchange(open_, {});
  if (sweep.size() >= kMinReadings) {
    sweeps_.push_back(with_silence(sweep));
  }
}

}  // namespace echomap::pipeline
