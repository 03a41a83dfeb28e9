// SPDX-License-Identifier: MIT
#include "host/apps/fleet_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/map_options.hpp"

namespace echomap::apps {
namespace {

void add_fleet_replay(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand(
      "replay",
      "Localize recorded robots jointly, by landmarks and by what they saw of each other");
  const auto options = std::make_shared<FleetReplayOptions>();
  command
      ->add_option(
          "folder",
          options->folder,
          "Folder of UTIAS MRCLAM logs: RobotN_Odometry.dat and what goes with them, plain "
          "or gz")
      ->required()
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--blind",
                   options->blind,
                   "Number of a robot whose sightings of landmarks are left out; may be repeated")
      ->allow_extra_args(false)
      ->check(CLI::PositiveNumber);
  add_out_options(*command, options->out, options->force);
  command->add_option("--json", options->json, "Write a report to this file, '-' for stdout");
  command->add_flag("--headless", options->headless, "No progress line");
  command->footer("Example: echomap fleet replay MRCLAM_Dataset6 --out team");
  command->callback(
      [&action, options] { action = [options] { return run_fleet_replay(*options); }; });
}

}  // namespace

void add_fleet(CLI::App& app, CommandAction& action) {
  CLI::App* fleet = app.add_subcommand("fleet", "Work with several robots at once");
  fleet->require_subcommand(1);
  add_fleet_replay(*fleet, action);
}

}  // namespace echomap::apps
