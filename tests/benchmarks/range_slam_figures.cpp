// SPDX-License-Identifier: MIT
#include "tests/benchmarks/range_slam_figures.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/slam/scan_slam.hpp"
#include "tests/benchmarks/relation_log.hpp"
#include "tests/benchmarks/spoilt_log.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {

namespace {

std::optional<RelationLog> log_or_note(const std::string& name) {
  auto log = read_relation_log(name);
  if (!log) {
    fmt::print("{}: not there, skipped\n", name);
  }
  return log;
}

Figure translation(const std::string& name,
                   const evaluation::RelationError& error,
                   const evaluation::RelationError& odometry) {
  return {name + "_m",
          error.translation_mean_m,
          "m",
          error.relations,
          {{"odometry", odometry.translation_mean_m}}};
}

Figure rotation(const std::string& name,
                const evaluation::RelationError& error,
                const evaluation::RelationError& odometry) {
  return {name + "_deg",
          geometry::degrees(error.rotation_mean_rad),
          "deg",
          error.relations,
          {{"odometry", geometry::degrees(odometry.rotation_mean_rad)}}};
}

void add_whole_log(const std::string& name, const RelationLog& log, std::vector<Figure>& figures) {
  slam::ScanSlam slam;
  const auto error = score_slam(log, slam);
  figures.push_back(translation(name, error, score_odometry(log)));
  figures.push_back(rotation(name, error, score_odometry(log)));
}

double ms_a_scan(const RelationLog& log, const slam::ScanSlamParams& params) {
  slam::ScanSlam slam(params);
  const double took_s = processor_seconds([&] { score_slam(log, slam); });
  return 1e3 * took_s / static_cast<double>(slam.trajectory().size());
}

/// A log to spoil, of which every `every`th scan is taken.
struct SpoiltCase {
  const char* name;
  const char* file;
  std::size_t every;
};

constexpr SpoiltCase kSpoiltCases[]{
    {"aces", "carmen_corrected/aces-corrected", 1},
    {"belgioioso", "carmen_corrected/belgioioso-corrected", 1},
    {"csail", "carmen_corrected/csail-corrected", 1},
    {"fr079_4th", "carmen_corrected/freiburg-079-corrected", 4},
    {"fr079_8th", "carmen_corrected/freiburg-079-corrected", 8},
};

constexpr double kLostM = 0.1;

void add_spoilt_log(const SpoiltCase& spoilt,
                    std::size_t first,
                    std::size_t seeds,
                    std::vector<Figure>& figures) {
  std::vector<double> errors_m;
  std::vector<double> odometry_m;
  for (std::size_t seed = first; seed < first + seeds; ++seed) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    const auto log = read_spoilt_log(spoilt.file, spoilt.every, random);
    if (!log) {
      fmt::print("{}: not there, skipped\n", spoilt.file);
      return;
    }
    slam::ScanSlam slam;
    errors_m.push_back(score_slam(*log, slam).translation_mean_m);
    odometry_m.push_back(score_odometry(*log).translation_mean_m);
  }
  const std::string name = std::string("spoilt_") + spoilt.name;
  const auto lost = std::count_if(
      errors_m.begin(), errors_m.end(), [](double error_m) { return error_m > kLostM; });
  figures.push_back({name + "_m",
                     tests::median(errors_m),
                     "m",
                     seeds,
                     {{"odometry", tests::median(odometry_m)}}});
  figures.push_back({name + "_worst_m", *std::ranges::max_element(errors_m), "m", seeds, {}});
  figures.push_back({name + "_lost", static_cast<double>(lost), "runs", seeds, {}});
}

}  // namespace

std::vector<Figure> laser_slam_figures() {
  std::vector<Figure> figures;
  if (const auto edmonton = log_or_note("edm")) {
    add_whole_log("edmonton", *edmonton, figures);
    for (const std::size_t beams : {60U, 36U, 24U, 12U}) {
      slam::ScanSlam slam;
      const auto error = score_slam(with_beams(*edmonton, beams), slam);
      figures.push_back(
          translation(fmt::format("edmonton_b{}", beams), error, score_odometry(*edmonton)));
    }
  }
  if (const auto freiburg = log_or_note("fr079")) {
    add_whole_log("fr079", *freiburg, figures);
  }
  return figures;
}

std::vector<Figure> laser_slam_cost_figures() {
  const auto edmonton = log_or_note("edm");
  if (!edmonton) {
    return {};
  }
  slam::ScanSlamParams without_loops;
  without_loops.closes_loops = false;
  return {{"scan_to_map_ms", ms_a_scan(*edmonton, without_loops), "ms", 1, {}},
          {"scan_slam_ms", ms_a_scan(*edmonton, {}), "ms", 1, {}}};
}

std::vector<Figure> sonar_slam_figures(const slam::NamedSlam& method, std::size_t seeds) {
  const auto edmonton = log_or_note("edm");
  if (!edmonton) {
    return {};
  }
  const double odometry_m = score_odometry(*edmonton).translation_mean_m;
  std::vector<Figure> figures;
  for (const std::size_t cones : {24U, 12U}) {
    double sum_m = 0.0;
    double worst_m = 0.0;
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
      const auto slam = method.make();
      const auto error = score_slam(with_cones(*edmonton, cones, random), *slam);
      sum_m += error.translation_mean_m;
      worst_m = std::max(worst_m, error.translation_mean_m);
    }
    const std::string name = fmt::format("edmonton_s{}", cones);
    figures.push_back(
        {name + "_m", sum_m / static_cast<double>(seeds), "m", seeds, {{"odometry", odometry_m}}});
    figures.push_back({name + "_worst_m", worst_m, "m", seeds, {{"odometry", odometry_m}}});
  }
  return figures;
}

std::vector<Figure> spoilt_slam_figures(std::size_t first, std::size_t seeds) {
  std::vector<Figure> figures;
  for (const SpoiltCase& spoilt : kSpoiltCases) {
    add_spoilt_log(spoilt, first, seeds, figures);
  }
  return figures;
}

}  // namespace echomap::bench
