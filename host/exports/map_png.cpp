// SPDX-License-Identifier: MIT
#include "host/exports/map_png.hpp"

#include <algorithm>

#include "host/exports/map_view.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

namespace {

constexpr double kRobotRadiusM = 0.09;

void draw_echoes(const mapping::PointCloudMap& points, const MapView& view, Picture& picture) {
  for (const auto& point : points.points()) {
    picture.fill_disc(view.place(point.position_m), 1.2, kOrange);
  }
}

void draw_trail(const pipeline::Snapshot& snapshot, const MapView& view, Picture& picture) {
  const auto& trajectory = *snapshot.trajectory;
  if (trajectory.empty()) {
    return;
  }
  Eigen::Vector2d last = view.place(trajectory.front().T_map_robot.position_m());
  for (const auto& pose : trajectory) {
    const Eigen::Vector2d place = view.place(pose.T_map_robot.position_m());
    picture.draw_line(last, place, 3.0, kBlue);
    last = place;
  }
  const Eigen::Vector2d start = view.place(trajectory.front().T_map_robot.position_m());
  picture.fill_disc(start, 8.0, kGreen);
  picture.fill_disc(start, 4.5, kFloorColour);
}

void draw_robot(const geometry::Pose2& T_map_robot, const MapView& view, Picture& picture) {
  const double radius = std::max(6.0, view.pixels(kRobotRadiusM));
  const Eigen::Vector2d nose_m = T_map_robot * Eigen::Vector2d(1.4 * kRobotRadiusM, 0.0);
  const Eigen::Vector2d centre = view.place(T_map_robot.position_m());
  picture.fill_disc(centre, radius, kVermilion);
  picture.draw_line(centre, view.place(nose_m), 4.0, kInkColour);
}

}  // namespace

void write_map_png(const std::filesystem::path& path, const pipeline::Snapshot& snapshot) {
  const MapView view(mapping::rasterize(*snapshot.grid));
  Picture picture = view.draw();
  draw_echoes(*snapshot.points, view, picture);
  draw_trail(snapshot, view, picture);
  draw_robot(snapshot.latest.T_map_robot, view, picture);
  picture.write_png(path, view.texts());
}

}  // namespace echomap::exports
