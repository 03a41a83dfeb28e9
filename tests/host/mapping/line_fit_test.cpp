// SPDX-License-Identifier: MIT
#include "host/mapping/line_fit.hpp"

#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// `count` points along a wall of `length_m`, whose normal at `normal_rad` meets it `along_m`
/// before its middle.
Points wall(double normal_rad, double offset_m, double along_m, double length_m, int count) {
  const Eigen::Vector2d normal = geometry::unit_vector(normal_rad);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  Points points;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / (count - 1) - 0.5;
    points.emplace_back(offset_m * normal + (along_m + share * length_m) * along);
  }
  return points;
}

Points with_noise(Points points, double stddev_m, std::mt19937& random) {
  std::normal_distribution<double> noise_m(0.0, stddev_m);
  for (auto& point : points) {
    point += Eigen::Vector2d(noise_m(random), noise_m(random));
  }
  return points;
}

TEST(LineFit, FindsTheLineThatPointsLieOn) {
  for (const double normal_rad : {-3.0, -1.6, -0.4, 0.0, 0.7, 1.5707963, 2.9}) {
    const auto line = fit_line(wall(normal_rad, 1.5, 0.4, 2.0, 7), 0.01);
    EXPECT_NEAR(geometry::angle_between(line.normal_rad, normal_rad), 0.0, 1e-9) << normal_rad;
    EXPECT_NEAR(line.offset_m, 1.5, 1e-9) << normal_rad;
    EXPECT_NEAR(line.segment.length_m(), 2.0, 1e-9) << normal_rad;
    EXPECT_EQ(line.points, 7U);
  }
}

TEST(LineFit, TurnsAndMovesWithItsPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Points points = with_noise(wall(any(random), 2.0, any(random), 1.5, 20), 0.02, random);
    const geometry::Pose2 T_new_old(any(random), any(random), any(random));
    Points moved;
    for (const auto& point : points) {
      moved.push_back(T_new_old * point);
    }
    const auto line = fit_line(points, 0.02);
    const auto other = fit_line(moved, 0.02);
    EXPECT_LT((T_new_old * line.segment.from_m - other.segment.from_m).norm(), 1e-9) << trial;
    EXPECT_LT((T_new_old * line.segment.to_m - other.segment.to_m).norm(), 1e-9) << trial;
    EXPECT_NEAR(line.covariance(1, 1), other.covariance(1, 1), 1e-12) << trial;
  }
}

TEST(LineFit, KnowsHowSureItIs) {
  // Its own covariance against that of many fits, for walls seen head-on and from far to one side.
  constexpr int kFits = 20000;
  constexpr double kStddevM = 0.03;
  std::mt19937 random(2);
  for (const double along_m : {0.0, 1.5, -4.0}) {
    const Points true_points = wall(0.6, 2.0, along_m, 1.2, 15);
    const auto line = fit_line(true_points, kStddevM);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (int i = 0; i < kFits; ++i) {
      const auto fit = fit_line(with_noise(true_points, kStddevM, random), kStddevM);
      const Eigen::Vector2d off(fit.offset_m - 2.0, geometry::angle_between(0.6, fit.normal_rad));
      sum += off * off.transpose() / kFits;
    }
    const double scale = std::sqrt(sum(0, 0) * sum(1, 1));
    EXPECT_NEAR(line.covariance(0, 0), sum(0, 0), 0.06 * sum(0, 0)) << along_m;
    EXPECT_NEAR(line.covariance(1, 1), sum(1, 1), 0.06 * sum(1, 1)) << along_m;
    EXPECT_NEAR(line.covariance(0, 1), sum(0, 1), 0.06 * scale) << along_m;
  }
}

TEST(LineFit, TakesPointsInTwoPlaces) {
  EXPECT_THROW(fit_line({}, 0.01), std::invalid_argument);
  EXPECT_THROW(fit_line(Points{{1, 1}}, 0.01), std::invalid_argument);
  EXPECT_THROW(fit_line(Points{{1, 1}, {1, 1}}, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
