// SPDX-License-Identifier: MIT
#include "tests/benchmarks/spoilt_log.hpp"

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "host/datasets/open_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/models/odometry_motion.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

using geometry::Pose2;

constexpr double kRelationDistanceM = 1.0;
constexpr double kRevisitTravelledM = 10.0;
constexpr double kRevisitM = 1.0;

struct TakenScan {
  Pose2 T_map_robot;
  sensors::RangeScan scan;
};

std::vector<TakenScan> read_scans(const std::filesystem::path& path, std::size_t every) {
  std::vector<TakenScan> scans;
  Pose2 T_map_robot;
  std::size_t count = 0;
  const auto reader = datasets::open_log(path, "carmen");
  while (auto record = reader->next()) {
    if (const auto* given = std::get_if<datasets::GivenPose>(&*record)) {
      T_map_robot = given->T_map_robot;
    } else if (auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      if (count++ % every == 0) {
        scans.push_back({T_map_robot, std::move(*scan)});
      }
    }
  }
  return scans;
}

/// Wheels that are off, always by the same, and noise.
class BadOdometry {
 public:
  explicit BadOdometry(std::mt19937& random)
      : random_(&random),
        drive_gain_(1.0 + 0.03 * normal_(random)),
        turn_gain_(1.0 + 0.1 * normal_(random)),
        drift_rad_per_m_(geometry::radians(2.0) * normal_(random)) {}

  Pose2 step(const Pose2& T_before_after) {
    const models::OdometryStep step = models::odometry_step({}, T_before_after);
    const double travelled_m = std::abs(step.drive_m);
    const double root_m = std::sqrt(travelled_m);
    const double drive_m = step.drive_m * drive_gain_ + 0.02 * root_m * normal_(*random_);
    const double drift_rad =
        drift_rad_per_m_ * travelled_m + geometry::radians(1.0) * root_m * normal_(*random_);
    return Pose2(0.0, 0.0, step.turn_before_rad * turn_gain_ + drift_rad / 2.0) *
           Pose2(drive_m, 0.0, step.turn_after_rad * turn_gain_ + drift_rad / 2.0);
  }

 private:
  std::mt19937* random_;
  std::normal_distribution<double> normal_;
  double drive_gain_;
  double turn_gain_;
  double drift_rad_per_m_;
};

std::vector<double> offsets_m(const std::vector<TakenScan>& scans) {
  std::vector<double> offsets_m{0.0};
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const Eigen::Vector2d step_m =
        scans[i].T_map_robot.position_m() - scans[i - 1].T_map_robot.position_m();
    offsets_m.push_back(offsets_m.back() + step_m.norm());
  }
  return offsets_m;
}

/// The nearest of the places long before; empty where none is near.
std::optional<std::size_t> revisited(const std::vector<TakenScan>& scans,
                                     const std::vector<double>& offsets_m,
                                     std::size_t now) {
  std::optional<std::size_t> nearest;
  double min_m = kRevisitM;
  for (std::size_t i = 0; i < now && offsets_m[i] <= offsets_m[now] - kRevisitTravelledM; ++i) {
    const double away_m =
        (scans[i].T_map_robot.position_m() - scans[now].T_map_robot.position_m()).norm();
    if (away_m < min_m) {
      min_m = away_m;
      nearest = i;
    }
  }
  return nearest;
}

std::vector<evaluation::PoseRelation> relations_of(const std::vector<TakenScan>& scans) {
  const std::vector<double> offsets_m = bench::offsets_m(scans);
  std::vector<evaluation::PoseRelation> relations;
  const auto add = [&](std::size_t from, std::size_t to) {
    relations.push_back({from, to, scans[from].T_map_robot.inverse() * scans[to].T_map_robot});
  };
  std::size_t last = 0;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (offsets_m[i] - offsets_m[last] < kRelationDistanceM) {
      continue;
    }
    add(last, i);
    if (const auto before = revisited(scans, offsets_m, i)) {
      add(*before, i);
    }
    last = i;
  }
  return relations;
}

}  // namespace

std::optional<RelationLog> read_spoilt_log(const std::string& file,
                                           std::size_t every,
                                           std::mt19937& random) {
  const auto path = tests::real_data(file + ".log.gz");
  if (!std::filesystem::exists(path)) {
    return std::nullopt;
  }
  std::vector<TakenScan> scans = read_scans(path, every);
  RelationLog log{{}, relations_of(scans)};
  BadOdometry odometry(random);
  Pose2 T_odom_robot;
  Pose2 T_map_before = scans.front().T_map_robot;
  for (TakenScan& taken : scans) {
    T_odom_robot = T_odom_robot * odometry.step(T_map_before.inverse() * taken.T_map_robot);
    T_map_before = taken.T_map_robot;
    log.records.emplace_back(datasets::OdometryPose{taken.scan.stamp_s, T_odom_robot});
    log.records.emplace_back(std::move(taken.scan));
  }
  return log;
}

}  // namespace echomap::bench
