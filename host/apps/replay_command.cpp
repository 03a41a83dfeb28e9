// SPDX-License-Identifier: MIT
#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/replay_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/saved_map.hpp"
#include "host/apps/whole_records.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/progress_bar.hpp"
#include "host/exports/landmarks_csv.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/log_player.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_methods.hpp"

namespace echomap::apps {
namespace {

/// A picture of more cells is one of a damaged pose, and would fill the memory.
constexpr double kMaxCells = 5e7;
/// Of smaller cells a log would fill the memory before its end.
constexpr double kMinUsualCellM = 0.01;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
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

/// A log that is played into the pipeline of a robot.
class PlayedLog {
 public:
  explicit PlayedLog(const ReplayOptions& options)
      : options_(options),
        method_(options.slam.empty() ? nullptr : &slam::slam_by_name(options.slam)),
        pipeline_(pipeline_for(options)),
        player_(pipeline_, source_of(options)) {}

  /// Plays until the log ends, is damaged or the user has had enough; answers why it ended, and
  /// with the error where it is damaged.
  std::pair<std::string, std::string> play(datasets::LogReader& log,
                                           console::ProgressBar& progress) {
    constexpr std::size_t kRecordsPerDrawing = 256;
    try {
      while (!console::interrupted()) {
        const auto record = next_whole_record(log);
        if (!record) {
          return {"finished", ""};
        }
        if (method_ != nullptr) {
          validate_fit(*record, *method_);
        }
        player_.play(*record);
        if (counts().records % kRecordsPerDrawing == 0) {
          if (options_.resolution_m < kMinUsualCellM) {
            refuse_huge_map(*pipeline_.snapshot().grid);
          }
          progress.show(log.progress(), fmt::format("{} scans", counts().scans));
        }
      }
    } catch (const files::FileError& error) {
      return {"log-damaged", error.what()};
    }
    return {"interrupted", ""};
  }

  /// Why there is no map to write; empty where there is one.
  std::string unusable() const;

  const pipeline::LogCounts& counts() const { return player_.counts(); }
  double duration_s() const { return player_.duration_s().value_or(0.0); }
  const pipeline::RobotPipeline& pipeline() const { return pipeline_; }

 private:
  static pipeline::PoseSource source_of(const ReplayOptions& options) {
    if (!options.slam.empty()) {
      return pipeline::PoseSource::kOdometryFromOrigin;
    }
    return options.poses == "given" ? pipeline::PoseSource::kGiven
                                    : pipeline::PoseSource::kOdometry;
  }

  static pipeline::RobotPipeline pipeline_for(const ReplayOptions& options) {
    pipeline::ScanMapParams scans;
    scans.map = options.map == "points" ? pipeline::MapKind::kPoints : pipeline::MapKind::kGrid;
    scans.grid.resolution_m = options.resolution_m;
    mapping::SonarMapperParams stops;
    stops.grid = scans.grid;
    return pipeline::RobotPipeline(
        {},
        stops,
        {},
        options.slam.empty() ? nullptr : slam::slam_by_name(options.slam).make(),
        scans);
  }

