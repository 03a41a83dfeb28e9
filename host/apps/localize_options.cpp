// SPDX-License-Identifier: MIT
#include "host/apps/localize_options.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_options.hpp"
#include "host/apps/localize_places.hpp"
#include "host/apps/map_options.hpp"
#include "host/apps/robot_options.hpp"
#include "host/pipeline/preset_names.hpp"

namespace echomap::apps {

namespace {

localization::LocalizerPreset preset_option(const std::string& name) {
  try {
    return pipeline::preset_named(name);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--preset", error.what());
  }
}

std::string check_finite(const std::string& text) {
  double number = 0.0;
  return CLI::detail::lexical_cast(text, number) && std::isfinite(number) ? ""
                                                                          : "it must be a number";
}

/// A map, or the folder of learned places.
std::string check_map(const std::string& text) {
  const auto places = places_of(text);
  std::string name = places ? places->string() : text;
  return places ? CLI::ExistingDirectory(name) : CLI::ExistingPath(name);
}

/// Of a robot without a map.
void check_places(const CLI::App& command, const LocalizeOptions& options) {
  if (options.log.empty()) {
    throw CLI::ValidationError("--map", "places=DIR is for the sweep of a log: name the log");
  }
  for (const char* of_a_filter : {"--preset", "--particles", "--resampling", "--at"}) {
    if (command.count(of_a_filter) > 0) {
      throw CLI::ValidationError(of_a_filter, "places=DIR has no particles: leave it out");
    }
  }
}

/// What would do nothing is refused.
void check_what_fits(const CLI::App& command, const LocalizeOptions& options) {
  const bool is_ekf = options.filter == "ekf";
  if (is_ekf && !options.log.empty()) {
    throw CLI::ValidationError("--filter", "ekf follows a robot on a --port, not a log");
  }
  const std::vector<std::string> others =
      is_ekf ? std::vector<std::string>{"--map", "--preset", "--particles", "--resampling"}
             : std::vector<std::string>{"--fixes", "--camera-at"};
  for (const std::string& other : others) {
    if (command.count(other) > 0) {
      throw CLI::ValidationError(other,
                                 std::string("it is for --filter ") + (is_ekf ? "mcl" : "ekf"));
    }
  }
  if (places_of(options.map)) {
    check_places(command, options);
  }
  const std::string needed = is_ekf ? "--fixes" : "--map";
  if (command.count(needed) == 0) {
    throw CLI::RequiredError(needed);
  }
}

void add_filter_options(CLI::App& command, LocalizeOptions& options) {
  command
      .add_option(
          "--filter",
          options.filter,
          "mcl localizes by ranges in a map, ekf by the pose measurements of an overhead camera")
      ->check(CLI::IsMember({"mcl", "ekf"}))
      ->capture_default_str();
  command.add_option("--fixes",
                     options.fixes,
                     "Pose measurements of an overhead camera: listen at udp:HOST:PORT, or fetch "
                     "from tcp:HOST:PORT");
  command
      .add_option("--camera-at",
                  options.camera_at,
                  "Pose of the camera's frame in the map: x and y in metres, degrees")
      ->expected(3)
      ->check(check_finite);
  command.add_option_function<std::string>(
      "--preset",
      [&options](const std::string& name) { options.preset = preset_option(name); },
      "Filter preset, ours or that of a paper: " +
          CLI::detail::join(pipeline::preset_names(), ", "));
  command
      .add_option(
          "--particles", options.particles, "Number of particles; by default that of the preset")
      ->check(CLI::Range(std::size_t{10}, std::size_t{200'000}));
  command
      .add_option("--resampling",
                  options.resampling_share,
                  "Resample below this share of effective particles, 1 at every update; by default "
                  "that of the preset")
      ->check(CLI::Range(0.0, 1.0));
}

}  // namespace

void add_localize(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("localize", "Localize a robot, live or from a log, in a given map");
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::Option* log = add_log_options(*command, options->log, options->format);
  command->get_option("--format")->needs(log);
  command
      ->add_option("--map",
                   options->map,
                   "Run directory, or YAML file of a ROS map; for mcl. Or places=DIR: the sweep of "
                   "a log is compared with those of places, a file of DIR each")
      ->check(check_map);
  command
      ->add_option("--at",
                   options->at,
                   "Start pose: x and y in metres, heading in degrees; anywhere by default")
      ->expected(3)
      ->check(check_finite);
  add_filter_options(*command, *options);
  add_connection_options(*command, options->connection);
  add_run_options(*command, options->run);
  add_live_options(*command, options->live, true);
  for (const char* of_a_robot : {"--port",
                                 "--baud",
                                 "--reconnect",
                                 "--no-reset",
                                 "--take-over",
                                 "--lockstep",
                                 "--robot",
                                 "--stops",
                                 "--live"}) {
    command->get_option(of_a_robot)->excludes(log);
  }
  command->footer(
      "Example: echomap localize tuesday.log --map monday\n"
      "Example: echomap localize --port /dev/ttyACM0 --map kitchen\n"
      "Example: echomap localize --port /dev/ttyACM0 --robot create --map arena\n"
      "Example: echomap localize field --map field --preset epuck --resampling 1\n"
      "Example: echomap localize sweep.dat --format nxt --map places=learned");
  command->callback([&action, command, options] {
    check_what_fits(*command, *options);
    action = [options] { return run_localize(*options); };
  });
}

}  // namespace echomap::apps
