// SPDX-License-Identifier: MIT
#include "host/exports/map_png.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "host/exports/map_view.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

namespace {

constexpr Colour kStartColour = kGreen;
constexpr double kFittedWidth = 3.0;
constexpr double kTrailWidth = 2.0;
constexpr double kMinRobotRadius = 4.0;
constexpr double kEchoShare = 0.45;

/// Faint: a pixel is mixed once, however many echoes lie there.
void draw_echoes(const mapping::PointCloudMap& points, const MapView& view, Picture& picture) {
  std::set<std::pair<int, int>> pixels;
  for (const auto& point : points.points()) {
    const Eigen::Vector2d place = view.place(point.position_m);
    if (!view.is_on_map(place)) {
      continue;
    }
    const int x = static_cast<int>(std::floor(place.x()));
    const int y = static_cast<int>(std::floor(place.y()));
    pixels.insert({{x, y}, {x - 1, y}, {x, y - 1}, {x - 1, y - 1}});
  }
  for (const auto& [x, y] : pixels) {
    picture.blend(x, y, kEchoColour, kEchoShare);
  }
}

void draw_features(const mapping::SonarFeatures& features, const MapView& view, Picture& picture) {
  for (const geometry::Segment& wall : features.walls) {
    picture.draw_line(view.place(wall.from_m), view.place(wall.to_m), kFittedWidth, kFittedColour);
  }
  for (const mapping::FittedCircle& circle : features.circles) {
    picture.draw_circle(
        view.place(circle.center_m), view.pixels(circle.radius_m), kFittedWidth, kFittedColour);
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
    picture.draw_line(last, place, kTrailWidth, kTrailColour);
    last = place;
  }
  const Eigen::Vector2d start = view.place(trajectory.front().T_map_robot.position_m());
  picture.draw_circle(start, 6.0, 4.0, kStartColour);
}

void draw_robot(const geometry::Pose2& T_map_robot,
                double radius_m,
                const MapView& view,
                Picture& picture) {
  const double radius = std::max(kMinRobotRadius, view.pixels(radius_m));
  const Eigen::Vector2d centre = view.place(T_map_robot.position_m());
  const Eigen::Vector2d ahead =
      (view.place(T_map_robot * Eigen::Vector2d(radius_m, 0.0)) - centre).normalized();
  picture.fill_disc(centre, radius, kRobotColour);
  picture.draw_line(centre, centre + radius * ahead, 3.0, kInkColour);
}

}  // namespace

void write_map_png(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const MapStyle& style) {
  auto legend = legend_of(snapshot, style);
  if (!snapshot.trajectory->empty()) {
    legend.push_back({kStartColour, "start"});
  }
  const MapView view(mapping::rasterize(*snapshot.grid),
                     {.legend = std::move(legend),
                      .title = style.title,
                      .turn_rad = style.turn_rad,
                      .points_m = trail_bounds_m(snapshot, style.robot_radius_m)});
  Picture picture = view.draw();
  draw_echoes(*snapshot.points, view, picture);
  if (style.shows_features) {
    draw_features(*snapshot.features, view, picture);
  }
  draw_trail(snapshot, view, picture);
  draw_robot(snapshot.latest.T_map_robot, style.robot_radius_m, view, picture);
  picture.write_png(path, view.texts());
}

}  // namespace echomap::exports
