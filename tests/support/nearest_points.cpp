// SPDX-License-Identifier: MIT
#include "tests/support/nearest_points.hpp"

#include <algorithm>
#include <cmath>

#include <nanoflann.hpp>

namespace echomap::tests {

class NearestPoints::Tree {
 public:
  explicit Tree(std::vector<Eigen::Vector2d> points_m)
      : table_{std::move(points_m)}, tree_(2, table_) {}

  std::vector<Neighbour> nearest(const Eigen::Vector2d& place_m, std::size_t count) const {
    std::vector<std::size_t> indices(std::min(count, table_.points_m.size()));
    std::vector<double> squares_m2(indices.size());
    if (indices.empty()) {
      return {};
    }
    tree_.knnSearch(place_m.data(), indices.size(), indices.data(), squares_m2.data());
    std::vector<Neighbour> neighbours;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      neighbours.push_back({indices[i], std::sqrt(squares_m2[i])});
    }
    return neighbours;
  }

 private:
  /// The points as nanoflann asks for them.
  struct PointTable {
    std::vector<Eigen::Vector2d> points_m;

    std::size_t kdtree_get_point_count() const { return points_m.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t axis) const {
      return points_m[index][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
  };

  using KdTree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointTable>,
                                          PointTable,
                                          2,
                                          std::size_t>;

  PointTable table_;
  KdTree tree_;
};

NearestPoints::NearestPoints(std::vector<Eigen::Vector2d> points_m)
    : tree_(std::make_unique<Tree>(std::move(points_m))) {}

NearestPoints::~NearestPoints() = default;
NearestPoints::NearestPoints(NearestPoints&&) noexcept = default;
NearestPoints& NearestPoints::operator=(NearestPoints&&) noexcept = default;

std::optional<Neighbour> NearestPoints::nearest(const Eigen::Vector2d& place_m) const {
  const auto found = tree_->nearest(place_m, 1);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<Neighbour> NearestPoints::nearest(const Eigen::Vector2d& place_m,
                                              std::size_t count) const {
  return tree_->nearest(place_m, count);
}

}  // namespace echomap::tests
