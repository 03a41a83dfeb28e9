// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/mapping/sonar_cone_mapper.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/laser_to_sonar.hpp"
#include "tests/benchmarks/laser_truth.hpp"

namespace echomap::bench {

/// A public laser log with corrected poses, by a short name.
struct SonarLog {
  std::string name;
  std::string path;  ///< Below the folder of the logs.
};

/// The four that figures are made of.
const std::vector<SonarLog>& sonar_logs();
/// Logs that no setting was chosen on.
const std::vector<SonarLog>& blind_sonar_logs();

/// How the maps of ours and of the peers agree with the laser's, by the model's name.
using SonarScores = std::map<std::string, LaserAgreement>;

/// The scores of one log, and what our mapper has made of its readings.
struct SonarRun {
  SonarScores scores;
  mapping::SonarReadingCounts counts;
  std::size_t wall_pieces = 0;
  /// wall_recall of the points that echoes came from: what a map of the echoes alone would score
  /// that knew of each where in the cone it came from.
  double recall_bound = 0.0;
};

/// Hears a laser log with a pan sonar and maps what it heard, for the seeds 1 to `seeds` of the
/// sonar's noise. Each score is the median over them; the counts are of the last. Throws
/// files::FileError.
SonarRun run_sonar_log(const std::filesystem::path& log,
                       const LaserToSonarParams& sonar,
                       std::size_t seeds);

/// sonar_free_iou, sonar_wall_rmse_m and sonar_wall_recall with `suffix`.
std::vector<Figure> figures_of(const SonarScores& scores,
                               std::size_t seeds,
                               const std::string& suffix);

/// The mean of several logs, by model.
SonarScores mean_of(const std::vector<SonarScores>& of_logs);

/// sonar_free_iou and sonar_wall_rmse_m: means over those of the four logs that are below `data`;
/// none without any. Throws files::FileError.
std::vector<Figure> sonar_figures(const std::filesystem::path& data, std::size_t seeds);

}  // namespace echomap::bench
