// SPDX-License-Identifier: MIT
#include "host/exports/map_png.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "host/exports/picture.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

namespace {

using mapping::CellState;
using mapping::RasterMap;

/// Okabe and Ito's palette on greys, told apart with any colour vision.
constexpr Colour kFloor{255, 255, 255};
constexpr Colour kWall{40, 40, 40};
constexpr Colour kUnknown{208, 211, 217};
constexpr Colour kUnknownHatch{190, 194, 202};
constexpr Colour kEcho{230, 159, 0};
constexpr Colour kTrail{0, 114, 178};
constexpr Colour kStart{0, 158, 115};
constexpr Colour kRobot{213, 94, 0};
constexpr Colour kInk{20, 20, 20};

constexpr int kLeastPixelsPerCell = 2;
constexpr int kMostPixelsPerCell = 8;
constexpr int kWantedSide = 900;
constexpr int kFooterHeight = 44;
constexpr int kTextScale = 2;
constexpr int kMargin = 14;
constexpr int kBarThickness = 5;
constexpr int kHatchPeriod = 8;
constexpr double kRobotRadiusM = 0.09;
constexpr std::size_t kTrailStride = 5;

/// Where the map frame lies in the picture.
class MapView {
 public:
  explicit MapView(const RasterMap& map) : map_(map) {
    const int longest = std::max(map.columns(), map.rows());
    pixels_per_cell_ = std::clamp(kWantedSide / longest, kLeastPixelsPerCell, kMostPixelsPerCell);
    left_ = std::max(0, (kLeastWidth - map.columns() * pixels_per_cell_) / 2);
  }

  int width() const { return map_.columns() * pixels_per_cell_ + 2 * left_; }
  int map_height() const { return map_.rows() * pixels_per_cell_; }
  int left() const { return left_; }
  int pixels_per_cell() const { return pixels_per_cell_; }
  double pixels(double length_m) const { return length_m / map_.resolution_m() * pixels_per_cell_; }

  Eigen::Vector2d place(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d from_origin_m = point_m - map_.origin_m();
    return {left_ + pixels(from_origin_m.x()), map_height() - pixels(from_origin_m.y())};
  }

 private:
  static constexpr int kLeastWidth = 160;

  const RasterMap& map_;
  int pixels_per_cell_ = 1;
  int left_ = 0;
};

Colour unknown_colour(int x, int y) {
  return (x + y) % kHatchPeriod == 0 ? kUnknownHatch : kUnknown;
}

void draw_cells(const RasterMap& map, const MapView& view, Picture& picture) {
  for (int y = 0; y < view.map_height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int column = (x - view.left()) / view.pixels_per_cell();
      const int row = map.rows() - 1 - y / view.pixels_per_cell();
      const CellState state = x < view.left() ? CellState::kUnknown : map.state({column, row});
      picture.set(x,
                  y,
                  state == CellState::kFree       ? kFloor
                  : state == CellState::kOccupied ? kWall
                                                  : unknown_colour(x, y));
    }
  }
}

void draw_echoes(const mapping::PointCloudMap& points, const MapView& view, Picture& picture) {
  for (const auto& point : points.points()) {
    picture.fill_disc(view.place(point.position_m), 1.2, kEcho);
  }
}

void draw_trail(const pipeline::Snapshot& snapshot, const MapView& view, Picture& picture) {
  const auto& trajectory = *snapshot.trajectory;
  if (trajectory.empty()) {
    return;
  }
  Eigen::Vector2d last = view.place(trajectory.front().T_map_robot.position_m());
  for (std::size_t i = kTrailStride; i < trajectory.size() + kTrailStride; i += kTrailStride) {
    const auto& pose = trajectory[std::min(i, trajectory.size() - 1)].T_map_robot;
    const Eigen::Vector2d place = view.place(pose.position_m());
    picture.draw_line(last, place, 3.0, kTrail);
    last = place;
  }
  const Eigen::Vector2d start = view.place(trajectory.front().T_map_robot.position_m());
  picture.fill_disc(start, 8.0, kStart);
  picture.fill_disc(start, 4.5, kFloor);
}

void draw_robot(const geometry::Pose2& T_map_robot, const MapView& view, Picture& picture) {
  const double radius = std::max(6.0, view.pixels(kRobotRadiusM));
  const Eigen::Vector2d nose_m = T_map_robot * Eigen::Vector2d(1.4 * kRobotRadiusM, 0.0);
  const Eigen::Vector2d centre = view.place(T_map_robot.position_m());
  picture.fill_disc(centre, radius, kRobot);
  picture.draw_line(centre, view.place(nose_m), 4.0, kInk);
}

/// The largest of these that takes at most a third of the picture's width.
double scale_bar_m(const MapView& view) {
  constexpr std::array kLengthsM{10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1};
  for (const double length_m : kLengthsM) {
    if (view.pixels(length_m) <= view.width() / 3.0) {
      return length_m;
    }
  }
  return kLengthsM.back();
}

void draw_scale_bar(const MapView& view, Picture& picture) {
  const double length_m = scale_bar_m(view);
  const int length = static_cast<int>(std::lround(view.pixels(length_m)));
  const int y = view.map_height() + kFooterHeight / 2;
  picture.fill_rectangle(kMargin, y - kBarThickness / 2, length, kBarThickness, kInk);
  for (const int x : {kMargin, kMargin + length - 2}) {
    picture.fill_rectangle(x, y - 2 * kBarThickness, 2, 4 * kBarThickness, kInk);
  }
  std::string label = std::to_string(length_m);
  label.erase(label.find_last_not_of('0') + 1);
  if (label.back() == '.') {
    label.pop_back();
  }
  picture.draw_text(kMargin + length + kMargin, y - 7, label + " m", kTextScale, kInk);
}

}  // namespace

void write_map_png(const std::filesystem::path& path, const pipeline::Snapshot& snapshot) {
  const RasterMap map = mapping::rasterize(*snapshot.grid);
  const MapView view(map);
  Picture picture(view.width(), view.map_height() + kFooterHeight, kFloor);
  draw_cells(map, view, picture);
  draw_echoes(*snapshot.points, view, picture);
  draw_trail(snapshot, view, picture);
  draw_robot(snapshot.latest.T_map_robot, view, picture);
  draw_scale_bar(view, picture);
  picture.write_png(path);
}

}  // namespace echomap::exports
