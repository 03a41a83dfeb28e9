// SPDX-License-Identifier: MIT
#include "tests/benchmarks/sonar_peers.hpp"

#ifdef ECHOMAP_WITH_MRPT
#include <algorithm>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/poses/CPose3D.h>
#endif

namespace echomap::bench {

#ifdef ECHOMAP_WITH_MRPT

namespace {

using mapping::OccupancyGrid;
using mapping::Scan;

constexpr double kResolutionM = 0.05;
constexpr double kSpareM = 1.0;
constexpr int kCertainCentilogits = 500;
constexpr double kFreeBelow = 0.196;
constexpr double kOccupiedFrom = 0.65;

mrpt::maps::COccupancyGridMap2D empty_map(const std::vector<Scan>& sweeps, double reach_m) {
  Eigen::Array2d low = sweeps.front().front().T_map_sonar.position_m();
  Eigen::Array2d high = low;
  for (const Scan& sweep : sweeps) {
    low = low.min(sweep.front().T_map_sonar.position_m().array());
    high = high.max(sweep.front().T_map_sonar.position_m().array());
  }
  low = kResolutionM * ((low - reach_m - kSpareM) / kResolutionM).floor();
  high = kResolutionM * ((high + reach_m + kSpareM) / kResolutionM).ceil();
  return mrpt::maps::COccupancyGridMap2D(static_cast<float>(low.x()),
                                         static_cast<float>(high.x()),
                                         static_cast<float>(low.y()),
                                         static_cast<float>(high.y()),
                                         static_cast<float>(kResolutionM));
}

OccupancyGrid as_grid(const mrpt::maps::COccupancyGridMap2D& map) {
  OccupancyGrid grid;
  for (unsigned y = 0; y < map.getSizeY(); ++y) {
    for (unsigned x = 0; x < map.getSizeX(); ++x) {
      const double occupied = 1.0 - map.getCell(static_cast<int>(x), static_cast<int>(y));
      if (occupied <= kFreeBelow || occupied >= kOccupiedFrom) {
        grid.add(grid.cell_at({map.idx2x(x), map.idx2y(y)}),
                 occupied >= kOccupiedFrom ? kCertainCentilogits : -kCertainCentilogits);
      }
    }
  }
  return grid;
}

}  // namespace

std::optional<OccupancyGrid> mrpt_grid(const std::vector<Scan>& sweeps, const PeerSonar& sonar) {
  auto map = empty_map(sweeps, sonar.max_range_m);
  constexpr float kBeyond = 1.0F;
  map.insertionOptions.maxDistanceInsertion = static_cast<float>(sonar.max_range_m) + 0.01F;
  for (const Scan& sweep : sweeps) {
    for (const auto& reading : sweep) {
      mrpt::obs::CObservationRange observation;
      observation.minSensorDistance = 0.0F;
      observation.maxSensorDistance = static_cast<float>(sonar.max_range_m);
      observation.sensorConeApperture = static_cast<float>(2.0 * sonar.beam_half_angle_rad);
      mrpt::obs::CObservationRange::TMeasurement measurement;
      measurement.sensedDistance =
          static_cast<float>(reading.range_m.value_or(sonar.max_range_m + kBeyond));
      observation.sensedData.push_back(measurement);
      // MRPT 2.5 draws the cone turned to the right by half its aperture: turned back here.
      const mrpt::poses::CPose3D pose(reading.T_map_sonar.x_m(),
                                      reading.T_map_sonar.y_m(),
                                      0.0,
                                      reading.T_map_sonar.heading_rad() + sonar.beam_half_angle_rad,
                                      0.0,
                                      0.0);
      map.insertObservation(observation, pose);
    }
  }
  return as_grid(map);
}

#else

std::optional<mapping::OccupancyGrid> mrpt_grid(const std::vector<mapping::Scan>&,
                                                const PeerSonar&) {
  return std::nullopt;
}

#endif

}  // namespace echomap::bench
