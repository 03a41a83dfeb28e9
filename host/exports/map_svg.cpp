// SPDX-License-Identifier: MIT
#include "host/exports/map_svg.hpp"

#include <string>

#include "host/exports/svg_elements.hpp"
#include "host/exports/svg_sheet.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// Widths on paper, millimetres.
constexpr double kOutlineMm = 1.0;
constexpr double kFittedMm = 0.5;
constexpr double kLandmarkMm = 0.5;
constexpr double kTrailMm = 0.4;
constexpr double kEchoMm = 0.35;
constexpr double kNoseMm = 0.6;
constexpr double kStartMm = 1.6;

/// The cells of one state, a rectangle for each run in a row.
std::string cells_path(const RasterMap& map, CellState state) {
  std::string path;
  const double side_m = map.resolution_m();
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const int begin = x;
      while (map.state({x, y}) == state && x < map.columns()) {
        ++x;
      }
      if (x > begin) {
        const Eigen::Vector2d corner_m = map.origin_m() + side_m * Eigen::Vector2d(begin, y);
        const std::string width = svg_number((x - begin) * side_m);
        path.append("M").append(svg_point(corner_m)).append("h").append(width);
        path.append("v").append(svg_number(side_m)).append("h-").append(width).append("z");
      }
    }
  }
  return path;
}

std::string outline_path(const mapping::PolygonMap& outline) {
  std::string path = svg_polygon(outline.outline_m());
  for (const auto& hole_m : outline.holes_m()) {
    path += svg_polygon(hole_m);
  }
  return path;
}

std::string trail_path(const pipeline::Snapshot& snapshot) {
  std::vector<Eigen::Vector2d> places_m;
  for (const auto& pose : *snapshot.trajectory) {
    places_m.push_back(pose.T_map_robot.position_m());
  }
  return svg_polyline(places_m);
}

/// Dots, as lines of no length with round ends.
std::string echoes_path(const mapping::PointCloudMap& points) {
  std::string path;
  for (const auto& point : points.points()) {
    path += "M" + svg_point(point.position_m) + "h0";
  }
  return path;
}

std::string features_path(const mapping::SonarFeatures& features) {
  std::string path;
  for (const geometry::Segment& wall : features.walls) {
    path += svg_polyline({wall.from_m, wall.to_m});
  }
  for (const mapping::FittedCircle& circle : features.circles) {
    path += svg_circle(circle.center_m, circle.radius_m);
  }
  return path;
}

std::string landmarks_path(const MapLandmarks& landmarks, double radius_m) {
  std::string path;
  for (const geometry::Segment& wall : landmarks.walls) {
    path += svg_polyline({wall.from_m, wall.to_m});
  }
  for (const Eigen::Vector2d& point_m : landmarks.points_m) {
    path += svg_circle(point_m, radius_m);
  }
  return path;
}

/// A disc as large as the robot, with a line from its centre to where it is ahead.
std::string robot_text(const geometry::Pose2& T_map_robot, double radius_m, double nose_width_m) {
  const std::string nose =
      svg_polyline({T_map_robot.position_m(), T_map_robot * Eigen::Vector2d(radius_m, 0.0)});
  return svg_filled("robot", kRobotColour, svg_circle(T_map_robot.position_m(), radius_m)) +
         svg_stroked("nose", kInkColour, nose_width_m, nose);
}

std::string trail_text(const pipeline::Snapshot& snapshot, const SvgSheet& sheet) {
  const double width_m = sheet.metres(kTrailMm);
  std::string text = svg_stroked("trail", kTrailColour, width_m, trail_path(snapshot));
  if (!snapshot.trajectory->empty()) {
    const Eigen::Vector2d start_m = snapshot.trajectory->front().T_map_robot.position_m();
    text += svg_stroked(
        "start", kStartColour, 2.0 * width_m, svg_circle(start_m, sheet.metres(kStartMm)));
  }
  return text;
}

}  // namespace

void write_map_svg(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style) {
  const RasterMap map = mapping::rasterize(*snapshot.grid);
  const SvgSheet sheet(frame_of(map, style.turn_rad, held_points_m(snapshot, style)),
                       style.title,
                       legend_of(snapshot, outline.has_value(), style));
  std::string text = sheet.header();
  text += svg_filled("floor", kFloorColour, cells_path(map, CellState::kFree));
  text += sheet.grid();
  text += svg_filled("walls", kWallColour, cells_path(map, CellState::kOccupied));
  text += svg_stroked("echoes", kEchoColour, sheet.metres(kEchoMm), echoes_path(*snapshot.points));
  if (outline) {
    text +=
        svg_stroked("outline", kOutlineColour, sheet.metres(kOutlineMm), outline_path(*outline));
  }
  if (style.shows_features) {
    text += svg_stroked(
        "fitted", kFittedColour, sheet.metres(kFittedMm), features_path(*snapshot.features));
  }
  if (!style.landmarks.empty()) {
    text += svg_stroked("landmarks",
                        kLandmarkColour,
                        sheet.metres(kLandmarkMm),
                        landmarks_path(style.landmarks, sheet.metres(kLandmarkMm)));
  }
  text += trail_text(snapshot, sheet);
  text += robot_text(snapshot.latest.T_map_robot, style.robot_radius_m, sheet.metres(kNoseMm));
  files::write_text_file(path, text + sheet.footer());
}

}  // namespace echomap::exports
