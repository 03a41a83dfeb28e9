// SPDX-License-Identifier: MIT
#include "host/time/lower_hull.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace echomap::time {
namespace {

/// Points over the line of rate 1, at random distances of up to 20 ms.
std::vector<ClockPoint> random_points(int count) {
  std::mt19937 random(3);
  std::vector<ClockPoint> points;
  std::int64_t robot_us = 1'000'000;
  for (int i = 0; i < count; ++i) {
    robot_us += 1 + static_cast<std::int64_t>(random() % 20'000);
    const auto delay_us = static_cast<std::int64_t>(random() % 20'000);
    points.push_back({robot_us, robot_us + 500'000 + delay_us});
  }
  return points;
}

double height_us(const ClockPoint& point, double rate) {
  return static_cast<double>(point.host_us) - rate * static_cast<double>(point.robot_us);
}

TEST(LowerHull, TouchesTheLowestPointForEveryRate) {
  const auto points = random_points(2000);
  LowerHull hull;
  for (const ClockPoint& point : points) {
    hull.add(point);
  }
  EXPECT_LT(hull.vertices().size(), 60U);
  for (const double rate : {0.994, 0.9999, 1.0, 1.00002, 1.006}) {
    const auto lowest = std::ranges::min(
        points, {}, [rate](const ClockPoint& point) { return height_us(point, rate); });
    EXPECT_EQ(hull.touched_by(rate).robot_us, lowest.robot_us) << rate;
  }
}

TEST(SlidingLowerHull, IsTheHullOfItsWindow) {
  constexpr std::int64_t kWindowUs = 8'000'000;
  const auto points = random_points(3000);
  SlidingLowerHull sliding(kWindowUs);
  LowerHull whole;
  for (const ClockPoint& point : points) {
    sliding.add(point);
    if (points.back().robot_us - point.robot_us < kWindowUs / 2) {
      whole.add(point);
    }
  }
  const LowerHull hull = sliding.hull();
  const auto oldest_us = hull.vertices().front().robot_us;
  EXPECT_NEAR(static_cast<double>(points.back().robot_us - oldest_us), kWindowUs, 0.05 * kWindowUs);
  EXPECT_EQ(hull.vertices().back().robot_us, points.back().robot_us);
  EXPECT_EQ(hull.touched_by(1.006).robot_us, whole.touched_by(1.006).robot_us);
}

TEST(SlidingLowerHull, LeavesOutWhatWasOvertaken) {
  SlidingLowerHull sliding(1'000'000);
  sliding.add({2000, 7000});
  sliding.add({1000, 7100});
  sliding.add({2000, 7200});
  EXPECT_EQ(sliding.hull().vertices().size(), 1U);
}

TEST(SlidingLowerHull, KeepsItsMemoryWhateverComes) {
  SlidingLowerHull sliding(1'000'000);
  for (std::int64_t i = 0; i < 100'000; ++i) {
    sliding.add({i, i * i});
  }
  EXPECT_LE(sliding.hull().vertices().size(), 129U * 256U);
}

TEST(SlidingLowerHull, ExpectsTheExcessOfARandomMinimum) {
  std::mt19937 random(4);
  double sum_of_ratios = 0.0;
  for (int run = 0; run < 50; ++run) {
    SlidingLowerHull sliding(60'000'000);
    for (std::int64_t i = 0; i < 3000; ++i) {
      sliding.add({i * 20'000, i * 20'000 + static_cast<std::int64_t>(random() % 16'000)});
    }
    sum_of_ratios += sliding.expected_excess_us(1.0) / (16'000.0 / 3000.0);
  }
  EXPECT_NEAR(sum_of_ratios / 50.0, 1.0, 0.3);
}

}  // namespace
}  // namespace echomap::time
