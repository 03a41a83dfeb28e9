// SPDX-License-Identifier: MIT
#include "host/exports/map_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "host/geometry/polygon.hpp"

namespace echomap::exports {

namespace {

constexpr double kOutlineWidth = 5.0;
constexpr double kFittedWidth = 2.0;
constexpr double kLandmarkWidth = 3.0;
constexpr double kLandmarkRadius = 4.0;
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

void draw_ring(const geometry::Polygon& ring_m, const MapView& view, Picture& picture) {
  for (std::size_t i = 0; i < ring_m.size(); ++i) {
    const geometry::Segment side = geometry::side(ring_m, i);
    picture.draw_line(
        view.place(side.from_m), view.place(side.to_m), kOutlineWidth, kOutlineColour);
  }
}

void draw_outline(const mapping::PolygonMap& outline, const MapView& view, Picture& picture) {
  draw_ring(outline.outline_m(), view, picture);
  for (const geometry::Polygon& hole_m : outline.holes_m()) {
    draw_ring(hole_m, view, picture);
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

void draw_landmarks(const MapLandmarks& landmarks, const MapView& view, Picture& picture) {
  for (const geometry::Segment& wall : landmarks.walls) {
    picture.draw_line(
        view.place(wall.from_m), view.place(wall.to_m), kLandmarkWidth, kLandmarkColour);
  }
  for (const Eigen::Vector2d& point_m : landmarks.points_m) {
    picture.fill_disc(view.place(point_m), kLandmarkRadius, kLandmarkColour);
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

Picture draw_map(const MapView& view,
                 const pipeline::Snapshot& snapshot,
                 const std::optional<mapping::PolygonMap>& outline,
                 const MapStyle& style) {
  Picture picture = view.draw();
  view.limit_to_map(picture);
  draw_echoes(*snapshot.points, view, picture);
  if (outline) {
    draw_outline(*outline, view, picture);
  }
  if (style.shows_features) {
    draw_features(*snapshot.features, view, picture);
  }
  draw_landmarks(style.landmarks, view, picture);
  draw_trail(snapshot, view, picture);
  draw_robot(snapshot.latest.T_map_robot, style.robot_radius_m, view, picture);
  return picture;
}

}  // namespace echomap::exports
