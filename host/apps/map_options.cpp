// SPDX-License-Identifier: MIT
#include "host/apps/map_options.hpp"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/live_options.hpp"
#include "host/datasets/open_log.hpp"
#include "host/slam/slam_methods.hpp"

namespace echomap::apps {
namespace {

void add_format_option(CLI::App& command, std::string& format) {
  command.add_option("--format", format, "Format of the log; not needed where the log says it")
      ->check([](const std::string& name) { return datasets::unknown_format(name); });
}

/// An option of an earlier version, which is not listed and says its new name.
void add_renamed_option(CLI::App& command, const std::string& old_name, const std::string& name) {
  command
      .add_option_function<std::string>(old_name,
                                        [old_name, name](const std::string& /*value*/) {
                                          throw CLI::ValidationError(
                                              old_name, "this option is now called " + name);
                                        })
      ->group("");
}

void add_played_part(CLI::App& command, ReplayOptions& options) {
  command
      .add_option("--from",
                  options.part.from_s,
                  "Seconds of a recording to leave out: the map begins where the robot is then")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--until", options.part.until_s, "Second of a recording at which to stop")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--speed",
                  options.part.speed,
                  "Seconds of a recording a second; by default as fast as possible, with --live 8")
      ->check(CLI::PositiveNumber);
  command.add_flag(
      "--step", options.step, "Wait for Enter after each stop of a recording, and say where it is");
  add_live_options(command, options.live, true);
}

std::vector<std::string> slam_names() {
  std::vector<std::string> names;
  for (const slam::NamedSlam& method : slam::slam_methods()) {
    names.emplace_back(method.name);
  }
  return names;
}

}  // namespace

CLI::Option* add_log_options(CLI::App& command, std::filesystem::path& log, std::string& format) {
  add_format_option(command, format);
  return command
      .add_option("log", log, "File of the log, plain or gz, a run directory or a recording")
      ->check(CLI::ExistingPath);
}

void add_out_options(CLI::App& command, std::filesystem::path& out, bool& force) {
  command.add_option("--out", out, "Run directory; a stamped one by default");
  command.add_flag("--force", force, "Overwrite the run that the run directory has in it");
}

void add_align_option(CLI::App& command, bool& align) {
  command
      .add_flag("--align,!--no-align",
                align,
                "Turn the pictures, never the data, to the room's main direction")
      ->capture_default_str();
}

void add_eval(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand("eval", "Score a run against the ground truth");
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
                       "True relative poses, lines 'from to dx dy dtheta': rows of trajectory.tum "
                       "from 0, metres, radians")
          ->check(CLI::ExistingFile);
  command
      ->add_option("--picture",
                   options->picture,
                   "Draw the map on the truth, its errors coloured, to this PNG file")
      ->needs(truth);
  add_align_option(*command, options->align);
  command->add_option("--json", options->json, "Write the scores to this file, '-' for stdout");
  command->footer("Example: echomap eval first_map --truth first_map/truth --json -");
  command->callback([&action, options, truth, relations] {
    if (truth->count() == 0 && relations->count() == 0) {
      throw CLI::RequiredError("--truth or --relations");
    }
    action = [options] { return run_eval(*options); };
  });
}

void add_diff(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("diff", "Report what changed between two maps of one room");
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

void add_characterise(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand(
      "characterise", "Measure a sonar's cone and range noise in a recording of its sweeps");
  const auto options = std::make_shared<CharacteriseOptions>();
  add_format_option(*command, options->format);
  command
      ->add_option(
          "logs", options->logs, "Files of logs, plain or gz, or run directories; of one sonar")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--range-stddev",
                   options->range_stddev_m,
                   "Approximate standard deviation of a range, metres: a wall rises by three of "
                   "them at both ends and fits within two")
      ->check(CLI::Range(0.001, 0.1))
      ->capture_default_str();
  add_renamed_option(*command, "--range-sd", "--range-stddev");
  command->add_option("--json", options->json, "Write the figures to this file, '-' for stdout");
  command->footer("Example: echomap characterise first_map --json -");
  command->callback(
      [&action, options] { action = [options] { return run_characterise(*options); }; });
}

void add_export(CLI::App& app, CommandAction& action) {
  CLI::App* command =
      app.add_subcommand("export", "Write a recorded run's map, path or observations as one file");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("run", options->run, "Run directory or session.mcap")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--to",
                   options->to,
                   "Format: pgm, png, svg, gif, geojson or json of the map, tum or csv of the path "
                   "and what was sensed, g2o of SLAM's graph, carmen for tools of logs")
      ->required()
      ->check(CLI::IsMember(export_names()));
  command->add_option(
      "--out", options->out, "The file; by default the run's name with the format's ending");
  command->add_flag("--force", options->force, "Overwrite the file");
  command->add_option("--until", options->until_s, "Second of the recording at which to stop")
      ->check(CLI::NonNegativeNumber);
  add_align_option(*command, options->align);
  command->footer("Example: echomap export first_map --to gif");
  command->callback([&action, options] { action = [options] { return run_export(*options); }; });
}

void add_replay(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand("replay", "Map a recorded log");
  const auto options = std::make_shared<ReplayOptions>();
  add_log_options(*command, options->log, options->format)->required();
  add_out_options(*command, options->out, options->force);
  command->add_option("--json", options->json, "Write a report to this file, '-' for stdout");
  command->add_flag("--headless", options->headless, "No progress line");
  command
      ->add_option("--map",
                   options->map,
                   "Kind of map: an occupancy grid, the points of all echoes, or the polygon "
                   "around the floor")
      ->check(CLI::IsMember({"grid", "points", "polygon"}))
      ->capture_default_str();
  CLI::Option* poses = command
                           ->add_option("--poses",
                                        options->poses,
                                        "Poses of the scans: the robot's odometry, or those that "
                                        "the log gives as corrected or true")
                           ->check(CLI::IsMember({"odometry", "given"}))
                           ->capture_default_str();
  command
      ->add_option("--slam",
                   options->slam,
                   "SLAM method: ekf (landmarks; sonar or laser), multiscan (sonar or few beams) "
                   "or scan (laser)")
      ->check(slam::renamed_slam_method)
      ->check(CLI::IsMember(slam_names()))
      ->excludes(poses);
  command
      ->add_option("--resolution",
                   options->resolution_m,
                   "Edge of a cell of grid and polygon in metres, 0.01 by default for what is only "
                   "felt; below that ranges take long")
      ->check(CLI::Range(0.001, 1.0))
      ->capture_default_str();
  add_played_part(*command, *options);
  add_align_option(*command, options->align);
  command->footer(
      "Example: echomap replay aces.log.gz --slam scan --out aces\n"
      "         echomap replay first_map/session.mcap --until 60 --out first_minute");
  command->callback([&action, options] { action = [options] { return run_replay(*options); }; });
}

}  // namespace echomap::apps
