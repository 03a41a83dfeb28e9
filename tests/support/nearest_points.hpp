// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace echomap::tests {

/// One of the points that a NearestPoints was made of.
struct Neighbour {
  std::size_t index = 0;
  double distance_m = 0.0;
};

/// Finds the nearest of many points without going through all of them: a k-d tree (nanoflann).
class NearestPoints {
 public:
  /// Keeps a copy of the points.
  explicit NearestPoints(std::vector<Eigen::Vector2d> points_m);
  ~NearestPoints();
  NearestPoints(NearestPoints&&) noexcept;
  NearestPoints& operator=(NearestPoints&&) noexcept;

  /// Empty where there are no points.
  std::optional<Neighbour> nearest(const Eigen::Vector2d& place_m) const;
  /// Up to `count` neighbours, the nearest first.
  std::vector<Neighbour> nearest(const Eigen::Vector2d& place_m, std::size_t count) const;

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace echomap::tests
