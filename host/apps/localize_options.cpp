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

}  // namespace

void add_localize(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("localize", "Find and follow a robot, or that of a log, in a map");
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::Option* log = add_log_options(*command, options->log, options->format);
  command->add_option("--map", options->map, "Run directory, or YAML file of a ROS map")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--at",
                   options->at,
                   "Where it starts: x and y in metres, heading in degrees; anywhere by default")
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
  command->callback([&action, options] { action = [options] { return run_localize(*options); }; });
}

}  // namespace echomap::apps
