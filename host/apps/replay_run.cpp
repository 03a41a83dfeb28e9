// SPDX-License-Identifier: MIT
#include "host/apps/replay_run.hpp"

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/live_replay.hpp"
#include "host/apps/recorded_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/saved_map.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/console/wait_for_enter.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/slam/slam_methods.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// A name for the folder of a replay: that of the run, or of the run that a file is in.
std::string name_beside(const fs::path& log) {
  const fs::path run = fs::is_directory(log) ? log : fs::absolute(log).parent_path();
  return (run.has_filename() ? run : run.parent_path()).filename().string() + "_again";
}

bool has_own_cells(const ReplayOptions& options) {
  return options.resolution_m != ReplayOptions().resolution_m;
}

/// Why a recording is not played; empty where it is. What is only felt is mapped in any cells.
std::string reason_against(const ReplayOptions& options, const fs::path& file) {
  const ReplayOptions usual;
  if (!options.format.empty()) {
    return "--format names its echoes alone";
  }
  const auto has_sonar = [&] { return profile_of(recording::SessionReader(file)).has_sonar; };
  if (options.map != usual.map || options.poses != usual.poses ||
      (has_own_cells(options) && has_sonar())) {
    return "--map, --poses or --resolution asks for another map";
  }
  if (!options.slam.empty() && !slam::slam_by_name(options.slam).takes_cones) {
    return "--slam " + options.slam + " is for lasers";
  }
  return "";
}

/// Throws CommandError where the recorded robot has no sonar, and so no echoes for another map.
void throw_if_without_echoes(const fs::path& log, const fs::path& file) {
  const recording::SessionReader recording(file);
  const session::RobotProfile profile = profile_of(recording);
  if (!profile.has_sonar) {
    const bool has_infrared = !profile.sensors.infrared.empty();
    throw console::CommandError(
        console::ExitCode::kUsage,
        fmt::format(
            "{} is a recording of robot '{}', which has no sonar: it holds odometry{} "
            "contacts{}, and no echoes to make another map of\n  next: {}",
            log.string(),
            profile.name,
            has_infrared ? "," : " and",
            has_infrared ? " and infra-red readings" : "",
            console::shell_line({"echomap", "replay", log.string(), "--out", name_beside(log)})));
  }
}

/// The run's summary, with what this replay has made of its map.
void save_summary(const fs::path& folder,
                  ordered_json run,
                  const exports::RunSummary& map,
                  const ordered_json& replay,
                  const std::string& damage) {
  const auto made = ordered_json::parse(exports::to_json_text(map));
  for (const char* key : {"slam",
                          "stops",
                          "poses",
                          "points",
                          "outline_by_strategy",
                          "pose_stddev_m",
                          "pose_stddev_deg",
                          "travelled_m",
                          "free_area_m2",
                          "coverage",
                          "expected_wall_rmse_m",
                          "wall_rmse_p90_m"}) {
    run[key] = made.at(key);
  }
  run["replay"] = replay;
  if (!damage.empty()) {
    run["outcome"] = "log-damaged";
    run["finished"] = false;
    run["why"] = damage;
  }
  write_report(folder / "summary.json", run);
}

/// A map that was made of a recording, and of what.
struct PlayedMap {
  const pipeline::RobotPipeline& pipeline;
  const session::RobotProfile& profile;
  const RunReport& report;
  ordered_json replay;  ///< The entry of the replay in the report.
  geometry::Polygon outline_m{};
  std::string slam{};
  std::string damage{};  ///< Of the recording; empty where it is whole.
  bool align = true;
};

void save_played(const PlayedMap& map, const fs::path& out) {
  exports::RunSummary made;
  made.slam = map.slam;
  made.world = map.report.world;
  made.robot = map.report.robot;
  const auto coverage = coverage_of(map.pipeline.snapshot(), map.profile);
  if (coverage && !map.report.json.value("coverage", ordered_json()).is_null()) {
    made.coverage = summary_of(*coverage);
    describe_walls(wall_error_of(map.pipeline), made);
  }
  fs::create_directories(out);
  save_map(map.pipeline, map.profile, out, made, {.outline_m = map.outline_m, .align = map.align});
  save_summary(out, map.report.json, made, map.replay, map.damage);
}

