// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "host/geometry/unit_vector.hpp"
#include "host/localization/landmark_matching.hpp"
#include "host/localization/pose_ekf.hpp"
#include "host/mapping/cylinder_detection.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/benchmarks/brenner_arena.hpp"
#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

constexpr double kMaxMatchM = 0.3;
localization::PoseEkf started_filter(const BrennerArena& arena) {
  localization::PoseEkfParams params;
  params.motion = arena.motion;
  return localization::PoseEkf({arena.T_map_start, arena.start_covariance}, params);
}

void look(const sensors::RangeScan& scan,
          const std::vector<Eigen::Vector2d>& landmarks_m,
          localization::PoseEkf& filter) {
  std::vector<Eigen::Vector2d> points_m;
  for (const sensors::Beam& beam : scan.beams) {
    if (beam.range_m) {
      points_m.push_back(*beam.range_m * geometry::unit_vector(beam.bearing_rad));
    }
  }
  for (const Eigen::Vector2d& center_m : mapping::find_cylinders(points_m)) {
    localization::LandmarkObservation seen;
    seen.range_m = center_m.norm() + kBrennerReadsShortM;
    seen.bearing_rad = std::atan2(center_m.y(), center_m.x());
    const auto landmark =
        localization::match_landmark(filter.belief().T_map_robot,
                                     scan.T_robot_sensor,
                                     seen.range_m * geometry::unit_vector(seen.bearing_rad),
                                     landmarks_m,
                                     kMaxMatchM);
    if (landmark && scan.stamp_s) {
      seen.stamp_s = *scan.stamp_s - kBrennerScanAgeS;
      seen.landmark_m = landmarks_m[*landmark];
      seen.T_robot_sensor = scan.T_robot_sensor;
      filter.update(seen);
    }
  }
}

}  // namespace

FollowScore follow_brenner(const std::filesystem::path& folder, bool scaled) {
  const BrennerArena arena = read_brenner(folder);
  const TruePath reference = brenner_reference(arena, scaled);
  localization::PoseEkf filter = started_filter(arena);
  FollowTally tally;
  Pose2 T_odom_robot;
  for (const datasets::LogRecord& record : arena.records) {
    if (const auto* scan = std::get_if<sensors::RangeScan>(&record)) {
      look(*scan, arena.landmarks_m, filter);
    } else if (const auto* wheels = std::get_if<datasets::WheelIncrement>(&record)) {
      T_odom_robot = T_odom_robot * brenner_step(*wheels);
      if (!wheels->stamp_s) {
        continue;
      }
      filter.move(*wheels->stamp_s, T_odom_robot);
      if (const auto truth = reference.at(*wheels->stamp_s)) {
        localization::PoseGaussian at_scanner = filter.belief();
        at_scanner.T_map_robot = at_scanner.T_map_robot * arena.T_robot_scanner;
        tally.count(
            at_scanner, *truth, arena.T_map_start * T_odom_robot * arena.T_robot_scanner, false);
      }
    }
  }
  return tally.score(filter.count(localization::EkfOutcome::kGated));
}

}  // namespace echomap::bench
