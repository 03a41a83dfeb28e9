// SPDX-License-Identifier: MIT
#include "host/apps/command_line.hpp"

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/flash_boards.hpp"
#include "host/apps/interrupt.hpp"
#include "host/datasets/open_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/nearest_word.hpp"
#include "host/files/toml_reader.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::apps {
namespace {

/// Where the grid of one stop begins to take a second (docs/algorithms/sonar_grid.md).
constexpr std::size_t kMostStops = 100;

/// In seconds: the robot's stamps of 32 bits tell absences of up to 35.8 minutes apart.
constexpr double kLongestAbsenceS = 1800.0;

using Action = std::function<ExitCode()>;

void add_run_options(CLI::App& command, RunOptions& run) {
  command.add_option("--robot", run.robot, "Profile of the robot: a bundled name or a TOML file")
      ->capture_default_str();
  command.add_option("--strategy", run.strategy, "How to explore")
      ->check(CLI::IsMember({"nxt-farthest"}))
      ->capture_default_str();
  command.add_option("--stops", run.stops, "End after this many stops at the latest")
      ->check(CLI::Range(std::size_t{1}, kMostStops))
      ->capture_default_str();
  command.add_option("--seed", run.seed, "Seed of every random choice")->capture_default_str();
  command.add_option("--out", run.out, "Run directory; a stamped one by default");
  command.add_option("--json", run.json, "Write a report to this file, '-' for stdout");
  command.add_flag("--headless", run.headless, "No progress line");
}

void add_explore(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explore", "Drive a robot through its room and map it");
  const auto options = std::make_shared<ExploreOptions>();
  command->add_option(
      "--port",
      options->ports,
      "Serial device, pty, tcp://HOST:PORT, bt://ADDRESS or id:TEXT of a USB port. "
      "Of several, or of all ports where none is named, the one robot that answers");
  command->add_option("--baud", options->baud, "Speed of a serial device")
      ->check(CLI::IsMember({9600, 57600, 115200, 250000, 500000}))
      ->capture_default_str();
  command
      ->add_option("--reconnect",
                   options->reconnect_s,
                   "Wait so many seconds for a robot that was unplugged or reset")
      ->check(CLI::Range(0.0, kLongestAbsenceS))
      ->capture_default_str();
  command->add_flag("--no-reset",
                    options->no_reset,
                    "Join a robot that runs, and end where opening its port has reset it: the "
                    "kernel raises DTR when a port is first opened after plugging in, or after a "
                    "program that dropped it, and that resets most Arduinos; it stays up from "
                    "then on");
  command->add_option("--lockstep", options->lockstep, "Socket of a simulated robot's clock");
  add_run_options(*command, options->run);
  command->footer("Example: echomap explore --port /dev/ttyACM0 --robot uno_2wd --out kitchen");
  command->callback([&action, options] { action = [options] { return run_explore(*options); }; });
}

/// A board names its emulator; where both are named they have to fit.
void choose_emulator(DemoOptions& options, bool emulator_is_named) {
  if (options.board.empty()) {
    return;
  }
  const std::string fitting = options.board == "stm32f103" ? "unicorn" : "simavr";
  if (emulator_is_named && options.emulator != fitting) {
    throw CLI::ValidationError(
        "--board", options.board + " is emulated by " + fitting + ", not by " + options.emulator);
  }
  options.emulator = fitting;
}

void add_demo(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("demo", "Watch an emulated robot map a room, and see it scored");
  const auto options = std::make_shared<DemoOptions>();
  command->add_option("--world", options->world, "Room: a bundled name or a TOML file")
      ->capture_default_str();
  const CLI::Option* emulator =
      command
          ->add_option("--emulator",
                       options->emulator,
                       "simavr and unicorn run the binary that a user flashes, of an AVR board and "
                       "of an STM32, mock the same code natively")
          ->check(CLI::IsMember({"simavr", "unicorn", "mock"}))
          ->capture_default_str();
  command
      ->add_option("--board",
                   options->board,
                   "The board that is emulated: uno or mega by simavr, stm32f103 by unicorn")
      ->check(CLI::IsMember({"uno", "mega", "stm32f103"}));
  command
      ->add_option("--line",
                   options->line,
                   "What carries the bytes: nothing between, or a model of a line's delays")
      ->check(CLI::IsMember({"direct", "usb", "ftdi", "bluetooth"}))
      ->capture_default_str();
  command->add_option("--faults",
                      options->faults,
                      "Faults of the line, as in loss=0.01: see echomap-simavr --help");
  command->add_option(
      "--body",
      options->body,
      "What is true of the robot, where --robot is what the host believes: a bundled "
      "name or a TOML file; by default the name in the profile");
  add_run_options(*command, options->run);
  command->footer("Example: echomap demo --world living_room --seed 7 --out first_map");
  command->callback([&action, options, emulator] {
    choose_emulator(*options, emulator->count() > 0);
    action = [options] { return run_demo(*options); };
  });
}

void add_eval(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("eval", "Score a run against what is known to be true");
  const auto options = std::make_shared<EvalOptions>();
  command->add_option("run", options->run, "Run directory")
      ->required()
      ->check(CLI::ExistingDirectory);
  CLI::Option* truth =
      command->add_option("--truth", options->truth, "Directory that the simulated robot wrote")
          ->check(CLI::ExistingDirectory);
  const CLI::Option* relations =
      command
          ->add_option("--relations",
                       options->relations,
                       "Known ways between records, lines 'from to dx dy dtheta': rows of "
                       "trajectory.tum from 0, metres, radians")
          ->check(CLI::ExistingFile);
  command
      ->add_option("--picture",
                   options->picture,
                   "Draw the map on the truth, its errors coloured, to this PNG file")
      ->needs(truth);
  command->add_option("--json", options->json, "Write the scores to this file, '-' for stdout");
  command->footer("Example: echomap eval first_map --truth first_map/truth --json -");
  command->callback([&action, options, truth, relations] {
    if (truth->count() == 0 && relations->count() == 0) {
      throw CLI::RequiredError("--truth or --relations");
    }
    action = [options] { return run_eval(*options); };
  });
}

void add_diff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("diff", "Say what changed between two maps of one room");
  const auto options = std::make_shared<DiffOptions>();
  command->add_option("before", options->before, "Run directory")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("after", options->after, "Run directory of a later run")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--picture", options->picture, "Draw the changes to this PNG file");
  command->add_option("--json", options->json, "Write the changes to this file, '-' for stdout");
  command->footer("Example: echomap diff monday tuesday --picture changes.png");
  command->callback([&action, options] { action = [options] { return run_diff(*options); }; });
}

