// SPDX-License-Identifier: MIT
#include "tests/benchmarks/landmark_figures.hpp"

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/mrclam6_joint.hpp"
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
  std::vector<Figure> figures = mrclam6_joint_figures(verbose);
  add_brenner(verbose, figures);
  add_nxt_places(figures);
  return figures;
}

}  // namespace echomap::bench
