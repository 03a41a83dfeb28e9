// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mapping_workloads.hpp"

#ifdef ECHOMAP_WITH_MRPT

#include <memory>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/poses/CPose3D.h>

#include "tests/benchmarks/thread_clock.hpp"

namespace echomap::bench {
namespace {

using mrpt::maps::COccupancyGridMap2D;

mrpt::poses::CPose3D pose_of(const geometry::Pose2& T_map_sensor) {
  return {T_map_sensor.x_m(), T_map_sensor.y_m(), 0.0, T_map_sensor.heading_rad(), 0.0, 0.0};
}

template <typename Observation>
using Placed = std::vector<std::pair<Observation, mrpt::poses::CPose3D>>;

template <typename Observation>
Contestant inserting(std::shared_ptr<Placed<Observation>> observations) {
  auto map = std::make_shared<COccupancyGridMap2D>(
      -12.0F, 12.0F, -12.0F, 12.0F, static_cast<float>(kResolutionM));
  map->insertionOptions.maxDistanceInsertion = 20.0F;
  return {"mrpt", [map, observations] {
            return processor_seconds([&] {
              for (const auto& [observation, pose] : *observations) {
                map->insertObservation(observation, pose);
              }
            });
          }};
}

}  // namespace

std::vector<Contestant> ray_peers(const std::vector<LaserScan>& scans) {
  using mrpt::obs::CObservation2DRangeScan;
  auto observations = std::make_shared<Placed<CObservation2DRangeScan>>();
  for (const LaserScan& scan : scans) {
    CObservation2DRangeScan observation;
    observation.aperture = static_cast<float>(kScanBeamWidthRad);
    observation.rightToLeft = true;
    observation.maxRange = 20.0F;
    observation.resizeScan(kBeams);
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
      observation.setScanRange(beam, scan.ranges_m[beam]);
      observation.setScanRangeValidity(beam, true);
    }
    observations->emplace_back(observation, pose_of(scan.T_map_sensor));
  }
  return {inserting(observations)};
}

std::vector<Contestant> cast_peers(const CastWorkload& workload) {
  const mapping::RasterMap& map = workload.map;
  const auto side_m = static_cast<float>(map.columns() * kResolutionM);
  auto grid = std::make_shared<COccupancyGridMap2D>(
      0.0F, side_m, 0.0F, side_m, static_cast<float>(kResolutionM));
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      grid->setCell(x, y, map.state({x, y}) == mapping::CellState::kOccupied ? 0.0F : 1.0F);
    }
  }
  return {
      {"mrpt", [grid, places = workload.places] {
         return processor_seconds([&] {
           float range_m = 0.0F;
           bool is_valid = false;
           for (const geometry::Pose2& place : places) {
             for (std::size_t beam = 0; beam < kBeams; ++beam) {
               grid->simulateScanRay(
                   place.x_m(), place.y_m(), beam_bearing_rad(beam), range_m, is_valid, kMaxCastM);
             }
           }
         });
       }}};
}

}  // namespace echomap::bench

#else

namespace echomap::bench {

std::vector<Contestant> ray_peers(const std::vector<LaserScan>&) { return {}; }
std::vector<Contestant> cast_peers(const CastWorkload&) { return {}; }

}  // namespace echomap::bench

#endif
