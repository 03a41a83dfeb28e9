// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ekf_slam_scaling.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "host/slam/data_association.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/joint_compatibility.hpp"
#include "tests/benchmarks/thread_clock.hpp"

namespace echomap::bench {

namespace {

constexpr std::size_t kSeenAtOnce = 10;
constexpr double kRangeStddevM = 0.05;
constexpr double kBearingStddevRad = 0.01;

/// Posts on a square lattice, two metres apart, the robot among them.
std::vector<Eigen::Vector2d> lattice_m(std::size_t landmarks) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(landmarks)));
  std::vector<Eigen::Vector2d> posts_m;
  for (std::size_t i = 0; i < landmarks; ++i) {
    posts_m.emplace_back(2.0 * static_cast<double>(i % columns) + 1.0,
                         2.0 * static_cast<double>(i / columns) + 1.0);
  }
  return posts_m;
}

slam::LandmarkSighting sighting_of(const Eigen::Vector2d& post_m, std::mt19937& random) {
  std::normal_distribution<double> normal;
  slam::LandmarkSighting seen;
  seen.value = {post_m.norm() + kRangeStddevM * normal(random),
                std::atan2(post_m.y(), post_m.x()) + kBearingStddevRad * normal(random)};
  seen.noise = Eigen::Vector2d(kRangeStddevM * kRangeStddevM, kBearingStddevRad * kBearingStddevRad)
                   .asDiagonal();
  return seen;
}

}  // namespace

EkfSlamStepCost ekf_slam_step_cost(std::size_t landmarks, int steps) {
  std::mt19937 random(1);
  const auto posts_m = lattice_m(landmarks);
  slam::EkfSlamFilter filter;
  for (const Eigen::Vector2d& post_m : posts_m) {
    filter.add(sighting_of(post_m, random));
  }
  const slam::AssociationParams association;
  EkfSlamStepCost cost;
  for (int step = 0; step < steps; ++step) {
    std::vector<slam::LandmarkSighting> seen;
    for (std::size_t i = 0; i < kSeenAtOnce; ++i) {
      seen.push_back(sighting_of(posts_m[i * posts_m.size() / kSeenAtOnce], random));
    }
    cost.move_ms += 1000.0 / steps * processor_seconds([&] {
                      filter.move(0, {}, {}, {0.001, 0.01, 0.001, 0.01});
                    });
    std::vector<slam::Candidate> pairs;
    cost.associate_ms += 1000.0 / steps * processor_seconds([&] {
                           const auto near = slam::find_candidates(
                               filter, seen, association.gate, association.max_wall_gap_m);
                           pairs = slam::jointly_compatible(filter, near, association.max_steps);
                         });
    std::vector<slam::LinearSighting> linear;
    for (const slam::Candidate& pair : pairs) {
      linear.push_back(pair.linear);
    }
    cost.update_ms += 1000.0 / steps * processor_seconds([&] { filter.update(linear); });
  }
  return cost;
}

}  // namespace echomap::bench
