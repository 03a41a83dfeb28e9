// SPDX-License-Identifier: MIT
#include "tests/benchmarks/brenner_arena.hpp"

#include "host/datasets/brenner_log.hpp"
#include "host/datasets/companion_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"
#include "tests/support/log_files.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

/// The scanner at the log's first scan, as its README gives it.
const Pose2 T_map_scanner_start(1.850, 1.897, geometry::radians(213.0));
/// What the reference is too large by and around where, fitted to the path of a filter that knows
/// the cylinders.
constexpr double kReferenceScale = 0.92;
const Eigen::Vector2d reference_middle_m(1.28, 1.20);

std::vector<Eigen::Vector2d> read_cylinders(const std::filesystem::path& path) {
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

}  // namespace

BrennerArena read_brenner(const std::filesystem::path& folder) {
  BrennerArena arena;
  arena.landmarks_m = read_cylinders(folder / "robot_arena_landmarks.txt");
  arena.T_robot_scanner = Pose2(0.030, 0.0, 0.0);
  arena.T_map_start = T_map_scanner_start * arena.T_robot_scanner.inverse();
  arena.start_covariance = Eigen::Vector3d(0.01 * 0.01, 0.01 * 0.01, 0.03 * 0.03).asDiagonal();
  arena.motion.alpha1 = 0.01;
  arena.motion.alpha2_rad2_per_m2 = 0.01;
  arena.motion.alpha3 = 0.01;
  arena.records = tests::records_of(*datasets::open_brenner_log(folder / "robot4_scan.txt.gz"));
  return arena;
}

TruePath brenner_reference(const BrennerArena& arena, bool scaled) {
  TruePath path;
  for (const auto& given : tests::only<datasets::GivenPosition>(arena.records)) {
    const Eigen::Vector2d off_m = given.position_m - reference_middle_m;
    const Eigen::Vector2d at_m = reference_middle_m + (scaled ? kReferenceScale : 1.0) * off_m;
    if (given.stamp_s) {
      path.add(*given.stamp_s, {at_m.x(), at_m.y(), 0.0});
    }
  }
  return path;
}

geometry::Pose2 brenner_step(const datasets::WheelIncrement& wheels) {
  return sensors::arc_step(0.5 * (wheels.left_m + wheels.right_m),
                           (wheels.right_m - wheels.left_m) / wheels.track_m);
}

}  // namespace echomap::bench
