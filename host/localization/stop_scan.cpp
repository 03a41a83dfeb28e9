// SPDX-License-Identifier: MIT
#include "host/localization/stop_scan.hpp"

#include <algorithm>
#include <numbers>

#include "host/geometry/angle.hpp"

namespace echomap::localization {

std::vector<RangeReading> all_readings(const StopScan& scan) {
  std::vector<RangeReading> readings = scan.readings;
  readings.insert(readings.end(), scan.on_the_way.begin(), scan.on_the_way.end());
  return readings;
}

std::vector<RangeReading> joined(std::span<const StopScan> scans) {
  std::vector<RangeReading> readings;
  for (const StopScan& scan : scans) {
    const geometry::Pose2 T_now_then = scans.front().T_odom_robot.inverse() * scan.T_odom_robot;
    for (const RangeReading& reading : all_readings(scan)) {
      readings.push_back({T_now_then * reading.T_robot_sensor, reading.range_m});
    }
  }
  return readings;
}

std::vector<std::vector<RangeReading>> sectors_of(const StopScan& scan, std::size_t sectors) {
  std::vector<std::vector<RangeReading>> heard(2 * sectors);
  for (const RangeReading& reading : scan.readings) {
    const double turns =
        geometry::wrap_angle(reading.T_robot_sensor.heading_rad()) / (2.0 * std::numbers::pi) + 0.5;
    const auto sector =
        static_cast<std::size_t>(std::max(turns, 0.0) * static_cast<double>(sectors));
    heard[std::min(sector, sectors - 1)].push_back(reading);
  }
  const std::size_t way = scan.on_the_way.size();
  const std::size_t pieces = std::min(sectors, way / 2);
  for (std::size_t i = 0; pieces > 0 && i < way; ++i) {
    heard[sectors + i * pieces / way].push_back(scan.on_the_way[i]);
  }
  std::erase_if(heard, [](const auto& readings) { return readings.size() < 2; });
  return heard;
}

}  // namespace echomap::localization
