// SPDX-License-Identifier: MIT
#include "hil_mock/world/start_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "hil_mock/world/floor_contact.hpp"
#include "hil_mock/world/noise.hpp"

namespace echomap::world {
namespace {

constexpr double kLatticeM = 0.05;
constexpr double kUnreachedM = std::numeric_limits<double>::infinity();
/// Sets of places that are begun before there is none.
constexpr int kAttempts = 100;

/// The floor as points 5 cm apart, and how long the ways between them are.
class FloorLattice {
 public:
  FloorLattice(const FloorPlan& plan, double radius_m) {
    Eigen::AlignedBox2d room;
    for (const Eigen::Vector2d& corner_m : plan.room_m()) {
      room.extend(corner_m);
    }
    origin_m_ = room.min();
    width_ = static_cast<int>(std::floor(room.sizes().x() / kLatticeM)) + 1;
    height_ = static_cast<int>(std::floor(room.sizes().y() / kLatticeM)) + 1;
    for (int i = 0; i < width_ * height_; ++i) {
      const Eigen::Vector2d point_m = point(i);
      const bool is_free = plan.is_free(point_m);
      rooms_m_.push_back(
          is_free ? std::min(plan.clearance_m(point_m), hole_distance_m(plan, point_m)) : 0.0);
    }
    radius_m_ = radius_m;
  }

  int size() const { return width_ * height_; }
  Eigen::Vector2d point(int index) const {
    return origin_m_ + kLatticeM * Eigen::Vector2d(index % width_, index / width_);
  }
  /// From that point to the next wall or hole.
  double room_m(int index) const { return rooms_m_[static_cast<std::size_t>(index)]; }

  /// To every point, for a robot's middle (Dijkstra 1959).
  std::vector<double> paths_m(const Eigen::Vector2d& from_m) const {
    std::vector<double> lengths_m(static_cast<std::size_t>(size()), kUnreachedM);
    using Open = std::pair<double, int>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    open_near(from_m, lengths_m, open);
    while (!open.empty()) {
      const auto [path_m, index] = open.top();
      open.pop();
      if (path_m > lengths_m[static_cast<std::size_t>(index)]) {
        continue;
      }
      for (const auto& [dx, dy] : kSteps) {
        if (const auto next = neighbour(index, dx, dy)) {
          const double longer_m = path_m + kLatticeM * std::hypot(dx, dy);
          if (longer_m < lengths_m[static_cast<std::size_t>(*next)]) {
            lengths_m[static_cast<std::size_t>(*next)] = longer_m;
            open.emplace(longer_m, *next);
          }
        }
      }
    }
    return lengths_m;
  }

 private:
  static constexpr std::array<std::pair<int, int>, 16> kSteps{{{1, 0},
                                                               {-1, 0},
                                                               {0, 1},
                                                               {0, -1},
                                                               {1, 1},
                                                               {1, -1},
                                                               {-1, 1},
                                                               {-1, -1},
                                                               {2, 1},
                                                               {2, -1},
                                                               {-2, 1},
                                                               {-2, -1},
                                                               {1, 2},
                                                               {1, -2},
                                                               {-1, 2},
                                                               {-1, -2}}};

  template <class Open>
  void open_near(const Eigen::Vector2d& from_m, std::vector<double>& lengths_m, Open& open) const {
    for (int i = 0; i < size(); ++i) {
      const double path_m = (point(i) - from_m).norm();
      if (path_m <= 2.0 * kLatticeM && room_m(i) >= radius_m_) {
        lengths_m[static_cast<std::size_t>(i)] = path_m;
        open.emplace(path_m, i);
      }
    }
  }

  std::optional<int> neighbour(int index, int dx, int dy) const {
    const int x = index % width_ + dx;
    const int y = index / width_ + dy;
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || room_m(y * width_ + x) < radius_m_) {
      return std::nullopt;
    }
    return y * width_ + x;
  }

  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  int width_ = 0;
  int height_ = 0;
  double radius_m_ = 0.0;
  std::vector<double> rooms_m_;
};

/// Draws places one after the other, each far enough from those before.
class StartDraw {
 public:
  StartDraw(const FloorPlan& plan, const StartRules& rules, std::uint32_t seed)
      : lattice_(plan, rules.radius_m), rules_(rules), noise_(seed, NoisePurpose::kStarts) {
    const auto paths_m = lattice_.paths_m(plan.T_world_start().position_m());
    for (int i = 0; i < lattice_.size(); ++i) {
      if (paths_m[static_cast<std::size_t>(i)] < kUnreachedM &&
          lattice_.room_m(i) >= rules.radius_m + rules.clearance_m) {
        places_.push_back(i);
      }
    }
  }

  /// Fewer than wanted where the last ones found no place.
  std::vector<geometry::Pose2> attempt(const std::optional<geometry::Pose2>& first) {
    std::vector<geometry::Pose2> starts;
    std::vector<int> open = places_;
    while (starts.size() < rules_.robots) {
      if (starts.empty() && first) {
        starts.push_back(*first);
      } else if (open.empty()) {
        return starts;
      } else {
        starts.push_back(draw(open));
      }
      if (starts.size() < rules_.robots) {
        leave_out_near(starts.back().position_m(), open);
      }
    }
    return starts;
  }

 private:
  geometry::Pose2 draw(const std::vector<int>& open) {
    const auto chosen =
        static_cast<std::size_t>(noise_.uniform() * static_cast<double>(open.size()));
    const Eigen::Vector2d place_m = lattice_.point(open[chosen]);
    return {place_m.x(), place_m.y(), 2.0 * std::numbers::pi * noise_.uniform()};
  }

  void leave_out_near(const Eigen::Vector2d& place_m, std::vector<int>& open) const {
    const auto paths_m = lattice_.paths_m(place_m);
    std::erase_if(
        open, [&](int index) { return paths_m[static_cast<std::size_t>(index)] < rules_.apart_m; });
  }

  FloorLattice lattice_;
  StartRules rules_;
  NoiseStream noise_;
  std::vector<int> places_;
};

}  // namespace

std::vector<geometry::Pose2> draw_starts(const FloorPlan& plan,
                                         const StartRules& rules,
                                         const std::optional<geometry::Pose2>& first,
                                         std::uint32_t seed) {
  StartDraw draw(plan, rules, seed);
  for (int i = 0; i < kAttempts; ++i) {
    std::vector<geometry::Pose2> starts = draw.attempt(first);
    if (starts.size() == rules.robots) {
      return starts;
    }
  }
  throw std::invalid_argument("there is no place for " + std::to_string(rules.robots) +
                              " robots with a way of " + std::to_string(rules.apart_m) +
                              " m between any two");
}

}  // namespace echomap::world
