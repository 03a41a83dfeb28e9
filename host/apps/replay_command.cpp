// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/replay_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/whole_records.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/progress_bar.hpp"
#include "host/datasets/open_log.hpp"
#include "host/exports/landmarks_csv.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/log_mapper.hpp"
#include "host/pipeline/log_slam.hpp"
#include "host/pipeline/replaced_poses.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_methods.hpp"

namespace echomap::apps {
namespace {

/// A picture of more cells is one of a damaged pose, and would fill the memory.
constexpr double kMaxCells = 5e7;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// SLAM gives its poses as a log gives its own.
bool are_poses_given(const ReplayOptions& options) {
  return options.poses == "given" || !options.slam.empty();
}

pipeline::LogMapperParams params_of(const ReplayOptions& options) {
  pipeline::LogMapperParams params;
  params.map = options.map == "points" ? pipeline::MapKind::kPoints : pipeline::MapKind::kGrid;
  params.poses =
      are_poses_given(options) ? pipeline::PoseSource::kGiven : pipeline::PoseSource::kOdometry;
  params.grid.resolution_m = options.resolution_m;
  return params;
}

/// Throws CommandError for a scan of sound where SLAM takes wide beams for thin ones, and errs.
void validate_fit(const datasets::LogRecord& record, const slam::NamedSlam& method) {
  const auto* scan = std::get_if<sensors::RangeScan>(&record);
  if (scan != nullptr && scan->beam_width_rad > 0.0 && !method.takes_cones) {
    throw CommandError(ExitCode::kRuntimeError,
                       fmt::format("--slam {} is for lasers, but the log is of sensors with wide "
                                   "beams\n  next: --slam multiscan",
                                   method.name));
  }
}

/// Where it was interrupted or is damaged, SLAM ends; what the damage is, is told when the map is
/// made, which meets it again.
void feed(datasets::LogReader& log,
          const slam::NamedSlam& method,
          pipeline::LogSlam& slam,
          console::ProgressBar& progress) {
  try {
    while (!console::interrupted()) {
      const auto record = log.next();
      if (!record) {
        return;
      }
      validate_fit(*record, method);
      slam.add(*record);
      progress.show(log.progress(), fmt::format("slam: {} scans", slam.scans()));
    }
  } catch (const files::FileError&) {
    return;
  }
}

/// What SLAM has found of a log.
struct FoundBySlam {
  std::vector<geometry::Pose2> trajectory;
  slam::FactorGraph graph;          ///< In the trajectory's frame.
  Eigen::Matrix3d last_covariance;  ///< Of the last pose.
};

FoundBySlam find_by_slam(const ReplayOptions& options,
                         datasets::LogReader& log,
                         console::ProgressBar& progress) {
  const slam::NamedSlam& method = slam::slam_by_name(options.slam);
  const auto running = method.make();
  pipeline::LogSlam slam(*running);
  feed(log, method, slam, progress);
  std::vector<geometry::Pose2> trajectory = slam.trajectory();
  if ((slam.scans() == 0 || trajectory.empty()) && !console::interrupted()) {
    throw CommandError(ExitCode::kRuntimeError,
                       options.log.string() + " has " +
                           (slam.scans() == 0 ? "no scans" : "no odometry") +
                           ", but SLAM needs both\n  next: leave out --slam");
  }
  return {std::move(trajectory),
          slam::in_frame_a(slam.T_log_map(), running->factor_graph()),
          running->belief().covariance};
}

/// Feeds the log to the mapper until it ends, is damaged or the user has had enough; answers why it
/// ended, and with the error where it is damaged. What SLAM had found where it was interrupted is
/// drawn whole.
std::pair<std::string, std::string> feed(datasets::LogReader& log,
                                         pipeline::LogMapper& mapper,
                                         console::ProgressBar& progress,
                                         bool was_interrupted) {
  constexpr std::size_t kRecordsPerDrawing = 256;
  try {
    while (was_interrupted || !console::interrupted()) {
      const auto record = next_whole_record(log);
      if (!record) {
        return {was_interrupted ? "interrupted" : "finished", ""};
      }
      mapper.add(*record);
      if (mapper.counts().records % kRecordsPerDrawing == 0) {
        progress.show(log.progress(), fmt::format("{} scans", mapper.counts().scans));
      }
    }
  } catch (const files::FileError& error) {
    return {"log-damaged", error.what()};
  }
  return {"interrupted", ""};
}

/// Why there is no map to write; empty where there is one.
std::string unusable(const ReplayOptions& options, const pipeline::LogMapper& mapper) {
  const pipeline::LogCounts& counts = mapper.counts();
  const pipeline::LogPoses& poses = mapper.poses();
  const std::string log = options.log.string();
  if (counts.scans > 0 && counts.scans == counts.scans_without_pose) {
    return log + " gives no poses for its scans\n  next: --poses odometry";
  }
  // One scan may be of a robot that stands.
  if (!are_poses_given(options) && poses.odometry_records() == 0 && counts.scans > 1) {
    return log + " has no odometry" +
           (poses.given_records() > 0 ? "\n  next: --poses given" : ", and no other poses");
  }
  return "";
}

void refuse_huge_map(const mapping::OccupancyGrid& grid) {
  const mapping::CellBounds& bounds = grid.bounds();
  const double columns = bounds.columns();
  const double rows = bounds.rows();
  if (!bounds.empty() && columns * rows > kMaxCells) {
    throw CommandError(ExitCode::kRuntimeError,
                       fmt::format("the map would be {:.0f} x {:.0f} m, too large for cells of {} "
                                   "m: a damaged pose?\n  next: --resolution {}",
                                   columns * grid.resolution_m(),
                                   rows * grid.resolution_m(),
                                   grid.resolution_m(),
                                   2.0 * grid.resolution_m()));
  }
}

nlohmann::ordered_json replay_json(const ReplayOptions& options,
                                   const pipeline::LogMapper& mapper) {
  const pipeline::LogCounts& counts = mapper.counts();
  return {{"log", options.log.filename().string()},
          {"map", options.map},
          {"poses", options.slam.empty() ? options.poses : options.slam},
          {"records", counts.records},
          {"scans", counts.scans},
          {"beams", counts.beams},
          {"scans_without_pose", counts.scans_without_pose},
          {"poses_without_stamp", counts.poses_without_stamp},
          {"bumps", counts.bumps},
          {"sightings", counts.sightings},
          {"sightings_without_pose", counts.sightings_without_pose}};
}

exports::RunSummary summary_of(const pipeline::LogMapper& mapper,
                               const pipeline::Snapshot& snapshot,
                               const std::string& outcome) {
  exports::RunSummary summary;
  summary.echomap_version = ECHOMAP_VERSION;
  summary.outcome = outcome;
  summary.sim_seconds = mapper.duration_s().value_or(0.0);
  exports::describe_snapshot(snapshot, summary);
  return summary;
}

void write_pose_graph(const std::filesystem::path& path, const FoundBySlam& found) {
  exports::write_pose_graph_g2o(path, found.graph);
  console::print(fmt::format("pose graph: {} ({} poses, {} landmarks, {} edges)",
                             path.string(),
                             found.graph.T_map_nodes.size(),
                             found.graph.landmarks_m.size(),
                             found.graph.edges.size() + found.graph.landmark_edges.size()));
}

void say_what_was_made(const exports::RunSummary& summary,
                       const pipeline::LogCounts& counts,
                       const std::filesystem::path& out) {
  console::print("map: " + (out / "map.png").string());
  console::print(fmt::format("{} scans of {} beams, {:.1f} m, {:.0f} s of log in {:.2f} s",
                             counts.scans,
                             counts.beams,
                             summary.travelled_m,
                             summary.sim_seconds,
                             summary.wall_seconds));
  if (counts.scans_without_pose > 0) {
    console::print(
        fmt::format("skipped {} scans before the first given pose", counts.scans_without_pose));
  }
}

ExitCode replay_log(const ReplayOptions& options) {
  const auto start = Clock::now();
  auto log = datasets::open_log(options.log, options.format);
  const auto out = run_folder(options.out);
  prepare_outputs(out, options.json);
  console::ProgressBar progress(stderr, !options.headless);
  std::optional<FoundBySlam> found;
  if (!options.slam.empty()) {
    found = find_by_slam(options, *log, progress);
    log = std::make_unique<pipeline::ReplacedPoses>(datasets::open_log(options.log, options.format),
                                                    found->trajectory);
  }
  const bool slam_was_interrupted = found && console::interrupted();
  pipeline::LogMapper mapper(params_of(options));
  const auto [outcome, damage] = feed(*log, mapper, progress, slam_was_interrupted);
  progress.clear();
  if (const std::string reason = unusable(options, mapper); damage.empty() && !reason.empty()) {
    throw CommandError(ExitCode::kRuntimeError, reason);
  }

  const pipeline::Snapshot snapshot = mapper.snapshot();
  refuse_huge_map(*snapshot.grid);
  exports::RunSummary summary = summary_of(mapper, snapshot, outcome);
  exports::write_run_directory(out, snapshot, summary);
  exports::write_landmarks_csv(out / "landmarks.csv", mapper.landmarks());
  if (found) {
    exports::describe_uncertainty(found->last_covariance, summary);
    write_pose_graph(out / "pose_graph.g2o", *found);
  }
  summary.wall_seconds = seconds_since(start);
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  report["replay"] = replay_json(options, mapper);
  write_report(out / "summary.json", report);
  write_report(options.json, report);
  say_what_was_made(summary, mapper.counts(), out);
  if (!damage.empty()) {
    spdlog::error("{}; the map up to there is saved", damage);
    return ExitCode::kRuntimeError;
  }
  return outcome == "interrupted" ? ExitCode::kInterrupted : ExitCode::kOk;
}

}  // namespace

ExitCode run_replay(const ReplayOptions& options) {
  return plays_observations(options) ? replay_run(options) : replay_log(options);
}

}  // namespace echomap::apps
