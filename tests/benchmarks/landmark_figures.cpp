// SPDX-License-Identifier: MIT
#include "tests/benchmarks/landmark_figures.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/nxt_places.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {

namespace {

void print(const std::string& who, const FollowScore& score) {
  fmt::print(
      "{}: rmse {:.3f} m, mean {:.3f} m (dead reckoning {:.3f} m), NEES {:.2f}, {} poses, {} "
      "gated\n",
      who,
      score.rmse_m,
      score.mean_m,
      score.dead_reckoning_mean_m,
      score.nees,
      score.poses,
      score.gated);
}

/// Root of the mean of the robots' mean squares.
double pooled_rmse_m(const std::string& who, const std::vector<FollowScore>& scores, bool verbose) {
  double squares_m2 = 0.0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    squares_m2 += scores[i].rmse_m * scores[i].rmse_m / static_cast<double>(scores.size());
    if (verbose) {
      print(fmt::format("mrclam6 {} robot {}", who, i + 1), scores[i]);
    }
  }
  return std::sqrt(squares_m2);
}

void add_mrclam(bool verbose, std::vector<Figure>& figures) {
  const auto folder = tests::real_data("utias_mrclam/MRCLAM_Dataset6");
  if (!std::filesystem::exists(folder)) {
    fmt::print("mrclam6: not there, skipped\n");
    return;
  }
  const double alone_m = pooled_rmse_m("alone", follow_mrclam(folder, false), verbose);
  const double team_m = pooled_rmse_m("team", follow_mrclam(folder, true), verbose);
  figures.push_back({"mrclam6_ekf_m", team_m, "m", 5, {}});
  figures.push_back({"mrclam6_ekf_alone_m", alone_m, "m", 5, {}});
}

void add_nxt_places(std::vector<Figure>& figures) {
  const auto folder = tests::real_data("nxt_sonar_imperial");
  if (!std::filesystem::exists(folder)) {
    fmt::print("nxt places: not there, skipped\n");
    return;
  }
  figures.push_back(
      {"nxt_places_of_5", static_cast<double>(nxt_places_known_again(folder)), "places", 5, {}});
}

void add_brenner(bool verbose, std::vector<Figure>& figures) {
  const auto folder = tests::real_data("lego_brenner");
  if (!std::filesystem::exists(folder)) {
    fmt::print("brenner: not there, skipped\n");
    return;
  }
  const FollowScore score = follow_brenner(folder, false);
  const FollowScore scaled = follow_brenner(folder, true);
  if (verbose) {
    print("brenner", score);
    print("brenner, reference scaled", scaled);
  }
  figures.push_back({"brenner_mean_mm", 1000.0 * score.mean_m, "mm", 1, {}});
  figures.push_back({"brenner_scaled_mean_mm", 1000.0 * scaled.mean_m, "mm", 1, {}});
}

}  // namespace

std::vector<Figure> landmark_figures(bool verbose) {
  std::vector<Figure> figures;
  add_mrclam(verbose, figures);
  add_brenner(verbose, figures);
  add_nxt_places(figures);
  return figures;
}

}  // namespace echomap::bench
