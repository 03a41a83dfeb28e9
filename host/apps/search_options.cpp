// SPDX-License-Identifier: MIT
#include "host/apps/search_options.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_options.hpp"
#include "host/apps/map_options.hpp"
#include "host/apps/robot_options.hpp"

namespace echomap::apps {
namespace {

/// A robot at a port, or one that is simulated.
void add_robot_of_search(CLI::App& command, SearchOptions& options) {
  add_connection_options(command, options.connection);
  CLI::Option* world = command.add_option(
      "--world",
      options.robot.world,
      "Simulate the robot in this room: a bundled name, as source_rooms, or a TOML file");
  for (const char* other : {"--port", "--baud", "--no-reset", "--take-over", "--lockstep"}) {
    world->excludes(other);
  }
  command
      .add_option("--source",
                  options.robot.sources,
                  "Simulated: sources in place of the room's, X,Y,STRENGTH in metres and pulses a "
                  "second at 1 m, may be repeated; or none")
      ->allow_extra_args(false)
      ->needs(world);
  command.add_option("--emulator", options.robot.emulator, "Simulated: what runs the firmware")
      ->check(CLI::IsMember({"simavr", "mock"}))
      ->needs(world)
      ->capture_default_str();
  command
      .add_option("--robot",
                  options.run.robot,
                  "Profile of the robot, with a [scalar] sensor of pulses: a bundled name or a "
                  "TOML file")
      ->capture_default_str();
}

}  // namespace

void add_search(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand(
      "search", "Drive a robot with a Geiger tube to a source of radiation, or show there is none");
  const auto options = std::make_shared<SearchOptions>();
  options->run.robot = "uno_geiger";
  options->robot.world.clear();
  add_robot_of_search(*command, *options);
  command
      ->add_option(
          "--seconds", options->max_s, "Robot time after which it ends unsure, exit code 8")
      ->check(CLI::PositiveNumber)
      ->default_str("900");
  command->add_option("--seed", options->run.seed, "Seed of every random generator")
      ->capture_default_str();
  add_out_options(*command, options->run.out, options->run.force);
  command->add_option("--json", options->run.json, "Write a report to this file, '-' for stdout");
  command->add_option("--view", options->run.view, "What a terminal shows during the run")
      ->check(CLI::IsMember({"map", "line", "none"}))
      ->capture_default_str();
  command->add_flag("--headless", options->run.headless, "As --view none")->excludes("--view");
  add_align_option(*command, options->run.align);
  add_live_options(*command, options->live, true);
  command->footer(
      "Example: echomap search --world square_room --source 1.0,1.0,20 --emulator mock --out "
      "found");
  command->callback([&action, options] { action = [options] { return run_search(*options); }; });
}

}  // namespace echomap::apps
