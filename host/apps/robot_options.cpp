// SPDX-License-Identifier: MIT
#include "host/apps/robot_options.hpp"

#include <memory>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_options.hpp"
#include "host/apps/map_options.hpp"
#include "host/boards/boards.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/slam/slam_methods.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {
namespace {

/// As far as the map's cost was measured (docs/algorithms/sonar_grid.md).
constexpr std::size_t kMaxStops = 1000;
constexpr std::size_t kMaxScans = 5;

/// In seconds: the robot's stamps of 32 bits tell absences of up to 35.8 minutes apart.
constexpr double kLongestAbsenceS = 1800.0;

/// A board names its emulator and its robot; an emulator of one board alone names that. Where board
/// and emulator are both named they have to fit.
void choose_board(DemoOptions& options, bool emulator_is_named, bool robot_is_named) {
  session::SimulatedRobotOptions& robot = options.robot;
  const boards::Board* board = robot.board.empty() ? boards::usual_board_of(robot.emulator)
                                                   : &boards::board_named(robot.board);
  if (board == nullptr) {
    return;
  }
  if (!robot.board.empty() && emulator_is_named && robot.emulator != board->emulator) {
    throw CLI::ValidationError("--board",
                               robot.board + " is emulated by " + std::string(board->emulator) +
                                   ", not by " + robot.emulator);
  }
  robot.board = board->name;
  robot.emulator = board->emulator;
  if (!robot_is_named) {
    options.run.robot = board->robot;
  }
}

/// Each emulator with the boards that it emulates: "uno or mega by simavr, ..".
std::string boards_by_emulator() {
  std::string words;
  for (const std::string& emulator : boards::emulator_names()) {
    std::string names;
    for (const boards::Board& board : boards::all_boards()) {
      if (board.emulator == emulator) {
        names += (names.empty() ? "" : " or ") + std::string(board.name);
      }
    }
    words += (words.empty() ? "" : ", ") + names + " by " + emulator;
  }
  return words;
}

/// One of these boards; for another word, the one that may be meant.
CLI::Validator board_among(const std::vector<std::string>& names) {
  return {[names](const std::string& name) { return boards::fault_of_board(name, names); },
          CLI::detail::generate_set(names)};
}

std::vector<std::string> emulators_and_mock() {
  std::vector<std::string> names = boards::emulator_names();
  names.emplace_back("mock");
  return names;
}

/// A camera knows better, so that one of both has the robot's pose.
void add_slam_option(CLI::App& command, RunOptions& run) {
  command
      .add_option("--slam",
                  run.slam,
                  "SLAM method of a robot with a sonar: multiscan (graph of gathered echoes), ekf "
                  "(walls and points) or none (odometry alone)")
      ->check(slam::renamed_slam_method)
      ->check(CLI::IsMember(session::live_slam_names()))
      ->each([&run](const std::string& /*name*/) { run.slam_is_named = true; })
      ->excludes("--fixes")
      ->capture_default_str();
}

}  // namespace

