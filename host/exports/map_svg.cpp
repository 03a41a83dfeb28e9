// SPDX-License-Identifier: MIT
#include "host/exports/map_svg.hpp"

#include <string>

#include <fmt/format.h>

#include "host/exports/map_view.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {
namespace {

using mapping::CellState;
using mapping::RasterMap;

constexpr double kFooterM = 0.4;
constexpr double kMillimetresPerMetre = 1000.0 / 20.0;
constexpr double kMinWidthM = 0.6;

/// To a tenth of a millimetre, which is what a map has of sense.
std::string text_of(double metres) {
  std::string text = fmt::format("{:.4f}", metres);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string text_of(const Eigen::Vector2d& point_m) {
  return text_of(point_m.x()) + " " + text_of(point_m.y());
}

std::string hex_of(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

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
        const std::string width = text_of((x - begin) * side_m);
        path.append("M").append(text_of(corner_m)).append("h").append(width);
        path.append("v").append(text_of(side_m)).append("h-").append(width).append("z");
      }
    }
  }
  return path;
}

std::string points_path(const std::vector<Eigen::Vector2d>& points_m, bool closed) {
  std::string path;
  for (const Eigen::Vector2d& point_m : points_m) {
    path += (path.empty() ? "M" : "L") + text_of(point_m);
  }
  return path.empty() || !closed ? path : path + "z";
}

std::string outline_path(const mapping::PolygonMap& outline) {
  std::string path = points_path(outline.outline_m(), true);
  for (const auto& hole_m : outline.holes_m()) {
    path += points_path(hole_m, true);
  }
  return path;
}

std::string trail_path(const pipeline::Snapshot& snapshot) {
  std::vector<Eigen::Vector2d> places_m;
  for (const auto& pose : *snapshot.trajectory) {
    places_m.push_back(pose.T_map_robot.position_m());
  }
  return points_path(places_m, false);
}

/// Dots, as lines of no length with round ends.
std::string echoes_path(const mapping::PointCloudMap& points) {
  std::string path;
  for (const auto& point : points.points()) {
    path += "M" + text_of(point.position_m) + "h0";
  }
  return path;
}

std::string filled(const char* name, Colour colour, const std::string& path) {
  return std::string("<path id=\"") + name + "\" fill=\"" + hex_of(colour) + "\" d=\"" + path +
         "\"/>\n";
}

std::string stroked(const char* name, Colour colour, double width_m, const std::string& path) {
  return std::string("<path id=\"") + name + "\" fill=\"none\" stroke=\"" + hex_of(colour) +
         "\" stroke-width=\"" + text_of(width_m) +
         "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"" + path + "\"/>\n";
}

std::string robot_text(const geometry::Pose2& T_map_robot) {
  const std::vector<Eigen::Vector2d> arrow_m{T_map_robot * Eigen::Vector2d(0.13, 0.0),
                                             T_map_robot * Eigen::Vector2d(-0.08, 0.08),
                                             T_map_robot * Eigen::Vector2d(-0.08, -0.08)};
  return filled("robot", kVermilion, points_path(arrow_m, true));
}

/// Below the map; y runs downwards here.
std::string scale_text(double left_m, double top_m, double width_m) {
  const double length_m = scale_bar_m(width_m / 3.0);
  const Eigen::Vector2d from_m(left_m + 0.1, top_m + 0.2);
  const std::string bar = "M" + text_of(from_m) + "h" + text_of(length_m) + "m0 -0.05v0.1M" +
                          text_of(Eigen::Vector2d(from_m - Eigen::Vector2d(0.0, 0.05))) + "v0.1";
  return stroked("scale", kInkColour, 0.02, bar) + "<text x=\"" +
         text_of(from_m.x() + length_m + 0.08) + "\" y=\"" + text_of(from_m.y() + 0.04) +
         "\" font-size=\"0.13\" font-family=\"sans-serif\">" + length_text(length_m) + "</text>\n";
}

std::string header(double left_m, double top_m, double width_m, double height_m) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         text_of(width_m * kMillimetresPerMetre) + "mm\" height=\"" +
         text_of(height_m * kMillimetresPerMetre) + "mm\" viewBox=\"" + text_of(left_m) + " " +
         text_of(top_m) + " " + text_of(width_m) + " " + text_of(height_m) +
         "\">\n<title>echomap: metres in the map frame</title>\n<rect x=\"" + text_of(left_m) +
         "\" y=\"" + text_of(top_m) + "\" width=\"100%\" height=\"100%\" fill=\"#d0d3d9\"/>\n";
}

}  // namespace

void write_map_svg(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline) {
  const RasterMap map = mapping::rasterize(*snapshot.grid);
  const double left_m = map.origin_m().x();
  const double map_height_m = map.rows() * map.resolution_m();
  const double top_m = -map.origin_m().y() - map_height_m;
  const double width_m = std::max(kMinWidthM, map.columns() * map.resolution_m());
  std::string text = header(left_m, top_m, width_m, map_height_m + kFooterM);
  text += "<g transform=\"scale(1,-1)\">\n";
  text += filled("floor", kFloorColour, cells_path(map, CellState::kFree));
  text += filled("walls", kWallColour, cells_path(map, CellState::kOccupied));
  text += stroked("echoes", kOrange, 0.02, echoes_path(*snapshot.points));
  text += stroked("trail", kBlue, 0.02, trail_path(snapshot));
  if (outline) {
    text += stroked("outline", kGreen, 0.03, outline_path(*outline));
  }
  text += robot_text(snapshot.latest.T_map_robot) + "</g>\n";
  text += scale_text(left_m, top_m + map_height_m, width_m) + "</svg>\n";
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
