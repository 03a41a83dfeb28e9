// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/ray_insertion.hpp"
#include "host/mapping/sonar_cone_mapper.hpp"
#include "host/pipeline/seen_landmark.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

/// What is made of range scans: cells of an occupancy grid, or the echoes as they are.
enum class MapKind : std::uint8_t { kGrid, kPoints };

/// How range scans become a map.
struct ScanMapParams {
  MapKind map = MapKind::kGrid;
  mapping::OccupancyGridParams grid;
  mapping::RayInsertionParams rays;  ///< Of lasers. A beam without return says nothing.
  /// Of sonars; opening and range are those of the scan, the grid is that above.
  mapping::SonarConeMapperParams sonars;
};

/// What a robot has seen that tells whole range scans and numbered landmarks, as it comes.
class ScanMap {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit ScanMap(const ScanMapParams& params = {});

  void add(const StampedPose& robot, const sensors::RangeScan& scan);
  void add(const StampedPose& robot, const sensors::LandmarkObservation& landmark);

  /// Neither a scan nor a landmark was added.
  bool is_empty() const { return scan_poses_.empty() && landmarks_.empty(); }
  /// Replaces points and stops of the snapshot, and puts the grid below the contacts in it; a map
  /// of points has no grid.
  void describe(Snapshot& snapshot) const;

 private:
  void add_points(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  void add_rays(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  void add_readings(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  /// Made when there first are cones like those of the scan.
  mapping::SonarConeMapper& sonar_of(const sensors::RangeScan& scan);
  /// What lasers and sonars say together.
  mapping::OccupancyGrid grid() const;

  ScanMapParams params_;
  mapping::OccupancyGrid grid_;
  mapping::RayInserter rays_;
  std::vector<mapping::Ray> scan_rays_;
  /// By the opening of their cones, and whether they are of light.
  std::map<std::pair<double, bool>, mapping::SonarConeMapper> sonars_;
  std::vector<geometry::Pose2> scan_poses_;
  std::vector<mapping::MapPoint> points_;
  std::vector<SeenLandmark> landmarks_;
};

}  // namespace echomap::pipeline
