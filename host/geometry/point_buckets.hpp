// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace echomap::geometry {

/// A number for the square, of `edge_m`, of a lattice that a point lies in, or for the one so many
/// squares beside it.
inline std::int64_t square_key(const Eigen::Vector2d& point_m,
                               double edge_m,
                               int dx = 0,
                               int dy = 0) {
  const auto x = static_cast<std::int64_t>(std::floor(point_m.x() / edge_m)) + dx;
  const auto y = static_cast<std::int64_t>(std::floor(point_m.y() / edge_m)) + dy;
  return x * (std::int64_t{1} << 32) + y;
}

/// Values by where they are, hashed by squares of `edge_m`: those near a point are found without a
/// look at the others.
template <class Value>
class PointBuckets {
 public:
  explicit PointBuckets(double edge_m) : edge_m_(edge_m) {}

  void add(const Eigen::Vector2d& point_m, Value value) {
    buckets_[square_key(point_m, edge_m_)].push_back(std::move(value));
  }

  /// Calls `visit(value)` for all values within `edge_m` of the point, and for some beyond.
  template <class Visit>
  void visit_near(const Eigen::Vector2d& point_m, Visit&& visit) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto bucket = buckets_.find(square_key(point_m, edge_m_, dx, dy));
        if (bucket != buckets_.end()) {
          std::for_each(bucket->second.begin(), bucket->second.end(), visit);
        }
      }
    }
  }

 private:
  double edge_m_;
  std::unordered_map<std::int64_t, std::vector<Value>> buckets_;
};

}  // namespace echomap::geometry
