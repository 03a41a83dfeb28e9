// SPDX-License-Identifier: MIT
#include "host/exports/poses_csv.hpp"

#include <array>
#include <stdexcept>

#include "host/exports/number_table.hpp"
#include "host/exports/points_csv.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr NumberTableFormat kFormat{"x_m,y_m,heading_rad", ',', 3};

}  // namespace

void write_poses_csv(const std::filesystem::path& path, const std::vector<geometry::Pose2>& poses) {
  std::string text(kFormat.header);
  text.push_back('\n');
  for (const auto& pose : poses) {
    append_row(text, std::array{pose.x_m(), pose.y_m(), pose.heading_rad()}, kFormat.separator);
  }
  files::write_text_file(path, text);
}

std::vector<geometry::Pose2> read_poses_csv(const std::filesystem::path& path) {
  std::vector<geometry::Pose2> poses;
  for (const auto& row : read_number_table(path, kFormat)) {
    poses.emplace_back(row.values[0], row.values[1], row.values[2]);
  }
  return poses;
}

mapping::PointCloudMap read_point_cloud_map(const std::filesystem::path& run_directory) {
  const auto points_path = run_directory / "points.csv";
  try {
    return {read_poses_csv(run_directory / "poses.csv"), read_points_csv(points_path)};
  } catch (const std::invalid_argument& error) {
    throw files::FileError(points_path.string() + ": " + error.what());
  }
}

}  // namespace echomap::exports
