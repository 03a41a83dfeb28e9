// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/contact_mapper.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::pipeline {

/// What a robot knows of its room: every echo as a point, a grid of the scans of its stops, and a
/// grid of what it touched and saw close by on its way. The grid of a snapshot is both together.
class StopMap {
 public:
  StopMap(const mapping::SonarMapperParams& sonar, const mapping::ContactMapperParams& contact);

  /// On the map.
  void add_echo(const mapping::PlacedReading& reading);
  /// All echoes, now that SLAM has them elsewhere.
  void replace_points(mapping::PointCloudMap points);
  /// Why a scan on the map is worthless.
  mapping::ScanFault fault_of(const mapping::Scan& scan) const {
    return mapping::fault_of(scan, *mapping::compared_map(sonar_grid_, *scans_));
  }
  /// Adds the readings of one more stop, on the map. `track_m` is where the robot has been so far.
  void add_stop(const mapping::Scan& scan, const std::vector<Eigen::Vector2d>& track_m);
  /// Replaces the readings of all stops, now that SLAM has them elsewhere.
  void replace_stops(std::vector<mapping::Scan> scans, const std::vector<Eigen::Vector2d>& track_m);
  /// Counts the scan on the map as a stop; `fault` is why it was not added.
  void end_stop(mapping::Scan scan, mapping::ScanFault fault);

  mapping::ContactMapper& contacts() { return contacts_; }
  void describe(Snapshot& snapshot) const;

 private:
  std::shared_ptr<const mapping::OccupancyGrid> grid() const;

  mapping::SonarMapper sonar_;
  mapping::ContactMapper contacts_;
  std::shared_ptr<mapping::PointCloudMap> points_ = std::make_shared<mapping::PointCloudMap>();
  std::shared_ptr<const mapping::OccupancyGrid> sonar_grid_;
  /// Made when a snapshot asks for it after one of the two has changed.
  mutable std::shared_ptr<const mapping::OccupancyGrid> grid_;
  mutable std::uint64_t contacts_in_grid_ = 0;
  std::shared_ptr<const mapping::SonarFeatures> features_ =
      std::make_shared<const mapping::SonarFeatures>();
  std::shared_ptr<const std::vector<mapping::Scan>> scans_;  ///< Those in the grid.
  std::shared_ptr<const mapping::Scan> last_scan_;
  mapping::ScanFault last_scan_fault_ = mapping::ScanFault::kNone;
  std::size_t stops_ = 0;
  double newly_free_m2_ = 0.0;
};

}  // namespace echomap::pipeline
