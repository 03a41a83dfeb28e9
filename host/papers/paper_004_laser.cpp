// SPDX-License-Identifier: MIT
#include "host/papers/paper_004_laser.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "host/evaluation/trajectory_error.hpp"
#include "host/geometry/angle.hpp"
#include "host/papers/edmonton.hpp"
#include "host/papers/laser_hall.hpp"
#include "host/papers/laser_log.hpp"
#include "host/papers/map_panels.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;
using paper_report::Equation;
using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;
using Numbers = std::vector<double>;

const std::string no_figure = "a picture, no figure";
constexpr double kMaxDrawnM = 20.0;

std::vector<Equation> equations_of_the_paper() {
  return {{"equations 1 to 3, odometry",
           "φ_i = φ_{i-1} + Δφ_i,   (x, y)_i = (x, y)_{i-1} + √(Δx² + Δy²) (cos φ_i, sin φ_i)",
           "host/papers/turn_first_odometry.cpp",
           "geometry::Pose2 turned_then_driven"},
          {"equations 4 to 6, where a beam ends",
           "φ_l = φ_r + φ_beam,   (x, y)_l = (x, y)_r + d (cos φ_l, sin φ_l)",
           "host/papers/turn_first_odometry.cpp",
           "Eigen::Vector2d scanned_point_m"}};
}

std::vector<Equation> equations_of_ekf_slam() {
  return {{"EKF-SLAM: odometry moves the robot",
           "x' = x ⊕ u,   P' = F P Fᵀ + W Q Wᵀ",
           "host/slam/ekf_slam_filter.cpp",
           "void EkfSlamFilter::move(std::size_t robot,"},
          {"landmarks are extracted from a scan",
           "lines by split and merge; their corners; what stands alone",
           "host/slam/landmark_extraction.cpp",
           "std::vector<LandmarkSighting> extract_landmarks"},
          {"landmarks seen before correct the state",
           "S = H P' Hᵀ + R,   K = P' Hᵀ S⁻¹,   P = P' - K S Kᵀ",
           "host/slam/ekf_slam_filter.cpp",
           "void EkfSlamFilter::update"},
          {"new landmarks are added",
           "x = (x, g(x, z))",
           "host/slam/ekf_slam_filter.cpp",
           "std::size_t EkfSlamFilter::add("}};
}

/// A figure of one log, which has no interval.
Measured single(double value) { return paper_report::measured_mean(std::array{value}); }

MapPanel panel_by_slam(const std::vector<datasets::LogRecord>& records,
                       const slam::LandmarkSlam& method) {
  MapPanel panel;
  panel.path = method.trajectory();
  panel.ends_m = scanned_points_m(records, panel.path, kMaxDrawnM);
  const slam::FactorGraph graph = method.factor_graph();
  panel.walls = graph.walls;
  panel.points_m = graph.landmarks_m;
  return panel;
}

MapPanel panel_as_told(const std::vector<datasets::LogRecord>& records) {
  MapPanel panel;
  panel.path = paper_odometry(records);
  panel.ends_m = scanned_points_m(records, panel.path, kMaxDrawnM);
  return panel;
}

std::vector<Finding> relation_findings(const EdmontonLog& log, const slam::LandmarkSlam& method) {
  const auto error = [&](const std::vector<Pose2>& path) {
    return evaluation::score_relations(path, log.relations);
  };
  const auto told = error(paper_odometry(log.records));
  const auto composed = error(composed_odometry(log.records));
  const auto slam = error(method.trajectory());
  const auto row = [](const std::string& quantity,
                      const std::optional<Measured>& as_told,
                      const Measured& ours,
                      const std::string& unit) {
    return Finding{quantity, "figures 1b and 2", no_figure, as_told, ours, unit, 1};
  };
  return {row("motion between scans is off by, odometry",
              single(100.0 * told.translation_mean_m),
              single(100.0 * composed.translation_mean_m),
              "cm"),
          row("turn between scans is off by, odometry",
              single(geometry::degrees(told.rotation_mean_rad)),
              single(geometry::degrees(composed.rotation_mean_rad)),
              "degrees"),
          row("motion between scans is off by, EKF-SLAM",
              std::nullopt,
              single(100.0 * slam.translation_mean_m),
              "cm"),
          row("turn between scans is off by, EKF-SLAM",
              std::nullopt,
              single(geometry::degrees(slam.rotation_mean_rad)),
              "degrees")};
}

