// SPDX-License-Identifier: MIT
#include "host/papers/laser_log.hpp"

#include <cstddef>
#include <variant>

#include "host/papers/turn_first_odometry.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::papers {
namespace {

using datasets::LogRecord;
using geometry::Pose2;

/// Hands each scan to `visit` with its pose by `next`.
template <class Next, class Visit>
void visit_scans(const std::vector<LogRecord>& records, const Next& next, const Visit& visit) {
  Pose2 T_odom_robot;
  for (const LogRecord& record : records) {
    if (const auto* step = std::get_if<datasets::OdometryStep>(&record)) {
      T_odom_robot = next(T_odom_robot, step->T_last_now);
    } else if (const auto* scan = std::get_if<sensors::RangeScan>(&record)) {
      visit(T_odom_robot, *scan);
    }
  }
}

Pose2 composed(const Pose2& T_map_last, const Pose2& T_last_now) { return T_map_last * T_last_now; }

template <class Next>
std::vector<Pose2> poses_of_scans(const std::vector<LogRecord>& records, const Next& next) {
  std::vector<Pose2> T_odom_scans;
  visit_scans(records, next, [&](const Pose2& T_odom_robot, const sensors::RangeScan&) {
    T_odom_scans.push_back(T_odom_robot);
  });
  return T_odom_scans;
}

}  // namespace

std::vector<Pose2> paper_odometry(const std::vector<LogRecord>& records) {
  return poses_of_scans(records, turned_then_driven);
}

std::vector<Pose2> composed_odometry(const std::vector<LogRecord>& records) {
  return poses_of_scans(records, composed);
}

void run_landmark_slam(const std::vector<LogRecord>& records, slam::LandmarkSlam& method) {
  visit_scans(records, composed, [&](const Pose2& T_odom_robot, const sensors::RangeScan& scan) {
    method.add(T_odom_robot, scan);
  });
}

std::vector<Eigen::Vector2d> scanned_points_m(const std::vector<LogRecord>& records,
                                              const std::vector<Pose2>& T_map_scans,
                                              double max_range_m) {
  std::vector<Eigen::Vector2d> points_m;
  std::size_t index = 0;
  for (const LogRecord& record : records) {
    const auto* scan = std::get_if<sensors::RangeScan>(&record);
    if (scan == nullptr) {
      continue;
    }
    for (const sensors::Beam& beam : scan->beams) {
      if (beam.range_m && *beam.range_m < max_range_m) {
        points_m.push_back(scanned_point_m(T_map_scans[index], *beam.range_m, beam.bearing_rad));
      }
    }
    ++index;
  }
  return points_m;
}

double path_length_m(const std::vector<Pose2>& path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length_m += (path[i].position_m() - path[i - 1].position_m()).norm();
  }
  return length_m;
}

}  // namespace echomap::papers