  const ReplayOptions& options_;
  const slam::NamedSlam* method_;
  pipeline::RobotPipeline pipeline_;
  pipeline::LogPlayer player_;
};

std::string PlayedLog::unusable() const {
  const std::string log = options_.log.string();
  if (counts().records == 0) {
    return log + " is empty: it has no record\n  next: name another log";
  }
  if (method_ != nullptr && (counts().scans == 0 || counts().odometry_poses == 0)) {
    return log + " has " + (counts().scans == 0 ? "no scans" : "no odometry") +
           ", but SLAM needs both\n  next: leave out --slam";
  }
  if (counts().scans > 0 && counts().scans == counts().scans_without_pose) {
    return log + " gives no poses for its scans\n  next: --poses odometry";
  }
  // One scan may be of a robot that stands.
  if (options_.poses != "given" && counts().odometry_poses == 0 && counts().scans > 1) {
    return log + " has no odometry" +
           (counts().given_poses > 0 ? "\n  next: --poses given" : ", and no other poses");
  }
  return "";
}

nlohmann::ordered_json replay_json(const ReplayOptions& options,
                                   const pipeline::LogCounts& counts) {
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

exports::RunSummary summary_of_log(const PlayedLog& log, const pipeline::Snapshot& snapshot) {
  exports::RunSummary summary;
  summary.echomap_version = ECHOMAP_VERSION;
  summary.sim_seconds = log.duration_s();
  exports::describe_snapshot(snapshot, summary);
  if (const slam::SlamMethod* slam = log.pipeline().slam()) {
    exports::describe_uncertainty(slam->belief().covariance, summary);
  }
  return summary;
}

void write_pose_graph(const std::filesystem::path& path, const slam::FactorGraph& graph) {
  exports::write_pose_graph_g2o(path, graph);
  console::print(fmt::format("pose graph: {} ({} poses, {} landmarks, {} edges)",
                             path.string(),
                             graph.T_map_nodes.size(),
                             graph.landmarks_m.size() + graph.walls.size(),
                             graph.edges.size() + graph.landmark_edges.size()));
}

void print_what_was_made(const exports::RunSummary& summary,
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

/// Throws CommandError where the map of a run's echoes would take the place of the run's own.
void refuse_to_overwrite(const std::filesystem::path& log, const std::filesystem::path& out) {
  const auto folder =
      std::filesystem::is_directory(log) ? log : std::filesystem::absolute(log).parent_path();
  if (recording_of(folder) && std::filesystem::exists(out) &&
      std::filesystem::equivalent(folder, out)) {
    throw CommandError(ExitCode::kUsage,
                       fmt::format("the map of its echoes would overwrite the run {}\n  next: name "
                                   "another folder with --out",
                                   folder.string()));
  }
}

ExitCode replay_log(const ReplayOptions& options) {
  const auto start = Clock::now();
  const auto log = open_reported_log(options.log, options.format);
  const auto out = run_folder(options.out);
  refuse_to_overwrite(options.log, out);
  prepare_outputs(out, options.json, options.force);
  PlayedLog played(options);
  console::ProgressBar progress(stderr, !options.headless);
  const auto [outcome, damage] = played.play(*log, progress);
  progress.clear();
  if (const std::string reason = played.unusable(); outcome == "finished" && !reason.empty()) {
    throw CommandError(ExitCode::kRuntimeError, reason);
  }

  const pipeline::Snapshot snapshot = played.pipeline().snapshot();
  refuse_huge_map(*snapshot.grid);
  exports::RunSummary summary = summary_of_log(played, snapshot);
  const RunEnding ending = ending_of_replay(outcome, damage, out.string());
  describe_ending(ending, summary);
  move_earlier_run_aside(out);
  const bool has_slam = played.pipeline().slam() != nullptr;
  const auto graph = has_slam ? played.pipeline().factor_graph() : slam::FactorGraph{};
  exports::write_run_directory(out,
                               snapshot,
                               summary,
                               {.align = options.align,
                                .holds_echoes = options.map == "points",
                                .name = options.log.stem().string(),
                                .landmarks = {graph.landmarks_m, graph.walls}});
  exports::write_landmarks_csv(out / "landmarks.csv", *snapshot.landmarks);
  if (has_slam) {
    write_pose_graph(out / "pose_graph.g2o", graph);
  }
  summary.wall_seconds = seconds_since(start);
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  report["replay"] = replay_json(options, played.counts());
  write_report(out / "summary.json", report);
  write_report(options.json, report);
  print_what_was_made(summary, played.counts(), out);
  print_ending(ending);
  return ending.code;
}

}  // namespace

ExitCode run_replay(const ReplayOptions& options) {
  if (options.map == "points" && options.resolution_m != ReplayOptions().resolution_m) {
    throw CommandError(ExitCode::kUsage,
                       "--resolution is the edge of a cell, and a map of points has none\n  next: "
                       "leave it out, or --map grid");
  }
  if (plays_recording(options)) {
    return replay_run(options);
  }
  if (options.plays_a_part()) {
    throw CommandError(ExitCode::kUsage,
                       "--from, --until, --speed and --step are for recordings of echomap\n  next: "
                       "leave them out");
  }
  if (options.live.serves) {
    throw CommandError(ExitCode::kUsage,
                       "--live is for recordings of echomap\n  next: leave it out, and look at the "
                       "map.png of the run");
  }
  return replay_log(options);
}

}  // namespace echomap::apps
