// SPDX-License-Identifier: MIT
#include <variant>
#include <vector>

#include <Eigen/Cholesky>

#include "host/sensors/range_scan.hpp"
#include "host/slam/landmark_slam.hpp"
#include "tests/benchmarks/brenner_arena.hpp"
#include "tests/benchmarks/ekf_slam_runs.hpp"
#include "tests/benchmarks/landmark_map_error.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

/// A landmark of the map is of the cylinder that is nearer than this.
constexpr double kMaxMatchM = 0.3;

slam::LandmarkSlamParams cylinder_params(const BrennerArena& arena) {
  slam::LandmarkSlamParams params;
  params.motion = arena.motion;
  params.start_covariance = arena.start_covariance;
  params.extraction.with_walls = false;
  params.extraction.with_corners = false;
  params.extraction.posts = mapping::CylinderDetectionParams{};
  return params;
}

/// Poses by odometry alone, from the known start on.
TruePath odometry_of(const BrennerArena& arena) {
  TruePath path;
  Pose2 T_map_robot = arena.T_map_start;
  for (const datasets::LogRecord& record : arena.records) {
    if (const auto* wheels = std::get_if<datasets::WheelIncrement>(&record)) {
      T_map_robot = T_map_robot * brenner_step(*wheels);
      if (wheels->stamp_s) {
        path.add(*wheels->stamp_s, T_map_robot);
      }
    }
  }
  return path;
}

sensors::RangeScan corrected_scan(const sensors::RangeScan& scan) {
  sensors::RangeScan corrected = scan;
  for (sensors::Beam& beam : corrected.beams) {
    if (beam.range_m) {
      *beam.range_m += kBrennerReadsShortM;
    }
  }
  return corrected;
}

void score_landmarks(const slam::EkfSlamFilter& filter,
                     const BrennerArena& arena,
                     LandmarkSlamScore& score) {
  std::vector<PlacePair> pairs;
  for (std::size_t i = 0; i < filter.landmarks().size(); ++i) {
    for (const Eigen::Vector2d& truth_m : arena.landmarks_m) {
      const Eigen::Vector2d off_m = filter.landmarks()[i].value - truth_m;
      if (off_m.norm() < kMaxMatchM) {
        pairs.emplace_back(filter.landmarks()[i].value, truth_m);
        score.landmark_nees += off_m.dot(filter.landmark_covariance(i).llt().solve(off_m));
      }
    }
  }
  score.landmarks = filter.landmarks().size();
  score.landmark_nees /= static_cast<double>(pairs.size());
  score.landmark_m = rms_m(pairs, {});
  score.aligned_landmark_m = rms_m(pairs, laid_onto(pairs));
}

}  // namespace

LandmarkSlamScore slam_brenner(const std::filesystem::path& folder) {
  const BrennerArena arena = read_brenner(folder);
  const TruePath odometry = odometry_of(arena);
  const TruePath reference = brenner_reference(arena, true);
  slam::LandmarkSlam slam(cylinder_params(arena));
  FollowTally tally;
  for (const datasets::LogRecord& record : arena.records) {
    const auto* scan = std::get_if<sensors::RangeScan>(&record);
    if (scan == nullptr || !scan->stamp_s) {
      continue;
    }
    const double stamp_s = *scan->stamp_s - kBrennerScanAgeS;
    const auto T_odom_robot = odometry.at(stamp_s);
    if (!T_odom_robot) {
      continue;
    }
    slam.add(*T_odom_robot, corrected_scan(*scan));
    if (const auto truth = reference.at(stamp_s)) {
      localization::PoseGaussian at_scanner = slam.belief();
      at_scanner.T_map_robot = at_scanner.T_map_robot * arena.T_robot_scanner;
      tally.count(at_scanner, *truth, *T_odom_robot * arena.T_robot_scanner, false);
    }
  }
  LandmarkSlamScore score;
  score.robots.push_back(tally.score(0));
  score_landmarks(slam.filter(), arena, score);
  return score;
}

}  // namespace echomap::bench