ordered_json read_json(const fs::path& file) {
  auto json = ordered_json::parse(files::read_text_file(file), nullptr, false);
  if (!json.is_object()) {
    throw files::FileError(file.string() + ": not the summary of a run");
  }
  return json;
}

/// The report of a map that was set aside: the run's own or, where only the recording is there, one
/// like that of the whole run.
RunReport report_of_previous(const fs::path& log, std::size_t number, const RunReport& whole) {
  RunReport report = whole;
  const fs::path file = previous_map_of(log, number) / "summary.json";
  if (exists(file)) {
    report.json = read_json(file);
  } else {
    report.json["outcome"] = "set-aside";
    report.json["coverage"] = nullptr;
  }
  return report;
}

/// Each in a folder of its own beside the map, as the run has written them.
void save_previous_maps(const pipeline::RobotAtlas& atlas,
                        const PlayedMap& map,
                        const fs::path& log,
                        const fs::path& out) {
  for (std::size_t i = 0; i < atlas.previous_maps().size(); ++i) {
    const RunReport report = report_of_previous(log, i + 1, map.report);
    save_played({atlas.previous_maps()[i].pipeline,
                 map.profile,
                 report,
                 map.replay,
                 {},
                 map.slam,
                 map.damage,
                 map.align},
                previous_map_of(out, i + 1));
  }
}

/// The run directory holds the recording, too.
void copy_recording(const fs::path& from, const fs::path& out) {
  const fs::path to = out / recording::kSessionFileName;
  for (std::size_t part = 0; exists(recording::part_of(from, part)); ++part) {
    fs::copy_file(recording::part_of(from, part), recording::part_of(to, part));
  }
  const fs::path metadata = from.parent_path() / recording::kBagMetadataName;
  if (from.filename() == recording::kSessionFileName && exists(metadata)) {
    fs::copy_file(metadata, out / recording::kBagMetadataName);
  }
}

/// The run's, or the one that is asked for.
std::string slam_of(const ReplayOptions& options,
                    const session::RobotProfile& profile,
                    const recording::SessionReader& recording) {
  std::string slam = recording.fact("session", "slam");
  if (options.slam.empty() || options.slam == slam) {
    return slam;
  }
  if (!profile.has_sonar) {
    throw console::CommandError(console::ExitCode::kUsage,
                                "--slam " + options.slam + " needs a sonar, and robot '" +
                                    profile.name +
                                    "' of the recording has none\n  next: leave out --slam");
  }
  console::print(fmt::format("the map will differ from the run's: it was placed by '{}'", slam));
  return options.slam;
}

/// Says where the replay is after a stop; with --step, waits for Enter.
class StopReporter {
 public:
  StopReporter(const recording::SessionReader& recording,
               const pipeline::RobotAtlas& atlas,
               bool waits)
      : recording_(recording), atlas_(atlas), waits_(waits) {}

  void report() {
    if (!waits_) {
      return;
    }
    exports::RunSummary summary;
    const pipeline::Snapshot snapshot = atlas_.pipeline().snapshot();
    exports::describe_snapshot(snapshot, summary);
    const geometry::Pose2& pose = snapshot.latest.T_map_robot;
    console::print(
        fmt::format("{:.1f} s: stop {} at x {:.2f} m, y {:.2f} m, {:.0f} degrees; {:.1f} m2 of "
                    "floor. Enter plays to the next",
                    recording_.elapsed_s(),
                    summary.stops,
                    pose.x_m(),
                    pose.y_m(),
                    geometry::degrees(pose.heading_rad()),
                    summary.free_area_m2));
    waits_ = console::wait_for_enter();
  }

 private:
  const recording::SessionReader& recording_;
  const pipeline::RobotAtlas& atlas_;
  bool waits_;
};

/// A recording that is watched is played so that it can be followed.
PlayedPart part_of(const ReplayOptions& options) {
  constexpr double kWatchedSpeed = 8.0;
  PlayedPart part = options.part;
  if (options.live.serves && !part.speed) {
    part.speed = kWatchedSpeed;
  }
  return part;
}

/// The entry of the report that says what was played.
ordered_json replay_entry(const ReplayOptions& options,
                          const std::string& slam,
                          const Played& played) {
  ordered_json entry{{"log", options.log.filename().string()},
                     {"map", "grid"},
                     {"poses", slam},
                     {"observations", played.observations},
                     {"whole_recording", played.is_whole}};
  if (options.part.from_s > 0.0) {
    entry["from_s"] = options.part.from_s;
  }
  if (std::isfinite(options.part.until_s)) {
    entry["until_s"] = options.part.until_s;
  }
  return entry;
}

