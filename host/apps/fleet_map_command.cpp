// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/fleet_map_files.hpp"
#include "host/apps/fleet_watch.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/console/shell_line.hpp"

namespace echomap::apps {
namespace {

/// The map that is asked for; throws where the fleet has none.
std::string chosen_map(const FleetMapOptions& options,
                       const fleet::FleetState& state,
                       const fleet_member::TeamPicture& picture) {
  const std::string status = "\n  next: echomap fleet status --as " + options.as.string();
  if (options.of.empty()) {
    std::string largest = largest_map(picture);
    if (largest.empty()) {
      throw CommandError(ExitCode::kUnfinished, "the fleet has no map yet" + status);
    }
    return largest;
  }
  for (const fleet::FleetRobot& robot : state.robots) {
    std::string name = fleet_member::map_name(robot.name, robot.map_number);
    if (robot.name == options.of && picture.team().component_of(name) != nullptr) {
      return name;
    }
  }
  throw CommandError(ExitCode::kUnfinished,
                     "nothing is known of a map of '" + options.of + "'" + status);
}

/// What is drawn and scored by the hull of the profile would be wrong for another robot.
void warn_of_another_hull(const FleetMapOptions& options,
                          const fleet::FleetState& state,
                          const std::string& map,
                          const session::RobotProfile& profile) {
  constexpr double kSameM = 0.005;
  for (const fleet::FleetRobot& robot : state.robots) {
    const double told_m = robot.traits.body_radius_m;
    if (map == fleet_member::map_name(robot.name, robot.map_number) && told_m > 0.0 &&
        std::abs(told_m - profile.body_radius_m) > kSameM) {
      spdlog::warn(
          "{} has a hull of {:.0f} mm radius, profile '{}' one of {:.0f} mm: name its own by "
          "--robot",
          robot.name,
          1e3 * told_m,
          options.robot,
          1e3 * profile.body_radius_m);
    }
  }
}

RunEnding ending_of(std::size_t joined,
                    std::size_t maps,
                    std::size_t missing_objects,
                    const std::string& name,
                    const std::filesystem::path& out,
                    const FleetMapOptions& options) {
  RunEnding ending;
  ending.outcome = joined < maps ? "not-joined" : missing_objects > 0 ? "incomplete" : "joined";
  ending.why =
      fmt::format("{} of {} maps of the fleet are in it, in the frame of {}", joined, maps, name);
  if (missing_objects > 0) {
    ending.why += fmt::format(
        "; {} submaps or source readings that its robots have made did not "
        "come within {:.0f} s",
        missing_objects,
        options.listen_s);
  }
  const bool is_all = joined == maps && missing_objects == 0;
  ending.code = is_all ? ExitCode::kOk : ExitCode::kUnfinished;
  ending.next =
      is_all ? console::shell_line({"echomap", "localize", "--map", out.string()})
             : console::shell_line({"echomap", "fleet", "status", "--as", options.as.string()});
  return ending;
}

}  // namespace

ExitCode run_fleet_map(const FleetMapOptions& options) {
  const auto profile = session::load_robot_profile(options.robot);
  const auto out = run_folder(options.out);
  prepare_outputs(out, options.json, options.force);
  FleetWatch watch(options.as);
  watch.listen_for(options.listen_s);
  watch.require_own_account();
  const fleet::FleetState state = watch.state();
  fleet_member::TeamPicture picture;
  picture.take_with_joins(state);
  const std::string name = chosen_map(options, state, picture);
  warn_of_another_hull(options, state, name, profile);
  const auto snapshot = team_snapshot(picture, name);
  exports::RunSummary summary;
  summary.echomap_version = ECHOMAP_VERSION;
  const std::size_t joined = picture.team().component_of(name)->robots.size();
  std::size_t maps = 0;
  for (const auto& component : picture.team().components()) {
    maps += component.robots.size();
  }
  const RunEnding ending = ending_of(joined, maps, watch.missing_objects(), name, out, options);
  describe_ending(ending, summary);
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): chosen_map answers one that is known
  save_team_map(*snapshot, profile, out, summary);
  save_provenance(picture.team().merged(name), out / "provenance.csv");
  write_report(options.json, nlohmann::ordered_json::parse(exports::to_json_text(summary)));
  print_ending(ending);
  return ending.code;
}

}  // namespace echomap::apps
