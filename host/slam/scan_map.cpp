// SPDX-License-Identifier: MIT
#include "host/slam/scan_map.hpp"

#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

namespace {

mapping::OccupancyGrid map_of_cones(const std::vector<geometry::Pose2>& T_map_robots,
                                    const std::vector<sensors::RangeScan>& scans,
                                    const ScanMapParams& params) {
  mapping::SonarConeMapperParams cones = params.cones;
  cones.cone.beam_half_angle_rad = scans.front().beam_width_rad / 2.0;
  if (scans.front().max_range_m > 0.0) {
    cones.cone.max_range_m = scans.front().max_range_m;
  }
  mapping::SonarConeMapper mapper(cones);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const sensors::RangeScan& scan = scans[i];
    mapping::Scan readings;
    for (const sensors::Beam& beam : scan.beams) {
      const geometry::Pose2 T_sensor_beam(0.0, 0.0, beam.bearing_rad);
      readings.push_back(
          {T_map_robots[i], T_map_robots[i] * scan.T_robot_sensor * T_sensor_beam, beam.range_m});
    }
    mapper.add(readings);
  }
  return mapper.map().grid;
}

mapping::OccupancyGrid map_of_rays(const std::vector<geometry::Pose2>& T_map_robots,
                                   const std::vector<sensors::RangeScan>& scans,
                                   const ScanMapParams& params) {
  mapping::OccupancyGrid grid(params.cones.grid);
  mapping::RayInserter inserter(params.rays);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const sensors::RangeScan& scan = scans[i];
    std::vector<mapping::Ray> rays;
    for (const sensors::Beam& beam : scan.beams) {
      if (beam.range_m) {
        rays.push_back({*beam.range_m * geometry::unit_vector(beam.bearing_rad), true});
      }
    }
    inserter.insert(T_map_robots[i] * scan.T_robot_sensor, rays, grid);
  }
  return grid;
}

}  // namespace

mapping::OccupancyGrid map_of_scans(const std::vector<geometry::Pose2>& T_map_robots,
                                    const std::vector<sensors::RangeScan>& scans,
                                    const ScanMapParams& params) {
  if (scans.empty()) {
    return mapping::OccupancyGrid(params.cones.grid);
  }
  const bool is_cone = scans.front().beam_width_rad > 0.0;
  return is_cone ? map_of_cones(T_map_robots, scans, params)
                 : map_of_rays(T_map_robots, scans, params);
}

}  // namespace echomap::slam
