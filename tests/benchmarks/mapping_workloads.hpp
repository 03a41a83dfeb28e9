// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// What a kernel and its peers are given, all with 5 cm cells.
constexpr double kResolutionM = 0.05;

/// 360 beams, one a degree, from the right behind to the left behind.
constexpr std::size_t kBeams = 360;
constexpr double kScanBeamWidthRad = geometry::radians(359.0);

inline double beam_bearing_rad(std::size_t beam) {
  return kScanBeamWidthRad * (static_cast<double>(beam) / (kBeams - 1) - 0.5);
}

struct LaserScan {
  geometry::Pose2 T_map_sensor;
  std::vector<float> ranges_m;
};

/// Scans of kBeams rays each are cast from these places, at most 10 m far.
struct CastWorkload {
  mapping::RasterMap map;
  std::vector<geometry::Pose2> places;
};
constexpr double kMaxCastM = 10.0;

/// Someone's way to do a whole workload; returns the processor time it took, seconds.
struct Contestant {
  std::string name;
  std::function<double()> run_s;
};

/// MRPT's and OpenCV's ways; none where this was built without them.
std::vector<Contestant> ray_peers(const std::vector<LaserScan>& scans);
std::vector<Contestant> cast_peers(const CastWorkload& workload);
std::vector<Contestant> distance_peers(const mapping::RasterMap& map);

}  // namespace echomap::bench
