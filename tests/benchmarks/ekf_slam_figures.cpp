// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ekf_slam_figures.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "host/evaluation/relation_error.hpp"
#include "host/geometry/angle.hpp"
#include "host/papers/edmonton.hpp"
#include "host/papers/laser_log.hpp"
#include "tests/benchmarks/ekf_slam_runs.hpp"
#include "tests/benchmarks/ekf_slam_scaling.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {

namespace {

const slam::EkfSlamFilterParams of_the_book{.is_invariant = false};

bool is_there(const char* name, const std::filesystem::path& folder) {
  const bool is_there = std::filesystem::exists(folder);
  if (!is_there) {
    fmt::print("{}: not there, skipped\n", name);
  }
  return is_there;
}

/// Root of the mean of the robots' mean squares.
double pooled_rmse_m(const LandmarkSlamScore& score) {
  double squares_m2 = 0.0;
  for (const FollowScore& robot : score.robots) {
    squares_m2 += robot.rmse_m * robot.rmse_m / static_cast<double>(score.robots.size());
  }
  return std::sqrt(squares_m2);
}

double mean_nees(const LandmarkSlamScore& score) {
  double nees = 0.0;
  for (const FollowScore& robot : score.robots) {
    nees += robot.nees / static_cast<double>(score.robots.size());
  }
  return nees;
}

void print(const std::string& who, const LandmarkSlamScore& score) {
  fmt::print(
      "{}: robots {:.3f} m, NEES {:.2f}; {} landmarks {:.3f} m, laid onto the surveyed {:.3f} m, "
      "NEES {:.2f}\n",
      who,
      pooled_rmse_m(score),
      mean_nees(score),
      score.landmarks,
      score.landmark_m,
      score.aligned_landmark_m,
      score.landmark_nees);
}

void print_mrclam(const std::filesystem::path& folder, const LandmarkSlamScore& team) {
  for (const FollowScore& robot : team.robots) {
    fmt::print("mrclam6 in the team: rmse {:.3f} m (dead reckoning, mean, {:.3f} m), NEES {:.2f}\n",
               robot.rmse_m,
               robot.dead_reckoning_mean_m,
               robot.nees);
  }
  print("mrclam6 team", team);
  print("mrclam6 team, the book's filter", slam_mrclam_team(folder, of_the_book));
  for (std::int64_t robot = 1; robot <= 5; ++robot) {
    print(fmt::format("mrclam6 robot {} alone", robot), slam_mrclam_robot(folder, robot));
    print(fmt::format("mrclam6 robot {} alone, the book's filter", robot),
          slam_mrclam_robot(folder, robot, of_the_book));
  }
}

void add_mrclam(bool verbose, std::vector<Figure>& figures) {
  const auto folder = tests::real_data("utias_mrclam/MRCLAM_Dataset6");
  if (!is_there("mrclam6", folder)) {
    return;
  }
  const LandmarkSlamScore team = slam_mrclam_team(folder);
  if (verbose) {
    print_mrclam(folder, team);
  }
  figures.push_back({"mrclam6_robot_m", pooled_rmse_m(team), "m", 5, {}});
  figures.push_back({"mrclam6_landmark_m", team.aligned_landmark_m, "m", 1, {}});
  figures.push_back({"mrclam6_robot_nees", mean_nees(team), "", 5, {}});
  figures.push_back({"mrclam6_landmark_nees", team.landmark_nees, "", 1, {}});
}

GpsAgreement print_victoria_park(const std::string& who,
                                 const std::filesystem::path& folder,
                                 const TreeSlamRun& run) {
  const GpsAgreement agreement = victoria_park_agreement(folder, run.T_map_robots);
  fmt::print(
      "victoria park, {}: {:.2f} m rms, mean {:.2f} m, worst {:.1f} m of {} fixes; {} trees, {} "
      "sightings gated\n",
      who,
      agreement.rmse_m,
      agreement.mean_m,
      agreement.worst_m,
      agreement.fixes,
      run.trees,
      run.gated);
  return agreement;
}

void add_victoria_park(bool verbose, std::vector<Figure>& figures) {
  const auto folder = tests::real_data("victoria_park");
  if (!is_there("victoria park", folder)) {
    return;
  }
  const TreeSlamRun run = slam_victoria_park(folder);
  const GpsAgreement odometry = victoria_park_agreement(folder, run.T_odom_robots);
  GpsAgreement found = victoria_park_agreement(folder, run.T_map_robots);
  if (verbose) {
    print_victoria_park("invariant", folder, run);
    print_victoria_park("the book's filter", folder, slam_victoria_park(folder, of_the_book));
  }
  figures.push_back({"victoria_park_m", found.rmse_m, "m", 1, {{"odometry", odometry.rmse_m}}});
}

void add_brenner(bool verbose, std::vector<Figure>& figures) {
  const auto folder = tests::real_data("lego_brenner");
  if (!is_there("brenner", folder)) {
    return;
  }
  const LandmarkSlamScore score = slam_brenner(folder);
  if (verbose) {
    print("brenner", score);
  }
  const FollowScore& robot = score.robots.front();
  figures.push_back({"brenner_slam_mean_mm",
                     1000.0 * robot.mean_m,
                     "mm",
                     1,
                     {{"odometry", 1000.0 * robot.dead_reckoning_mean_m}}});
  figures.push_back({"brenner_slam_landmark_mm", 1000.0 * score.aligned_landmark_m, "mm", 1, {}});
}

evaluation::RelationError edmonton_error(const papers::EdmontonLog& log,
                                         const slam::LandmarkSlamParams& params) {
  slam::LandmarkSlam method(params);
  papers::run_landmark_slam(log.records, method);
  return evaluation::score_relations(method.trajectory(), log.relations);
}

void print_edmonton(const papers::EdmontonLog& log) {
  const auto told = [&](const char* who, const slam::LandmarkSlamParams& params) {
    const auto error = edmonton_error(log, params);
    fmt::print("edmonton, {}: {:.3f} m, {:.2f} deg\n",
               who,
               error.translation_mean_m,
               geometry::degrees(error.rotation_mean_rad));
  };
  slam::LandmarkSlamParams nearest;
  nearest.update.method = slam::AssociationMethod::kNearestNeighbour;
  told("nearest neighbour", nearest);
  slam::LandmarkSlamParams book;
  book.filter = of_the_book;
  told("the book's filter", book);
  slam::LandmarkSlamParams walls;
  walls.extraction.with_corners = false;
  walls.extraction.with_posts = false;
  told("walls alone", walls);
  slam::LandmarkSlamParams points;
  points.extraction.with_walls = false;
  told("points alone", points);
}

void add_edmonton(bool verbose, std::vector<Figure>& figures) {
  const auto log = papers::read_edmonton(tests::real_data(""));
  if (!log || log->relations.empty()) {
    fmt::print("edmonton: not there, skipped\n");
    return;
  }
  const auto error = edmonton_error(*log, {});
  const auto odometry =
      evaluation::score_relations(papers::paper_odometry(log->records), log->relations);
  if (verbose) {
    print_edmonton(*log);
  }
  figures.push_back({"edmonton_ekf_m",
                     error.translation_mean_m,
                     "m",
                     1,
                     {{"odometry", odometry.translation_mean_m}}});
  figures.push_back({"edmonton_ekf_deg",
                     geometry::degrees(error.rotation_mean_rad),
                     "deg",
                     1,
                     {{"odometry", geometry::degrees(odometry.rotation_mean_rad)}}});
}

}  // namespace

std::vector<Figure> ekf_slam_figures(bool verbose) {
  std::vector<Figure> figures;
  add_mrclam(verbose, figures);
  add_victoria_park(verbose, figures);
  add_brenner(verbose, figures);
  add_edmonton(verbose, figures);
  return figures;
}

std::vector<Figure> ekf_slam_cost_figures(bool verbose) {
  constexpr int kSteps = 50;
  std::vector<Figure> figures;
  for (const std::size_t landmarks : {50U, 100U, 200U, 500U, 1000U}) {
    const EkfSlamStepCost cost = ekf_slam_step_cost(landmarks, kSteps);
    if (verbose) {
      fmt::print("{} landmarks: move {:.4f} ms, associate ten {:.3f} ms, update {:.3f} ms\n",
                 landmarks,
                 cost.move_ms,
                 cost.associate_ms,
                 cost.update_ms);
    }
    figures.push_back({fmt::format("ekf_slam_step_{}_ms", landmarks),
                       cost.move_ms + cost.associate_ms + cost.update_ms,
                       "ms",
                       kSteps,
                       {}});
  }
  return figures;
}

}  // namespace echomap::bench
