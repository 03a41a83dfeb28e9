// SPDX-License-Identifier: MIT
// How often `echomap diff` finds a box that was put into a simulated room, taken out or moved, and
// how often it finds something where nothing has changed.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/evaluation/map_difference.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::bench {
namespace {

using evaluation::ChangeKind;
using geometry::Polygon;
using geometry::Pose2;
using world::FloorPlan;

/// The edge of the box, and how far from walls and starts it stands at least.
constexpr double kBoxM = 0.35;
constexpr double kToWallsM = 0.25;
constexpr double kToStartM = 0.6;
/// A box that is moved is moved by its diagonal at least, off the floor where it stood.
constexpr double kMovedM = 0.5;
/// Starts of two runs differ by at most this.
constexpr double kStartM = 0.3;
constexpr double kStartRad = 0.2;

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

/// A room, its robot's two starts and two places for the box.
class Scene {
 public:
  Scene(const std::string& room, std::uint32_t seed)
      : plan_(tests::bundled_room(room)), random_(seed), seed_(seed) {
    before_start_ = plan_.T_world_start();
    do {
      after_start_ = Pose2(before_start_.x_m() + kStartM * signed_share(),
                           before_start_.y_m() + kStartM * signed_share(),
                           before_start_.heading_rad() + kStartRad * signed_share());
    } while (!plan_.is_free(after_start_.position_m()) ||
             plan_.clearance_m(after_start_.position_m()) < 0.15);
    place_m_.push_back(free_place_m());
    do {
      place_m_.resize(1);
      place_m_.push_back(free_place_m());
    } while ((place_m_[0] - place_m_[1]).norm() < kMovedM);
  }

  const Pose2& before_start() const { return before_start_; }
  const Eigen::Vector2d& place_m(std::size_t box) const { return place_m_[box]; }

  /// A map of the room with these of the boxes, from the first start or the second.
  mapping::RasterMap mapped(const std::vector<std::size_t>& boxes, bool after) {
    std::vector<Polygon> polygons;
    for (const std::size_t box : boxes) {
      polygons.push_back(box_at(place_m_[box]));
    }
    const auto plan = with_boxes(plan_, polygons, after ? after_start_ : before_start_);
    return mapping::rasterize(
        *tests::explore_offline(plan, "uno_2wd", 10 * seed_ + runs_++).snapshot.grid);
  }

 private:
  double signed_share() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  static Polygon box_at(const Eigen::Vector2d& center_m) {
    const double half_m = 0.5 * kBoxM;
    return {center_m + Eigen::Vector2d(-half_m, -half_m),
            center_m + Eigen::Vector2d(half_m, -half_m),
            center_m + Eigen::Vector2d(half_m, half_m),
            center_m + Eigen::Vector2d(-half_m, half_m)};
  }

  Eigen::Vector2d free_place_m() {
    Eigen::Vector2d low_m = plan_.room_m().front();
    Eigen::Vector2d high_m = low_m;
    for (const Eigen::Vector2d& corner_m : plan_.room_m()) {
      low_m = low_m.cwiseMin(corner_m);
      high_m = high_m.cwiseMax(corner_m);
    }
    while (true) {
      const Eigen::Vector2d share(signed_share(), signed_share());
      const Eigen::Vector2d place_m = 0.5 * (low_m + high_m + (high_m - low_m).cwiseProduct(share));
      const auto is_far_from = [&](const Pose2& start) {
        return (place_m - start.position_m()).norm() > kToStartM + 0.5 * kBoxM;
      };
      if (plan_.is_free(place_m) && plan_.clearance_m(place_m) > 0.71 * kBoxM + kToWallsM &&
          is_far_from(before_start_) && is_far_from(after_start_)) {
        return place_m;
      }
    }
  }

  FloorPlan plan_;
  std::mt19937 random_;
  std::uint32_t seed_;
  std::uint32_t runs_ = 0;
  Pose2 before_start_;
  Pose2 after_start_;
  std::vector<Eigen::Vector2d> place_m_;
};

/// What was asked and what was found.
struct Tally {
  double found = 0.0;
  double asked = 0.0;
  double false_regions = 0.0;
  double pairs = 0.0;
  double unaligned = 0.0;

  void add(const Tally& other) {
    found += other.found;
    asked += other.asked;
    false_regions += other.false_regions;
    pairs += other.pairs;
    unaligned += other.unaligned;
  }
  double share() const { return asked > 0.0 ? found / asked : 1.0; }
};

/// A box that appeared or vanished: its place in the first map's frame.
struct Expected {
  ChangeKind kind = ChangeKind::kAppeared;
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
};

bool is_at(const evaluation::ChangedRegion& region, const Expected& expected) {
  return region.kind == expected.kind &&
         (region.center_m - expected.place_m).norm() < 0.5 * kBoxM + 0.25;
}

void compare(const mapping::RasterMap& before,
             const mapping::RasterMap& after,
             const std::vector<Expected>& expected,
             Tally& tally) {
  const auto difference = evaluation::find_difference(before, after);
  ++tally.pairs;
  tally.asked += static_cast<double>(expected.size());
  if (!difference) {
    ++tally.unaligned;
    return;
  }
  for (const Expected& one : expected) {
    const auto& regions = difference->regions;
    tally.found +=
        std::any_of(
            regions.begin(), regions.end(), [&](const auto& region) { return is_at(region, one); })
            ? 1.0
            : 0.0;
  }
  for (const auto& region : difference->regions) {
    const bool hit = std::any_of(
        expected.begin(), expected.end(), [&](const Expected& one) { return is_at(region, one); });
    tally.false_regions += hit ? 0.0 : 1.0;
  }
}

/// Of one room, over the seeds.
struct Tallies {
  Tally unchanged;
  Tally put_in;
  Tally taken_out;
  Tally moved;