std::vector<Finding> log_findings(const EdmontonLog& log, const slam::LandmarkSlam& method) {
  const auto told = paper_odometry(log.records);
  const slam::FactorGraph graph = method.factor_graph();
  std::vector<Finding> findings = {
      {"scans", "", "not given", single(static_cast<double>(told.size())), std::nullopt, "", 0},
      {"length of the path",
       "figure 1b",
       no_figure,
       single(path_length_m(told)),
       single(path_length_m(method.trajectory())),
       "m",
       1},
      {"landmarks that are walls",
       "figure 2",
       no_figure,
       std::nullopt,
       single(static_cast<double>(graph.walls.size())),
       "",
       0},
      {"landmarks that are points",
       "figure 2",
       no_figure,
       std::nullopt,
       single(static_cast<double>(graph.landmarks_m.size())),
       "",
       0}};
  if (!log.relations.empty()) {
    const auto more = relation_findings(log, method);
    findings.insert(findings.end(), more.begin(), more.end());
  }
  return findings;
}

std::string answer_without_log(const std::filesystem::path& logs) {
  return fmt::format(
      "Not repeated: {} is not there. Put the text form of MRPT's copy of the log (Edmonton 2002, "
      "www.mrpt.org/Dataset_Edmonton_2002) into {}: dataset_edmonton.rawlog_LASER.txt and "
      "dataset_edmonton.rawlog_ODO.txt, plain or gz; or let ECHOMAP_DATA name the folder above it. "
      "Then repeat this command. The next experiment does the same in a simulated hall.",
      edmonton_scans(logs).string(),
      (logs / "edmonton").string());
}

std::string answer_with_log(const EdmontonLog& log, const std::filesystem::path& logs) {
  return "Yes: walls that odometry doubles and bends become single and straight. " +
         (log.relations.empty()
              ? fmt::format("By how much is not measured, since {} is not there.",
                            (logs / "slam_relations" / "edm.assoc.gz").string())
              : "Turning first and driving all of an increment ahead is a little worse than "
                "composing increments as they are; either way the drift stays.");
}

}  // namespace

Experiment edmonton_experiment(const PaperSettings& settings, const std::filesystem::path& logs) {
  Experiment experiment;
  experiment.title = "The paper's log: Edmonton";
  experiment.question = "Is the map of that log better by EKF-SLAM than by odometry?";
  experiment.as_told =
      "The Edmonton log gives increments of odometry, and a laser scan of 180 degrees a line. The "
      "path is that of equations 1 to 3: the robot turns first and drives all of an increment "
      "ahead. Beams end where equations 4 to 6 say.";
  experiment.our_way =
      "The paper tells its EKF-SLAM in words only; this is ours, as echomap replay --slam ekf runs "
      "it, with walls, corners and posts as landmarks. In rows of odometry increments are composed "
      "as they are. Errors are those of known relations between scans (Kuemmerle et al. 2009), "
      "which another SLAM's path gave: a few centimetres mean agreement, not truth.";
  experiment.open = {
      "No error, no time, and no setting of the filter is given: neither noise nor gates, nor how "
      "landmarks are extracted and associated.",
      "Equation 1 has the same index on both sides, and equation 4 the same name for the beam's "
      "angle in the robot's frame and in the map's.",
      "Where the real map of figure 1a comes from is not said; no plan comes with the log."};
  experiment.equations = equations_of_the_paper();
  const auto of_ekf_slam = equations_of_ekf_slam();
  experiment.equations.insert(experiment.equations.end(), of_ekf_slam.begin(), of_ekf_slam.end());
  const auto log = read_edmonton(logs);
  if (!log) {
    experiment.answer = answer_without_log(logs);
    return experiment;
  }
  settings.progress("EKF-SLAM of the Edmonton log", 0, 1);
  slam::LandmarkSlam method;
  run_landmark_slam(log->records, method);
  settings.progress("EKF-SLAM of the Edmonton log", 1, 1);
  experiment.answer = answer_with_log(*log, logs);
  experiment.findings = log_findings(*log, method);
  experiment.pictures = {
      {"By odometry, and by EKF-SLAM",
       "figures 1b and 2",
       "Left: beams and path by equations 1 to 6. Right: by EKF-SLAM, with its landmarks.",
       draw_panels(settings.out / "pictures" / "004_edmonton.png",
                   {panel_as_told(log->records), panel_by_slam(log->records, method)},
                   0.15)}};
  return experiment;
}

