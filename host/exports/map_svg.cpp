// SPDX-License-Identifier: MIT
#include "host/exports/map_svg.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/exports/picture_frame.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {
namespace {

using mapping::CellState;
using mapping::RasterMap;

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

std::string circle_path(const Eigen::Vector2d& center_m, double radius_m) {
  const std::string radius = text_of(radius_m);
  const std::string diameter = text_of(2.0 * radius_m);
  const std::string half_turn = "a" + radius + " " + radius + " 0 1 0 ";
  return "M" + text_of(Eigen::Vector2d(center_m - Eigen::Vector2d(radius_m, 0.0))) + half_turn +
         diameter + " 0" + half_turn + "-" + diameter + " 0z";
}

std::string features_path(const mapping::SonarFeatures& features) {
  std::string path;
  for (const geometry::Segment& wall : features.walls) {
    path += points_path({wall.from_m, wall.to_m}, false);
  }
  for (const mapping::FittedCircle& circle : features.circles) {
    path += circle_path(circle.center_m, circle.radius_m);
  }
  return path;
}

/// A disc as large as the robot, with a line from its centre to where it is ahead.
std::string robot_text(const geometry::Pose2& T_map_robot, double radius_m) {
  const std::string nose =
      points_path({T_map_robot.position_m(), T_map_robot * Eigen::Vector2d(radius_m, 0.0)}, false);
  return filled("robot", kRobotColour, circle_path(T_map_robot.position_m(), radius_m)) +
         stroked("nose", kInkColour, 0.02, nose);
}

std::string text_at(const Eigen::Vector2d& from_m, double size_m, const std::string& text) {
  return "<text x=\"" + text_of(from_m.x()) + "\" y=\"" + text_of(from_m.y()) + "\" font-size=\"" +
         text_of(size_m) + "\" font-family=\"sans-serif\">" + text + "</text>\n";
}

/// Text of a profile or a file's name, as XML holds it.
std::string escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        escaped += "&lt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

/// The sheet of paper around the map: a title above, the scale bar and the legend below. In metres,
/// x right and y down.
class Sheet {
 public:
  Sheet(const PictureFrame& frame, std::string title, std::vector<LegendEntry> legend)
      : left_m_(frame.low_m.x()),
        map_top_m_(-frame.low_m.y() - frame.size_m.y()),
        map_bottom_m_(-frame.low_m.y()),
        width_m_(std::max(kMinWidthM, frame.size_m.x())),
        title_(escaped(title)),
        legend_(std::move(legend)) {
    for (const LegendEntry& entry : legend_) {
      column_m_ = std::max(
          column_m_, 2.0 * kMarginM + kSwatchM + kLetterM * static_cast<double>(entry.text.size()));
    }
    columns_ = std::max(1, static_cast<int>(width_m_ / column_m_));
  }

  std::string header() const {
    const double top_m = map_top_m_ - kHeaderM;
    const int lines = (static_cast<int>(legend_.size()) + columns_ - 1) / columns_;
    const double height_m = map_bottom_m_ - top_m + kFooterM + kLineM * lines;
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
           text_of(width_m_ * kMillimetresPerMetre) + "mm\" height=\"" +
           text_of(height_m * kMillimetresPerMetre) + "mm\" viewBox=\"" + text_of(left_m_) + " " +
           text_of(top_m) + " " + text_of(width_m_) + " " + text_of(height_m) +
           "\">\n<title>echomap: metres in the map frame</title>\n" +
           rectangle(
               left_m_, map_top_m_, "100%", text_of(map_bottom_m_ - map_top_m_), kUnknownColour) +
           text_at({left_m_ + kMarginM, map_top_m_ - 0.1}, kFontM, title_);
  }

  /// Scale bar and legend.
  std::string footer() const {
    const double length_m = scale_bar_m(width_m_ / 3.0);
    const Eigen::Vector2d from_m(left_m_ + kMarginM, map_bottom_m_ + 0.2);
    const std::string bar = "M" + text_of(from_m) + "h" + text_of(length_m) + "m0 -0.05v0.1M" +
                            text_of(Eigen::Vector2d(from_m - Eigen::Vector2d(0.0, 0.05))) + "v0.1";
    std::string text = stroked("scale", kInkColour, 0.02, bar);
    text += text_at(from_m + Eigen::Vector2d(length_m + 0.08, 0.04), kFontM, length_text(length_m));
    int number = 0;
    for (const LegendEntry& entry : legend_) {
      const Eigen::Vector2d at_m(left_m_ + kMarginM + number % columns_ * column_m_,
                                 map_bottom_m_ + kFooterM + number / columns_ * kLineM);
      text += rectangle(at_m.x(), at_m.y(), text_of(kSwatchM), text_of(kSwatchM), entry.colour);
      text += text_at(at_m + Eigen::Vector2d(kSwatchM + 0.06, 0.11), kFontM, entry.text);
      ++number;
    }
    return text;
  }

 private:
  static constexpr double kHeaderM = 0.3;
  static constexpr double kFooterM = 0.4;
  static constexpr double kLineM = 0.2;
  static constexpr double kMarginM = 0.1;
  static constexpr double kSwatchM = 0.12;
  static constexpr double kFontM = 0.13;
  static constexpr double kLetterM = 0.075;  ///< Width of a letter, on average.

  static std::string rectangle(
      double x_m, double y_m, const std::string& width, const std::string& height, Colour colour) {
    return "<rect x=\"" + text_of(x_m) + "\" y=\"" + text_of(y_m) + "\" width=\"" + width +
           "\" height=\"" + height + "\" fill=\"" + hex_of(colour) +
           "\" stroke=\"#141414\" stroke-width=\"0.005\"/>\n";
  }

  double left_m_;
  double map_top_m_;
  double map_bottom_m_;
  double width_m_;
  std::string title_;
  std::vector<LegendEntry> legend_;
  double column_m_ = kMarginM;
  int columns_ = 1;
};

std::string group_begin(double turn_rad) {
  const std::string turn =
      turn_rad == 0.0 ? "" : " rotate(" + text_of(geometry::degrees(-turn_rad)) + ")";
  return "<g transform=\"scale(1,-1)" + turn + "\">\n";
}

}  // namespace

void write_map_svg(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style) {
  const RasterMap map = mapping::rasterize(*snapshot.grid);
  const PictureFrame frame =
      frame_of(map, style.turn_rad, trail_bounds_m(snapshot, style.robot_radius_m));
  auto legend = legend_of(snapshot, style);
  if (outline) {
    legend.push_back({kGreen, "outline"});
  }
  const Sheet sheet(frame, style.title, std::move(legend));
  std::string text = sheet.header() + group_begin(frame.turn_rad);
  text += filled("floor", kFloorColour, cells_path(map, CellState::kFree));
  text += filled("walls", kWallColour, cells_path(map, CellState::kOccupied));
  text += stroked("echoes", kEchoColour, 0.01, echoes_path(*snapshot.points));
  if (outline) {
    text += stroked("outline", kGreen, 0.03, outline_path(*outline));
  }
  if (style.shows_features) {
    text += stroked("fitted", kFittedColour, 0.015, features_path(*snapshot.features));
  }
  text += stroked("trail", kTrailColour, 0.01, trail_path(snapshot));
  text += robot_text(snapshot.latest.T_map_robot, style.robot_radius_m) + "</g>\n";
  files::write_text_file(path, text + sheet.footer() + "</svg>\n");
}

}  // namespace echomap::exports