void add_run_options(CLI::App& command, RunOptions& run) {
  command.add_option("--robot", run.robot, "Profile of the robot: a bundled name or a TOML file")
      ->capture_default_str();
  command.add_option("--strategy", run.strategy.name, "Exploration strategy")
      ->check(CLI::IsMember(strategies::strategy_names()))
      ->capture_default_str();
  command
      .add_option("--stops",
                  run.strategy.stops,
                  "Maximum number of stops; by default as many as it takes, of localize 20")
      ->check(CLI::Range(std::size_t{1}, kMaxStops));
  command
      .add_option("--scans",
                  run.strategy.scans,
                  "How often nxt-farthest scans the room, each time with as many stops")
      ->check(CLI::Range(std::size_t{1}, kMaxScans))
      ->capture_default_str();
  command.add_option(
      "--waypoints",
      run.strategy.waypoints,
      "Waypoints and known walls of tangent-bug: a bundled name, as playground, or a TOML file");
  command.add_option("--stop-list",
                     run.strategy.stop_list,
                     "Places that stops drives to, in the frame of the start pose: a TOML file "
                     "(docs/algorithms/stop_tour.md)");
  command
      .add_option(
          "--hand", run.strategy.hand, "Side of coastal's wall sensor: the hand on the wall")
      ->check(CLI::IsMember({"right", "left"}))
      ->capture_default_str();
  command.add_flag("--as-told",
                   run.strategy.as_told,
                   "Leave out those of our departures from the paper of nxt-farthest, coastal or "
                   "tangent-bug that a parameter can switch off (docs/papers.md)");
  command.add_option("--seconds", run.strategy.seconds, "Duration of random-bounce, seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--seed", run.seed, "Seed of every random generator")->capture_default_str();
  add_out_options(command, run.out, run.force);
  command.add_option("--json", run.json, "Write a report to this file, '-' for stdout");
  CLI::Option* view =
      command
          .add_option("--view",
                      run.view,
                      "What a terminal shows during the run: map (the map and the robot, drawn in "
                      "place), line (a progress line) or none")
          ->check(CLI::IsMember({"map", "line", "none"}))
          ->capture_default_str();
  command.add_flag("--headless", run.headless, "As --view none; of demo no live page, too")
      ->excludes(view);
  command
      .add_option("--split",
                  run.split_mb,
                  "Megabytes at which the recording goes on in another file; 0: never")
      ->capture_default_str();
}

void add_connection_options(CLI::App& command, session::ConnectionOptions& options) {
  command.add_option(
      "--port",
      options.ports,
      "Serial device, pty, tcp://HOST:PORT, bt://ADDRESS or id:TEXT of a USB port; of "
      "several the one robot that answers. By default the one port where a robot "
      "has answered before; `echomap ports` lists them");
  command
      .add_option("--baud",
                  options.baud,
                  "Speed of a serial device; by default that of 250000, 115200 and 500000 at which "
                  "the robot answers")
      ->check(CLI::IsMember({9600, 57600, 115200, 250000, 500000}));
  command
      .add_option("--reconnect",
                  options.reconnect_s,
                  "Seconds to wait for a robot that was unplugged or reset")
      ->check(CLI::Range(0.0, kLongestAbsenceS))
      ->capture_default_str();
  command.add_flag("--no-reset",
                   options.no_reset,
                   "Join a running robot, and stop if opening its port has reset it: the kernel "
                   "raises DTR when a port is first opened after plugging in, which resets most "
                   "Arduinos; it stays up from then on");
  command.add_flag("--take-over",
                   options.take_over,
                   "Take the robot from another program that holds it; without it that program is "
                   "left alone, and this one ends");
  command.add_option("--lockstep", options.lockstep, "Socket of a simulated robot's clock");
  options.session_number = std::random_device{}();
}

void add_explore(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand("explore", "Drive a robot through its room and map it");
  const auto options = std::make_shared<ExploreOptions>();
  add_connection_options(*command, options->connection);
  command->add_option("--fixes",
                      options->fixes,
                      "Pose measurements of an overhead camera at udp:HOST:PORT or tcp:HOST:PORT "
                      "(docs/guides/localize.md)");
  add_run_options(*command, options->run);
  add_align_option(*command, options->run.align);
  add_slam_option(*command, options->run);
  command
      ->add_option("--resume",
                   options->resume,
                   "Resume the map of this run directory; the robot stands where that run ended")
      ->check(CLI::ExistingDirectory)
      ->excludes("--fixes");
  add_live_options(*command, options->live, true);
  command->alias("slam");
  command->footer("Example: echomap explore --port /dev/ttyACM0 --robot uno_2wd --out kitchen");
  command->callback([&action, options] { action = [options] { return run_explore(*options); }; });
}

