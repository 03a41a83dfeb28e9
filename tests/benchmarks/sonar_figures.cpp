// SPDX-License-Identifier: MIT
#include "tests/benchmarks/sonar_figures.hpp"

#include <algorithm>
#include <random>

#include "tests/benchmarks/sonar_peers.hpp"

namespace echomap::bench {

namespace {

using Column = double LaserAgreement::*;

constexpr Column kColumns[] = {
    &LaserAgreement::free_iou, &LaserAgreement::wall_rmse_m, &LaserAgreement::wall_recall};

struct HeardLog {
  std::vector<mapping::Scan> sweeps;
  std::vector<Eigen::Vector2d> origins_m;  ///< Of the echoes, in the map frame.
};

HeardLog heard_log(const std::vector<PosedScan>& scans,
                   const LaserToSonarParams& sonar,
                   std::uint32_t seed) {
  std::mt19937 random(seed);
  HeardLog log;
  for (const PosedScan& posed : scans) {
    mapping::Scan sweep;
    const HeardScan heard = heard_scan(posed.scan, sonar, random);
    for (const auto& beam : heard.scan.beams) {
      sweep.push_back({posed.T_map_laser,
                       posed.T_map_laser * geometry::Pose2(0.0, 0.0, beam.bearing_rad),
                       beam.range_m});
    }
    log.sweeps.push_back(std::move(sweep));
    for (const Eigen::Vector2d& origin_m : heard.origins_m) {
      log.origins_m.push_back(posed.T_map_laser * origin_m);
    }
  }
  return log;
}

SonarRun run_once(const HeardLog& log, const LaserToSonarParams& params, const LaserTruth& truth) {
  const auto& sweeps = log.sweeps;
  mapping::SonarConeMapper mapper;
  for (const auto& sweep : sweeps) {
    mapper.add(sweep);
  }
  const auto map = mapper.map();
  const PeerSonar sonar{params.beam_half_angle_rad, params.max_range_m};
  SonarRun run{{{"ours", truth.score(map.grid)},
                {"paper002", truth.score(paper002_grid(sweeps, sonar))},
                {"paper002_single", truth.score(paper002_single_grid(sweeps, sonar))},
                {"paper003", truth.score(paper003_grid(sweeps))}},
               map.counts,
               map.wall_pieces,
               truth.wall_recall(log.origins_m)};
  if (const auto mrpt = mrpt_grid(sweeps, sonar)) {
    run.scores["mrpt"] = truth.score(*mrpt);
  }
  return run;
}

/// The median of each column by itself; of an even number the upper.
LaserAgreement median(const std::vector<SonarRun>& runs, const std::string& model) {
  LaserAgreement medians;
  for (const Column column : kColumns) {
    std::vector<double> values;
    for (const SonarRun& run : runs) {
      values.push_back(run.scores.at(model).*column);
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    medians.*column = *middle;
  }
  return medians;
}

Figure figure(const std::string& name,
              const char* unit,
              Column column,
              const SonarScores& scores,
              std::size_t seeds) {
  Figure figure{name, scores.at("ours").*column, unit, seeds, {}};
  for (const auto& [model, agreement] : scores) {
    if (model != "ours") {
      figure.peers[model] = agreement.*column;
    }
  }
  return figure;
}

}  // namespace

const std::vector<SonarLog>& sonar_logs() {
  static const std::vector<SonarLog> logs = {
      {"edmonton", "edmonton/edmonton-corrected.log.gz"},
      {"aces", "carmen_corrected/aces-corrected.log.gz"},
      {"csail", "carmen_corrected/csail-corrected.log.gz"},
      {"belgioioso", "carmen_corrected/belgioioso-corrected.log.gz"}};
  return logs;
}

const std::vector<SonarLog>& blind_sonar_logs() {
  static const std::vector<SonarLog> logs = {
      {"freiburg-079", "carmen_corrected/freiburg-079-corrected.log.gz"},
      {"intel", "carmen_corrected/intel-corrected.log.gz"},
      {"fhw", "carmen_corrected/fhw-corrected.log.gz"}};
  return logs;
}

SonarRun run_sonar_log(const std::filesystem::path& log,
                       const LaserToSonarParams& sonar,
                       std::size_t seeds) {
  const auto scans = read_posed_scans(log);
  const LaserTruth truth(scans, sonar.max_range_m);
  std::vector<SonarRun> runs;
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    runs.push_back(
        run_once(heard_log(scans, sonar, static_cast<std::uint32_t>(seed)), sonar, truth));
  }
  SonarRun whole = runs.back();
  for (auto& [model, agreement] : whole.scores) {
    agreement = median(runs, model);
  }
  return whole;
}

std::vector<Figure> figures_of(const SonarScores& scores,
                               std::size_t seeds,
                               const std::string& suffix) {
  return {figure("sonar_free_iou" + suffix, "1", &LaserAgreement::free_iou, scores, seeds),
          figure("sonar_wall_rmse_m" + suffix, "m", &LaserAgreement::wall_rmse_m, scores, seeds),
          figure("sonar_wall_recall" + suffix, "1", &LaserAgreement::wall_recall, scores, seeds)};
}

SonarScores mean_of(const std::vector<SonarScores>& of_logs) {
  SonarScores sums;
  for (const SonarScores& scores : of_logs) {
    for (const auto& [model, agreement] : scores) {
      for (const Column column : kColumns) {
        sums[model].*column += agreement.*column / static_cast<double>(of_logs.size());
      }
    }
  }
  return sums;
}

std::vector<Figure> sonar_figures(const std::filesystem::path& data, std::size_t seeds) {
  std::vector<SonarScores> of_logs;
  for (const SonarLog& log : sonar_logs()) {
    if (std::filesystem::exists(data / log.path)) {
      of_logs.push_back(run_sonar_log(data / log.path, {}, seeds).scores);
    }
  }
  if (of_logs.empty()) {
    return {};
  }
  auto figures = figures_of(mean_of(of_logs), seeds, "");
  figures.pop_back();
  return figures;
}

}  // namespace echomap::bench
