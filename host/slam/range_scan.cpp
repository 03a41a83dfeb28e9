// SPDX-License-Identifier: MIT
#include "host/slam/range_scan.hpp"

#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

std::vector<Eigen::Vector2d> end_points_m(const RangeScan& scan, double most_range_m) {
  std::vector<Eigen::Vector2d> points_m;
  points_m.reserve(scan.beams.size());
  for (const RangeBeam& beam : scan.beams) {
    if (beam.range_m && *beam.range_m <= most_range_m) {
      points_m.push_back(scan.T_robot_sensor *
                         (*beam.range_m * geometry::unit_vector(beam.bearing_rad)));
    }
  }
  return points_m;
}

}  // namespace echomap::slam
