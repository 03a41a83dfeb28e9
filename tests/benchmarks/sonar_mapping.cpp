// SPDX-License-Identifier: MIT
// Sonar maps against the laser's: four public logs with corrected poses, a pan sonar of 24
// directions made from the laser, and the maps of our model and of its peers from the same
// readings.
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/datasets/laser_to_sonar.hpp"
#include "host/mapping/sonar_cone_mapper.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/laser_truth.hpp"
#include "tests/benchmarks/sonar_peers.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

using Scores = std::map<std::string, LaserAgreement>;

const std::map<std::string, std::string>& logs() {
  static const std::map<std::string, std::string> paths = {
      {"edmonton", "edmonton/edmonton-corrected.log.gz"},
      {"csail", "carmen_corrected/csail-corrected.log.gz"},
      {"aces", "carmen_corrected/aces-corrected.log.gz"},
      {"belgioioso", "carmen_corrected/belgioioso-corrected.log.gz"}};
  return paths;
}

std::vector<mapping::Scan> sonar_sweeps(const std::vector<PosedScan>& scans,
                                        const datasets::LaserToSonarParams& params,
                                        std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<mapping::Scan> sweeps;
  for (const PosedScan& posed : scans) {
    mapping::Scan sweep;
    for (const auto& beam : datasets::laser_to_sonar(posed.scan, params, random).beams) {
      sweep.push_back({posed.T_map_laser,
                       posed.T_map_laser * geometry::Pose2(0.0, 0.0, beam.bearing_rad),
                       beam.range_m});
    }
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

Scores scores_of(const std::vector<PosedScan>& scans,
                 const datasets::LaserToSonarParams& params,
                 std::uint32_t seed) {
  const LaserTruth truth(scans, params.max_range_m);
  const auto sweeps = sonar_sweeps(scans, params, seed);
  mapping::SonarConeMapper mapper;
  for (const auto& sweep : sweeps) {
    mapper.add(sweep);
  }
  const auto map = mapper.map();
  fmt::print("  {} readings: {} silent, {} behind walls, {} seen through; {} pieces of wall\n",
             map.counts.readings,
             map.counts.silent,
             map.counts.behind_wall,
             map.counts.seen_through,
             map.wall_pieces);
  const PeerSonar sonar{params.half_opening_rad, params.max_range_m};
  Scores scores{{"ours", truth.score(map.grid)},
                {"paper002", truth.score(paper002_grid(sweeps, sonar))},
                {"paper002_single", truth.score(paper002_single_grid(sweeps, sonar))},
                {"paper003", truth.score(paper003_grid(sweeps))}};
  if (const auto mrpt = mrpt_grid(sweeps, sonar)) {
    scores["mrpt"] = truth.score(*mrpt);
  }
  return scores;
}

using Column = double LaserAgreement::*;

Figure figure(const std::string& name, const char* unit, Column column, const Scores& scores) {
  Figure figure{name, scores.at("ours").*column, unit, 1, {}};
  for (const auto& [model, agreement] : scores) {
    if (model != "ours") {
      figure.peers[model] = agreement.*column;
    }
  }
  return figure;
}

void add_figures(const std::string& suffix, const Scores& scores, std::vector<Figure>& figures) {
  figures.push_back(figure("sonar_free_iou" + suffix, "1", &LaserAgreement::free_iou, scores));
  figures.push_back(
      figure("sonar_wall_rmse_m" + suffix, "m", &LaserAgreement::wall_rmse_m, scores));
  figures.push_back(
      figure("sonar_wall_recall" + suffix, "1", &LaserAgreement::wall_recall, scores));
}

Scores mean(const std::vector<Scores>& of_logs) {
  Scores sums;
  const auto count = static_cast<double>(of_logs.size());
  for (const Scores& scores : of_logs) {
    for (const auto& [model, agreement] : scores) {
      sums[model].free_iou += agreement.free_iou / count;
      sums[model].wall_rmse_m += agreement.wall_rmse_m / count;
      sums[model].wall_recall += agreement.wall_recall / count;
    }
  }
  return sums;
}

void run(const datasets::LaserToSonarParams& params,
         std::uint32_t seed,
         const std::vector<std::string>& chosen,
         const std::filesystem::path& json) {
  std::vector<Scores> of_logs;
  std::vector<Figure> figures;
  for (const auto& [name, path] : logs()) {
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), name) == chosen.end()) {
      continue;
    }
    const auto log = tests::real_data(path);
    if (!std::filesystem::exists(log)) {
      fmt::print("{}: not there, skipped\n", name);
      continue;
    }
    fmt::print("{}\n", name);
    of_logs.push_back(scores_of(read_posed_scans(log), params, seed));
    add_figures("_" + name, of_logs.back(), figures);
  }
  if (!of_logs.empty()) {
    add_figures("", mean(of_logs), figures);
  }
  report(figures, json);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::datasets::LaserToSonarParams params;
  std::uint32_t seed = 1;
  std::vector<std::string> chosen;
  std::filesystem::path json;
  CLI::App app("Sonar maps of four public logs against the laser's");
  app.add_option("--seed", seed, "Of the sonar's noise")->capture_default_str();
  app.add_option("--log", chosen, "Only these: edmonton, csail, aces, belgioioso");
  app.add_flag("!--diffuse", params.specular, "Let every wall answer at any incidence");
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run(params, seed, chosen, json);
}
