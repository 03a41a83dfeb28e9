// SPDX-License-Identifier: MIT
#include "host/exports/carmen_log.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "host/exports/sonar_sweeps.hpp"
#include "host/exports/sweep_times.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exports {
namespace {

using pipeline::StampedPose;

constexpr const char* kComments =
    "# CARMEN log of a run of echomap: metres, radians, seconds; poses in the map frame\n"
    "# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n"
    "# PARAM param_name param_value\n"
    "# ODOM x y theta tv rv accel\n"
    "# ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range accuracy "
    "remission_mode num_readings [range_readings] num_remissions [remission values] laser_pose_x "
    "laser_pose_y laser_pose_theta robot_pose_x robot_pose_y robot_pose_theta laser_tv laser_rv "
    "forward_safety_dist side_safety_dist turn_axis\n";

double max_range_m(const std::vector<TimedSweep>& sweeps, const CarmenLogParams& params) {
  // A range as long as the maximum has no echo for readers; ranges have four decimals.
  constexpr double kAboveM = 0.001;
  double range_m = params.max_range_m;
  for (const TimedSweep& timed : sweeps) {
    for (const SweepReading& reading : timed.sweep.readings) {
      range_m = std::max(range_m, reading.range_m.value_or(0.0) + kAboveM);
    }
  }
  return range_m;
}

/// The text of a log, line by line.
class CarmenText {
 public:
  CarmenText(const std::vector<StampedPose>& trajectory, double max_range_m, double stddev_m)
      : trajectory_(trajectory), max_range_m_(max_range_m), stddev_m_(stddev_m) {}

  void add_params(double resolution_rad) {
    text_ += kComments;
    const auto param = [&](const char* name, double value) {
      fmt::format_to(std::back_inserter(text_), "PARAM {} {:.4f} 0 echomap 0\n", name, value);
    };
    param("robot_frontlaser_offset", 0.0);
    param("robot_front_laser_max", max_range_m_);
    param("laser_front_laser_resolution", geometry::degrees(resolution_rad));
  }

  /// `is_carried`: nobody has driven from the pose before to this one.
  void add_odometry(std::size_t index, bool is_carried) {
    const geometry::Pose2& T_map_robot = trajectory_[index].T_map_robot;
    double speed_m_per_s = 0.0;
    double turn_rate_rad_per_s = 0.0;
    if (index > 0 && !is_carried) {
      const StampedPose& before = trajectory_[index - 1];
      const std::chrono::duration<double> elapsed = trajectory_[index].stamp - before.stamp;
      const geometry::Pose2 T_before_now = before.T_map_robot.inverse() * T_map_robot;
      if (elapsed.count() > 0.0) {
        speed_m_per_s =
            std::copysign(T_before_now.position_m().norm(), T_before_now.x_m()) / elapsed.count();
        turn_rate_rad_per_s = T_before_now.heading_rad() / elapsed.count();
      }
    }
    text_ += "ODOM";
    add_pose(T_map_robot);
    fmt::format_to(
        std::back_inserter(text_), " {:.6f} {:.6f} 0.000000", speed_m_per_s, turn_rate_rad_per_s);
    add_stamp(index);
  }

  void add_sweep(std::size_t index, const SonarSweep& sweep) {
    const std::size_t count = sweep.readings.size();
    fmt::format_to(std::back_inserter(text_),
                   "ROBOTLASER1 99 {:.9f} {:.9f} {:.9f} {:.4f} {:.4f} 0 {}",
                   sweep.first_rad,
                   sweep.step_rad * static_cast<double>(count - 1),
                   sweep.step_rad,
                   max_range_m_,
                   stddev_m_,
                   count);
    for (const SweepReading& reading : sweep.readings) {
      fmt::format_to(std::back_inserter(text_),
                     " {:.4f}",
                     reading.has_answered ? reading.range_m.value_or(max_range_m_) : 0.0);
    }
    text_ += " 0";
    add_pose(sweep.T_map_sensor);
    add_pose(sweep.T_map_robot);
    text_ += " 0 0 0 0 0";
    add_stamp(index);
  }

  const std::string& text() const { return text_; }

 private:
  void add_pose(const geometry::Pose2& pose) {
    fmt::format_to(std::back_inserter(text_),
                   " {:.6f} {:.6f} {:.9f}",
                   pose.x_m(),
                   pose.y_m(),
                   pose.heading_rad());
  }

  /// The logger's time begins with the log.
  void add_stamp(std::size_t index) {
    const time::RobotTime stamp = trajectory_[index].stamp;
    const std::chrono::duration<double> of_robot = stamp.time_since_epoch();
    const std::chrono::duration<double> of_logger = stamp - trajectory_.front().stamp;
    fmt::format_to(
        std::back_inserter(text_), " {:.6f} echomap {:.6f}\n", of_robot.count(), of_logger.count());
  }

  const std::vector<StampedPose>& trajectory_;
  double max_range_m_;
  double stddev_m_;
  std::string text_;
};

}  // namespace

void write_carmen_log(const std::filesystem::path& path,
                      const pipeline::Snapshot& snapshot,
                      const CarmenLogParams& params) {
  geometry::ParameterValidator("carmen log")
      .positive_finite("max_range_m", params.max_range_m)
      .nonnegative_finite("range_stddev_m", params.range_stddev_m);
  const auto& trajectory = *snapshot.trajectory;
  const std::vector<TimedSweep> sweeps = timed_sweeps(snapshot);
  CarmenText log(trajectory, max_range_m(sweeps, params), params.range_stddev_m);
  log.add_params(sweeps.empty() ? 0.0 : sweeps.front().sweep.step_rad);
  const auto& carried_to = snapshot.carried_to;
  auto next = sweeps.begin();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    log.add_odometry(i, std::find(carried_to.begin(), carried_to.end(), i) != carried_to.end());
    for (; next != sweeps.end() && next->pose == i; ++next) {
      log.add_sweep(i, next->sweep);
    }
  }
  files::write_text_file(path, log.text());
}

}  // namespace echomap::exports