namespace {

/// What the drives of all seeds come to.
struct HallFigures {
  Numbers told_m;
  Numbers composed_m;
  Numbers slam_m;
  Numbers told_heading_deg;
  Numbers slam_heading_deg;
  Numbers told_ends_m;
  Numbers slam_ends_m;
  Numbers walls;
  Numbers points;
};

std::vector<pipeline::StampedPose> stamped(const std::vector<Pose2>& path) {
  std::vector<pipeline::StampedPose> poses;
  for (const Pose2& pose : path) {
    poses.push_back({time::robot_time(static_cast<double>(poses.size())), pose});
  }
  return poses;
}

evaluation::TrajectoryError path_error(const std::vector<Pose2>& path,
                                       const std::vector<Pose2>& truth) {
  std::vector<evaluation::TruePose> true_poses;
  for (const auto& [stamp, pose] : stamped(truth)) {
    true_poses.push_back({stamp, pose});
  }
  return evaluation::score_trajectory(stamped(path), true_poses);
}

/// Distance of ends of beams from the nearest true wall, RMS over every 50th.
double ends_rmse_m(const world::FloorPlan& hall,
                   const std::vector<datasets::LogRecord>& records,
                   const std::vector<Pose2>& path) {
  constexpr std::size_t kEvery = 50;
  const auto ends_m = scanned_points_m(records, path, kMaxDrawnM);
  double squares_m2 = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < ends_m.size(); i += kEvery) {
    const double distance_m = hall.clearance_m(hall.T_world_start() * ends_m[i]);
    squares_m2 += distance_m * distance_m;
    count += 1.0;
  }
  return std::sqrt(squares_m2 / count);
}

void add_figures(const world::FloorPlan& hall,
                 const LaserDrive& drive,
                 const slam::LandmarkSlam& method,
                 HallFigures& figures) {
  const auto told = paper_odometry(drive.records);
  const auto by_slam = method.trajectory();
  const auto told_error = path_error(told, drive.T_start_scans);
  const auto slam_error = path_error(by_slam, drive.T_start_scans);
  figures.told_m.push_back(told_error.ate_rmse_m);
  figures.composed_m.push_back(
      path_error(composed_odometry(drive.records), drive.T_start_scans).ate_rmse_m);
  figures.slam_m.push_back(slam_error.ate_rmse_m);
  figures.told_heading_deg.push_back(geometry::degrees(told_error.ate_heading_rmse_rad));
  figures.slam_heading_deg.push_back(geometry::degrees(slam_error.ate_heading_rmse_rad));
  figures.told_ends_m.push_back(ends_rmse_m(hall, drive.records, told));
  figures.slam_ends_m.push_back(ends_rmse_m(hall, drive.records, by_slam));
  const slam::FactorGraph graph = method.factor_graph();
  figures.walls.push_back(static_cast<double>(graph.walls.size()));
  figures.points.push_back(static_cast<double>(graph.landmarks_m.size()));
}

