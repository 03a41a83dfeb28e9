// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "host/datasets/brenner_log.hpp"
#include "host/datasets/companion_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/localization/landmark_matching.hpp"
#include "host/localization/pose_ekf.hpp"
#include "host/mapping/cylinder_detection.hpp"
#include "host/sensors/odometry.hpp"
#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/true_path.hpp"
#include "tests/support/log_files.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

const Pose2 T_robot_scanner(0.030, 0.0, 0.0);
/// The scanner at the log's first scan, as its README gives it.
const Pose2 T_map_scanner_start(1.850, 1.897, geometry::radians(213.0));
/// A scan has taken 0.1 s when it is stamped.
constexpr double kScanAgeS = 0.1;
/// The scanner reads short by that: bearings alone place the robot where ranges are so much longer.
constexpr double kReadsShortM = 0.085;
constexpr double kFarthestMatchM = 0.3;
/// What the reference is too large by and around where, fitted to the filter's path.
constexpr double kReferenceScale = 0.92;
const Eigen::Vector2d reference_middle_m(1.28, 1.20);

std::vector<Eigen::Vector2d> read_landmarks(const std::filesystem::path& path) {
  std::vector<Eigen::Vector2d> landmarks_m;
  datasets::CompanionLines lines(path);
  while (auto fields = lines.next()) {
    fields->skip(2);
    const double x_m = fields->number("x") / 1000.0;
    const double y_m = fields->number("y") / 1000.0;
    landmarks_m.emplace_back(x_m, y_m);
  }
  return landmarks_m;
}

TruePath reference_of(const std::vector<datasets::LogRecord>& records, bool scaled) {
  TruePath path;
  for (const auto& given : tests::only<datasets::GivenPosition>(records)) {
    const Eigen::Vector2d off_m = given.position_m - reference_middle_m;
    const Eigen::Vector2d at_m = reference_middle_m + (scaled ? kReferenceScale : 1.0) * off_m;
    if (given.stamp_s) {
      path.add(*given.stamp_s, {at_m.x(), at_m.y(), 0.0});
    }
  }
  return path;
}

localization::PoseEkf started_filter(const Pose2& T_map_robot) {
  localization::PoseEkfParams params;
  params.motion.turn_by_turn = 0.01;
  params.motion.turn_by_drive_rad2_per_m2 = 0.01;
  params.motion.drive_by_drive = 0.01;
  const Eigen::Vector3d variance(0.01 * 0.01, 0.01 * 0.01, 0.03 * 0.03);
  return localization::PoseEkf({T_map_robot, variance.asDiagonal()}, params);
}

void look(const datasets::RangeScan& scan,
          const std::vector<Eigen::Vector2d>& landmarks_m,
          localization::PoseEkf& filter) {
  std::vector<Eigen::Vector2d> points_m;
  for (const datasets::Beam& beam : scan.beams) {
    if (beam.range_m) {
      points_m.push_back(*beam.range_m * geometry::unit_vector(beam.bearing_rad));
    }
  }
  for (const Eigen::Vector2d& center_m : mapping::find_cylinders(points_m)) {
    localization::LandmarkObservation seen;
    seen.range_m = center_m.norm() + kReadsShortM;
    seen.bearing_rad = std::atan2(center_m.y(), center_m.x());
    const auto landmark =
        localization::match_landmark(filter.belief().T_map_robot,
                                     scan.T_robot_sensor,
                                     seen.range_m * geometry::unit_vector(seen.bearing_rad),
                                     landmarks_m,
                                     kFarthestMatchM);
    if (landmark && scan.stamp_s) {
      seen.stamp_s = *scan.stamp_s - kScanAgeS;
      seen.landmark_m = landmarks_m[*landmark];
      seen.T_robot_sensor = scan.T_robot_sensor;
      filter.update(seen);
    }
  }
}

}  // namespace

FollowScore follow_brenner(const std::filesystem::path& folder, bool scaled) {
  const auto landmarks_m = read_landmarks(folder / "robot_arena_landmarks.txt");
  const auto records =
      tests::records_of(*datasets::open_brenner_log(folder / "robot4_scan.txt.gz"));
  const TruePath reference = reference_of(records, scaled);
  const Pose2 T_map_start = T_map_scanner_start * T_robot_scanner.inverse();
  localization::PoseEkf filter = started_filter(T_map_start);
  FollowTally tally;
  Pose2 T_odom_robot;
  for (const datasets::LogRecord& record : records) {
    if (const auto* scan = std::get_if<datasets::RangeScan>(&record)) {
      look(*scan, landmarks_m, filter);
    } else if (const auto* wheels = std::get_if<datasets::WheelIncrement>(&record)) {
      const double turn_rad = (wheels->right_m - wheels->left_m) / wheels->track_m;
      T_odom_robot =
          T_odom_robot * sensors::arc_step(0.5 * (wheels->left_m + wheels->right_m), turn_rad);
      if (!wheels->stamp_s) {
        continue;
      }
      filter.move(*wheels->stamp_s, T_odom_robot);
      if (const auto truth = reference.at(*wheels->stamp_s)) {
        localization::PoseGaussian at_scanner = filter.belief();
        at_scanner.T_map_robot = at_scanner.T_map_robot * T_robot_scanner;
        tally.count(at_scanner, *truth, T_map_start * T_odom_robot * T_robot_scanner, false);
      }
    }
  }
  return tally.score(filter.count(localization::EkfOutcome::kGated));
}

}  // namespace echomap::bench
