// SPDX-License-Identifier: MIT
#include "host/papers/room_picture.hpp"

#include <string>
#include <utility>

#include "host/files/atomic_file.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {
namespace {

constexpr double kCellM = 0.01;
constexpr double kMarginM = 0.2;

exports::MapView view_of(const world::FloorPlan& room, std::vector<exports::LegendEntry> legend) {
  exports::MapViewParams params;
  params.legend = std::move(legend);
  return exports::MapView(floor_of(room, kCellM, kMarginM), params);
}

}  // namespace

std::vector<Eigen::Vector2d> positions_of(const localization::Particles& particles) {
  std::vector<Eigen::Vector2d> positions_m;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    positions_m.push_back(particles.pose(i).position_m());
  }
  return positions_m;
}

RoomPicture::RoomPicture(const world::FloorPlan& room, std::vector<exports::LegendEntry> legend)
    : view_(view_of(room, std::move(legend))), picture_(view_.draw()) {
  view_.limit_to_map(picture_);
  for (const world::Wall& wall : room.walls()) {
    picture_.draw_line(view_.place(wall.segment.from_m),
                       view_.place(wall.segment.to_m),
                       2.0,
                       exports::kWallColour);
  }
}

void RoomPicture::add_points(const std::vector<Eigen::Vector2d>& points_m,
                             double radius_px,
                             exports::Colour colour) {
  for (const Eigen::Vector2d& point_m : points_m) {
    picture_.fill_disc(view_.place(point_m), radius_px, colour);
  }
}

void RoomPicture::add_robot(const geometry::Pose2& T_world_robot,
                            double radius_m,
                            exports::Colour colour) {
  const Eigen::Vector2d at = view_.place(T_world_robot.position_m());
  picture_.draw_circle(at, view_.pixels(radius_m), 2.5, colour);
  picture_.draw_line(
      at, view_.place(T_world_robot * Eigen::Vector2d(1.5 * radius_m, 0.0)), 2.5, colour);
}

std::vector<std::uint8_t> RoomPicture::write_png(const std::filesystem::path& file) const {
  std::filesystem::create_directories(file.parent_path());
  picture_.write_png(file, view_.texts());
  const std::string bytes = files::read_text_file(file);
  return {bytes.begin(), bytes.end()};
}

}  // namespace echomap::papers
