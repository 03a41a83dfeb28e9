// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mrclam6_joint.hpp"

#include <string>

#include <fmt/format.h>

#include "host/datasets/mrclam_team.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {

namespace {

std::filesystem::path set_6() { return tests::real_data("utias_mrclam/MRCLAM_Dataset6"); }

void print_score(const std::string& who, const evaluation::TeamScore& score) {
  for (const auto& robot : score.robots) {
    fmt::print(
        "mrclam6 {}, robot {}: rmse {:.3f} m by odometry, {:.3f} m alone, {:.3f} m jointly ({:.0f} "
        "% less); NEES {:.1f} alone, {:.1f} jointly; {:.0f} % and {:.0f} % within 95 %\n",
        who,
        robot.robot,
        robot.odometry.rmse_m,
        robot.alone.rmse_m,
        robot.joint.rmse_m,
        robot.gain_percent().value_or(0.0),
        robot.alone.nees,
        robot.joint.nees,
        100.0 * robot.alone.within_95,
        100.0 * robot.joint.within_95);
  }
}

double mean_nees(const evaluation::TeamScore& score) {
  double sum = 0.0;
  for (const auto& robot : score.robots) {
    sum += robot.joint.nees;
  }
  return sum / static_cast<double>(score.robots.size());
}

}  // namespace

evaluation::TeamScore localize_mrclam(const std::filesystem::path& folder,
                                      const std::set<std::int64_t>& blind) {
  const datasets::TeamLog team = datasets::read_mrclam_team(folder);
  pipeline::TeamReplayParams params;
  params.blind = blind;
  evaluation::TeamComparison comparison(team.landmarks_m, params);
  for (const datasets::TeamRecord& record : team.records) {
    comparison.play(record);
  }
  return comparison.score(team.robots);
}

std::vector<Figure> mrclam6_joint_figures(bool verbose) {
  if (!std::filesystem::exists(set_6())) {
    fmt::print("mrclam6: not there, skipped\n");
    return {};
  }
  const auto score = localize_mrclam(set_6());
  const auto robots = score.robots.size();
  if (verbose) {
    print_score("with all landmarks", score);
    print_score("robots 3, 4 and 5 blind to landmarks", localize_mrclam(set_6(), {3, 4, 5}));
  }
  return {{"mrclam6_joint_gain_percent", score.min_gain_percent.value_or(0.0), "%", robots, {}},
          {"mrclam6_joint_pooled_gain_percent", score.gain_percent.value_or(0.0), "%", robots, {}},
          {"mrclam6_joint_m", score.joint_rmse_m.value_or(0.0), "m", robots, {}},
          {"mrclam6_alone_m", score.alone_rmse_m.value_or(0.0), "m", robots, {}},
          {"mrclam6_joint_nees", mean_nees(score), "", robots, {}}};
}

std::optional<double> mrclam6_joint_gain_percent() {
  return std::filesystem::exists(set_6()) ? localize_mrclam(set_6()).min_gain_percent
                                          : std::nullopt;
}

}  // namespace echomap::bench
