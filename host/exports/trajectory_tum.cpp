// SPDX-License-Identifier: MIT
#include "host/exports/trajectory_tum.hpp"

#include <chrono>
#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr NumberTableFormat kTumFormat{"", ' ', 8};

/// What fits into a stamp, in microseconds, with room to spare.
constexpr double kLongestS = 1e12;

}  // namespace

void write_trajectory_tum(const std::filesystem::path& path,
                          const std::vector<pipeline::StampedPose>& trajectory) {
  std::string text;
  for (const auto& [stamp, T_map_robot] : trajectory) {
    const double half_heading_rad = 0.5 * T_map_robot.heading_rad();
    fmt::format_to(std::back_inserter(text),
                   "{:.6f} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n",
                   std::chrono::duration<double>(stamp.time_since_epoch()).count(),
                   T_map_robot.x_m(),
                   T_map_robot.y_m(),
                   std::sin(half_heading_rad),
                   std::cos(half_heading_rad));
  }
  files::write_text_file(path, text);
}

std::vector<pipeline::StampedPose> read_trajectory_tum(const std::filesystem::path& path) {
  std::vector<pipeline::StampedPose> trajectory;
  for (const auto& [row, line] : read_number_table(path, kTumFormat)) {
    if (std::abs(row[0]) > kLongestS) {
      fail_at_line(path, line, "outside the range of seconds");
    }
    const time::RobotTime stamp{time::RobotClock::duration(std::llround(row[0] * 1e6))};
    const double heading_rad = 2.0 * std::atan2(row[6], row[7]);
    trajectory.push_back({stamp, geometry::Pose2(row[1], row[2], heading_rad)});
  }
  return trajectory;
}

}  // namespace echomap::exports
