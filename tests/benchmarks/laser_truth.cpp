// SPDX-License-Identifier: MIT
#include "tests/benchmarks/laser_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <variant>

#include "host/datasets/carmen_log.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/ray_insertion.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::bench {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::OccupancyGrid;

constexpr int kSeenCentilogits = 100;
/// Beams end here at the latest.
constexpr double kLaserRangeM = 30.0;
constexpr double kRecallReachM = 0.1;

OccupancyGrid laser_map(const std::vector<PosedScan>& scans) {
  OccupancyGrid grid;
  mapping::RayInserter inserter;
  for (const PosedScan& posed : scans) {
    std::vector<mapping::Ray> rays;
    for (const sensors::Beam& beam : posed.scan.beams) {
      if (beam.range_m && *beam.range_m <= kLaserRangeM) {
        rays.push_back({*beam.range_m * geometry::unit_vector(beam.bearing_rad), true});
      }
    }
    inserter.insert(posed.T_map_laser, rays, grid);
  }
  return grid;
}

template <typename Visitor>
void for_cells(const OccupancyGrid& grid, CellState state, Visitor&& visit) {
  const auto& bounds = grid.bounds();
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      if (grid.state({x, y}) == state) {
        visit(CellIndex{x, y});
      }
    }
  }
}

std::vector<Eigen::Vector2d> walls_m(const OccupancyGrid& grid) {
  std::vector<Eigen::Vector2d> points_m;
  for_cells(
      grid, CellState::kOccupied, [&](CellIndex cell) { points_m.push_back(grid.center_m(cell)); });
  return points_m;
}

/// The walls that some scan has seen from near enough.
std::vector<Eigen::Vector2d> walls_within_m(const std::vector<PosedScan>& scans,
                                            const OccupancyGrid& grid,
                                            double reach_m) {
  OccupancyGrid near;
  for (const PosedScan& posed : scans) {
    for (const sensors::Beam& beam : posed.scan.beams) {
      if (beam.range_m && *beam.range_m <= reach_m) {
        const Eigen::Vector2d hit_m =
            posed.T_map_laser *
            Eigen::Vector2d(*beam.range_m * geometry::unit_vector(beam.bearing_rad));
        near.add(near.cell_at(hit_m), kSeenCentilogits);
      }
    }
  }
  auto points_m = walls_m(near);
  std::erase_if(points_m, [&](const Eigen::Vector2d& point_m) {
    return grid.state(grid.cell_at(point_m)) != CellState::kOccupied;
  });
  return points_m;
}

}  // namespace

std::vector<PosedScan> read_posed_scans(const std::filesystem::path& log) {
  const auto reader = datasets::open_carmen_log(log);
  std::vector<PosedScan> scans;
  geometry::Pose2 T_map_robot;
  while (auto record = reader->next()) {
    if (const auto* pose = std::get_if<datasets::GivenPose>(&*record)) {
      T_map_robot = pose->T_map_robot;
    } else if (auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      scans.push_back({T_map_robot * scan->T_robot_sensor, std::move(*scan)});
    }
  }
  return scans;
}

LaserTruth::LaserTruth(const std::vector<PosedScan>& scans, double sonar_range_m)
    : grid_(laser_map(scans)),
      reachable_walls_m_(walls_within_m(scans, grid_, sonar_range_m)),
      walls_(walls_m(grid_)) {}

LaserAgreement LaserTruth::score(const OccupancyGrid& map) const {
  std::size_t common = 0;
  std::size_t either = 0;
  for_cells(grid_, CellState::kFree, [&](CellIndex cell) {
    ++either;
    common += map.state(cell) == CellState::kFree ? 1 : 0;
  });
  for_cells(map, CellState::kFree, [&](CellIndex cell) {
    either += grid_.state(cell) == CellState::kFree ? 0 : 1;
  });
  const auto occupied_m = walls_m(map);
  if (occupied_m.empty()) {
    throw std::invalid_argument("the map has no occupied cell");
  }
  double squares_m2 = 0.0;
  for (const auto& point_m : occupied_m) {
    const double distance_m = walls_.nearest(point_m)->distance_m;
    squares_m2 += distance_m * distance_m;
  }
  return {static_cast<double>(common) / static_cast<double>(either),
          std::sqrt(squares_m2 / static_cast<double>(occupied_m.size())),
          wall_recall(occupied_m)};
}

double LaserTruth::wall_recall(const std::vector<Eigen::Vector2d>& occupied_m) const {
  const tests::NearestPoints found(occupied_m);
  const auto recalled =
      std::count_if(reachable_walls_m_.begin(), reachable_walls_m_.end(), [&](const auto& point_m) {
        return found.nearest(point_m)->distance_m <= kRecallReachM;
      });
  return static_cast<double>(recalled) / static_cast<double>(reachable_walls_m_.size());
}

}  // namespace echomap::bench