/// What every command has that reads a log and writes a run directory.
template <typename Options>
void add_log_options(CLI::App* command, Options& options) {
  command->add_option("log", options.log, "File of the log, plain or gz, or a run directory")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option(
          "--format", options.format, "Format of the log; not needed where the log says it")
      ->check([](const std::string& name) { return datasets::unknown_format(name); });
  command->add_option("--out", options.out, "Run directory; a stamped one by default");
  command->add_option("--json", options.json, "Write a report to this file, '-' for stdout");
  command->add_flag("--headless", options.headless, "No progress line");
}

void add_replay(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("replay", "Make a map of a robot's log");
  const auto options = std::make_shared<ReplayOptions>();
  add_log_options(command, *options);
  command
      ->add_option("--map",
                   options->map,
                   "What to make: an occupancy grid, the points of all echoes, or the polygon "
                   "around the floor")
      ->check(CLI::IsMember({"grid", "points", "polygon"}))
      ->capture_default_str();
  command
      ->add_option("--poses",
                   options->poses,
                   "Where scans were taken: by the robot's odometry, or by the poses that the log "
                   "gives as corrected or true")
      ->check(CLI::IsMember({"odometry", "given"}))
      ->capture_default_str();
  command->add_option("--resolution", options->resolution_m, "Edge of a cell in metres")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->footer("Example: echomap replay aces.log.gz --poses given --out aces");
  command->callback([&action, options] { action = [options] { return run_replay(*options); }; });
}

