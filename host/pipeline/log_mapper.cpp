// SPDX-License-Identifier: MIT
#include "host/pipeline/log_mapper.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/models/gaussian_patch.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {
namespace {

using namespace std::chrono_literals;

/// Later stamps, beyond the year 5000, are damage.
constexpr double kLatestStampS = 1e11;

std::optional<double> without_damage(std::optional<double> stamp_s) {
  return stamp_s && std::abs(*stamp_s) <= kLatestStampS ? stamp_s : std::nullopt;
}

time::RobotTime time_of(double stamp_s) {
  return time::RobotTime(time::RobotClock::duration(std::llround(stamp_s * 1e6)));
}

Eigen::Vector2d end_m(const sensors::Beam& beam) {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): callers hand a beam with a range
  return *beam.range_m * geometry::unit_vector(beam.bearing_rad);
}

/// What has been met: the line of Hennessey et al. before the robot, or its left or right half. It
/// is as wide as the bumper's radius: beyond that a round bumper has curved away.
geometry::Segment met_line(double bumper_radius_m, bool left, bool right) {
  geometry::Segment line_m = models::bumper_line(bumper_radius_m, bumper_radius_m);
  if (!right) {
    line_m.from_m.y() = 0.0;
  }
  if (!left) {
    line_m.to_m.y() = 0.0;
  }
  return line_m;
}

void add_evidence(const mapping::OccupancyGrid& from, mapping::OccupancyGrid& to) {
  const mapping::CellBounds& bounds = from.bounds();
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      to.add({x, y}, from.centilogits({x, y}).value_or(0));
    }
  }
}

}  // namespace

LogMapper::LogMapper(const LogMapperParams& params)
    : params_(params), poses_(params.poses), grid_(params.grid), rays_(params.rays) {}

void LogMapper::add(const datasets::LogRecord& record) {
  ++counts_.records;
  const auto stamp_s = without_damage(datasets::stamp_s(record));
  if (stamp_s) {
    first_stamp_s_ = std::min(first_stamp_s_.value_or(*stamp_s), *stamp_s);
    last_stamp_s_ = std::max(last_stamp_s_.value_or(*stamp_s), *stamp_s);
  }
  if (poses_.follow(record)) {
    note_pose(stamp_s);
  }
  std::visit([this](const auto& kind) { use(kind); }, record);
}

void LogMapper::note_pose(std::optional<double> stamp_s) {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): follow() has just set it
  const geometry::Pose2 T_map_robot = *poses_.T_map_robot();
  counts_.poses_without_stamp += stamp_s ? 0 : 1;
  if (trajectory_.empty()) {
    trajectory_.push_back({time_of(stamp_s.value_or(0.0)), T_map_robot});
    return;
  }
  const time::RobotTime last = trajectory_.back().stamp;
  const time::RobotTime stamp = stamp_s ? time_of(*stamp_s) : last + 1ms;
  if (stamp > last) {
    trajectory_.push_back({stamp, T_map_robot});
  } else if (stamp == last) {
    trajectory_.back().T_map_robot = T_map_robot;
  }
}

void LogMapper::use(const sensors::RangeScan& scan) {
  ++counts_.scans;
  counts_.beams += scan.beams.size();
  const auto T_map_robot = poses_.T_map_robot();
  if (!T_map_robot) {
    ++counts_.scans_without_pose;
    return;
  }
  begin_trajectory(scan.stamp_s);
  scan_poses_.push_back(*T_map_robot);
  const geometry::Pose2 T_map_sensor = *T_map_robot * scan.T_robot_sensor;
  if (params_.map == MapKind::kPoints) {
    add_points(T_map_sensor, scan);
  } else if (scan.beam_width_rad > 0.0) {
    add_readings(T_map_sensor, scan);
  } else {
    add_rays(T_map_sensor, scan);
  }
}

