// SPDX-License-Identifier: MIT
#include "host/apps/localize_options.hpp"

#include <memory>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
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

void check_what_fits(const LocalizeOptions& options) {
  const bool is_ekf = options.filter == "ekf";
  if (is_ekf && !options.log.empty()) {
    throw CLI::ValidationError("--filter", "ekf follows a robot on a --port, not a log");
  }
  if (is_ekf && options.fixes.empty()) {
    throw CLI::RequiredError("--fixes");
  }
  if (!is_ekf && !options.fixes.empty()) {
    throw CLI::ValidationError("--fixes", "they are for --filter ekf");
  }
  if (!is_ekf && options.map.empty()) {
    throw CLI::RequiredError("--map");
  }
}

}  // namespace

void add_localize(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("localize", "Find and follow a robot, or that of a log, in a map");
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::Option* log = add_log_options(*command, options->log, options->format);
  command->add_option("--map", options->map, "Run directory, or YAML file of a ROS map; for mcl")
      ->check(CLI::ExistingPath);
  command
      ->add_option("--at",
                   options->at,
                   "Where it starts: x and y in metres, heading in degrees; anywhere by default")
      ->expected(3);
  command
      ->add_option("--filter",
                   options->filter,
                   "mcl finds the robot in a map by its ranges, ekf follows it by the fixes of an "
                   "overhead camera")
      ->check(CLI::IsMember({"mcl", "ekf"}))
      ->capture_default_str();
  command->add_option("--fixes",
                      options->fixes,
                      "Fixes of an overhead camera: udp:HOST:PORT, where they are listened for, or "
                      "tcp:HOST:PORT, where they are fetched");
  command
      ->add_option("--camera-at",
                   options->camera_at,
                   "Where the map has the camera's frame: x and y in metres, degrees")
      ->expected(3);
  command->add_option_function<std::string>(
      "--preset",
      [options](const std::string& name) { options->preset = preset_option(name); },
      "The filter: ours, or that of a paper: " + CLI::detail::join(pipeline::preset_names(), ", "));
  add_connection_options(*command, options->connection);
  command->get_option("--port")->excludes(log);
  add_run_options(*command, options->run);
  command->footer(
      "Example: echomap localize tuesday.log --map monday\n"
      "Example: echomap localize --port /dev/ttyACM0 --map kitchen");
  command->callback([&action, options] {
    check_what_fits(*options);
    action = [options] { return run_localize(*options); };
  });
}

}  // namespace echomap::apps
