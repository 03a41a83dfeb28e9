// SPDX-License-Identifier: MIT
#include "host/apps/fleet_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_options.hpp"
#include "host/apps/map_options.hpp"
#include "host/apps/robot_options.hpp"

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

CLI::Option* add_as(CLI::App& command, std::filesystem::path& as) {
  return command
      .add_option("--as",
                  as,
                  "Credentials of a member, as `echomap fleet start` writes them: "
                  "broker/members/NAME.toml")
      ->required()
      ->check(CLI::ExistingFile);
}

/// Of a fleet that searches a source.
CLI::Option* add_search_options(CLI::App& command, bool& search, double& max_s) {
  CLI::Option* flag =
      command.add_flag("--search",
                       search,
                       "Search a source of radiation together, or show that there is none; the "
                       "robots need a [scalar] sensor of pulses, as uno_geiger has");
  command
      .add_option(
          "--search-seconds", max_s, "Robot time after which a search ends unsure, exit code 8")
      ->check(CLI::PositiveNumber)
      ->needs(flag)
      ->capture_default_str();
  return flag;
}

void add_fleet_start(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand(
      "start", "Start a broker and simulated robots that explore one room together");
  const auto options = std::make_shared<FleetStartOptions>();
  options->robot.robots = 2;
  command->add_option("--robots", options->robot.robots, "How many robots")
      ->check(CLI::Range(std::size_t{1}, std::size_t{16}))
      ->capture_default_str();
  command->add_option("--world", options->robot.world, "A bundled world or a TOML file")
      ->capture_default_str();
  command
      ->add_option("--starts",
                   options->robot.starts,
                   "Where they start, x,y,degrees;x,y,degrees;.. or drawn; by default the first "
                   "where the world has it, the others drawn by the seed")
      ->capture_default_str();
  command->add_option("--emulator", options->robot.emulator, "What runs the firmware")
      ->check(CLI::IsMember({"simavr", "mock"}))
      ->capture_default_str();
  command->add_flag("--tls", options->tls, "The broker speaks TLS, by a certificate made for it");
  command->add_option("--robot", options->run.robot, "Profile of the robots")
      ->capture_default_str();
  add_search_options(*command, options->search, options->max_s);
  command
      ->add_option("--source",
                   options->robot.sources,
                   "Sources in place of the room's, X,Y,STRENGTH in metres and pulses a second at "
                   "1 m, may be repeated; or none")
      ->allow_extra_args(false);
  command->add_option("--seed", options->run.seed, "Seed of every random generator")
      ->capture_default_str();
  add_out_options(*command, options->run.out, options->run.force);
  command->add_option("--json", options->run.json, "Write a report to this file, '-' for stdout");
  command->add_flag("--headless", options->run.headless, "No live page");
  add_live_options(*command, options->live, false);
  command->footer("Example: echomap fleet start --robots 2 --world corridor_rooms");
  command->callback([&action, options] {
    options->live.serves = !options->run.headless;
    action = [options] { return run_fleet_start(*options); };
  });
}

void add_fleet_broker(CLI::App& fleet, CommandAction& action) {
  CLI::App* command =
      fleet.add_subcommand("broker", "Run a broker with TLS for robots on other machines");
  const auto options = std::make_shared<FleetBrokerOptions>();
  command
      ->add_option("--robots",
                   options->robots,
                   "Names of the robots, with commas between them; not hub and watch")
      ->delimiter(',')
      ->required();
  command->add_option("--fleet", options->fleet, "Name of the fleet")->capture_default_str();
  command->add_option("--address", options->address, "Address of this machine that it listens on")
      ->capture_default_str();
  command->add_option("--port", options->port, "TCP port; 0: any free one, another at each start")
      ->capture_default_str();
  command
      ->add_option("--name",
                   options->host_names,
                   "Name or address that the robots' hosts have for this machine; may be repeated. "
                   "By default --address")
      ->allow_extra_args(false);
  command
      ->add_option("--bridge-as",
                   options->bridge_as,
                   "Credentials of this site at the broker of its region: bridges presence, "
                   "manifests, graphs and submaps to it")
      ->check(CLI::ExistingFile);
  command
      ->add_option("--out",
                   options->out,
                   "Folder of the broker: accounts, certificate and what it has retained; one that "
                   "is there is used again")
      ->required();
  command->footer(
      "Example: echomap fleet broker --robots alice,bob --name 192.168.1.7 --out lab_broker");
  command->callback(
      [&action, options] { action = [options] { return run_fleet_broker(*options); }; });
}

void add_fleet_join(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand("join", "Drive a robot as a member of a fleet");
  const auto options = std::make_shared<FleetJoinOptions>();
  add_as(*command, options->as);
  add_connection_options(*command, options->connection);
  command
      ->add_option("--knows",
                   options->knows,
                   "Where another robot started, in this one's map: NAME,X,Y,DEGREES; may be "
                   "repeated. Without it the maps are joined by what the sonars hear")
      ->allow_extra_args(false);
  command
      ->add_option("--round-with",
                   options->rounds_with,
                   "Of a simulated fleet: a robot of it, this one included; may be repeated")
      ->allow_extra_args(false);
  add_search_options(*command, options->search, options->max_s);
  add_run_options(*command, options->run);
  command->footer("Example: echomap fleet join --as broker/members/robot0.toml");
  command->callback(
      [&action, options] { action = [options] { return run_fleet_join(*options); }; });
}

void add_fleet_status(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand("status", "Who is in a fleet, and how far it has come");
  const auto options = std::make_shared<FleetStatusOptions>();
  add_as(*command, options->as);
  command->add_option("--listen-s", options->listen_s, "How long it listens, seconds")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str();
  command->add_option("--json", options->json, "Write a report to this file, '-' for stdout");
  command->callback(
      [&action, options] { action = [options] { return run_fleet_status(*options); }; });
}

void add_fleet_map(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand("map", "Write the map that a fleet has made so far");
  const auto options = std::make_shared<FleetMapOptions>();
  add_as(*command, options->as);
  command->add_option(
      "--of", options->of, "Robot in whose frame it is; by default of the largest map");
  command
      ->add_option(
          "--robot", options->robot, "Profile of that robot: a bundled name or a TOML file")
      ->capture_default_str();
  command->add_option("--listen-s", options->listen_s, "How long it listens, seconds")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str();
  add_out_options(*command, options->out, options->force);
  command->add_option("--json", options->json, "Write a report to this file, '-' for stdout");
  command->callback([&action, options] { action = [options] { return run_fleet_map(*options); }; });
}

void add_fleet_record(CLI::App& fleet, CommandAction& action) {
  CLI::App* command = fleet.add_subcommand("record", "Write all that a fleet says to an MCAP file");
  const auto options = std::make_shared<FleetRecordOptions>();
  add_as(*command, options->as);
  command->add_option("--out", options->out, "The file")->required();
  command->add_option("--for-s", options->for_s, "How long, seconds; 0: until Ctrl-C")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace the file");
  command->callback(
      [&action, options] { action = [options] { return run_fleet_record(*options); }; });
}

}  // namespace

void add_fleet(CLI::App& app, CommandAction& action) {
  CLI::App* fleet = app.add_subcommand("fleet", "Work with several robots at once");
  fleet->require_subcommand(1);
  add_fleet_start(*fleet, action);
  add_fleet_broker(*fleet, action);
  add_fleet_join(*fleet, action);
  add_fleet_status(*fleet, action);
  add_fleet_map(*fleet, action);
  add_fleet_record(*fleet, action);
  add_fleet_replay(*fleet, action);
}

}  // namespace echomap::apps
