// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace echomap::world {

/// A disc on the floor, metres of the world.
struct Disc {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// Somebody who comes and goes. The path may begin and end outside of the room.
struct PersonParams {
  std::vector<Eigen::Vector2d> path_m;  ///< Two points or more.
  double speed_m_per_s = 1.0;
  double radius_m = 0.2;
  double start_s = 0.0;
};

/// Walks once along a path and is gone at its end. Looks where it goes: it waits while a robot
/// stands where its next step would be, and so is never who pushes.
class Person {
 public:
  /// Throws std::invalid_argument for fewer than two points, or a speed or radius that is none.
  explicit Person(PersonParams params);

  /// Goes on for `dt_s`, at the time `now_s`, among these robots.
  void step(double dt_s, double now_s, std::span<const Disc> robots);

  /// Empty before it has come and after it has gone.
  const std::optional<Disc>& place() const { return place_; }

 private:
  bool is_blocked(const Eigen::Vector2d& there_m, std::span<const Disc> robots) const;

  PersonParams params_;
  std::size_t next_ = 1;  ///< The point of the path that it goes to.
  Eigen::Vector2d at_m_;
  std::optional<Disc> place_;
};

}  // namespace echomap::world