void add_localize(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("localize", "Find and follow the robot of a log in a map");
  const auto options = std::make_shared<LocalizeOptions>();
  add_log_options(command, *options);
  command->add_option("--map", options->map, "Run directory, or YAML file of a ROS map")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--at",
                   options->at,
                   "Where it starts: x and y in metres, heading in degrees; anywhere by default")
      ->expected(3);
  command->add_option("--seed", options->seed, "Seed of the particles")->capture_default_str();
  command->footer("Example: echomap localize tuesday.log --map monday");
  command->callback([&action, options] { action = [options] { return run_localize(*options); }; });
}

void add_flash(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("flash", "Write the firmware to a board");
  const auto options = std::make_shared<FlashOptions>();
  command->add_option("--board", options->board, "Which board; by default what its USB id says")
      ->check(CLI::IsMember(flash_board_names()));
  command
      ->add_option("--port",
                   options->port,
                   "Serial device, or id:TEXT of a USB port or ST-Link; by default the one board "
                   "here that its USB id gives away")
      ->envname("ECHOMAP_PORT");
  command->add_option(
      "--image", options->image, "Intel hex file; by default the one of this build");
  command->add_flag("--dry-run", options->dry_run, "Only print the commands");
  command->footer("Example: echomap flash --board nano --port /dev/ttyUSB0");
  command->callback([&action, options] { action = [options] { return run_flash(*options); }; });
}

void set_up_logging(bool verbose, bool quiet) {
  auto logger = spdlog::stderr_color_mt("echomap");
  logger->set_pattern("echomap: %^%l%$: %v");
  logger->set_level(verbose ? spdlog::level::debug
                            : (quiet ? spdlog::level::err : spdlog::level::info));
  spdlog::set_default_logger(std::move(logger));
}

/// The sub-command that the arguments name, right or wrong; empty where there is none.
std::string named_command(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto word = std::find_if(
      words.begin(), words.end(), [](const std::string& text) { return !text.starts_with('-'); });
  return word == words.end() ? std::string() : *word;
}

/// CLI11 says only that some sub-command is needed; say which one was meant.
ExitCode report_usage(const CLI::App& app, const CLI::ParseError& error, const std::string& name) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    return ExitCode::kOk;
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  const std::string what =
      known || name.empty() ? error.what()
                            : "no command is named '" + name + "'" + files::suggestion(name, names);
  const std::string help = known ? "echomap " + name + " --help" : "echomap --help";
  std::fputs(("echomap: " + what + "\n  next: " + help + "\n").c_str(), stderr);
  return ExitCode::kUsage;
}

ExitCode run_and_report(const Action& action) {
  const auto fail = [](ExitCode code, const char* message) {
    spdlog::error("{}", message);
    return code;
  };
  try {
    return action();
  } catch (const CommandError& error) {
    return fail(error.code(), error.what());
  } catch (const files::ConfigError& error) {
    return fail(ExitCode::kConfigInvalid, error.what());
  } catch (const transport::TransportError& error) {
    return fail(ExitCode::kNoRobot, error.what());
  } catch (const std::exception& error) {
    return fail(ExitCode::kRuntimeError, error.what());
  }
}

}  // namespace

ExitCode run_command_line(int argc, char** argv) {
  CLI::App app("echomap: cheap robots that map a room and know where they are", "echomap");
  app.set_version_flag("--version", "echomap " ECHOMAP_VERSION);
  app.require_subcommand(1);
  bool verbose = false;
  bool quiet = false;
  app.add_flag("-v,--verbose", verbose, "Say more on stderr");
  app.add_flag("-q,--quiet", quiet, "Say only errors");
  app.fallthrough();
  Action action;
  add_demo(app, action);
  add_explore(app, action);
  add_eval(app, action);
  add_replay(app, action);
  add_localize(app, action);
  add_diff(app, action);
  add_flash(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error, named_command(argc, argv));
  }
  set_up_logging(verbose, quiet);
  catch_interrupts();
  return run_and_report(action);
}

}  // namespace echomap::apps
