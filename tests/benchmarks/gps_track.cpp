// SPDX-License-Identifier: MIT
#include "tests/benchmarks/gps_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/benchmarks/landmark_map_error.hpp"

namespace echomap::bench {

namespace {

constexpr int kMaxRounds = 30;

/// The number of the pose of each fix, by the cheapest course of the time stood (dynamic
/// programming over it, in periods).
class Synchronisation {
 public:
  Synchronisation(std::span<const geometry::Pose2> T_map_robots,
                  std::span<const GpsFix> fixes,
                  double period_s,
                  double max_stood_s)
      : poses_(T_map_robots),
        fixes_(fixes),
        period_s_(period_s),
        stops_(static_cast<std::size_t>(max_stood_s / period_s) + 1) {}

  std::vector<std::size_t> poses_of_fixes(const geometry::Pose2& T_gps_map) const {
    std::vector<double> cost(stops_, 0.0);
    std::vector<std::vector<std::size_t>> best_before(fixes_.size());
    for (std::size_t fix = 0; fix < fixes_.size(); ++fix) {
      // The cheapest course that has stood no longer so far.
      best_before[fix].resize(stops_);
      std::size_t best = 0;
      for (std::size_t stood = 0; stood < stops_; ++stood) {
        best = cost[stood] < cost[best] ? stood : best;
        best_before[fix][stood] = best;
      }
      std::vector<double> next(stops_);
      for (std::size_t stood = 0; stood < stops_; ++stood) {
        const Eigen::Vector2d place_m = T_gps_map * poses_[pose_of(fix, stood)].position_m();
        next[stood] =
            cost[best_before[fix][stood]] + (place_m - fixes_[fix].position_m).squaredNorm();
      }
      cost = next;
    }
    std::size_t stood =
        static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    std::vector<std::size_t> poses(fixes_.size());
    for (std::size_t fix = fixes_.size(); fix-- > 0;) {
      poses[fix] = pose_of(fix, stood);
      stood = best_before[fix][stood];
    }
    return poses;
  }

 private:
  std::size_t pose_of(std::size_t fix, std::size_t stood) const {
    const double periods = (fixes_[fix].stamp_s - fixes_.front().stamp_s) / period_s_;
    const double number = std::round(periods) - static_cast<double>(stood) + lead();
    return static_cast<std::size_t>(
        std::clamp(number, 0.0, static_cast<double>(poses_.size() - 1)));
  }
  /// The path may have begun as long before the first fix as the robot may have stood.
  double lead() const { return 0.5 * static_cast<double>(stops_); }

  std::span<const geometry::Pose2> poses_;
  std::span<const GpsFix> fixes_;
  double period_s_;
  std::size_t stops_;
};

std::vector<PlacePair> pairs_of(std::span<const geometry::Pose2> T_map_robots,
                                std::span<const GpsFix> fixes,
                                const std::vector<std::size_t>& poses) {
  std::vector<PlacePair> pairs;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    pairs.emplace_back(T_map_robots[poses[i]].position_m(), fixes[i].position_m);
  }
  return pairs;
}

GpsAgreement agreement_of(const std::vector<PlacePair>& pairs, const geometry::Pose2& T_gps_map) {
  GpsAgreement agreement;
  agreement.fixes = pairs.size();
  agreement.rmse_m = rms_m(pairs, T_gps_map);
  for (const auto& [believed, truth] : pairs) {
    const double off_m = (T_gps_map * believed - truth).norm();
    agreement.mean_m += off_m / static_cast<double>(pairs.size());
    agreement.worst_m = std::max(agreement.worst_m, off_m);
  }
  return agreement;
}

}  // namespace

GpsAgreement agreement_with_gps(std::span<const geometry::Pose2> T_map_robots,
                                std::span<const GpsFix> fixes,
                                double period_s,
                                double max_stood_s) {
  const Synchronisation synchronisation(T_map_robots, fixes, period_s, max_stood_s);
  // First by time alone, as if the robot had stood for half of that at the beginning.
  std::vector<std::size_t> poses(fixes.size());
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const double periods = (fixes[i].stamp_s - fixes.front().stamp_s) / period_s;
    poses[i] = std::min(T_map_robots.size() - 1, static_cast<std::size_t>(periods));
  }
  GpsAgreement agreement;
  agreement.rmse_m = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto pairs = pairs_of(T_map_robots, fixes, poses);
    const geometry::Pose2 T_gps_map = laid_onto(pairs);
    const GpsAgreement found = agreement_of(pairs, T_gps_map);
    if (found.rmse_m > agreement.rmse_m - 1e-6) {
      break;
    }
    agreement = found;
    poses = synchronisation.poses_of_fixes(T_gps_map);
  }
  return agreement;
}

}  // namespace echomap::bench