void add_demo(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand(
      "demo", "Explore a simulated room with an emulated robot, and score the map");
  const auto options = std::make_shared<DemoOptions>();
  command->add_option("--world", options->robot.world, "Room: a bundled name or a TOML file")
      ->capture_default_str();
  const CLI::Option* emulator =
      command
          ->add_option("--emulator",
                       options->robot.emulator,
                       "mock runs the firmware natively, all others the binary that a user flashes")
          ->check(CLI::IsMember(emulators_and_mock()))
          ->capture_default_str();
  command
      ->add_option(
          "--board", options->robot.board, "The board that is emulated: " + boards_by_emulator())
      ->check(board_among(boards::emulated_board_names()));
  command->add_option("--driver",
                      options->robot.driver,
                      "Motor driver of profile and simulated robot: tb6612fng, l298n, drv8833, .. "
                      "(docs/guides/simulated_world.md); by default the profile's");
  command
      ->add_option("--line",
                   options->robot.line,
                   "Serial line: direct, or with the modelled delays of an adapter")
      ->check(CLI::IsMember({"direct", "usb", "ftdi", "bluetooth"}))
      ->capture_default_str();
  command->add_option("--faults",
                      options->robot.faults,
                      "Faults of the line, as in loss=0.01: see echomap-simavr --help");
  command->add_option("--part-faults",
                      options->robot.part_faults,
                      "Parts that fail, as in sonar-dead@30: see echomap-simavr --help");
  command->add_option("--body",
                      options->robot.body,
                      "The simulated body, where --robot is the host's profile of it: a bundled "
                      "name or a TOML file; by default the name in the profile");
  CLI::Option* fixes = command->add_option(
      "--fixes",
      options->robot.fixes,
      "Simulate an overhead camera and localize by its pose measurements at udp:127.0.0.1:PORT");
  command
      ->add_option("--camera-params",
                   options->robot.camera_params,
                   "Parameters of that camera: see echomap-simavr --help")
      ->needs(fixes);
  command->add_flag(
      "--no-kidnap",
      options->no_kidnap,
      "Stop after mapping; by default a robot with a sonar is then carried off and relocalizes");
  const auto speed = std::make_shared<double>(0.0);
  const CLI::Option* speed_is_named = add_speed_option(*command, *speed);
  add_live_options(*command, options->live, false);
  add_run_options(*command, options->run);
  add_align_option(*command, options->run.align);
  add_slam_option(*command, options->run);
  const CLI::Option* robot = command->get_option("--robot");
  command->footer("Example: echomap demo --world living_room --seed 7 --out first_map");
  command->callback([&action, options, emulator, robot, speed, speed_is_named] {
    choose_board(*options, emulator->count() > 0, robot->count() > 0);
    options->live.serves = !options->run.headless;
    if (speed_is_named->count() > 0) {
      options->speed = *speed;
    }
    action = [options] { return run_demo(*options); };
  });
}

void add_flash(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand("flash", "Write the firmware to a board");
  const auto options = std::make_shared<FlashOptions>();
  command->add_option("--board", options->board, "Which board; by default what its USB id says")
      ->check(board_among(boards::board_names()));
  command
      ->add_option("--port",
                   options->port,
                   "Serial device, or id:TEXT of a USB port or ST-Link; by default the one board "
                   "here that its USB id gives away")
      ->envname("ECHOMAP_PORT");
  command->add_option("--image",
                      options->image,
                      "Intel hex file, of an EV3 the program, of a Pico .bin or .uf2; by default "
                      "the one of this build");
  command
      ->add_option(
          "--baud",
          options->baud,
          "Speed of that image, by default 250000: 115200 for an HC-05 or a bridge that is "
          "set to it")
      ->check(CLI::IsMember({9600, 115200, 250000, 500000}))
      ->excludes("--image");
  command->add_option(
      "--host", options->host, "Of an EV3: USER@NAME for ssh; by default robot@ev3dev.local");
  CLI::Option* volume = command->add_option(
      "--volume",
      options->volume,
      "Of a Pico: where the drive RPI-RP2 of its boot loader is mounted; by default "
      "the one that is");
  command
      ->add_option("--uf2",
                   options->uf2,
                   "Of a Pico: write the image as this UF2 file instead of flashing it")
      ->excludes(volume);
  command->add_flag("--dry-run", options->dry_run, "Only print the commands");
  command->footer("Example: echomap flash --board nano --port /dev/ttyUSB0");
  command->callback([&action, options] { action = [options] { return run_flash(*options); }; });
}

}  // namespace echomap::apps
