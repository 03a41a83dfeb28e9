// SPDX-License-Identifier: MIT
#include "tests/benchmarks/localization_soak.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/geometry/angle.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/range_table_model.hpp"
#include "tests/benchmarks/room_runs.hpp"
#include "tests/support/expect_pose_estimate.hpp"
#include "tests/support/resident_memory.hpp"

namespace echomap::bench {
namespace {

using geometry::Pose2;
using localization::LocalizationStatus;
using localization::PoseBelief;

constexpr char kRoom[] = "living_room";
constexpr double kOdometryHz = 100.0;
constexpr double kMPerS = 0.2;
constexpr double kRadPerS = 1.0;
constexpr double kSweepS = 2.0;
constexpr int kDirections = 24;
constexpr double kMaxGrownMb = 8.0;

bool is_finite(const PoseBelief& belief) {
  return std::all_of(belief.hypotheses.begin(), belief.hypotheses.end(), [](const auto& one) {
    return one.T_map_robot.position_m().allFinite() && one.covariance.allFinite() &&
           std::isfinite(one.T_map_robot.heading_rad()) && std::isfinite(one.probability);
  });
}

class Soak {
 public:
  explicit Soak(std::uint32_t seed)
      : model_(localization::RangeTable(map_of_room(kRoom), kSonar),
               models::BeamModel(models::sonar_cone_returns())),
        localizer_(model_, {}, std::mt19937(seed)),
        robot_(kRoom, seed) {
    localizer_.update(robot_.T_odom_robot(), {});
    localizer_.start_at(robot_.T_map_robot(), 0.05, 0.05);
    score_.min_particles = localizer_.particles().size();
  }

  void stop_after_a_distance() {
    const Pose2 T_odom_before = robot_.T_odom_robot();
    const bool was_right = is_right();
    robot_.drive();
    const auto step = models::odometry_step(T_odom_before, robot_.T_odom_robot());
    Pose2 T_odom_robot = T_odom_before;
    T_odom_robot = glide(T_odom_robot, {0.0, 0.0, step.turn_before_rad}, kRadPerS);
    T_odom_robot = glide(T_odom_robot, {step.drive_m, 0.0, 0.0}, kMPerS);
    T_odom_robot = glide(T_odom_robot, {0.0, 0.0, step.turn_after_rad}, kRadPerS);
    rest(T_odom_robot, kSweepS);
    const PoseBelief& belief = localizer_.update(robot_.T_odom_robot(), robot_.listen(kDirections));
    note(belief);
    ++score_.stops;
    score_.right += is_right() ? 1 : 0;
    score_.false_alarms += was_right && belief.status == LocalizationStatus::kLost ? 1 : 0;
  }

  SoakScore score() const {
    SoakScore score = score_;
    score.hours = static_cast<double>(score.updates) / kOdometryHz / 3600.0;
    return score;
  }

 private:
  bool is_right() const {
    return tests::is_estimated_near(
        localizer_.belief(), robot_.T_map_robot(), 0.15, geometry::radians(10.0));
  }
  void note(const PoseBelief& belief) {
    score_.not_finite += is_finite(belief) ? 0 : 1;
    score_.min_particles = std::min(score_.min_particles, localizer_.particles().size());
  }
  void tell(const Pose2& T_odom_robot) {
    note(localizer_.update(T_odom_robot, {}));
    ++score_.updates;
  }
  Pose2 glide(const Pose2& from, const Pose2& T_before_after, double speed) {
    const double length =
        T_before_after.position_m().norm() + std::abs(T_before_after.heading_rad());
    const int parts = std::max(1, static_cast<int>(std::ceil(length / speed * kOdometryHz)));
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      tell(from * Pose2(share * T_before_after.x_m(), 0.0, share * T_before_after.heading_rad()));
    }
    return from * T_before_after;
  }
  void rest(const Pose2& T_odom_robot, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * kOdometryHz); ++i) {
      tell(T_odom_robot);
    }
  }

  localization::RangeTableModel model_;
  localization::MonteCarloLocalizer localizer_;
  RoomRobot robot_;
  SoakScore score_;
};

}  // namespace

bool SoakScore::holds() const {
  return not_finite == 0 && min_particles > 0 && grown_mb <= kMaxGrownMb && right >= 0.95 * stops &&
         false_alarms <= hours;
}

SoakScore soak_localizer(double hours, std::uint32_t seed) {
  Soak soak(seed);
  std::optional<double> early_mb;
  double grown_mb = 0.0;
  while (soak.score().hours < hours) {
    soak.stop_after_a_distance();
    if (soak.score().hours >= 0.1 * hours) {
      early_mb = early_mb ? early_mb : tests::resident_mb();
      grown_mb = std::max(grown_mb, tests::resident_mb() - *early_mb);
    }
  }
  SoakScore score = soak.score();
  score.grown_mb = grown_mb;
  return score;
}

std::vector<Figure> soak_figures(const SoakScore& score) {
  const auto stops = static_cast<std::size_t>(score.stops);
  return {{"false_alarms_per_hour", score.false_alarms / score.hours, "1/h", stops, {}},
          {"soak_hours", score.hours, "h", 1, {}},
          {"soak_right", static_cast<double>(score.right) / score.stops, "1", stops, {}},
          {"soak_not_finite", static_cast<double>(score.not_finite), "", score.updates, {}},
          {"soak_min_particles", static_cast<double>(score.min_particles), "", stops, {}},
          {"soak_grown_mb", score.grown_mb, "MB", 1, {}}};
}

}  // namespace echomap::bench
