// SPDX-License-Identifier: MIT
#include "tests/benchmarks/box_scene.hpp"

#include <stdexcept>
#include <utility>

#include "host/slam/slam_methods.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::bench {
namespace {

using geometry::Polygon;
using geometry::Pose2;
using world::FloorPlan;

/// How far from walls and starts the box stands at least.
constexpr double kToWallsM = 0.25;
constexpr double kToStartM = 0.6;
/// A box that is moved is moved by its diagonal at least, off the floor where it stood.
constexpr double kMovedM = 0.5;
/// Starts of two runs differ by at most this.
constexpr double kStartM = 0.3;
constexpr double kStartRad = 0.2;
constexpr double kStartToWallsM = 0.15;
/// A room in which none of so many places will do has none.
constexpr int kMaxDraws = 100000;

/// The outline that begins at wall `first` and has so many sides.
world::Outline outline_at(const FloorPlan& plan, std::size_t first, std::size_t sides) {
  world::Outline outline;
  for (std::size_t i = first; i < first + sides; ++i) {
    outline.corners_m.push_back(plan.walls()[i].segment.from_m);
    outline.surfaces.push_back(plan.walls()[i].surface);
  }
  return outline;
}

/// The room with boxes of cardboard in it and another start.
FloorPlan with_boxes(const FloorPlan& plan, const std::vector<Polygon>& boxes, const Pose2& start) {
  std::size_t first = plan.room_m().size();
  const world::Outline room = outline_at(plan, 0, first);
  std::vector<world::Outline> obstacles;
  for (const Polygon& obstacle : plan.obstacles_m()) {
    obstacles.push_back(outline_at(plan, first, obstacle.size()));
    first += obstacle.size();
  }
  for (const Polygon& box : boxes) {
    obstacles.push_back({box, std::vector<world::Surface>(4, {world::Material::kRough, 0.9})});
  }
  return {plan.name(), room, std::move(obstacles), start};
}

Polygon box_at(const Eigen::Vector2d& center_m) {
  const double half_m = 0.5 * kBoxM;
  return {center_m + Eigen::Vector2d(-half_m, -half_m),
          center_m + Eigen::Vector2d(half_m, -half_m),
          center_m + Eigen::Vector2d(half_m, half_m),
          center_m + Eigen::Vector2d(-half_m, half_m)};
}

/// The first draw that is right.
template <class Draw, class IsRight>
auto first_right(const std::string& what, const Draw& draw, const IsRight& is_right) {
  for (int i = 0; i < kMaxDraws; ++i) {
    if (const auto drawn = draw(); is_right(drawn)) {
      return drawn;
    }
  }
  throw std::runtime_error("no place for " + what);
}

}  // namespace

BoxScene::BoxScene(const std::string& room, std::uint32_t seed)
    : plan_(tests::bundled_room(room)),
      random_(seed),
      seed_(seed),
      before_start_(plan_.T_world_start()) {
  const std::string in_room = " in room '" + room + "'";
  after_start_ = first_right(
      "a second start" + in_room,
      [this] { return near_start(); },
      [this](const Pose2& start) {
        return plan_.is_free(start.position_m()) &&
               plan_.clearance_m(start.position_m()) >= kStartToWallsM;
      });
  const auto somewhere = [this] { return somewhere_m(); };
  place_m_.push_back(
      first_right("the box" + in_room, somewhere, [this](const Eigen::Vector2d& place_m) {
        return has_room_for_box(place_m);
      }));
  place_m_.push_back(
      first_right("the moved box" + in_room, somewhere, [this](const Eigen::Vector2d& place_m) {
        return has_room_for_box(place_m) && (place_m - place_m_.front()).norm() >= kMovedM;
      }));
}

mapping::RasterMap BoxScene::mapped(const std::vector<std::size_t>& boxes, bool after) {
  std::vector<Polygon> polygons;
  for (const std::size_t box : boxes) {
    polygons.push_back(box_at(place_m_[box]));
  }
  const auto plan = with_boxes(plan_, polygons, after ? after_start_ : before_start_);
  tests::OfflineSettings as_users;
  as_users.slam = slam::slam_by_name("multiscan").make;
  const auto run =
      tests::explore_offline(plan, tests::bundled_robot("uno_2wd"), 10 * seed_ + runs_++, as_users);
  return mapping::rasterize(*run.snapshot.grid);
}

double BoxScene::signed_share() {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random_);
}

Pose2 BoxScene::near_start() {
  return Pose2(before_start_.x_m() + kStartM * signed_share(),
               before_start_.y_m() + kStartM * signed_share(),
               before_start_.heading_rad() + kStartRad * signed_share());
}

Eigen::Vector2d BoxScene::somewhere_m() {
  Eigen::Vector2d low_m = plan_.room_m().front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& corner_m : plan_.room_m()) {
    low_m = low_m.cwiseMin(corner_m);
    high_m = high_m.cwiseMax(corner_m);
  }
  const Eigen::Vector2d share(signed_share(), signed_share());
  return 0.5 * (low_m + high_m + (high_m - low_m).cwiseProduct(share));
}

bool BoxScene::has_room_for_box(const Eigen::Vector2d& place_m) const {
  const auto is_far_from = [&](const Pose2& start) {
    return (place_m - start.position_m()).norm() > kToStartM + 0.5 * kBoxM;
  };
  return plan_.is_free(place_m) && plan_.clearance_m(place_m) > 0.71 * kBoxM + kToWallsM &&
         is_far_from(before_start_) && is_far_from(after_start_);
}

}  // namespace echomap::bench
