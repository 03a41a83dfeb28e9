// SPDX-License-Identifier: MIT
#include "host/pipeline/stop_map.hpp"

#include <utility>

#include "host/pipeline/detached.hpp"

namespace echomap::pipeline {

StopMap::StopMap(const mapping::SonarMapperParams& sonar,
                 const mapping::ContactMapperParams& contact)
    : sonar_(sonar),
      contacts_(contact, sonar.grid),
      sonar_grid_(std::make_shared<const mapping::OccupancyGrid>(sonar.grid)),
      grid_(sonar_grid_),
      scans_(std::make_shared<const std::vector<mapping::Scan>>()),
      last_scan_(std::make_shared<const mapping::Scan>()) {}

void StopMap::add_echo(const mapping::PlacedReading& reading) { detached(points_).add(reading); }

void StopMap::replace_points(mapping::PointCloudMap points) {
  points_ = std::make_shared<mapping::PointCloudMap>(std::move(points));
}

void StopMap::add_stop(const mapping::Scan& scan, const std::vector<Eigen::Vector2d>& track_m) {
  std::vector<mapping::Scan> scans = *scans_;
  scans.push_back(scan);
  replace_stops(std::move(scans), track_m);
}

void StopMap::replace_stops(std::vector<mapping::Scan> scans,
                            const std::vector<Eigen::Vector2d>& track_m) {
  sonar_.take(scans, track_m);
  scans_ = std::make_shared<const std::vector<mapping::Scan>>(std::move(scans));
  const auto grid = std::make_shared<const mapping::OccupancyGrid>(sonar_.grid());
  newly_free_m2_ = mapping::newly_free_area_m2(*sonar_grid_, *grid);
  sonar_grid_ = grid;
  grid_ = nullptr;
  features_ = std::make_shared<const mapping::SonarFeatures>(sonar_.features());
}

void StopMap::end_stop(mapping::Scan scan, mapping::ScanFault fault) {
  last_scan_ = std::make_shared<const mapping::Scan>(std::move(scan));
  last_scan_fault_ = fault;
  newly_free_m2_ = fault == mapping::ScanFault::kNone ? newly_free_m2_ : 0.0;
  ++stops_;
}

std::shared_ptr<const mapping::OccupancyGrid> StopMap::grid() const {
  if (grid_ == nullptr || contacts_in_grid_ != contacts_.grid().revision()) {
    grid_ = std::make_shared<const mapping::OccupancyGrid>(
        mapping::with_contact_evidence(*sonar_grid_, contacts_.grid()));
    contacts_in_grid_ = contacts_.grid().revision();
  }
  return grid_;
}

void StopMap::describe(Snapshot& snapshot) const {
  snapshot.points = points_;
  snapshot.grid = grid();
  snapshot.features = features_;
  snapshot.scans = scans_;
  snapshot.landmarks = std::make_shared<const std::vector<SeenLandmark>>();
  snapshot.last_scan = last_scan_;
  snapshot.last_scan_fault = last_scan_fault_;
  snapshot.stops = stops_;
  snapshot.newly_free_m2 = newly_free_m2_;
}

}  // namespace echomap::pipeline
