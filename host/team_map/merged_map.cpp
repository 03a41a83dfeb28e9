// SPDX-License-Identifier: MIT
#include "host/team_map/merged_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/unit_vector.hpp"

namespace echomap::team_map {

namespace {

using mapping::CellState;
using mapping::OccupancyGrid;

/// A reading without an echo shows this much floor.
constexpr double kSilentReachM = 2.0;
constexpr std::size_t kMaxBits = 64;

/// Marks what a reading has passed: the cells of its axis, up to and with the echo.
void mark_along(const mapping::PlacedReading& reading,
                std::size_t robot,
                const OccupancyGrid& grid,
                Provenance& provenance) {
  const double step_m = 0.5 * grid.resolution_m();
  const double behind_m = reading.range_m ? 2.0 * grid.resolution_m() : 0.0;
  const double reach_m = reading.range_m.value_or(kSilentReachM) + behind_m;
  const auto steps = static_cast<int>(std::ceil(reach_m / step_m));
  for (int step = 0; step <= steps; ++step) {
    const geometry::CellIndex cell =
        grid.cell_at(reading.T_map_sonar * Eigen::Vector2d(step * step_m, 0.0));
    const CellState state = grid.state(cell);
    if (state != CellState::kUnknown) {
      provenance.add(cell, robot);
    }
    if (state == CellState::kOccupied && !reading.range_m) {
      return;
    }
  }
}

mapping::ContactMapperParams contact_params(double body_radius_m) {
  mapping::ContactMapperParams params;
  params.body_radius_m = body_radius_m;
  return params;
}

/// The grid with the floor that the robots have driven over, and their contacts.
OccupancyGrid with_contacts(OccupancyGrid grid,
                            const std::vector<MapShare>& shares,
                            const mapping::OccupancyGridParams& params) {
  for (const MapShare& share : shares) {
    mapping::ContactMapper contacts(contact_params(share.body_radius_m), params);
    for (const geometry::Pose2& T_map_robot : share.placed.T_map_way) {
      contacts.pass_over(T_map_robot);
    }
    for (const PlacedContact& contact : share.placed.contacts) {
      contacts.bump(contact.T_map_robot, contact.left, contact.right);
    }
    grid = mapping::with_contact_evidence(std::move(grid), contacts.grid());
  }
  return grid;
}

}  // namespace

Provenance::Provenance(const mapping::CellBounds& bounds, double resolution_m)
    : bounds_(bounds), resolution_m_(resolution_m) {
  if (!bounds.empty()) {
    robots_.resize(static_cast<std::size_t>(bounds.columns()) *
                   static_cast<std::size_t>(bounds.rows()));
  }
}

std::uint64_t Provenance::robots_at(geometry::CellIndex cell) const {
  return bounds_.holds(cell) ? robots_[bounds_.index(cell)] : 0;
}

void Provenance::add(geometry::CellIndex cell, std::size_t robot) {
  if (bounds_.holds(cell) && robot < kMaxBits) {
    robots_[bounds_.index(cell)] |= std::uint64_t{1} << robot;
  }
}

void MergedMapper::begin_with(const std::vector<MapShare>& shares) {
  std::vector<std::string> robots;
  robots.reserve(shares.size());
  for (const MapShare& share : shares) {
    robots.push_back(share.robot);
  }
  bool goes_on = mapper_ && robots == robots_;
  for (std::size_t robot = 0; goes_on && robot < shares.size(); ++robot) {
    goes_on = shares[robot].placed.scans.size() >= taken_[robot];
  }
  if (!goes_on) {
    mapper_ = std::make_unique<mapping::SonarMapper>(params_);
    robots_ = std::move(robots);
    taken_.assign(shares.size(), 0);
    order_.clear();
  }
}

MergedMap MergedMapper::merge(const std::vector<MapShare>& shares) {
  begin_with(shares);
  std::vector<Eigen::Vector2d> track_m;
  for (std::size_t robot = 0; robot < shares.size(); ++robot) {
    const PlacedSubmaps& placed = shares[robot].placed;
    while (taken_[robot] < placed.scans.size()) {
      order_.push_back({robot, taken_[robot]++});
    }
    const auto path_m = positions_m(placed.T_map_way);
    track_m.insert(track_m.end(), path_m.begin(), path_m.end());
  }
  std::vector<mapping::Scan> scans;
  scans.reserve(order_.size());
  for (const Contribution& one : order_) {
    scans.push_back(shares[one.robot].placed.scans[one.scan]);
  }
  mapper_->take(scans, track_m);
  MergedMap merged;
  merged.robots = robots_;
  merged.grid =
      std::make_shared<const OccupancyGrid>(with_contacts(mapper_->grid(), shares, params_.grid));
  merged.provenance = Provenance(merged.grid->bounds(), merged.grid->resolution_m());
  for (std::size_t robot = 0; robot < shares.size(); ++robot) {
    for (const mapping::Scan& scan : shares[robot].placed.scans) {
      for (const mapping::PlacedReading& reading : scan) {
        mark_along(reading, robot, *merged.grid, merged.provenance);
      }
    }
  }
  merged.scans = std::make_shared<const std::vector<mapping::Scan>>(std::move(scans));
  merged.features = std::make_shared<const mapping::SonarFeatures>(mapper_->features());
  merged.been_m = std::make_shared<const std::vector<Eigen::Vector2d>>(std::move(track_m));
  return merged;
}

}  // namespace echomap::team_map
