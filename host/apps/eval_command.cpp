// SPDX-License-Identifier: MIT
#include <filesystem>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/map_file.hpp"
#include "host/apps/report.hpp"
#include "host/apps/truth_match.hpp"
#include "host/console/print.hpp"
#include "host/evaluation/relation_error.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/evaluation/truth_picture.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

/// Scored before, so that the truth holds a pose.
void draw_on_truth(const EvalOptions& options) {
  const auto truth = evaluation::read_truth(options.truth);
  evaluation::write_truth_picture(options.picture,
                                  exports::read_pgm_yaml(map_file_of(options.run)),
                                  truth.trajectory.front().T_world_robot,
                                  truth.map,
                                  {options.run.filename().string(), options.align});
  console::print("  picture              " + options.picture.string());
}

evaluation::RelationError score_relations_of(const EvalOptions& options) {
  std::vector<geometry::Pose2> trajectory;
  for (const auto& pose : exports::read_trajectory_tum(options.run / "trajectory.tum")) {
    trajectory.push_back(pose.T_map_robot);
  }
  try {
    return evaluation::score_relations(trajectory, evaluation::read_relations(options.relations));
  } catch (const std::invalid_argument& error) {
    throw files::FileError(options.relations.string() + ": " + error.what());
  }
}

}  // namespace

ExitCode run_eval(const EvalOptions& options) {
  nlohmann::ordered_json report;
  RoomMatch match = RoomMatch::kUnknown;
  std::optional<evaluation::RunScore> score;
  if (!options.truth.empty()) {
    map_file_of(options.run);
    match = match_rooms(options.run, options.truth);
    score = evaluation::score_run(options.run, options.truth, radius_of_robot(options.run));
    print_score(*score);
    report = to_json(*score);
  }
  if (!options.picture.empty()) {
    draw_on_truth(options);
  }
  if (!options.relations.empty()) {
    const auto error = score_relations_of(options);
    print_relation_error(error);
    report.update(to_json(error));
  }
  write_report(options.json, report);
  if (score && match == RoomMatch::kUnknown) {
    refuse_misfit(options.run, options.truth, *score);
  }
  return ExitCode::kOk;
}

}  // namespace echomap::apps