bool is_same_file(const fs::path& one, const fs::path& other) {
  return exists(one) && exists(other) && fs::equivalent(one, other);
}

/// Throws CommandError where the recording lies in the folder that is written, and is not the run's
/// own: an earlier one or a later part of it, which would be moved away.
void throw_if_in_the_way(const fs::path& recording, const fs::path& out) {
  if (is_same_file(fs::absolute(recording).parent_path(), out) &&
      !is_same_file(recording, out / recording::kSessionFileName)) {
    throw console::CommandError(console::ExitCode::kUsage,
                                recording.string() + " would be moved away by the run " +
                                    out.string() + "\n  next: name another folder with --out");
  }
}

/// Where a run is replayed into itself, damage leaves it as it is.
void throw_if_damaged_and_own(const Played& played,
                              const fs::path& recording,
                              const fs::path& out) {
  if (!played.damage.empty() && is_same_file(recording, out / recording::kSessionFileName)) {
    throw console::CommandError(
        console::ExitCode::kRuntimeError,
        played.damage + "; the run is left as it is\n  next: name another folder with --out");
  }
}

}  // namespace

bool plays_recording(const ReplayOptions& options) {
  const auto file = recording_of(options.log);
  if (!file) {
    return false;
  }
  const std::string reason = reason_against(options, *file);
  if (!reason.empty()) {
    throw_if_without_echoes(options.log, *file);
    console::print("the map will differ from the run's: " + reason +
                   "; its echoes are mapped as thin beams");
  }
  return reason.empty();
}

console::ExitCode replay_run(const ReplayOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path file = recording_of(options.log).value_or(options.log);
  const auto out = run_folder(options.out);
  throw_if_in_the_way(file, out);
  refuse_to_replace_run(out, options.force);
  recording::SessionReader recording(file);
  throw_if_without_map(recording);
  const session::RobotProfile profile = profile_of(recording);
  const std::string slam = slam_of(options, profile, recording);
  pipeline::RobotAtlas atlas = session::atlas_for(
      profile, slam, {}, has_own_cells(options) ? options.resolution_m : session::kNearCellM);
  pipeline::ObservationFork fork;
  fork.add(atlas);
  const auto live = options.live.serves
                        ? std::make_unique<LiveReplay>(options.live, out, recording, profile, atlas)
                        : nullptr;
  if (live) {
    fork.add(live->sink());
  }
  pipeline::JoinedSessions sessions(fork);
  StopReporter stops(recording, atlas, options.step);
  const Played played = play(recording, profile, {sessions, atlas, &atlas}, part_of(options), [&] {
    stops.report();
    if (live) {
      live->add_stop();
    }
  });
  throw_if_damaged_and_own(played, file, out);
  if (played.damage.empty()) {
    throw_if_empty(atlas.record(), options.part, recording);
  } else if (atlas.record().observations() == 0) {
    throw files::FileError(played.damage);
  }
  const RunReport report = read_report(options.log, recording);
  prepare_outputs(out, options.json, options.force);
  if (!is_same_file(file, out / recording::kSessionFileName)) {
    move_earlier_run_aside(out);
    copy_recording(file, out);
  }
  const PlayedMap map{atlas.pipeline(),
                      profile,
                      report,
                      replay_entry(options, slam, played),
                      outline_of(options.log, report, recording),
                      slam,
                      played.damage,
                      options.align};
  save_previous_maps(atlas, map, options.log, out);
  save_played(map, out);
  write_report(options.json, ordered_json::parse(files::read_text_file(out / "summary.json")));
  console::print("map: " + (out / "map.png").string());
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  console::print(fmt::format("{} observations, {:.0f} s of the robot, played in {:.2f} s",
                             played.observations,
                             played.duration_s,
                             wall.count()));
  const RunEnding ending = ending_of_replay(
      played.damage.empty() ? "finished" : "log-damaged", played.damage, out.string());
  print_ending(ending);
  if (live) {
    live->end(ending);
  }
  return ending.code;
}

}  // namespace echomap::apps