std::vector<Finding> hall_findings(const HallFigures& figures) {
  const auto mean = [](const Numbers& numbers, double scale) {
    return scaled(paper_report::measured_mean(numbers), scale);
  };
  const auto row = [](const std::string& quantity,
                      const std::string& where,
                      const std::optional<Measured>& as_told,
                      const std::optional<Measured>& ours,
                      const std::string& unit) {
    return Finding{quantity, where, no_figure, as_told, ours, unit, unit.empty() ? 0 : 1};
  };
  return {
      row("path by odometry is off by (RMS)",
          "figure 1b",
          mean(figures.told_m, 100.0),
          mean(figures.composed_m, 100.0),
          "cm"),
      row("path by EKF-SLAM is off by (RMS)",
          "figure 2",
          std::nullopt,
          mean(figures.slam_m, 100.0),
          "cm"),
      row("heading is off by (RMS)",
          "figures 1b and 2",
          mean(figures.told_heading_deg, 1.0),
          mean(figures.slam_heading_deg, 1.0),
          "degrees"),
      row("ends of beams are off the true walls by (RMS)",
          "figures 1b and 2",
          mean(figures.told_ends_m, 100.0),
          mean(figures.slam_ends_m, 100.0),
          "cm"),
      row("landmarks that are walls", "figure 2", std::nullopt, mean(figures.walls, 1.0), ""),
      row("landmarks that are points", "figure 2", std::nullopt, mean(figures.points, 1.0), "")};
}

MapPanel true_panel(const world::FloorPlan& hall, const LaserDrive& drive) {
  MapPanel panel;
  panel.path = drive.T_start_scans;
  const Pose2 T_start_world = hall.T_world_start().inverse();
  for (const world::Wall& wall : hall.walls()) {
    panel.true_walls.push_back(
        {T_start_world * wall.segment.from_m, T_start_world * wall.segment.to_m});
  }
  return panel;
}

}  // namespace

Experiment hall_experiment(const PaperSettings& settings) {
  const world::FloorPlan hall = laser_hall();
  HallFigures figures;
  std::vector<MapPanel> panels;
  for (std::size_t i = 0; i < settings.runs; ++i) {
    const LaserDrive drive = drive_hall(hall, settings.seed + static_cast<std::uint32_t>(i));
    slam::LandmarkSlam method;
    run_landmark_slam(drive.records, method);
    add_figures(hall, drive, method, figures);
    if (panels.empty()) {
      panels = {true_panel(hall, drive),
                panel_as_told(drive.records),
                panel_by_slam(drive.records, method)};
    }
    settings.progress("EKF-SLAM in a simulated hall", i + 1, settings.runs);
  }
  Experiment experiment;
  experiment.title = "The same in a simulated hall";
  experiment.question = "How far are path and map off the truth by odometry, and by EKF-SLAM?";
  experiment.as_told =
      "A robot drives three rounds through a hall of 10 x 10 m with nine pillars. Its wheels slip "
      "and differ from their nominal size; its laser, 180 beams a scan with 2 cm of noise, is the "
      "log's. Path and ends of beams are those of equations 1 to 6.";
  experiment.our_way =
      "EKF-SLAM with the settings of the log. In the row of odometry increments are composed as "
      "they are.";
  experiment.answer =
      "By odometry the walls of each round lie somewhere else. EKF-SLAM brings the rounds together "
      "and takes most of the error out of the path. How increments are composed matters much less "
      "than the drift.";
  experiment.findings = hall_findings(figures);
  experiment.pictures = {
      {"The hall in truth, by odometry, and by EKF-SLAM",
       "figures 1a, 1b and 2",
       "Of the first run. Left: true walls and true path. Middle: equations 1 to 6. Right: "
       "EKF-SLAM with its landmarks.",
       draw_panels(settings.out / "pictures" / "004_hall.png", panels, 0.05)}};
  experiment.equations = {
      {"the odometry's errors, ours",
       "scales of drives and turns and a bend, constant in a run; slip ~ √distance",
       "host/papers/bounce_drive.cpp",
       "Pose2 WheelErrors::measured"},
      {"the laser, ours",
       "the first wall that a ray meets, and noise",
       "host/papers/laser_hall.cpp",
       "void add_scan()"}};
  experiment.open = {"The paper has no simulation. Hall, drive and noise are ours."};
  return experiment;
}

}  // namespace echomap::papers