  void add(const Tallies& other) {
    unchanged.add(other.unchanged);
    put_in.add(other.put_in);
    taken_out.add(other.taken_out);
    moved.add(other.moved);
  }
};

void add_scene(const std::string& room, std::uint32_t seed, Tallies& tallies) {
  Scene scene(room, seed);
  const Pose2 T_map_world = scene.before_start().inverse();
  const Eigen::Vector2d first_m = T_map_world * scene.place_m(0);
  const Eigen::Vector2d second_m = T_map_world * scene.place_m(1);
  const auto empty = scene.mapped({}, false);
  const auto empty_again = scene.mapped({}, true);
  const auto one_box = scene.mapped({0}, false);
  const auto one_box_later = scene.mapped({0}, true);
  const auto moved_box = scene.mapped({1}, true);
  compare(empty, empty_again, {}, tallies.unchanged);
  compare(one_box, one_box_later, {}, tallies.unchanged);
  compare(empty, one_box_later, {{ChangeKind::kAppeared, first_m}}, tallies.put_in);
  compare(one_box, empty_again, {{ChangeKind::kVanished, first_m}}, tallies.taken_out);
  compare(one_box,
          moved_box,
          {{ChangeKind::kVanished, first_m}, {ChangeKind::kAppeared, second_m}},
          tallies.moved);
}

std::vector<Figure> figures_of(const std::string& room, const Tallies& tallies) {
  const auto runs = [](const Tally& tally) { return static_cast<std::size_t>(tally.pairs); };
  const double pairs = tallies.put_in.pairs + tallies.taken_out.pairs + tallies.moved.pairs;
  const double unaligned = tallies.unchanged.unaligned + tallies.put_in.unaligned +
                           tallies.taken_out.unaligned + tallies.moved.unaligned;
  const double false_regions =
      tallies.put_in.false_regions + tallies.taken_out.false_regions + tallies.moved.false_regions;
  return {
      {room + "_put_in_found", tallies.put_in.share(), "share", runs(tallies.put_in), {}},
      {room + "_taken_out_found", tallies.taken_out.share(), "share", runs(tallies.taken_out), {}},
      {room + "_moved_found", tallies.moved.share(), "share", runs(tallies.moved), {}},
      {room + "_false_regions_unchanged",
       tallies.unchanged.false_regions / tallies.unchanged.pairs,
       "a pair",
       runs(tallies.unchanged),
       {}},
      {room + "_false_regions_changed",
       false_regions / pairs,
       "a pair",
       static_cast<std::size_t>(pairs),
       {}},
      {room + "_not_aligned",
       unaligned / (pairs + tallies.unchanged.pairs),
       "share",
       static_cast<std::size_t>(pairs + tallies.unchanged.pairs),
       {}}};
}

/// Whether a map difference is as good as it was: bounds a little below what it does over all
/// rooms.
bool is_within_bounds(const Tallies& tallies) {
  return tallies.put_in.share() >= 0.8 && tallies.taken_out.share() >= 0.8 &&
         tallies.moved.share() >= 0.7 &&
         tallies.unchanged.false_regions <= 0.2 * tallies.unchanged.pairs;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::uint32_t seeds = 20;
  std::vector<std::string> rooms{"living_room", "l_room", "landing"};
  std::filesystem::path json;
  bool check = false;
  CLI::App app("How often a map difference finds a box that was moved, in simulated rooms");
  app.add_option("--seeds", seeds, "Run seeds 1 to this")->capture_default_str();
  app.add_option("--rooms", rooms, "Bundled rooms")->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  app.add_flag("--check", check, "Fail outside of wide bounds");
  CLI11_PARSE(app, argc, argv);
  std::vector<echomap::bench::Figure> figures;
  echomap::bench::Tallies all;
  for (const std::string& room : rooms) {
    echomap::bench::Tallies tallies;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
      echomap::bench::add_scene(room, seed, tallies);
    }
    all.add(tallies);
    for (const auto& figure : echomap::bench::figures_of(room, tallies)) {
      figures.push_back(figure);
    }
  }
  const std::vector<echomap::bench::Figure> of_all = echomap::bench::figures_of("all", all);
  figures.insert(figures.end(), of_all.begin(), of_all.end());
  echomap::bench::report(figures, json);
  return check && !echomap::bench::is_within_bounds(all) ? 1 : 0;
}
