// SPDX-License-Identifier: MIT
#include "host/pipeline/scan_map.hpp"

#include <memory>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/cell_insertion.hpp"
#include "host/mapping/contact_mapper.hpp"

namespace echomap::pipeline {
namespace {

Eigen::Vector2d end_m(double range_m, double bearing_rad) {
  return range_m * geometry::unit_vector(bearing_rad);
}

void add_evidence(const mapping::OccupancyGrid& from, mapping::OccupancyGrid& to) {
  mapping::insert_cells(
      from.bounds(),
      [&](geometry::CellIndex cell) { return from.centilogits(cell).value_or(0); },
      to);
}

}  // namespace

ScanMap::ScanMap(const ScanMapParams& params)
    : params_(params), grid_(params.grid), rays_(params.rays) {}

void ScanMap::add(const StampedPose& robot, const sensors::RangeScan& scan) {
  scan_poses_.push_back(robot.T_map_robot);
  const geometry::Pose2 T_map_sensor = robot.T_map_robot * scan.T_robot_sensor;
  if (params_.map == MapKind::kPoints) {
    add_points(T_map_sensor, scan);
  } else if (scan.beam_width_rad > 0.0) {
    add_readings(T_map_sensor, scan);
  } else {
    add_rays(T_map_sensor, scan);
  }
}

void ScanMap::add(const StampedPose& robot, const sensors::LandmarkObservation& landmark) {
  const Eigen::Vector2d seen_m = landmark.range_m * geometry::unit_vector(landmark.bearing_rad);
  landmarks_.push_back({robot.stamp,
                        landmark.id,
                        landmark.range_m,
                        landmark.bearing_rad,
                        robot.T_map_robot * seen_m});
}

void ScanMap::add_points(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
  for (const auto& beam : scan.beams) {
    if (beam.range_m) {
      points_.push_back(
          {T_map_sensor * end_m(*beam.range_m, beam.bearing_rad), scan_poses_.size() - 1});
    }
  }
}

void ScanMap::add_rays(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
  scan_rays_.clear();
  for (const auto& beam : scan.beams) {
    if (beam.range_m) {
      scan_rays_.push_back({end_m(*beam.range_m, beam.bearing_rad), true});
    }
  }
  rays_.insert(T_map_sensor, scan_rays_, grid_);
}

void ScanMap::add_readings(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan) {
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

mapping::SonarConeMapper& ScanMap::sonar_of(const sensors::RangeScan& scan) {
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

mapping::OccupancyGrid ScanMap::grid() const {
  mapping::OccupancyGrid grid = grid_;
  for (const auto& [kind, sonar] : sonars_) {
    add_evidence(sonar.map().grid, grid);
  }
  return grid;
}

void ScanMap::describe(Snapshot& snapshot) const {
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(scan_poses_, points_);
  snapshot.grid = std::make_shared<const mapping::OccupancyGrid>(
      params_.map == MapKind::kGrid ? mapping::with_contact_evidence(grid(), *snapshot.grid)
                                    : mapping::OccupancyGrid(params_.grid));
  snapshot.landmarks = std::make_shared<const std::vector<SeenLandmark>>(landmarks_);
  snapshot.stops = scan_poses_.size();
}

}  // namespace echomap::pipeline
