// SPDX-License-Identifier: MIT
#include "host/apps/replay_run.hpp"

#include <chrono>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/report.hpp"
#include "host/apps/resumed_run.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/saved_map.hpp"
#include "host/console/print.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/observations_file.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/slam/slam_methods.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Why the observations of a run are not played; empty where they are.
std::string reason_against(const ReplayOptions& options) {
  const ReplayOptions usual;
  if (!options.format.empty()) {
    return "--format names its echoes alone";
  }
  if (options.map != usual.map || options.poses != usual.poses ||
      options.resolution_m != usual.resolution_m) {
    return "--map, --poses or --resolution asks for another map";
  }
  if (!options.slam.empty() && !slam::slam_by_name(options.slam).takes_cones) {
    return "--slam " + options.slam + " is for lasers";
  }
  for (const char* needed : {kRecordName, kProfileName}) {
    if (!exists(options.log / needed)) {
      return fmt::format("the run has no {}", needed);
    }
  }
  return "";
}

/// The summary of a run, and what of it the replay needs.
struct PlayedSummary {
  ordered_json json;
  std::string slam;
  std::string world;
  std::string robot;
  bool outline_by_strategy = false;
};

PlayedSummary read_summary(const fs::path& path) {
  PlayedSummary summary;
  summary.json = ordered_json::parse(files::read_text_file(path), nullptr, false);
  try {
    summary.json.at("slam").get_to(summary.slam);
    summary.json.at("outline_by_strategy").get_to(summary.outline_by_strategy);
    summary.world = summary.json.value("world", "");
    summary.robot = summary.json.value("robot", "");
  } catch (const nlohmann::json::exception&) {
    throw files::FileError(path.string() +
                           ": not the summary of a run, slam or outline_by_strategy is missing");
  }
  return summary;
}

/// What a strategy has drawn itself is not in the observations.
geometry::Polygon outline_of(const fs::path& run, const PlayedSummary& summary) {
  const auto outline = summary.outline_by_strategy
                           ? exports::read_outline_geojson(run / "outline.geojson")
                           : std::nullopt;
  return outline ? outline->outline_m() : geometry::Polygon{};
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

struct PlayedMap {
  const pipeline::ObservationLog& record;
  const pipeline::RobotPipeline& pipeline;
  std::string slam;
  std::string damage;  ///< Of the record; empty where it is whole.
  bool align = true;
};

void save_played(const PlayedMap& map,
                 const session::RobotProfile& profile,
                 const fs::path& run,
                 const fs::path& out) {
  const PlayedSummary summary = read_summary(run / "summary.json");
  exports::RunSummary made;
  made.slam = map.slam;
  made.world = summary.world;
  made.robot = summary.robot;
  const auto coverage = coverage_of(map.pipeline.snapshot(), profile);
  if (coverage && !summary.json.value("coverage", ordered_json()).is_null()) {
    made.coverage = summary_of(*coverage);
    describe_walls(wall_error_of(map.pipeline), made);
  }
  fs::create_directories(out);
  exports::ObservationsFile(out / kRecordName).save(map.record, false);
  save_map(map.pipeline,
           profile,
           out,
           made,
           {.outline_m = outline_of(run, summary), .align = map.align});
  save_summary(out,
               summary.json,
               made,
               {{"log", run.filename().string()},
                {"map", "grid"},
                {"poses", map.slam},
                {"observations", map.record.observations()}},
               map.damage);
}

/// Answers what is wrong with those that cannot be saved; empty where all are.
std::string save_previous_maps(const pipeline::RobotAtlas& atlas,
                               const std::string& slam,
                               const session::RobotProfile& profile,
                               const ReplayOptions& options,
                               const fs::path& out) {
  std::string damage;
  for (std::size_t i = 0; i < atlas.previous_maps().size(); ++i) {
    const pipeline::PreviousMap& previous = atlas.previous_maps()[i];
    try {
      save_played({previous.record, previous.pipeline, slam, "", options.align},
                  profile,
                  stored_previous_map(options.log, i + 1),
                  previous_map_of(out, i + 1));
    } catch (const files::FileError& error) {
      damage += (damage.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  return damage;
}

/// The run's, or the one that is asked for.
std::string slam_of(const ReplayOptions& options, const session::RobotProfile& profile) {
  std::string slam = read_summary(options.log / "summary.json").slam;
  if (options.slam.empty() || options.slam == slam || !profile.has_sonar) {
    return slam;
  }
  console::print(fmt::format("the map will differ from the run's: it was placed by '{}'", slam));
  return options.slam;
}

}  // namespace

bool plays_observations(const ReplayOptions& options) {
  if (!fs::is_directory(options.log)) {
    return false;
  }
  const std::string reason = reason_against(options);
  if (!reason.empty()) {
    console::print("the map will differ from the run's: " + reason +
                   "; its echoes are mapped as thin beams");
  }
  return reason.empty();
}

console::ExitCode replay_run(const ReplayOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const session::RobotProfile profile =
      session::load_robot_profile((options.log / kProfileName).string());
  const std::string slam = slam_of(options, profile);
  pipeline::RobotAtlas atlas = session::atlas_for(profile, slam);
  std::string damage;
  try {
    play_run(options.log, atlas, atlas);
  } catch (const files::FileError& error) {
    damage = error.what();
  }
  if (damage.empty() && atlas.record().observations() == 0) {
    throw console::CommandError(
        console::ExitCode::kRuntimeError,
        (options.log / kRecordName).string() +
            " is empty: the run has recorded nothing\n  next: name another run");
  }
  const auto out = run_folder(options.out);
  if (!damage.empty() && fs::exists(out) && fs::equivalent(options.log, out)) {
    spdlog::error("{}; the run is left as it is\n  next: name another folder with --out", damage);
    return console::ExitCode::kRuntimeError;
  }
  prepare_outputs(out, options.json, options.force);
  if (!fs::equivalent(options.log, out)) {
    move_earlier_run_aside(out);
  }
  const std::string unsaved = save_previous_maps(atlas, slam, profile, options, out);
  damage += (damage.empty() || unsaved.empty() ? "" : "\n") + unsaved;
  save_played(
      {atlas.record(), atlas.pipeline(), slam, damage, options.align}, profile, options.log, out);
  write_report(options.json, ordered_json::parse(files::read_text_file(out / "summary.json")));
  console::print("map: " + (out / "map.png").string());
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  console::print(fmt::format(
      "{} observations played in {:.2f} s", atlas.record().observations(), wall.count()));
  const RunEnding ending =
      ending_of_replay(damage.empty() ? "finished" : "log-damaged", damage, out.string());
  print_ending(ending);
  return ending.code;
}

}  // namespace echomap::apps