void LogMapper::use(const datasets::Contact& contact) {
  const bool left = contact.bump_left && !last_contact_.bump_left;
  const bool right = contact.bump_right && !last_contact_.bump_right;
  last_contact_ = contact;
  if (!left && !right) {
    return;
  }
  ++counts_.bumps;
  const auto T_map_robot = poses_.T_map_robot();
  if (T_map_robot && params_.map == MapKind::kGrid) {
    mapping::insert_bump(
        *T_map_robot, met_line(contact.bumper_radius_m, left, right), params_.bumps, grid_);
  }
}

void LogMapper::use(const datasets::LandmarkSighting& sighting) {
  ++counts_.sightings;
  const auto T_map_robot = poses_.T_map_robot();
  if (!T_map_robot) {
    ++counts_.sightings_without_pose;
    return;
  }
  begin_trajectory(sighting.stamp_s);
  const Eigen::Vector2d seen_m = sighting.range_m * geometry::unit_vector(sighting.bearing_rad);
  landmarks_.push_back({trajectory_.back().stamp,
                        sighting.id,
                        sighting.range_m,
                        sighting.bearing_rad,
                        *T_map_robot * seen_m});
}

void LogMapper::begin_trajectory(std::optional<double> stamp_s) {
  if (trajectory_.empty()) {
    note_pose(without_damage(stamp_s));
  }
}

void LogMapper::add_points(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
  for (const auto& beam : scan.beams) {
    if (beam.range_m) {
      points_.push_back({T_map_sensor * end_m(beam), scan_poses_.size() - 1});
    }
  }
}

void LogMapper::add_rays(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
  scan_rays_.clear();
  for (const auto& beam : scan.beams) {
    if (beam.range_m) {
      scan_rays_.push_back({end_m(beam), true});
    }
  }
  rays_.insert(T_map_sensor, scan_rays_, grid_);
}

void LogMapper::add_readings(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
  mapping::Scan readings;
  for (const auto& beam : scan.beams) {
    if (beam.range_m || !scan.is_light) {
      readings.push_back({scan_poses_.back(),
                          T_map_sensor * geometry::Pose2(0.0, 0.0, beam.bearing_rad),
                          beam.range_m});
    }
  }
  sonar_of(scan).add(readings);
}

mapping::SonarConeMapper& LogMapper::sonar_of(const sensors::RangeScan& scan) {
  const auto kind = std::pair(scan.beam_width_rad, scan.is_light);
  auto known = sonars_.find(kind);
  if (known == sonars_.end()) {
    mapping::SonarConeMapperParams params = params_.sonars;
    params.grid = params_.grid;
    params.cone.beam_half_angle_rad = scan.beam_width_rad / 2.0;
    params.cone.max_range_m = scan.max_range_m;
    params.is_sound = !scan.is_light;
    known = sonars_.emplace(kind, mapping::SonarConeMapper(params)).first;
  }
  return known->second;
}

mapping::OccupancyGrid LogMapper::grid() const {
  mapping::OccupancyGrid grid = grid_;
  for (const auto& [kind, sonar] : sonars_) {
    add_evidence(sonar.map().grid, grid);
  }
  return grid;
}

Snapshot LogMapper::snapshot() const {
  Snapshot snapshot;
  if (!trajectory_.empty()) {
    snapshot.latest = trajectory_.back();
  }
  snapshot.trajectory = std::make_shared<const std::vector<StampedPose>>(trajectory_);
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(scan_poses_, points_);
  snapshot.grid = std::make_shared<const mapping::OccupancyGrid>(grid());
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>();
  snapshot.last_scan = std::make_shared<const mapping::Scan>();
  snapshot.stops = scan_poses_.size();
  return snapshot;
}

std::optional<double> LogMapper::duration_s() const {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): both are set together
  return first_stamp_s_ ? std::optional(*last_stamp_s_ - *first_stamp_s_) : std::nullopt;
}

}  // namespace echomap::pipeline
