// SPDX-License-Identifier: MIT
#include "tests/support/source_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/square.hpp"
#include "host/models/uniform_sample.hpp"

namespace echomap::tests {

namespace {

constexpr double kResolutionM = 0.05;
constexpr double kWallM = 0.2;

mapping::RasterMap drawn_boxes(const Eigen::Vector2d& size_m, const std::vector<SolidBox>& boxes) {
  const auto columns = static_cast<int>(std::lround((size_m.x() + 2.0 * kWallM) / kResolutionM));
  const auto rows = static_cast<int>(std::lround((size_m.y() + 2.0 * kWallM) / kResolutionM));
  mapping::RasterMap map(columns, rows, kResolutionM, {-kWallM, -kWallM});
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const bool is_solid = std::any_of(boxes.begin(), boxes.end(), [&](const SolidBox& box) {
        return box.contains(map.center_m({x, y}));
      });
      map.set({x, y}, is_solid ? mapping::CellState::kOccupied : mapping::CellState::kFree);
    }
  }
  return map;
}

std::vector<SolidBox> with_walls(std::vector<SolidBox> boxes, const Eigen::Vector2d& size_m) {
  const double right_m = size_m.x();
  const double top_m = size_m.y();
  boxes.push_back({{-kWallM, -kWallM}, {right_m + kWallM, 0.0}});
  boxes.push_back({{-kWallM, top_m}, {right_m + kWallM, top_m + kWallM}});
  boxes.push_back({{-kWallM, 0.0}, {0.0, top_m}});
  boxes.push_back({{right_m, 0.0}, {right_m + kWallM, top_m}});
  return boxes;
}

/// How much of the line from `from_m` on, by `offset_m`, is in the box (the slab method).
double length_in_m(const SolidBox& box,
                   const Eigen::Vector2d& from_m,
                   const Eigen::Vector2d& offset_m) {
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(offset_m[axis]) < 1e-12) {
      if (from_m[axis] <= box.low_m[axis] || from_m[axis] >= box.high_m[axis]) {
        return 0.0;
      }
      continue;
    }
    const double one = (box.low_m[axis] - from_m[axis]) / offset_m[axis];
    const double other = (box.high_m[axis] - from_m[axis]) / offset_m[axis];
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return std::max(0.0, last - first) * offset_m.norm();
}

}  // namespace

SourceWorld::SourceWorld(const Eigen::Vector2d& size_m, std::vector<SolidBox> boxes)
    : size_m_(size_m),
      boxes_(with_walls(std::move(boxes), size_m)),
      map_(drawn_boxes(size_m_, boxes_)) {}

bool SourceWorld::is_free(const Eigen::Vector2d& point_m, double clearance_m) const {
  return std::none_of(boxes_.begin(), boxes_.end(), [&](const SolidBox& box) {
    const Eigen::Vector2d nearest_m = point_m.cwiseMax(box.low_m).cwiseMin(box.high_m);
    return (point_m - nearest_m).norm() <= clearance_m;
  });
}

Eigen::Vector2d SourceWorld::sample_free(double clearance_m, std::mt19937& random) const {
  for (;;) {
    const double x_m = models::uniform_sample(random) * size_m_.x();
    const double y_m = models::uniform_sample(random) * size_m_.y();
    if (is_free({x_m, y_m}, clearance_m)) {
      return {x_m, y_m};
    }
  }
}

double SourceWorld::solid_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
  double solid_m = 0.0;
  for (const SolidBox& box : boxes_) {
    solid_m += length_in_m(box, from_m, to_m - from_m);
  }
  return solid_m;
}

double SourceWorld::rate(const SourceTruth& truth,
                         const Eigen::Vector2d& at_m,
                         double standoff_m) const {
  const double side = (at_m.x() / size_m_.x() + at_m.y() / size_m_.y()) - 1.0;
  const double background = truth.background * (1.0 + truth.background_slope * side);
  if (!truth.at_m) {
    return background;
  }
  const double distance_m2 = (at_m - *truth.at_m).squaredNorm() + geometry::square(standoff_m);
  const double shielding = std::exp(-truth.attenuation_per_m * solid_m(at_m, *truth.at_m));
  return background + truth.strength * shielding / distance_m2;
}

SourceWorld open_hall() {
  return SourceWorld({16.0, 12.0},
                     {{{3.0, 2.5}, {3.6, 3.1}},
                      {{7.5, 5.0}, {8.7, 5.8}},
                      {{12.0, 2.0}, {12.5, 3.5}},
                      {{4.0, 8.5}, {5.0, 9.0}},
                      {{11.0, 8.0}, {11.8, 8.8}},
                      {{14.0, 10.0}, {14.6, 10.6}}});
}

SourceWorld shielding_rooms() {
  std::vector<SolidBox> boxes;
  for (const double x_m : {4.6, 9.2}) {
    boxes.push_back({{x_m, 0.0}, {x_m + kWallM, 4.0}});
    boxes.push_back({{x_m, 6.0}, {x_m + kWallM, 10.0}});
  }
  for (const double y_m : {4.0, 5.8}) {
    double from_m = 0.0;
    for (const double door_m : {1.8, 6.6, 11.2}) {
      boxes.push_back({{from_m, y_m}, {door_m, y_m + kWallM}});
      from_m = door_m + 0.9;
    }
    boxes.push_back({{from_m, y_m}, {14.0, y_m + kWallM}});
  }
  return SourceWorld({14.0, 10.0}, boxes);
}

double sample_poisson(double mean, std::mt19937& random) {
  constexpr double kLargeMean = 16.0;
  if (mean > kLargeMean) {
    return sample_poisson(0.5 * mean, random) + sample_poisson(0.5 * mean, random);
  }
  const double end = std::exp(-mean);
  double count = 0.0;
  for (double product = models::uniform_sample(random); product > end;
       product *= models::uniform_sample(random)) {
    count += 1.0;
  }
  return count;
}

}  // namespace echomap::tests
