// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/evaluation/run_score.hpp"

namespace echomap::bench {

/// A room to be mapped, and how a robot gets around in it.
struct TruthRoom {
  std::string name;
  std::string world;  ///< What `--world` takes.
  world::FloorPlan plan;
  std::vector<Eigen::Vector2d> stops_m;  ///< In the world frame; empty where a strategy chooses.
  std::filesystem::path stop_list;       ///< For `--stop-list`; empty where a strategy chooses.
  std::string emulator = "mock";

  /// At most 4 x 4 m.
  bool is_small() const;
};

/// Who maps it.
struct TruthRobot {
  std::string profile = "uno_2wd";
  std::string body;  ///< What is true of it; empty: as the profile's name says.
  std::string strategy = "stops";
  double radius_m = evaluation::kDefaultRobotRadiusM;
};

/// What a run came to.
struct TruthRun {
  std::string outcome;
  bool complete = false;                       ///< By the strategy's word.
  bool finished = false;                       ///< By the map's own estimate of what is unseen.
  double coverage = 0.0;                       ///< That estimate, of 1.
  std::optional<double> expected_wall_rmse_m;  ///< By the map's own estimate: the median.
  std::optional<double> wall_rmse_p90_m;       ///< The ninth decile.
  double sim_seconds = 0.0;
  int hard_collisions = 0;
  int bumps = 0;
  std::size_t stops = 0;
  /// map.pgm of the replayed run is that of the run, byte for byte.
  bool replays_equal = false;
  evaluation::RunScore score;
};

/// The command that drives one seed, whose run is in folder/run and its report in
/// folder/report.json; at its end the robot is carried off in its own map or not.
std::vector<std::string> demo_command(const TruthRoom& room,
                                      const TruthRobot& robot,
                                      int seed,
                                      bool is_carried_off,
                                      const std::filesystem::path& folder);

/// Drives one seed, replays and scores it. Files are in `folder`, an empty one. Says on stderr why
/// there is no run where there is none.
std::optional<TruthRun> run_truth(const TruthRoom& room,
                                  const TruthRobot& robot,
                                  int seed,
                                  const std::filesystem::path& folder);

}  // namespace echomap::bench
