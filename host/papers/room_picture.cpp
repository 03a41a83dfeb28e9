// SPDX-License-Identifier: MIT
#include "host/papers/room_picture.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "host/geometry/unit_vector.hpp"
#include "host/papers/picture_file.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {
namespace {

constexpr double kCellM = 0.01;
constexpr double kCrossPx = 7.0;

exports::MapView view_of(const world::FloorPlan& room,
                         std::vector<exports::LegendEntry> legend,
                         double margin_m) {
  exports::MapViewParams params;
  params.legend = std::move(legend);
  return exports::MapView(floor_of(room, kCellM, margin_m), params);
}

}  // namespace

std::vector<Eigen::Vector2d> positions_of(const localization::Particles& particles) {
  std::vector<Eigen::Vector2d> positions_m;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    positions_m.push_back(particles.pose(i).position_m());
  }
  return positions_m;
}

RoomPicture::RoomPicture(const world::FloorPlan& room,
                         std::vector<exports::LegendEntry> legend,
                         double margin_m)
    : view_(view_of(room, std::move(legend), margin_m)), picture_(view_.draw()) {
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

void RoomPicture::add_path(const std::vector<Eigen::Vector2d>& points_m,
                           double width_px,
                           exports::Colour colour) {
  for (std::size_t i = 1; i < points_m.size(); ++i) {
    picture_.draw_line(view_.place(points_m[i - 1]), view_.place(points_m[i]), width_px, colour);
  }
}

void RoomPicture::add_ellipse(const Eigen::Vector2d& mean_m,
                              const Eigen::Matrix2d& covariance_m2,
                              double sigmas,
                              exports::Colour colour) {
  constexpr int kSides = 72;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance_m2);
  const Eigen::Matrix2d scaled_axes =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  std::vector<Eigen::Vector2d> outline_m;
  for (int i = 0; i <= kSides; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kSides;
    outline_m.emplace_back(mean_m + sigmas * scaled_axes * geometry::unit_vector(angle_rad));
  }
  add_path(outline_m, 2.0, colour);
  const Eigen::Vector2d middle = view_.place(mean_m);
  for (const Eigen::Vector2d& arm :
       {Eigen::Vector2d(kCrossPx, kCrossPx), Eigen::Vector2d(kCrossPx, -kCrossPx)}) {
    picture_.draw_line(middle - arm, middle + arm, 2.0, colour);
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
  return write_picture(picture_, file, view_.texts());
}

}  // namespace echomap::papers
