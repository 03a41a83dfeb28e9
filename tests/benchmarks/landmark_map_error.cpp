// SPDX-License-Identifier: MIT
#include "tests/benchmarks/landmark_map_error.hpp"

#include <cmath>

#include "host/geometry/segment.hpp"

namespace echomap::bench {

geometry::Pose2 laid_onto(std::span<const PlacePair> pairs) {
  Eigen::Vector2d believed_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d true_m = Eigen::Vector2d::Zero();
  for (const auto& [believed, truth] : pairs) {
    believed_m += believed / static_cast<double>(pairs.size());
    true_m += truth / static_cast<double>(pairs.size());
  }
  double cosine = 0.0;
  double sine = 0.0;
  for (const auto& [believed, truth] : pairs) {
    cosine += (believed - believed_m).dot(truth - true_m);
    sine += geometry::cross(believed - believed_m, truth - true_m);
  }
  const geometry::Pose2 turn(0.0, 0.0, std::atan2(sine, cosine));
  const Eigen::Vector2d shift_m = true_m - turn * believed_m;
  return {shift_m.x(), shift_m.y(), turn.heading_rad()};
}

double rms_m(std::span<const PlacePair> pairs, const geometry::Pose2& T_true_believed) {
  double squares_m2 = 0.0;
  for (const auto& [believed, truth] : pairs) {
    squares_m2 += (T_true_believed * believed - truth).squaredNorm();
  }
  return std::sqrt(squares_m2 / static_cast<double>(pairs.size()));
}

}  // namespace echomap::bench
